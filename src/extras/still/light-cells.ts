// The lights that may reach a point. A cube around the eye is divided where points ask for it, and
// each part lists the lights whose cones it touches: of 100,000 spots a point needs a few. A picture of
// a teapot on a floor takes 0.74 of its CPU time so under 30 narrow spots, 0.39 under 100.
import { cross, dot, length, subtract, type Vec3 } from '../../phong/math/vector.js';

/** A light's place and cone, relative to the eye. */
export interface Cone {
  /** Directional lights reach everything. */
  readonly positional: boolean;
  readonly place: Vec3;
  /** Unit; zero for no cone. */
  readonly axis: Vec3;
  /** Cosine and sine of the aperture. */
  readonly cosine: number;
  readonly sine: number;
}

interface Cell<L> {
  readonly lights: readonly L[];
  readonly eighths: Cell<L>[];
}

/** So many lights of a cell are not worth its division. */
const FEW = 12;

/** Times that the cube is halved: to 1/4096 of it. */
const LEVELS = 12;

/** Comparisons in vain for each light that has been summed: wide cones take 2 % longer so. */
const SHARE = 1 / 16;

/** Most comparisons: 128 MB of lists. */
const MOST = 2 ** 24;

/** Above √3: the radius of a cube's corners. It covers the rounding of points, too. */
const CORNER = 1.7321;

/** Angles by which cones are wider than they are, for the rounding of both. Radians. */
const SLACK = 1e-9;

export class LightCells<L extends Cone> {
  readonly #root: Cell<L>;
  readonly #reach: number;
  /** Comparisons that may be in vain before more lights are summed. */
  #left: number;
  #made = 0;

  /** `reach`: no coordinate of a point is larger. 0: every point gets all lights. */
  constructor(lights: readonly L[], reach: number) {
    this.#root = { lights, eighths: [] };
    this.#reach = reach;
    this.#left = lights.length;
  }

  /** In the order of all lights. Those that are left out add nothing at the point. */
  at(p: Vec3): readonly L[] {
    let cell = this.#root;
    let half = this.#reach;
    let [x, y, z] = [0, 0, 0];
    for (let level = 0; level < LEVELS && half > 0 && cell.lights.length > FEW; level++) {
      half /= 2;
      const eighth = Number(p[0] > x) + 2 * Number(p[1] > y) + 4 * Number(p[2] > z);
      x += p[0] > x ? half : -half;
      y += p[1] > y ? half : -half;
      z += p[2] > z ? half : -half;
      if (cell.eighths[eighth] === undefined) {
        const { lights } = cell;
        if (this.#left < 0 || this.#made > MOST) break;
        const near = lights.filter((light) => reaches(light, [x, y, z], half * CORNER));
        this.#left -= Math.max(0, 2 * near.length - lights.length);
        this.#made += lights.length;
        cell.eighths[eighth] = { lights: near, eighths: [] };
      }
      cell = cell.eighths[eighth]!;
    }
    this.#left += SHARE * cell.lights.length;
    return cell.lights;
  }
}

/** Whether a cone may touch a sphere. */
function reaches(
  { positional, place, axis, cosine, sine }: Cone,
  center: Vec3,
  r: number,
): boolean {
  if (!positional) return true;
  const v = subtract(center, place);
  const beside = length(cross(v, axis)) * cosine - dot(v, axis) * sine;
  return beside <= r + SLACK * (length(center) + length(place));
}
