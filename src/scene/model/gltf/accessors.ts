// Do a glTF document's accessors fit into their buffer views? Checks counts and byte lengths only.
import { BYTE_LIMIT } from '../fetch-bytes.js';
import { ModelError } from '../model.js';
import { countAt, indexAt, objectAt, objectsAt, optionalObject, type JsonObject } from './json.js';

export interface BufferView {
  readonly buffer: number;
  readonly byteOffset: number;
  readonly byteLength: number;
  readonly byteStride: number | undefined;
}

export interface Accessor {
  readonly definition: JsonObject;
  readonly count: number;
  /** Numbers per element. */
  readonly components: number;
  /** Throws if the views hold fewer bytes than claimed. */
  readonly requireBytes: () => void;
  /** Bytes of an accessor without a view, which stands for zeros. */
  readonly zeroBytes: number;
}

const COMPONENT_BYTES: Readonly<Record<number, number>> = {
  5120: 1,
  5121: 1,
  5122: 2,
  5123: 2,
  5125: 4,
  5126: 4,
};
const COMPONENTS: Readonly<Record<string, number>> = {
  SCALAR: 1,
  VEC2: 2,
  VEC3: 3,
  VEC4: 4,
  MAT2: 4,
  MAT3: 9,
  MAT4: 16,
};

export function readBufferViews(json: JsonObject, buffers: number): readonly BufferView[] {
  return objectsAt(json['bufferViews'], 'bufferViews').map((view, i) => {
    const what = `bufferViews[${String(i)}]`;
    const byteStride = view['byteStride'];
    return {
      buffer: indexAt(view['buffer'], buffers, `${what}.buffer`),
      byteOffset: countAt(view['byteOffset'], `${what}.byteOffset`, 0),
      byteLength: countAt(view['byteLength'], `${what}.byteLength`),
      byteStride: byteStride === undefined ? undefined : countAt(byteStride, `${what}.byteStride`),
    };
  });
}

export function readAccessors(json: JsonObject, views: readonly BufferView[]): readonly Accessor[] {
  return objectsAt(json['accessors'], 'accessors').map((accessor, i) => {
    const what = `accessors[${String(i)}]`;
    const components = COMPONENTS[String(accessor['type'])];
    const bytes = COMPONENT_BYTES[countAt(accessor['componentType'], `${what}.componentType`)];
    if (components === undefined || bytes === undefined) throw new Error(`${what} has an unknown type`);
    const count = countAt(accessor['count'], `${what}.count`);
    const offset = countAt(accessor['byteOffset'], `${what}.byteOffset`, 0);
    const item = components * bytes;
    const sparse = accessor['sparse'] === undefined ? undefined : sparseOf(accessor['sparse'], what);
    const requireBytes = (): void => {
      requireView(accessor['bufferView'], views, { offset, count, item }, what);
      if (!sparse) return;
      requireView(sparse.indices['bufferView'], views, { ...sparse.indexRun, count: sparse.count }, what);
      requireView(
        sparse.values['bufferView'],
        views,
        { offset: sparse.valueOffset, count: sparse.count, item },
        what,
      );
    };
    return {
      // The parser warns about missing bounds; the box that it computes from them is not used.
      definition: { ...accessor, extras: undefined, name: undefined, min: ZERO, max: ZERO },
      count,
      components,
      requireBytes,
      zeroBytes: accessor['bufferView'] === undefined ? count * item : 0,
    };
  });
}

const ZERO = [0, 0, 0];

/** Throws unless every used accessor is backed by bytes, and accessors of zeros stay within a limit. */
export function requireClaims(used: Iterable<Accessor>): void {
  let zeros = 0;
  for (const accessor of used) {
    accessor.requireBytes();
    zeros += accessor.zeroBytes;
  }
  if (zeros > BYTE_LIMIT / 4) {
    throw new ModelError(
      'too-large',
      `The model claims ${String(zeros)} bytes of zeros, more than can be loaded.`,
    );
  }
}

interface Run {
  readonly offset: number;
  readonly count: number;
  readonly item: number;
}

function requireView(index: unknown, views: readonly BufferView[], run: Run, what: string): void {
  if (index === undefined || run.count === 0) return;
  const view = views[indexAt(index, views.length, `${what}.bufferView`)];
  if (!view) return;
  const end = run.offset + (view.byteStride ?? run.item) * (run.count - 1) + run.item;
  if (end > view.byteLength) {
    throw new Error(`${what} claims ${String(run.count)} elements, more than its buffer holds`);
  }
}

interface Sparse {
  readonly count: number;
  readonly indices: JsonObject;
  readonly indexRun: { readonly offset: number; readonly item: number };
  readonly values: JsonObject;
  readonly valueOffset: number;
}

function sparseOf(value: unknown, what: string): Sparse {
  const sparse = objectAt(value, `${what}.sparse`);
  const indices = objectAt(sparse['indices'], `${what}.sparse.indices`);
  const values = optionalObject(sparse['values'], `${what}.sparse.values`);
  const item = COMPONENT_BYTES[countAt(indices['componentType'], `${what}.sparse.indices.componentType`)];
  if (item === undefined || values['bufferView'] === undefined || indices['bufferView'] === undefined) {
    throw new Error(`${what}.sparse is incomplete`);
  }
  return {
    count: countAt(sparse['count'], `${what}.sparse.count`),
    indices,
    indexRun: { offset: countAt(indices['byteOffset'], `${what}.sparse`, 0), item },
    values,
    valueOffset: countAt(values['byteOffset'], `${what}.sparse`, 0),
  };
}
