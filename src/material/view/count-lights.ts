// Packs lights for the view `light-count`, in rows of their own: one loop tests each light for an effect. All are spots
// to culling and grids; those without a cone reach everything.
import { isSpot, kindOf, packedLimit } from '../../light/light-features.js';
import { COUNTED_CONE, LIMIT_OPEN, ROWS } from '../../light/light-layout.js';
import type { LightValues } from '../../light/light-state.js';
import {
  emptyPack,
  type PackedLights,
  packLights,
  packNothing,
  type PackSpace,
  reserve,
  writeCounts,
  writeDirection,
  writeThrough,
} from '../../light/pack-lights.js';
import { normalize, type Vec3, type Vec4 } from '../../math/vector.js';

type Values = Readonly<LightValues>;

/**
 * Where directional lights stand: so far that their direction is the same everywhere. Its square is still a float32.
 */
const FAR = 1e18;

/** A light that could add something somewhere. */
interface Counted {
  readonly light: Values;
  /** A position (w 1) or a direction times {@link FAR} (w 0). */
  readonly position: Vec4;
  /** Bits of the channels of its colours that are not black: ambient 0–2, diffuse 3–5, specular 6–8. */
  readonly channels: number;
  readonly limit: number;
}

/** Packs the active lights that could add something anywhere. Returns how many leading ones have no cone. */
export function packCounted(lights: readonly Values[], space: PackSpace, into: PackedLights): number {
  const open: Counted[] = [];
  const cones: Counted[] = [];
  for (const light of lights) {
    const counted = light.active ? countedOf(light, space) : null;
    if (counted !== null) (counted.limit === LIMIT_OPEN ? open : cones).push(counted);
  }
  packNothing(into);
  into.cone = COUNTED_CONE;
  for (const counted of [...open, ...cones]) packOne(counted, space, into);
  into.active = into.sent;
  into.counts.spot = into.sent;
  writeCounts(into);
  return open.length;
}

function packOne({ light, position, channels, limit }: Counted, space: PackSpace, into: PackedLights): void {
  const { rows } = ROWS.counted;
  reserve(into, into.rows + rows, into.sent + 1);
  const at = into.rows * 4;
  const matrix = light.space === 'camera' ? space.cameraToShading : space.worldToShading;
  const [x, y, z, w] = position;
  writeThrough(matrix, into.data, at + ROWS.counted.position * 4, x, y, z, w === 1 ? 1 : 0, channels);
  const axis: Vec3 = limit === LIMIT_OPEN ? [0, 0, -1] : light.axis;
  writeDirection(matrix, into.data, at + ROWS.counted.axis * 4, axis, limit);
  into.features[into.sent] = 0;
  into.rows += rows;
  into.sent += 1;
}

/** Null: it adds nothing. */
function countedOf(light: Values, space: PackSpace): Counted | null {
  const { position, ambient, diffuse, specular, aperture } = light;
  const channels = channelBits(ambient) + 8 * channelBits(diffuse) + 64 * channelBits(specular);
  if (channels === 0) return null;
  const coned = kindOf(light) === 'spot' && aperture < 180;
  const limit = coned ? packedLimit(aperture) : LIMIT_OPEN;
  if (position[3] === 1) return { light, position, channels, limit };
  const [x, y, z] = normalize([position[0], position[1], position[2]]);
  // Without a direction it has nothing but its ambient light.
  if (x === 0 && y === 0 && z === 0) return { light, position, channels: channelBits(ambient), limit };
  if (isOutside(light, space)) return null;
  return { light, position: [x * FAR, y * FAR, z * FAR, 0], channels, limit };
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
