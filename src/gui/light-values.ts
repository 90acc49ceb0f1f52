// Values that the panel writes to lights: those of a new light, and those that make a light directional, a point or a
// spot.
import { isSpot, kindOf } from '../light/light-features.js';
import { type LightKind, type LightValues } from '../light/light-state.js';
import type { Vec3, Vec4 } from '../math/vector.js';

export interface ConeValues {
  readonly aperture: number;
  readonly cutoff: number;
}

/** For a light that becomes a spot for the first time. */
const FIRST_CONE: ConeValues = { aperture: 30, cutoff: 8 };

const NO_CONE: ConeValues = { aperture: 180, cutoff: 0 };

/** Changes the kind of one light. A kind that it had before gets its former values back. */
export class KindChange {
  #formerCone: ConeValues | null = null;

  /**
   * The values to write so that the light becomes this kind; none if it is already. x, y and z stay. A spot gets its
   * former cone back. Without an axis it is aimed at `target`, a point in the light's own space.
   */
  writesFor(light: Readonly<LightValues>, kind: LightKind, axisGiven: boolean, target: Vec3): Partial<LightValues> {
    if (kindOf(light) === kind) return {};
    const [x, y, z] = light.position;
    const position: Vec4 = [x, y, z, kind === 'directional' ? 0 : 1];
    if (kind !== 'spot') {
      if (!isSpot(light)) return { position };
      this.#formerCone = { aperture: light.aperture, cutoff: light.cutoff };
      return { position, ...NO_CONE };
    }
    // Keep the default axis only if it has been in use.
    const chosen = axisGiven || isSpot(light) || this.#formerCone !== null;
    const axis = chosen && light.axis.some((n) => n !== 0) ? {} : { axis: aim(light.position, target) };
    const cone = isSpot({ ...light, ...axis }) ? {} : (this.#formerCone ?? FIRST_CONE);
    return { position, ...axis, ...cone };
  }
}

/** The direction from a place to a point, in short numbers; straight down if they coincide. */
function aim([x, y, z]: Vec4, target: Vec3): Vec3 {
  const offset = [target[0] - x, target[1] - y, target[2] - z] as const;
  const longest = Math.max(...offset.map(Math.abs));
  if (longest === 0) return [0, -1, 0];
  const short = (n: number): number => Number((n / longest).toFixed(3)) + 0;
  return [short(offset[0]), short(offset[1]), short(offset[2])];
}

/** Points placed around a circle in steps of this angle never come close to one another. */
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

/** Dimmer than the default, so that a scene that is lit already does not become white. */
const GREY: Vec3 = [140, 140, 140];

/**
 * A point light beside the scene, each at a different place. World space, scene units.
 *
 * `count`: number of lights so far. `reach`: half the range of the sliders around `center`.
 */
export function newLight(count: number, center: Vec3, reach: number): Partial<LightValues> {
  const angle = GOLDEN_ANGLE * (count + 1);
  const distance = reach / 2;
  const near = (offset: number, middle: number): number => Number((middle + distance * offset).toPrecision(3));
  return {
    position: [near(0.8 * Math.sin(angle), center[0]), near(0.6, center[1]), near(0.8 * Math.cos(angle), center[2]), 1],
    diffuse: GREY,
    specular: GREY,
  };
}
