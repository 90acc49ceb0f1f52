// Which primitives of a glTF mesh are drawn? Triangles only, with the attributes that are used. Knows the JSON only.
import type { Accessor } from './accessors.js';
import { countAt, indexAt, objectAt, objectsAt, optionalObject, type JsonObject } from './json.js';

export const DRACO = 'KHR_draco_mesh_compression';

export interface Primitive {
  readonly attributes: Readonly<Record<string, number>>;
  readonly extensions: JsonObject;
  readonly indices: number | undefined;
  readonly material: number | undefined;
  readonly mode: number;
}

export interface PrimitiveContext {
  readonly accessors: readonly Accessor[];
  /** Number of materials. */
  readonly materials: number;
  /** Number of buffer views. */
  readonly views: number;
  /** Output: the accessors that will be read. */
  readonly used: Set<Accessor>;
}

const ATTRIBUTES = /^(POSITION|NORMAL|TANGENT|TEXCOORD_[0-3]|COLOR_0|JOINTS_0|WEIGHTS_0)$/;
const TRIANGLES = 4;
const FAN = 6;

export function readPrimitives(mesh: JsonObject, context: PrimitiveContext): readonly Primitive[] {
  return objectsAt(mesh['primitives'], 'primitives')
    .filter((primitive) => isDrawn(primitive))
    .map((primitive) => readPrimitive(primitive, context))
    .filter((primitive) => cornersOf(primitive, context) >= 3);
}

function isDrawn(primitive: JsonObject): boolean {
  const mode = countAt(primitive['mode'], 'mode', TRIANGLES);
  return (
    mode >= TRIANGLES && mode <= FAN && 'POSITION' in optionalObject(primitive['attributes'], 'attributes')
  );
}

function readPrimitive(primitive: JsonObject, context: PrimitiveContext): Primitive {
  const { accessors, used } = context;
  const read = (value: unknown, what: string): number => indexAt(value, accessors.length, what);
  const attributes: Record<string, number> = {};
  for (const [name, value] of Object.entries(objectAt(primitive['attributes'], 'attributes'))) {
    if (ATTRIBUTES.test(name)) attributes[name] = read(value, name);
  }
  const indices = primitive['indices'] === undefined ? undefined : read(primitive['indices'], 'indices');
  const material = primitive['material'];
  const extension = optionalObject(primitive['extensions'], 'extensions')[DRACO];
  const packed =
    extension === undefined ? undefined : readDraco(objectAt(extension, DRACO), attributes, context);
  for (const [name, index] of Object.entries(attributes)) {
    const accessor = accessors[index];
    if (accessor && !(packed && name in packed.attributes)) used.add(accessor);
  }
  const order = indices === undefined ? undefined : accessors[indices];
  if (order && !packed) used.add(order);
  return {
    attributes,
    indices,
    material: material === undefined ? undefined : indexAt(material, context.materials, 'material'),
    // The decoder returns separate triangles, whatever the mode was.
    mode: packed ? TRIANGLES : countAt(primitive['mode'], 'mode', TRIANGLES),
    extensions: packed ? { [DRACO]: packed } : {},
  };
}

/** @param wanted the primitive's attributes. One that only the extension lists has no accessor type, so it is ignored. */
function readDraco(
  extension: JsonObject,
  wanted: JsonObject,
  context: PrimitiveContext,
): { bufferView: number; attributes: JsonObject } {
  const attributes: Record<string, number> = {};
  for (const [name, id] of Object.entries(objectAt(extension['attributes'], DRACO))) {
    if (name in wanted) attributes[name] = countAt(id, `${DRACO}.${name}`);
  }
  return { bufferView: indexAt(extension['bufferView'], context.views, DRACO), attributes };
}

/** Claimed number of corners. Whether the bytes exist is checked with the accessors. */
function cornersOf(primitive: Primitive, { accessors }: PrimitiveContext): number {
  return accessors[primitive.indices ?? primitive.attributes['POSITION'] ?? -1]?.count ?? 0;
}
