// Reads the rows of a PLY file's elements into lists: a vertex, a face or strips of triangles each. Lists of millions
// of items are read in slices.
import { clip } from '../../fields/clip.js';
import type { LeftOut } from '../left-out.js';
import { CORNER_LIMIT } from '../limits.js';
import type { Slices } from '../slices.js';
import { CornerLists, type Growing, NONE, NOT_THERE, UNSTATED, wrongCoordinate } from '../triangles/corner-lists.js';
import { Polygons } from '../triangles/triangulate.js';
import { countOf, type PlyElement, type PlyHeader, type PlyProperty, type PlyType } from './ply-header.js';
import type { PlyValues } from './ply-values.js';

/** @throws Error for broken data; ModelError `too-large`. */
export async function readRows(
  header: PlyHeader,
  values: PlyValues,
  leftOut: LeftOut,
  slices: Slices,
): Promise<CornerLists> {
  const lists = new CornerLists(countOf(header.elements, 'vertex'), countOf(header.elements, 'face'));
  const polygons = new Polygons(lists);
  const ofVertices = new Colors(lists.colors, 0);
  const ofFaces = new Colors(lists.faceColors, 1);
  const file: PlyFile = { values, leftOut, slices, lists, polygons, ofVertices, ofFaces, highestVertex: -1 };
  for (const element of header.elements) {
    if (element.properties.length === 0) continue;
    await readElement(element, file, (READERS.get(element.name) ?? skipping)(element, file));
  }
  chooseColors(file);
  const { highestVertex } = file;
  const { count } = lists.places;
  if (highestVertex >= count)
    leftOut.because('face', `a face refers to vertex ${String(highestVertex)} of ${String(count)}`);
  return lists;
}

interface PlyFile {
  readonly values: PlyValues;
  readonly leftOut: LeftOut;
  readonly slices: Slices;
  readonly lists: CornerLists;
  readonly polygons: Polygons;
  readonly ofVertices: Colors;
  readonly ofFaces: Colors;
  /** The largest number of a vertex that a face refers to. */
  highestVertex: number;
}

/** Reads one property of a row. Null, or for a long list a promise. */
type Column = () => Promise<void> | null;

interface RowReader {
  readonly begin?: () => void;
  readonly columns: readonly Column[];
  /** What follows after the last property. */
  readonly end?: () => void;
}

type MakeReader = (element: PlyElement, file: PlyFile) => RowReader;

async function readElement(element: PlyElement, file: PlyFile, row: RowReader): Promise<void> {
  const { values, leftOut, slices, polygons } = file;
  for (let i = 0; i < element.count;) {
    const { at } = values;
    const { steps } = polygons;
    if (values.beginRow()) {
      row.begin?.();
      for (const column of row.columns) {
        const longList = column();
        if (longList) await longList;
      }
      row.end?.();
      if (values.endRow()) leftOut.add('surplus');
      i += 1;
    }
    if (slices.took((values.at - at) / 8 + (polygons.steps - steps) / 16)) await slices.pause();
  }
}

const READERS: ReadonlyMap<string, MakeReader> = new Map([
  ['vertex', vertexReader],
  ['face', faceReader],
  ['tristrips', ({ properties }, file) => ({ columns: columnsOf(properties, file, stripTaker(file)) })],
]);

const skipping: MakeReader = ({ name, properties, count }, file) => {
  if (count > 0) file.leftOut.feature(`the element ${clip(name, 40)}`);
  return { columns: columnsOf(properties, file) };
};

/** What takes the items of a list of vertices: each in turn, then its end. */
interface ListTaker {
  readonly lists: RegExp;
  item(value: number): void;
  end(): void;
}

/** What takes a number: at once. */
type NumberTaker = (value: number) => void;

/** Properties that nothing takes are skipped. */
function columnsOf(
  properties: readonly PlyProperty[],
  file: PlyFile,
  vertices: ListTaker | null = null,
  takerOf: (property: PlyProperty) => NumberTaker | null = () => null,
): readonly Column[] {
  const { values } = file;
  return properties.map((property) => {
    const { name, type, countType } = property;
    if (countType !== null)
      return listColumn(type, countType, file, vertices?.lists.test(name) === true ? vertices : null);
    const take = takerOf(property);
    return () => {
      const value = values.next(type);
      take?.(value);
      return null;
    };
  });
}

/** Longest list that is read at once. */
const SHORT_LIST = 256;

function listColumn(type: PlyType, countType: PlyType, { values, slices }: PlyFile, taker: ListTaker | null): Column {
  const read = (most: number): number => {
    if (taker === null) return values.skip(type, most);
    taker.item(values.next(type));
    return 1;
  };
  const readLong = async (count: number): Promise<void> => {
    for (let i = 0; i < count;) {
      const { at } = values;
      i += read(count - i);
      if (slices.took(1 / 8 + (values.at - at) / 8)) await slices.pause();
    }
    taker?.end();
  };
  return () => {
    const count = values.next(countType);
    if (Number.isNaN(count)) throw new Error(values.problem());
    if (!(Number.isInteger(count) && count >= 0)) throw new Error('a list has no length');
    if (count > SHORT_LIST) return readLong(count);
    for (let i = 0; i < count;) i += read(count - i);
    taker?.end();
    return null;
  };
}

type Slot = 'x' | 'y' | 'z' | 'nx' | 'ny' | 'nz' | ColorSlot;
type ColorSlot = 'red' | 'green' | 'blue' | 'alpha';

const SLOTS: ReadonlyMap<string, Slot> = new Map([
  ...(['x', 'y', 'z', 'nx', 'ny', 'nz', 'red', 'green', 'blue', 'alpha'] as const).map((name) => [name, name] as const),
  ['r', 'red'],
  ['g', 'green'],
  ['b', 'blue'],
  ['a', 'alpha'],
  ['diffuse_red', 'red'],
  ['diffuse_green', 'green'],
  ['diffuse_blue', 'blue'],
]);

/** The numbers of the current row, and which of them it has. */
class RowValues {
  readonly values: Record<Slot, number> = { x: 0, y: 0, z: 0, nx: 0, ny: 0, nz: 0, red: 0, green: 0, blue: 0, alpha: 1 }; // prettier-ignore
  readonly #found = new Set<Slot>();

  has(...slots: readonly Slot[]): boolean {
    return slots.every((slot) => this.#found.has(slot));
  }

  /** @param check called where a coordinate of a position is no number. */
  takerOf({ name, type }: PlyProperty, check: () => void = () => undefined): NumberTaker | null {
    const slot = SLOTS.get(name);
    if (slot === undefined) return null;
    this.#found.add(slot);
    const full = COLOR_SLOTS.has(slot) ? type.full : 1;
    const isPlace = slot === 'x' || slot === 'y' || slot === 'z';
    const { values } = this;
    return (value) => {
      values[slot] = value / full;
      if (isPlace && Number.isNaN(value)) check();
    };
  }
}

const COLOR_SLOTS: ReadonlySet<Slot> = new Set(['red', 'green', 'blue', 'alpha']);

const clamped = (value: number): number => (value > 0 ? Math.min(value, 1) : 0);

/** Colours of vertices or of faces. */
class Colors {
  readonly list: Growing<Float32Array>;
  /** Whether they are not all the same. */
  differ = false;
  hasAlpha = false;
  readonly #first: number;

  /** @param first number of the first one in the list. */
  constructor(list: Growing<Float32Array>, first: number) {
    this.list = list;
    this.#first = 3 * first;
    for (let i = 0; i < this.#first; i += 1) list.push(1);
  }

  get count(): number {
    return (this.list.length - this.#first) / 3;
  }

  push({ values }: RowValues): void {
    const { list } = this;
    for (const slot of ['red', 'green', 'blue'] as const) {
      const { length } = list;
      list.push(clamped(values[slot]));
      this.differ ||= list.array[this.#first + (length % 3)] !== list.array[length];
    }
    this.hasAlpha ||= values.alpha < 1;
  }
}

/** A geometry has one kind of colours: those of faces, unless those of vertices say more, as in other viewers. */
function chooseColors({ ofVertices, ofFaces, lists, leftOut }: PlyFile): void {
  const both = ofVertices.count > 0 && ofFaces.count > 0;
  const byFace = ofFaces.count > 0 && !(both && ofVertices.differ);
  if (both) leftOut.feature(byFace ? 'the colours of its vertices' : 'the colours of its faces');
  if (!byFace) lists.faceColors.length = lists.triangleColors.length = 0;
  if ((byFace ? ofFaces : ofVertices).hasAlpha) leftOut.feature('alpha');
}

function vertexReader({ properties }: PlyElement, file: PlyFile): RowReader {
  const { values, leftOut, lists } = file;
  const row = new RowValues();
  const check = (): void => {
    if (!leftOut.hasReason('vertex')) leftOut.because('vertex', values.problem());
  };
  const columns = columnsOf(properties, file, null, (property) => row.takerOf(property, check));
  if (!row.has('x', 'y', 'z')) throw new Error('its vertices have no x, y and z');
  const withNormals = row.has('nx', 'ny', 'nz');
  const withColors = row.has('red', 'green', 'blue');
  const end = (): void => {
    const { x, y, z, nx, ny, nz } = row.values;
    if (!lists.places.push(x, y, z)) {
      leftOut.add('vertex');
      leftOut.because('vertex', wrongCoordinate(x, y, z));
    }
    if (withNormals) lists.pushNormal(nx, ny, nz);
    if (withColors) file.ofVertices.push(row);
  };
  return { columns, end };
}

function faceReader({ properties }: PlyElement, file: PlyFile): RowReader {
  const { polygons, ofFaces } = file;
  const row = new RowValues();
  const taker: ListTaker = {
    lists: /^vertex_ind(ices|ex)$/,
    item: (value) => polygons.add(vertexOf(value, file)),
    end: () => polygons.end(),
  };
  const columns = columnsOf(properties, file, taker, (property) => row.takerOf(property));
  const withColors = row.has('red', 'green', 'blue');
  const begin = (): void => polygons.begin(UNSTATED, withColors ? ofFaces.list.length / 3 : NONE);
  const end = (): void => {
    if (withColors) ofFaces.push(row);
  };
  return { begin, columns, end };
}

/** Each vertex makes a triangle with the two before it, every second one turned around; -1 begins a new strip. */
function stripTaker(file: PlyFile): ListTaker {
  const { lists } = file;
  let length = 0;
  let before = 0;
  let last = 0;
  return {
    lists: /^vertex_indices$/,
    item: (value) => {
      if (value === -1) {
        length = 0;
        return;
      }
      const vertex = vertexOf(value, file);
      if (length >= 2) {
        const even = length % 2 === 0;
        lists.beginTriangle(false);
        lists.pushCorner(even ? before : last);
        lists.pushCorner(even ? last : before);
        lists.pushCorner(vertex);
      }
      before = last;
      last = vertex;
      length += 1;
    },
    end: () => (length = 0),
  };
}

/** The vertex with this number, which may come later. */
function vertexOf(value: number, file: PlyFile): number {
  const { leftOut } = file;
  if (Number.isInteger(value) && value >= 0 && value < CORNER_LIMIT) {
    file.highestVertex = Math.max(file.highestVertex, value);
    return value;
  }
  if (!leftOut.hasReason('face')) leftOut.because('face', `a face refers to the vertex ${String(value)}`);
  return NOT_THERE;
}
