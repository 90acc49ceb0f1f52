// The primitives of a glTF mesh that are drawn: triangles, and the attributes that are used. Knows
// the JSON only.
import type { Slices } from '../slices.js';
import type { Accessor, Accessors } from './accessors.js';
import { leftOutOf } from './extensions.js';
import type { GltfMaterial } from './materials.js';
import {
  countAt,
  indexAt,
  optionalIndex,
  namesIn,
  objectAt,
  objectsAt,
  optionalObject,
  shortListAt,
  type JsonObject,
} from './json.js';
import { JSON_NAME_LIMIT } from '../limits.js';

export const DRACO = 'KHR_draco_mesh_compression';

export interface Primitive {
  /**
   * For the parser, which gets triangles: it would turn strips into arrays of numbers and copy
   * their vertices.
   */
  readonly definition: {
    readonly attributes: Readonly<Record<string, number>>;
    readonly extensions: JsonObject;
    readonly indices: number | undefined;
    readonly material: number | undefined;
    readonly mode: number;
  };
  /** How vertices or indices become triangles. */
  readonly mode: number;
  /** As drawn. */
  readonly corners: number;
  readonly vertices: number;
  /** The attributes, each with the numbers per vertex that it becomes. */
  readonly attributes: readonly {
    readonly accessor: Accessor;
    readonly items: number;
    readonly name: string;
  }[];
  /** Accessors that are read: all but those whose numbers are in Draco data. */
  readonly read: readonly Accessor[];
  /** Accessors of its morph targets, by their attributes' names. */
  readonly targets: readonly MorphAccessors[];
  /** The buffer view of Draco data. */
  readonly packed: number | undefined;
}

/**
 * Absent where a target leaves an attribute as it is. As many elements as the mesh has vertices.
 */
export type MorphAccessors = Readonly<Partial<Record<(typeof MORPHED)[number], Accessor>>>;

export interface PrimitiveContext {
  readonly accessors: Accessors;
  readonly materials: readonly GltfMaterial[];
  /** Number of buffer views. */
  readonly views: number;
  /** Receives what is left out, by the file's own names. */
  readonly dropped: Set<string>;
  readonly slices: Slices;
}

/** The attributes that are used, and the numbers per vertex that they become. */
const ATTRIBUTES: ReadonlyMap<string, number> = new Map([
  ...['POSITION', 'NORMAL'].map((name) => [name, 3] as const),
  ...['TANGENT', 'COLOR_0', 'JOINTS_0', 'WEIGHTS_0', 'JOINTS_1', 'WEIGHTS_1'].map(
    (name) => [name, 4] as const,
  ),
  ...[0, 1, 2, 3].map((set) => [`TEXCOORD_${String(set)}`, 2] as const),
]);
/** The attributes that morph targets move. */
const MORPHED = ['POSITION', 'NORMAL', 'TANGENT'] as const;
export const TRIANGLES = 4;
export const STRIPS = 5;
export const FANS = 6;

/** Corners of triangles that a list, strip or fan of this many vertices or indices stands for. */
export const cornersOf = (mode: number, count: number) =>
  mode === TRIANGLES ? count - (count % 3) : Math.max(count - 2, 0) * 3;

export async function readPrimitives(
  mesh: JsonObject,
  context: PrimitiveContext,
): Promise<readonly Primitive[]> {
  const primitives = await context.slices.map(
    objectsAt(mesh['primitives'], 'primitives'),
    (primitive) => (isDrawn(primitive, context.dropped) ? readPrimitive(primitive, context) : null),
  );
  return primitives.flatMap((primitive) =>
    primitive !== null && primitive.corners > 0 ? primitive : [],
  );
}

function isDrawn(primitive: JsonObject, dropped: Set<string>): boolean {
  const mode = countAt(primitive['mode'], 'mode', TRIANGLES);
  const attributes = optionalObject(primitive['attributes'], 'attributes');
  if (mode < TRIANGLES) {
    dropped.add(mode === 0 ? 'points' : 'lines');
  }
  for (const name of leftOutOf(primitive)) {
    dropped.add(name);
  }
  if ('JOINTS_2' in attributes) {
    dropped.add('JOINTS_2');
  }
  return mode >= TRIANGLES && mode <= FANS && 'POSITION' in attributes;
}

function readPrimitive(primitive: JsonObject, context: PrimitiveContext): Primitive {
  const { accessors, materials } = context;
  const material = optionalIndex(primitive['material'], materials.length, 'material');
  const nameOf = (written: string) => drawnName(written, materials[material ?? -1]);
  const written = objectAt(primitive['attributes'], 'attributes');
  const attributes = namesIn(written, 'attributes').flatMap((writtenName) => {
    const name = nameOf(writtenName);
    const least = ATTRIBUTES.get(name);
    if (least === undefined) return [];
    const accessor = accessors.at(written[writtenName], name);
    return [{ name, accessor, items: Math.max(least, accessor.components) }];
  });
  // Without a prototype, as the Draco attributes: three.js would look for an accessor by what a
  // page added to Object.prototype.
  const indexes = Object.create(null) as Record<string, number>;
  for (const { name, accessor } of attributes) {
    indexes[name] = accessor.index;
  }
  if (
    materials[material ?? -1]?.uses.some(
      ({ texCoord }) => !(`TEXCOORD_${String(texCoord)}` in indexes),
    )
  ) {
    context.dropped.add('textures that have no texture coordinates');
  }
  const order =
    primitive['indices'] === undefined ? undefined : accessors.at(primitive['indices'], 'indices');
  const extension = optionalObject(primitive['extensions'], 'extensions')[DRACO];
  const packed =
    extension === undefined
      ? undefined
      : readDraco(objectAt(extension, DRACO), indexes, nameOf, context);
  const vertices = attributes.find(({ name }) => name === 'POSITION')?.accessor.count ?? 0;
  const count = (order ?? { count: vertices }).count;
  // The Draco decoder returns separate triangles, whatever the mode was.
  const mode = packed ? TRIANGLES : countAt(primitive['mode'], 'mode', TRIANGLES);
  const definition = {
    attributes: indexes,
    indices: order?.index,
    material,
    mode: TRIANGLES,
    extensions: packed ? { [DRACO]: packed } : {},
  };
  const targets = readTargets(primitive, vertices, context);
  const unpacked = attributes.filter(
    ({ name }) => !(packed && Object.hasOwn(packed.attributes, name)),
  );
  return {
    definition,
    mode,
    corners: cornersOf(mode, count),
    vertices,
    attributes,
    read: [
      ...unpacked.map(({ accessor }) => accessor),
      ...(order === undefined || packed ? [] : [order]),
      ...targets.flatMap((target) => Object.values(target)),
    ],
    targets,
    packed: packed?.bufferView,
  };
}

/** The name under which an attribute is drawn: a material may use another set in its place. */
function drawnName(name: string, material: GltfMaterial | undefined): string {
  const [, digits] = /^TEXCOORD_(\d+)$/.exec(name) ?? [];
  if (digits === undefined || material === undefined) return name;
  const set = Number(digits);
  for (const [place, moved] of material.uvSets) {
    if (moved === set) return `TEXCOORD_${String(place)}`;
  }
  return material.uvSets.has(set) ? 'unused' : name;
}

function readTargets(
  primitive: JsonObject,
  vertices: number,
  { accessors, dropped }: PrimitiveContext,
): readonly MorphAccessors[] {
  const targets = shortListAt(primitive['targets'], 'targets', JSON_NAME_LIMIT);
  return objectsAt(targets, 'targets').map((target, i) => {
    for (const name of namesIn(target, 'targets')) {
      if (!(MORPHED as readonly string[]).includes(name)) {
        dropped.add(`morph targets of ${name}`);
      }
    }
    const read: Partial<Record<(typeof MORPHED)[number], Accessor>> = {};
    for (const name of MORPHED) {
      if (target[name] === undefined) continue;
      const what = `targets[${String(i)}].${name}`;
      const accessor = accessors.at(target[name], what);
      if (accessor.components !== 3) {
        throw new Error(`${what} is not made of vectors of three numbers`);
      }
      const { count } = accessor;
      if (count !== vertices) {
        throw new Error(
          `${what} has ${String(count)} elements, but its mesh has ${String(vertices)} vertices`,
        );
      }
      read[name] = accessor;
    }
    return read;
  });
}

/**
 * @param wanted attributes. One that only the extension lists has no accessor type, so it is
 * ignored.
 */
function readDraco(
  extension: JsonObject,
  wanted: JsonObject,
  nameOf: (written: string) => string,
  context: PrimitiveContext,
) {
  const attributes = Object.create(null) as Record<string, number>;
  const ids = objectAt(extension['attributes'], DRACO);
  for (const written of namesIn(ids, DRACO)) {
    const name = nameOf(written);
    if (Object.hasOwn(wanted, name)) {
      attributes[name] = countAt(ids[written], `${DRACO}.${name}`);
    }
  }
  return { bufferView: indexAt(extension['bufferView'], context.views, DRACO), attributes };
}
