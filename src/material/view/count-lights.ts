// Which lights does the view `light-count` pack, so that one loop can test each for an effect? All as spots, because only
// spots are culled and divided into grids. Numbers that the count does not need make room for those that it reads. Knows no programs.
import { isSpot, kindOf, packedLimit } from '../../light/light-features.js';
import { LIMIT_OPEN } from '../../light/light-layout.js';
import type { LightValues } from '../../light/light-state.js';
import { emptyPack, packLights, type PackSpace } from '../../light/pack-lights.js';
import { normalize, type Vec3 } from '../../math/vector.js';

type Values = Readonly<LightValues>;

/** Where directional lights stand: so far that their direction is the same everywhere. Its square is still a float32. */
const FAR = 1e18;

export interface CountLights {
  /** As spots, those without a cone first. */
  readonly lights: readonly Values[];
  /** How many have no cone. */
  readonly open: number;
}

/** The active lights that could add something anywhere. */
export function countLights(all: readonly Values[], space: PackSpace): CountLights {
  const open: Values[] = [];
  const cones: Values[] = [];
  for (const light of all) {
    const spot = light.active ? asSpot(light, space) : null;
    if (spot !== null) (spot.aperture < 180 ? cones : open).push(spot);
  }
  return { lights: [...open, ...cones], open: open.length };
}

/** Null: it adds nothing. */
function asSpot(light: Values, space: PackSpace): Values | null {
  const { position, ambient, diffuse, specular } = light;
  const channels = channelBits(ambient) + 8 * channelBits(diffuse) + 64 * channelBits(specular);
  if (channels === 0) return null;
  const coned = kindOf(light) === 'spot' && light.aperture < 180;
  const axis: Vec3 = coned ? light.axis : [0, 0, -1];
  const spot: Values = {
    ...light,
    axis,
    aperture: coned ? light.aperture : 180,
    attenuation: [channels, 0, 0],
    cutoff: coned ? packedLimit(light.aperture) : LIMIT_OPEN,
  };
  if (position[3] === 1) return spot;
  const [x, y, z] = normalize([position[0], position[1], position[2]]);
  // Without a direction it has nothing but its ambient light.
  if (x === 0 && y === 0 && z === 0) return { ...spot, attenuation: [channelBits(ambient), 0, 0] };
  return isOutside(light, space) ? null : { ...spot, position: [x * FAR, y * FAR, z * FAR, 1] };
}

/** A bit for each channel that is not black, as in shaders/view_count.glsl. */
const channelBits = ([r, g, b]: Vec3): number => Number(r > 0) + 2 * Number(g > 0) + 4 * Number(b > 0);

const scratch = emptyPack();

/** A directional light whose one direction is outside its own cone: packed, nothing is left of it. */
function isOutside(light: Values, space: PackSpace): boolean {
  if (!isSpot(light)) return false;
  packLights([{ ...light, diffuse: [255, 255, 255] }], space, scratch);
  return scratch.sent === 0;
}
