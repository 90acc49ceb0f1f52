// The accessors of a glTF document: counts, alignment and byte lengths against their buffer views, and what reading
// them costs.
import type { ModelBudget } from '../model-budget.js';
import type { Slices } from '../slices.js';
import { countAt, indexAt, objectAt, objectsAt, optionalObject, type JsonObject } from './json.js';
import { readMeshoptView, type MeshoptView } from './meshopt-views.js';

export interface BufferView {
  readonly buffer: number;
  readonly byteOffset: number;
  readonly byteLength: number;
  readonly byteStride: number | undefined;
  /** Null if its bytes are not compressed. */
  readonly meshopt: MeshoptView | null;
}

/** What the document says about numbers. Only {@link Accessors.read} gives access to them. */
export interface Accessor {
  readonly index: number;
  readonly count: number;
  /** Numbers per element. */
  readonly components: number;
}

/**
 * The accessors of a document. One that was not counted by {@link Accessors.read} has no elements for the parser, which
 * reads all of them, so no reader can get at numbers that the budget does not know.
 */
export class Accessors {
  readonly #entries: readonly Entry[];
  readonly #budget: ModelBudget;
  readonly #read = new Set<Entry>();

  /** Use {@link Accessors.of}. */
  constructor(entries: readonly Entry[], budget: ModelBudget) {
    this.#entries = entries;
    this.#budget = budget;
  }

  static async of(
    json: JsonObject,
    views: readonly BufferView[],
    budget: ModelBudget,
    slices: Slices,
  ): Promise<Accessors> {
    const definitions = objectsAt(json['accessors'], 'accessors');
    return new Accessors(await slices.map(definitions, (accessor, i) => entryOf(accessor, i, views)), budget);
  }

  /** The accessor that a value in the document names. */
  at(value: unknown, what: string): Accessor {
    return this.#entries[indexAt(value, this.#entries.length, what)]!;
  }

  /**
   * Counts the memory that the elements take when they are read, once for all readers. A reader that converts them
   * counts its own copy.
   * @throws ModelError `too-large` past a limit, a plain Error if its views hold fewer bytes than it claims.
   */
  read({ index }: Accessor): void {
    const entry = this.#entries[index]!;
    if (this.#read.has(entry)) return;
    entry.requireBytes();
    this.#budget.add({ values: Math.ceil(entry.ownBytes / 4) });
    this.#read.add(entry);
  }

  /** For the parser. Call it when everything that is needed was read. */
  definitions(slices: Slices): Promise<readonly JsonObject[]> {
    return slices.map(this.#entries, (entry) => {
      // The parser looks up the types of attributes that Draco data hold.
      const { definition } = entry;
      return this.#read.has(entry) ? definition : { ...definition, count: 0, bufferView: undefined, sparse: undefined };
    });
  }
}

interface Entry extends Accessor {
  readonly definition: JsonObject;
  /** Throws if the views hold fewer bytes than claimed. */
  readonly requireBytes: () => void;
  /** Bytes that are allocated beside the copies of its views: zeros without a view, and sparse values put in place. */
  readonly ownBytes: number;
}

// Maps, because a file can name a type `constructor`.
const COMPONENT_BYTES: ReadonlyMap<unknown, number> = new Map([
  [5120, 1],
  [5121, 1],
  [5122, 2],
  [5123, 2],
  [5125, 4],
  [5126, 4],
]);
const COMPONENTS: ReadonlyMap<unknown, number> = new Map([
  ['SCALAR', 1],
  ['VEC2', 2],
  ['VEC3', 3],
  ['VEC4', 4],
  ['MAT2', 4],
  ['MAT3', 9],
  ['MAT4', 16],
]);

export function readBufferViews(json: JsonObject, buffers: number, slices: Slices): Promise<readonly BufferView[]> {
  return slices.map(objectsAt(json['bufferViews'], 'bufferViews'), (view, i) => {
    const what = `bufferViews[${String(i)}]`;
    const byteStride = view['byteStride'] || undefined; // some exporters write 0 for "packed"
    return {
      buffer: indexAt(view['buffer'], buffers, `${what}.buffer`),
      byteOffset: countAt(view['byteOffset'], `${what}.byteOffset`, 0),
      byteLength: countAt(view['byteLength'], `${what}.byteLength`),
      byteStride: byteStride === undefined ? undefined : countAt(byteStride, `${what}.byteStride`),
      meshopt: readMeshoptView(view, buffers, what),
    };
  });
}

function entryOf(accessor: JsonObject, index: number, views: readonly BufferView[]): Entry {
  const what = `accessors[${String(index)}]`;
  const components = COMPONENTS.get(accessor['type']);
  const bytes = COMPONENT_BYTES.get(accessor['componentType']);
  if (components === undefined || bytes === undefined) throw new Error(`${what} has an unknown type`);
  const count = countAt(accessor['count'], `${what}.count`);
  const offset = countAt(accessor['byteOffset'], `${what}.byteOffset`, 0);
  const item = components * bytes;
  const sparse = accessor['sparse'] === undefined ? undefined : sparseOf(accessor['sparse'], what);
  const requireBytes = (): void => {
    const stride = requireView(accessor['bufferView'], views, { offset, count, item, unit: bytes }, what);
    if (!sparse) return;
    if (stride !== item) throw new Error(`${what} is sparse and interleaved, which is not supported`);
    requireView(sparse.indices['bufferView'], views, { ...sparse.indexRun, count: sparse.count }, what);
    requireView(
      sparse.values['bufferView'],
      views,
      { offset: sparse.valueOffset, count: sparse.count, item, unit: bytes },
      what,
    );
  };
  return {
    index,
    // The parser warns about missing bounds; the box that it computes from them is not used.
    definition: { ...accessor, extras: undefined, name: undefined, min: ZERO, max: ZERO },
    count,
    components,
    requireBytes,
    ownBytes: accessor['bufferView'] === undefined || sparse ? count * item : 0,
  };
}

const ZERO = [0, 0, 0];

interface Run {
  readonly offset: number;
  readonly count: number;
  /** Bytes of an element, and of one number in it. */
  readonly item: number;
  readonly unit: number;
}

/** Throws unless the view holds the run. Gives the distance of elements in bytes. */
function requireView(index: unknown, views: readonly BufferView[], run: Run, what: string): number {
  const { offset, count, item, unit } = run;
  const view = index === undefined ? undefined : views[indexAt(index, views.length, `${what}.bufferView`)];
  if (!view || count === 0) return item;
  const stride = view.byteStride ?? item;
  if (stride * (count - 1) + offset + item > view.byteLength) {
    throw new Error(`${what} claims ${String(count)} elements, more than its buffer holds`);
  }
  // Typed arrays cannot read numbers across their own size.
  if (offset % unit !== 0 || stride % unit !== 0) {
    throw new Error(`${what} is not aligned: its byteOffset and byteStride must be multiples of ${String(unit)}`);
  }
  return stride;
}

interface Sparse {
  readonly count: number;
  readonly indices: JsonObject;
  readonly indexRun: Omit<Run, 'count'>;
  readonly values: JsonObject;
  readonly valueOffset: number;
}

function sparseOf(value: unknown, what: string): Sparse {
  const sparse = objectAt(value, `${what}.sparse`);
  const indices = objectAt(sparse['indices'], `${what}.sparse.indices`);
  const values = optionalObject(sparse['values'], `${what}.sparse.values`);
  const item = COMPONENT_BYTES.get(indices['componentType']);
  if (item === undefined || values['bufferView'] === undefined || indices['bufferView'] === undefined) {
    throw new Error(`${what}.sparse is incomplete`);
  }
  return {
    count: countAt(sparse['count'], `${what}.sparse.count`),
    indices,
    indexRun: { offset: countAt(indices['byteOffset'], `${what}.sparse`, 0), item, unit: item },
    values,
    valueOffset: countAt(values['byteOffset'], `${what}.sparse`, 0),
  };
}
