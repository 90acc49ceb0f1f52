// Which lights does the view `light-count` pack, so that one loop can ask each whether it adds something? All as spots: only a
// spot's row has its ambient light, and only spots are culled. Knows no programs.
import { isSpot, kindOf } from '../../light/light-features.js';
import type { LightValues } from '../../light/light-state.js';
import { packLights, emptyPack, type PackSpace } from '../../light/pack-lights.js';
import { normalize } from '../../math/vector.js';

type Values = Readonly<LightValues>;

/** A cone that every direction is in, on any axis; the cutoff makes the light a spot, and the view reads no cutoff. */
const OPEN = { axis: [0, 0, -1], aperture: 180, cutoff: 1 } as const;

const BLACK = { diffuse: [0, 0, 0], specular: [0, 0, 0] } as const;

/** Where directional lights stand: so far that their direction is the same everywhere. Its square is still a float32. */
const FAR = 1e18;

/** The active lights that could add something anywhere. */
export const countLights = (lights: readonly Values[], space: PackSpace): Values[] =>
  lights.filter(({ active }) => active).flatMap((light) => asSpot(light, space) ?? []);

function asSpot(light: Values, space: PackSpace): Values | null {
  if (kindOf(light) === 'spot') return light;
  if (light.position[3] === 1) return { ...light, ...OPEN };
  const [x, y, z] = normalize([light.position[0], light.position[1], light.position[2]]);
  // Without a direction it has nothing but its ambient light.
  if (x === 0 && y === 0 && z === 0) return { ...light, ...OPEN, ...BLACK, position: [0, 0, 0, 1] };
  if (isOutside(light, space)) return null;
  return { ...light, ...OPEN, position: [x * FAR, y * FAR, z * FAR, 1] };
}

const scratch = emptyPack();

/** A directional light whose one direction is outside its own cone: packed, nothing is left of it. */
function isOutside(light: Values, space: PackSpace): boolean {
  if (!isSpot(light)) return false;
  packLights([{ ...light, diffuse: [255, 255, 255] }], space, scratch);
  return scratch.sent === 0;
}
