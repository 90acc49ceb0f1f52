// A geometry and a file's look as the ray caster reads them.
import {
  type BufferAttribute,
  type BufferGeometry,
  ClampToEdgeWrapping,
  type InterleavedBufferAttribute,
  MirroredRepeatWrapping,
  NearestFilter,
  RepeatWrapping,
  type Texture,
  type Wrapping,
} from 'three';
import type { BaseLook } from '../../phong/material/file-surface.js';
import { cosDegrees, sinDegrees } from '../../phong/math/angle.js';
import type { CastMaterial, CastTexture, CastShape, Wrap } from './cast-scene.js';

/** What `images.ts` decodes. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  /** r, g, b, a of each pixel, straight, rows from the top. */
  readonly data: Uint8Array;
  close(): void;
}

type Textures = Pick<
  CastMaterial,
  'texture' | 'emissiveTexture' | 'metalRoughTexture' | 'normalTexture'
>;

type MeshShape = ReturnType<typeof makeShape>;

/** Instances share their shape. */
const known = new WeakMap<BufferGeometry, Map<BaseLook, MeshShape>>();

/** The triangles of a geometry, and the maps of a look with coordinates of their own. */
export function meshShape(geometry: BufferGeometry, look: BaseLook): MeshShape {
  const shapes = known.get(geometry) ?? new Map<BaseLook, MeshShape>();
  const made = shapes.get(look) ?? makeShape(geometry, look);
  known.set(geometry, shapes.set(look, made));
  return made;
}

function makeShape(
  geometry: BufferGeometry,
  { map, emissiveMap, metalRoughMap, normalMap, vertexColors, ...plain }: BaseLook,
) {
  const uvs: Float64Array[] = [];
  const textureOf = (name: keyof Textures, texture: Texture | null): Textures => {
    if (texture === null) return {};
    const { width, height, data } = texture.image as Pixels;
    const uv = uvs.push(coordinatesOf(geometry, texture)) - 1;
    const nearest = texture.magFilter === NearestFilter;
    const [wrapS, wrapT] = [WRAPS[texture.wrapS], WRAPS[texture.wrapT]];
    return { [name]: { width, height, data, wrapS, wrapT, nearest, uv } satisfies CastTexture };
  };
  const look = {
    ...plain,
    ...textureOf('texture', map),
    ...textureOf('emissiveTexture', emissiveMap),
    ...textureOf('metalRoughTexture', metalRoughMap),
    ...textureOf('normalTexture', normalMap),
  };
  const { position, normal, tangent, color } = geometry.attributes;
  const index = geometry.index?.array;
  const shape: CastShape = {
    positions: numbersOf(position!),
    normals: numbersOf(normal!),
    uvs,
    ...(tangent !== undefined && normalMap !== null && { tangents: numbersOf(tangent) }),
    ...(color !== undefined &&
      vertexColors !== false && {
        colors: numbersOf(color, 4),
        linearColors: vertexColors === 'linear',
      }),
    ...(index !== undefined && { index }),
  };
  return { shape, look };
}

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** `size` numbers of each vertex; 1 for those that it has not. */
function numbersOf(attribute: Attribute, size = attribute.itemSize): ArrayLike<number> {
  const { array, itemSize, count } = attribute;
  if (!('data' in attribute) && array instanceof Float32Array && size === itemSize) return array;
  return Float64Array.from({ length: count * size }, (_, i) =>
    i % size < itemSize ? attribute.getComponent(Math.floor(i / size), i % size) : 1,
  );
}

/**
 * The texture's own coordinates, moved as glTF says: scaled, turned, shifted. three.js's matrix needs
 * the engine's sines.
 */
function coordinatesOf({ attributes }: BufferGeometry, texture: Texture): Float64Array {
  const { channel, offset, repeat, rotation } = texture;
  const uv = attributes[channel === 0 ? 'uv' : `uv${String(channel)}`];
  if (uv === undefined) return new Float64Array();
  const degrees = (rotation * 180) / Math.PI;
  const [c, s] = [cosDegrees(degrees), sinDegrees(degrees)];
  const moved = new Float64Array(2 * uv.count);
  for (let i = 0; i < uv.count; i++) {
    const [u, v] = [uv.getX(i) * repeat.x, uv.getY(i) * repeat.y];
    moved[2 * i] = c * u + s * v + offset.x;
    moved[2 * i + 1] = c * v - s * u + offset.y;
  }
  return moved;
}

const WRAPS = {
  [ClampToEdgeWrapping]: 'clamp',
  [MirroredRepeatWrapping]: 'mirror',
  [RepeatWrapping]: 'repeat',
} satisfies Record<Wrapping, Wrap>;
