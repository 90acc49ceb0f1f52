// Which values turn a light into a directional light, a point light or a spot? Choosing a former kind again restores it. Vectors in
// the light's own space. Knows no controls.
import { isSpot, kindOf, type LightKind } from '../light/light-features.js';
import type { LightValues } from '../light/light-state.js';
import type { Vec3, Vec4 } from '../math/vector.js';

export const LIGHT_KINDS = ['directional', 'point', 'spot'] as const satisfies readonly LightKind[];

export interface Cone {
  readonly aperture: number;
  readonly cutoff: number;
}

/** For a light that becomes a spot for the first time. */
const FIRST_CONE: Cone = { aperture: 30, cutoff: 8 };

const NO_CONE: Cone = { aperture: 180, cutoff: 0 };

export class KindChoice {
  #formerCone: Cone | null = null;

  /**
   * The values to write so that the light becomes this kind; none if it is already. x, y and z stay. A spot gets its former cone
   * back. Without an axis it is aimed at `target`, a point in the light's own space.
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
