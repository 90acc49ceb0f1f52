// The equation's sums over the lights, as the reference has them, for millions of points: what does
// not depend on the point is prepared once. All places are relative to the eye, so that scenes far
// from the origin lose no digits.
import { falloff, type LightValues } from '../../phong/light/light-state.js';
import { LEAST_EXPONENT, NEAREST } from '../../phong/light/precision.js';
import { cosDegrees, radians, sinDegrees } from '../../phong/math/angle.js';
import { colorOf } from '../../phong/math/color.js';
import { atan2 } from '../../phong/math/elementary.js';
import { add, cross, dot, normalize, scale, subtract, type Vec3 } from '../../phong/math/vector.js';
import { EDGE, halfChord, power, toWorld } from '../../phong/reference/equation.js';
import type { CastCamera } from './cast-scene.js';
import { LightCells } from './light-cells.js';
import { unit } from './placed.js';

type Prepared = ReturnType<typeof prepared>;

/** Cosines this far from the cone's decide without the angle. Their own error is below 1e-15. */
const CLEAR = 1e-7;

export class LightSums {
  /** Ambient, diffuse and specular light at the last point, r g b each. */
  readonly sums = new Float64Array(9);
  /**
   * N·L, the lobe's cosine, attenuation and decay of the only light, for views: outside its cone and
   * behind the surface too.
   */
  last = { NoL: 0, RoV: 0, att: 1, decay: 1 };
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
    const { sums } = this;
    sums.fill(0);
    let piece = 0;
    for (const each of this.#cells.at(p)) {
      const { positional, place, axis, light, ambient, diffuse, specular } = each;
      const toLight = positional ? subtract(place, p) : place;
      const far = Math.sqrt(dot(toLight, toLight));
      const d = far < NEAREST ? 0 : far;
      const L = positional ? scale(toLight, d > 0 ? 1 / d : 0) : place;
      const att = positional ? 1 / Math.max(falloff(light, d), 1) : 1;
      const isSpot = dot(axis, axis) > 0 && dot(L, L) > 0;
      const inside = !isSpot || isInside(each, L);
      // The one light of a view shows its decay outside of its cone, too.
      if (!inside && this.count > 1) continue;
      // By chords: behind the spot (1 + c) / 2 would lose all digits.
      const decay =
        isSpot && light.cutoff >= LEAST_EXPONENT
          ? power(halfChord(L, axis) / 2, halfChord(L, scale(axis, -1)) / 2, light.cutoff)
          : 1;
      const NoL = dot(N, L);
      if (inside) {
        piece += NoL > 0 ? 2 * each.mark : each.mark;
      }
      // R and V, or H and N.
      const lobe = isBlinn ? unit(add(L, V)) : subtract(scale(N, 2 * NoL), L);
      const middle = isBlinn ? N : V;
      const RoV = dot(lobe, middle);
      if (this.count === 1) {
        this.last = { NoL, RoV, att, decay };
      }
      if (!inside) continue;
      const lit = NoL > 0 ? att * decay : 0;
      const spec = lit > 0 ? lit * power(RoV, halfChord(lobe, middle), n) : 0;
      for (let k = 0; k < 3; k++) {
        sums[k]! += ambient[k as 0] * decay;
        sums[k + 3]! += diffuse[k as 0] * lit * NoL;
        sums[k + 6]! += specular[k as 0] * spec;
      }
    }
    this.piece = piece | 0;
  }
}

/** Axis and direction of the light must not be zero vectors. */
function isInside({ axis, cosine, aperture }: Prepared, L: Vec3): boolean {
  const c = -dot(L, axis);
  if (Math.abs(c - cosine) > CLEAR || cosine === -1) return c > cosine || cosine === -1;
  const across = cross(L, axis);
  return atan2(Math.sqrt(dot(across, across)), c) <= aperture + EDGE;
}

function prepared(light: Readonly<LightValues>, camera: CastCamera, linear: boolean, mark: number) {
  const [x, y, z, w] = light.position;
  const positional = w === 1;
  const ofCamera = light.space === 'camera';
  const turned = (v: Vec3): Vec3 => (ofCamera ? toWorld(camera, v) : v);
  const given = turned([x, y, z]);
  return {
    positional,
    /** The unit vector to a directional light; zero if it has none. */
    place: !positional ? normalize(given) : ofCamera ? given : subtract(given, camera.eye),
    axis: scale(
      normalize(turned(light.axis)),
      Number(light.aperture < 180 || light.cutoff >= LEAST_EXPONENT),
    ),
    cosine: cosDegrees(light.aperture),
    sine: sinDegrees(light.aperture),
    /** Radians; at 180° no direction is compared. */
    aperture: radians(light.aperture),
    light,
    ambient: colorOf(light.ambient, linear),
    diffuse: colorOf(light.diffuse, linear),
    specular: colorOf(light.specular, linear),
    /** Its part in the pieces of the points that it reaches. */
    mark,
  };
}
