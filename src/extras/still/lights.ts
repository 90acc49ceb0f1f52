// The equation's sums over the lights, as the reference has them, for millions of points: what does
// not depend on the point is prepared once, and nothing is allocated. All places are relative to
// the eye, so that scenes far from the origin lose no digits.
import { falloff, type LightValues } from '../../phong/light/light-state.js';
import { LEAST_EXPONENT, NEAREST } from '../../phong/light/precision.js';
import { cosDegrees, radians, sinDegrees } from '../../phong/math/angle.js';
import { srgbDecode } from '../../phong/math/color.js';
import { atan2 } from '../../phong/math/elementary.js';
import { map, normalize, scale, subtract, type Vec3 } from '../../phong/math/vector.js';
import { EDGE, power } from '../../phong/reference/equation.js';
import type { CastCamera } from './cast-scene.js';
import { type Cone, LightCells } from './light-cells.js';
import { turned } from './placed.js';

/** `place` is the unit vector to a directional light; zero if it has none. */
interface Prepared extends Cone {
  /** Radians; at 180° no direction is compared. */
  readonly aperture: number;
  readonly light: Readonly<LightValues>;
  readonly ambient: Vec3;
  readonly diffuse: Vec3;
  readonly specular: Vec3;
  /** Its part in the pieces of the points that it reaches. */
  readonly mark: number;
}

/** Cosines this far from the cone's decide without the angle. Their own error is below 1e-15. */
const CLEAR = 1e-7;

export class LightSums {
  /** Ambient, diffuse and specular light at the last point, r g b each. */
  readonly sums = new Float64Array(9);
  /** N·L, the lobe's cosine, attenuation and decay of the last light; no term is 0 by them. */
  readonly last = { NoL: 0, RoV: 0, att: 1, decay: 1 };
  /** Equal where the same lights' cones and horizons hold the point. */
  piece = 0;
  /** Of all lights. */
  readonly count: number;
  readonly #cells: LightCells<Prepared>;

  /** `reach`: no coordinate of a point is larger; 0 if none is known. */
  constructor(
    lights: readonly Readonly<LightValues>[],
    camera: CastCamera,
    linear: boolean,
    reach = 0,
  ) {
    let mark = 1;
    const all = lights
      .filter(({ active }) => active)
      .map((light) => {
        mark = Math.imul(mark, 0x9e3779b1);
        return prepared(light, camera, linear, mark);
      });
    this.count = all.length;
    this.#cells = new LightCells(all, reach);
  }

  /** Sums at a point with unit vectors N (or zero) and V. `n`: the exponent. */
  at(p: Vec3, N: Vec3, V: Vec3, n: number, isBlinn: boolean): void {
    const { sums, last } = this;
    sums.fill(0);
    let piece = 0;
    for (const each of this.#cells.at(p)) {
      const { place, axis, light, ambient, diffuse, specular } = each;
      const { cutoff } = light;
      let lx = place[0];
      let ly = place[1];
      let lz = place[2];
      let att = 1;
      if (each.positional) {
        lx -= p[0];
        ly -= p[1];
        lz -= p[2];
        const far = Math.sqrt(lx * lx + ly * ly + lz * lz);
        const d = far < NEAREST ? 0 : far;
        att = 1 / Math.max(falloff(light, d), 1);
        const factor = d > 0 ? 1 / d : 0;
        lx *= factor;
        ly *= factor;
        lz *= factor;
      }
      const ax = axis[0];
      const ay = axis[1];
      const az = axis[2];
      let decay = 1;
      let inside = true;
      if ((ax !== 0 || ay !== 0 || az !== 0) && (lx !== 0 || ly !== 0 || lz !== 0)) {
        inside = isInside(each, lx, ly, lz);
        // The one light of a view shows its decay outside of its cone, too.
        if (!inside && this.count > 1) continue;
        // By chords: behind the spot (1 + c) / 2 would lose all digits.
        if (cutoff >= LEAST_EXPONENT) {
          decay = power(
            squared(lx - ax, ly - ay, lz - az) / 4,
            squared(lx + ax, ly + ay, lz + az) / 4,
            cutoff,
          );
        }
      }
      const NoL = N[0] * lx + N[1] * ly + N[2] * lz;
      if (inside) {
        piece += NoL > 0 ? 2 * each.mark : each.mark;
      }
      // R and V, or H and N.
      let rx = 2 * NoL * N[0] - lx;
      let ry = 2 * NoL * N[1] - ly;
      let rz = 2 * NoL * N[2] - lz;
      if (isBlinn) {
        rx = lx + V[0];
        ry = ly + V[1];
        rz = lz + V[2];
        const length = Math.sqrt(squared(rx, ry, rz));
        const factor = length > 0 ? 1 / length : 0;
        rx *= factor;
        ry *= factor;
        rz *= factor;
      }
      const qx = isBlinn ? N[0] : V[0];
      const qy = isBlinn ? N[1] : V[1];
      const qz = isBlinn ? N[2] : V[2];
      const RoV = rx * qx + ry * qy + rz * qz;
      last.NoL = NoL;
      last.RoV = RoV;
      last.att = att;
      last.decay = decay;
      if (!inside) continue;
      sums[0]! += ambient[0] * decay;
      sums[1]! += ambient[1] * decay;
      sums[2]! += ambient[2] * decay;
      if (!(NoL > 0)) continue;
      const d = att * decay * NoL;
      sums[3]! += diffuse[0] * d;
      sums[4]! += diffuse[1] * d;
      sums[5]! += diffuse[2] * d;
      const s = att * decay * power(RoV, squared(rx - qx, ry - qy, rz - qz) / 2, n);
      sums[6]! += specular[0] * s;
      sums[7]! += specular[1] * s;
      sums[8]! += specular[2] * s;
    }
    this.piece = piece | 0;
  }
}

const squared = (x: number, y: number, z: number): number => x * x + y * y + z * z;

/** Axis and direction of the light must not be zero vectors. */
function isInside({ axis, cosine, aperture }: Prepared, x: number, y: number, z: number): boolean {
  const ax = axis[0];
  const ay = axis[1];
  const az = axis[2];
  const c = -(x * ax + y * ay + z * az);
  if (Math.abs(c - cosine) > CLEAR || cosine === -1) return c > cosine || cosine === -1;
  const across = squared(y * az - z * ay, z * ax - x * az, x * ay - y * ax);
  return atan2(Math.sqrt(across), c) <= aperture + EDGE;
}

function prepared(
  light: Readonly<LightValues>,
  { eye, right, up, back }: CastCamera,
  linear: boolean,
  mark: number,
): Prepared {
  const [x, y, z, w] = light.position;
  const positional = w === 1;
  const axes = { x: right, y: up, z: back, origin: eye };
  const ofCamera = light.space === 'camera';
  const given: Vec3 = ofCamera ? turned(axes, [x, y, z]) : [x, y, z];
  const color = (c255: Vec3): Vec3 =>
    map(scale(c255, 1 / 255), (c) => (linear ? srgbDecode(c) : c));
  const isSpot = light.aperture < 180 || light.cutoff >= LEAST_EXPONENT;
  return {
    positional,
    place: !positional ? normalize(given) : ofCamera ? given : subtract(given, eye),
    axis: isSpot ? normalize(ofCamera ? turned(axes, light.axis) : light.axis) : [0, 0, 0],
    cosine: cosDegrees(light.aperture),
    sine: sinDegrees(light.aperture),
    aperture: radians(light.aperture),
    light,
    ambient: color(light.ambient),
    diffuse: color(light.diffuse),
    specular: color(light.specular),
    mark,
  };
}
