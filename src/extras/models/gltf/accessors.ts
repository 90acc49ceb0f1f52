// The accessors and buffer views of a glTF document, checked before anything is allocated. Knows
// the JSON only.
import type { ModelBudget } from '../../../phong/model/model-budget.js';
import type { Slices } from '../slices.js';
import {
  countAt,
  indexAt,
  objectAt,
  objectsAt,
  optionalObject,
  textAt,
  type JsonObject,
} from './json.js';

export interface BufferView {
  readonly buffer: number;
  readonly byteOffset: number;
  readonly byteLength: number;
  readonly byteStride: number | undefined;
  /** Null if its bytes are not compressed. */
  readonly meshopt: MeshoptView | null;
  /** Where a view is made of a part of these bytes: its elements, one behind another. */
  readonly elements?: Run & { readonly stride: number };
}

/** What the document says about numbers. Only {@link Accessors.read} gives access to them. */
export interface Accessor {
  readonly index: number;
  readonly count: number;
  /** Numbers per element. */
  readonly components: number;
}

/**
 * The accessors of a document. One that was not counted by {@link Accessors.read} has no elements
 * for the parser, which reads all of them, so no reader can get at numbers that the budget does not
 * know.
 */
export class Accessors {
  readonly #entries: readonly Entry[];
  readonly #budget: ModelBudget;
  /** With the view that stands for its own, if one does. */
  readonly #read = new Map<Entry, number | undefined>();

  constructor(entries: readonly Entry[], budget: ModelBudget) {
    this.#entries = entries;
    this.#budget = budget;
  }

  /** @param views gets one for each sparse accessor among others, which the parser cannot read. */
  static async of(
    json: JsonObject,
    views: BufferView[],
    budget: ModelBudget,
    slices: Slices,
  ): Promise<Accessors> {
    const definitions = objectsAt(json['accessors'], 'accessors');
    return new Accessors(
      await slices.map(definitions, (accessor, i) => entryOf(accessor, i, views)),
      budget,
    );
  }

  /** The accessor that a value in the document names. */
  at(value: unknown, what: string): Accessor {
    return this.#entries[indexAt(value, this.#entries.length, what)]!;
  }

  /**
   * Counts the memory that the elements take when they are read, once for all readers. A reader
   * that converts them counts its own copy.
   * @throws ModelError `too-large` past a limit, a plain Error if its views hold fewer bytes than
   * it claims.
   */
  read({ index }: Accessor): void {
    const entry = this.#entries[index]!;
    if (this.#read.has(entry)) return;
    const view = entry.requireBytes();
    this.#budget.add({ values: Math.ceil(entry.ownBytes / 4) });
    this.#read.set(entry, view);
  }

  /** For the parser. Call it when everything that is needed was read. */
  definitions(slices: Slices): Promise<readonly JsonObject[]> {
    return slices.map(this.#entries, (entry) => {
      // The parser looks up the types of attributes that Draco data hold.
      const { definition } = entry;
      if (!this.#read.has(entry)) {
        return { ...definition, count: 0, bufferView: undefined, sparse: undefined };
      }
      const bufferView = this.#read.get(entry);
      return bufferView === undefined ? definition : { ...definition, bufferView, byteOffset: 0 };
    });
  }
}

interface Entry extends Accessor {
  readonly definition: JsonObject;
  /** Throws if the views hold fewer bytes than claimed. Gives the view to read in its own's place. */
  readonly requireBytes: () => number | undefined;
  /**
   * Bytes that are allocated beside the copies of its views: zeros without a view, and sparse
   * values put in place.
   */
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
const COMPONENTS: ReadonlyMap<unknown, number> = new Map(
  Object.entries({ SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 }),
);

export function readBufferViews(
  json: JsonObject,
  buffers: number,
  slices: Slices,
): Promise<BufferView[]> {
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

function entryOf(accessor: JsonObject, index: number, views: BufferView[]): Entry {
  const what = `accessors[${String(index)}]`;
  const components = COMPONENTS.get(accessor['type']);
  const unit = COMPONENT_BYTES.get(accessor['componentType']);
  if (components === undefined || unit === undefined) {
    throw new Error(`${what} has an unknown type`);
  }
  const count = countAt(accessor['count'], `${what}.count`);
  const offset = countAt(accessor['byteOffset'], `${what}.byteOffset`, 0);
  const elements = { view: accessor['bufferView'], offset, count, item: components * unit, unit };
  const sparse =
    accessor['sparse'] === undefined ? null : sparseRuns(accessor['sparse'], elements, what);
  const requireBytes = (): number | undefined => {
    const stride = requireView(elements, views, what);
    for (const run of sparse ?? []) {
      requireView(run, views, what);
    }
    if (sparse === null || stride === elements.item) return undefined;
    const view = views[Number(elements.view)]!;
    return views.push({ ...view, byteStride: undefined, elements: { ...elements, stride } }) - 1;
  };
  return {
    index,
    // The parser warns about missing bounds; the box that it computes from them is not used.
    definition: { ...accessor, extras: undefined, name: undefined, min: ZERO, max: ZERO },
    count,
    components,
    requireBytes,
    ownBytes: elements.view === undefined || sparse !== null ? count * elements.item : 0,
  };
}

const ZERO = [0, 0, 0];

interface Run {
  /** Index of the buffer view, not yet checked; undefined for zeros. */
  readonly view: unknown;
  readonly offset: number;
  readonly count: number;
  /** Bytes of an element, and of one number in it. */
  readonly item: number;
  readonly unit: number;
}

/** Throws unless the view holds the run. Gives the distance of elements in bytes. */
function requireView(
  { view: index, offset, count, item, unit }: Run,
  views: readonly BufferView[],
  what: string,
): number {
  const view =
    index === undefined ? undefined : views[indexAt(index, views.length, `${what}.bufferView`)];
  if (!view || count === 0) return item;
  const stride = view.byteStride ?? item;
  if (stride * (count - 1) + offset + item > view.byteLength) {
    throw new Error(`${what} claims ${String(count)} elements, more than its buffer holds`);
  }
  // Typed arrays cannot read numbers across their own size.
  if (offset % unit !== 0 || stride % unit !== 0) {
    throw new Error(
      `${what} is not aligned: its byteOffset and byteStride must be multiples of ${String(unit)}`,
    );
  }
  return stride;
}

/** The indices and the values of a sparse accessor. */
function sparseRuns(value: unknown, elements: Run, what: string): readonly Run[] {
  const sparse = objectAt(value, `${what}.sparse`);
  const indices = objectAt(sparse['indices'], `${what}.sparse.indices`);
  const values = optionalObject(sparse['values'], `${what}.sparse.values`);
  const unit = COMPONENT_BYTES.get(indices['componentType']);
  if (
    unit === undefined ||
    values['bufferView'] === undefined ||
    indices['bufferView'] === undefined
  ) {
    throw new Error(`${what}.sparse is incomplete`);
  }
  const count = countAt(sparse['count'], `${what}.sparse.count`);
  const offsetOf = (run: JsonObject) => countAt(run['byteOffset'], `${what}.sparse`, 0);
  return [
    { view: indices['bufferView'], offset: offsetOf(indices), count, item: unit, unit },
    { ...elements, view: values['bufferView'], offset: offsetOf(values), count },
  ];
}

/** The same data under two names; the second is the ratified one. */
const MESHOPT = ['EXT_meshopt_compression', 'KHR_meshopt_compression'] as const;

export interface MeshoptView {
  /** Where the compressed bytes are. */
  readonly buffer: number;
  readonly byteOffset: number;
  readonly byteLength: number;
  /** Elements, and bytes of each, once decoded. */
  readonly count: number;
  readonly stride: number;
  readonly mode: MeshoptMode;
  readonly filter: MeshoptFilter;
}

const MODES = ['ATTRIBUTES', 'TRIANGLES', 'INDICES'] as const;
const FILTERS = ['NONE', 'OCTAHEDRAL', 'QUATERNION', 'EXPONENTIAL', 'COLOR'] as const;

type MeshoptMode = (typeof MODES)[number];
type MeshoptFilter = (typeof FILTERS)[number];

/** Null if the view is not compressed. @throws Error for a claim that the decoder must not see. */
function readMeshoptView(view: JsonObject, buffers: number, what: string): MeshoptView | null {
  const extensions = optionalObject(view['extensions'], `${what}.extensions`);
  const name = MESHOPT.find((one) => one in extensions);
  if (name === undefined) return null;
  const packed = optionalObject(extensions[name], `${what}.${name}`);
  const mode = MODES.find((one) => one === packed['mode']);
  const filter = FILTERS.find((one) => one === (textAt(packed['filter']) || 'NONE'));
  const count = countAt(packed['count'], `${what}.count`);
  const stride = countAt(packed['byteStride'], `${what}.byteStride`);
  if (mode === undefined || filter === undefined) {
    throw new Error(`${what} has an unknown mode or filter`);
  }
  const fits =
    mode === 'ATTRIBUTES'
      ? stride % 4 === 0 && stride > 0 && stride <= 256
      : stride === 2 || stride === 4;
  const filtered = filter === 'NONE' || (mode === 'ATTRIBUTES' && filterFits(filter, stride));
  const whole = mode !== 'TRIANGLES' || count % 3 === 0;
  if (!fits || !filtered || !whole || count * stride !== view['byteLength']) {
    throw new Error(`${what} does not unpack to the bytes that it claims`);
  }
  return {
    buffer: indexAt(packed['buffer'], buffers, `${what}.buffer`),
    byteOffset: countAt(packed['byteOffset'], `${what}.byteOffset`, 0),
    byteLength: countAt(packed['byteLength'], `${what}.byteLength`),
    count,
    stride,
    mode,
    filter,
  };
}

/** The strides that the decoder takes for a filter; it does not check them. */
function filterFits(filter: MeshoptFilter, stride: number): boolean {
  if (filter === 'QUATERNION') return stride === 8;
  return filter === 'EXPONENTIAL' || stride === 4 || stride === 8;
}
