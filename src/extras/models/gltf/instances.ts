// The instances of a node's mesh (EXT_mesh_gpu_instancing): where each one is, and its colour.
import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Slices } from '../slices.js';
import type { Accessor, Accessors } from './accessors.js';
import type { Attribute } from './attributes.js';
import { INSTANCING } from './extensions.js';
import { optionalObject, type JsonObject } from './json.js';

/** As many elements in each list; absent where all instances have the default. */
export interface Instances {
  readonly count: number;
  readonly lists: Readonly<Partial<Record<keyof typeof LISTS, Accessor>>>;
}

/**
 * Numbers per instance, at least and at most. The colour is no part of the extension, but files
 * have it.
 */
const LISTS = { TRANSLATION: [3, 3], ROTATION: [4, 4], SCALE: [3, 3], _COLOR_0: [3, 4] } as const;

/**
 * Undefined for a node without instances. @param dropped receives lists that are longer than
 * others.
 */
export function readInstances(
  node: JsonObject,
  accessors: Accessors,
  what: string,
  dropped: Set<string>,
): Instances | undefined {
  const extension = optionalObject(node['extensions'], `${what}.extensions`)[INSTANCING];
  if (extension === undefined) return undefined;
  const attributes = optionalObject(
    optionalObject(extension, what)['attributes'],
    `${what}.attributes`,
  );
  const lists: Partial<Record<keyof typeof LISTS, Accessor>> = {};
  for (const [name, [least, most]] of Object.entries(LISTS) as [
    keyof typeof LISTS,
    readonly [number, number],
  ][]) {
    if (attributes[name] === undefined) continue;
    const accessor = accessors.at(attributes[name], `${what}.${name}`);
    const { components } = accessor;
    if (components < least || components > most) {
      throw new Error(`${what}.${name} has ${String(components)} numbers for each instance`);
    }
    lists[name] = accessor;
  }
  const counts = Object.values(lists).map(({ count }) => count);
  if (counts.length === 0) return undefined;
  const count = Math.min(...counts);
  if (count < Math.max(...counts)) {
    dropped.add(`instances of ${what} that lack some of their values`);
  }
  return { count, lists };
}

export interface Instance {
  /** Within the node, in float64; null for the node's own place. */
  readonly matrix: Matrix4 | null;
  /** Linear, with opacity; null for no colour of its own. */
  readonly color: readonly number[] | null;
}

/** @param numbers gives an accessor's elements. Throws for a place that is not finite. */
export async function placeInstances(
  { count, lists }: Instances,
  numbers: (accessor: Accessor) => Promise<Attribute>,
  slices: Slices,
): Promise<readonly Instance[]> {
  const read = (name: keyof typeof LISTS) => (lists[name] ? numbers(lists[name]) : null);
  const [translations, rotations, scales] = [
    await read('TRANSLATION'),
    await read('ROTATION'),
    await read('SCALE'),
  ];
  const colors = await read('_COLOR_0');
  const position = new Vector3();
  const rotation = new Quaternion();
  const scale = new Vector3(1, 1, 1);
  return slices.map(Array.from({ length: count }), (_, i) => {
    if (translations !== null) {
      position.fromBufferAttribute(translations, i);
    }
    if (rotations !== null) {
      setRotation(rotation, rotations, i);
    }
    if (scales !== null) {
      scale.fromBufferAttribute(scales, i);
    }
    const matrix = new Matrix4().compose(position, rotation, scale);
    if (!matrix.elements.every(Number.isFinite)) {
      throw new Error('the transform of an instance is not finite');
    }
    return { matrix, color: colors === null ? null : colorOf(colors, i) };
  });
}

/** Quantised rotations are not of unit length. One without length turns nothing. */
function setRotation(rotation: Quaternion, source: Attribute, i: number) {
  const [x, y, z, w] = [source.getX(i), source.getY(i), source.getZ(i), source.getW(i)];
  const length = Math.sqrt(x * x + y * y + z * z + w * w);
  if (length > 0 && length < Infinity) {
    rotation.set(x / length, y / length, z / length, w / length);
  } else {
    rotation.identity();
  }
}

function colorOf(source: Attribute, i: number): readonly number[] {
  // Integers stand for 0 to 1, whether the file says so or not.
  const { array, normalized } = source;
  const full =
    normalized || array instanceof Float32Array
      ? 1
      : 256 * (1 << (8 * array.BYTES_PER_ELEMENT - 8)) - 1;
  return Array.from({ length: 4 }, (_, c) => {
    const value = c < source.itemSize ? source.getComponent(i, c) / full : 1;
    return value > 0 ? Math.min(value, 1) : 0;
  });
}
