// What makes a light directional, a point light or a spot? What is written for each choice, so that coming back to a
// kind finds it as it was. World or camera space, as the light's own. Knows no controls.
import { isSpot, kindOf, type LightKind } from '../light/light-features.js';
import type { LightValues } from '../light/light-state.js';
import type { Vec3, Vec4 } from '../math/vector.js';

export const LIGHT_KINDS = ['directional', 'point', 'spot'] as const satisfies readonly LightKind[];

/** In one line, for who chooses. */
export const KIND_RULE =
  'Directional: w = 0. Point: w = 1. Spot: w = 1 with its cone, which the other kinds put away (aperture 180, cutoff 0).';

export interface Cone {
  readonly aperture: number;
  readonly cutoff: number;
}

/** For a light that becomes a spot for the first time. */
const FIRST_CONE: Cone = { aperture: 30, cutoff: 8 };

const NO_CONE: Cone = { aperture: 180, cutoff: 0 };

export class KindChoice {
  #kept: Cone | null = null;

  /**
   * The values to write so that a light is of this kind; none where it is. x, y and z stay as they are. A spot gets back
   * the cone it had; without an axis it is aimed at `target`, a point in the light's own space.
   */
  writesFor(
    light: Readonly<LightValues>,
    kind: LightKind,
    axisGiven: boolean,
    target: Vec3,
  ): Partial<LightValues> {
    if (kindOf(light) === kind) return {};
    const [x, y, z] = light.position;
    const position: Vec4 = [x, y, z, kind === 'directional' ? 0 : 1];
    if (kind !== 'spot') {
      if (!isSpot(light)) return { position };
      this.#kept = { aperture: light.aperture, cutoff: light.cutoff };
      return { position, ...NO_CONE };
    }
    // The default axis is somebody's choice only where it has been at work.
    const chosen = axisGiven || isSpot(light) || this.#kept !== null;
    const axis = chosen && light.axis.some((n) => n !== 0) ? {} : { axis: aim(light.position, target) };
    const cone = isSpot({ ...light, ...axis }) ? {} : (this.#kept ?? FIRST_CONE);
    return { position, ...axis, ...cone };
  }
}

/** From a place to a point, in numbers that read well; straight down where both are one. */
function aim([x, y, z]: Vec4, target: Vec3): Vec3 {
  const way = [target[0] - x, target[1] - y, target[2] - z] as const;
  const longest = Math.max(...way.map(Math.abs));
  if (longest === 0) return [0, -1, 0];
  const short = (n: number): number => Number((n / longest).toFixed(3)) + 0;
  return [short(way[0]), short(way[1]), short(way[2])];
}
