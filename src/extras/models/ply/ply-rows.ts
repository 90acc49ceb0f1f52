// Reads the rows of a PLY file's elements into lists: a vertex, a face or strips of triangles each.
import { clip } from '../../../phong/fields/clip.js';
import type { LeftOut } from '../left-out.js';
import { LIMITS } from '../../../phong/model/limits.js';
import type { Slices } from '../slices.js';
import { TextScanner } from '../text/text-scanner.js';
import {
  CornerLists,
  FULL,
  fullOf,
  type Growing,
  NOT_THERE,
  pushColor,
  toFractions,
  UNSTATED,
  wrongCoordinate,
} from '../triangles/corner-lists.js';
import { Polygons } from '../triangles/triangulate.js';
import {
  countOf,
  type PlyElement,
  type PlyHeader,
  type PlyProperty,
  type PlyType,
} from './ply-header.js';

/**
 * @param byLines whether each row of a text is a line, and may have more values than its header
 * names.
 * @throws Error for broken data; ModelError `too-large`.
 */
export async function readRows(
  bytes: Uint8Array<ArrayBuffer>,
  { encoding, elements, end }: PlyHeader,
  byLines: boolean,
  leftOut: LeftOut,
  slices: Slices,
): Promise<CornerLists> {
  const values =
    encoding === 'text'
      ? new TextValues(bytes, end, byLines)
      : new BinaryValues(bytes, end, encoding === 'little-endian');
  const rows = new PlyRows(elements, values, leftOut, slices);
  for (const element of elements) {
    if (element.properties.length > 0) {
      await rows.read(element);
    }
  }
  return rows.finish();
}

/**
 * The numbers of a row that are used, by property in any spelling. x y z come first, then the
 * normal, then the colour.
 */
const SLOTS: ReadonlyMap<string, number> = new Map(
  [
    ['x', 'px', 'posx'],
    ['y', 'py', 'posy'],
    ['z', 'pz', 'posz'],
    ['nx', 'normalx'],
    ['ny', 'normaly'],
    ['nz', 'normalz'],
    ['red', 'r', 'diffuse_red', 'diffuse_r'],
    ['green', 'g', 'diffuse_green', 'diffuse_g'],
    ['blue', 'b', 'diffuse_blue', 'diffuse_b'],
    ['alpha', 'a'],
  ].flatMap((names, slot) => names.map((name) => [name, slot] as const)),
);
const [PLACE, NORMAL, COLOR, ALPHA, UNUSED] = [0, 3, 6, 9, 10] as const;

const slotOf = (name: string) => SLOTS.get(name.toLowerCase());

/** Most items of a list that are read at once. */
const ITEMS_AT_ONCE = 256;

type Row = Float64Array;

/** What becomes of the rows of an element. Whatever else they have is skipped. */
interface RowTaker {
  /** Name of the list of vertices. */
  readonly list?: RegExp;
  readonly begin?: () => void;
  readonly item?: (value: number) => void;
  readonly endList?: () => void;
  readonly end?: () => void;
}

interface Column extends Omit<PlyProperty, 'name'> {
  readonly slot: number;
  /** What its numbers are divided by. */
  readonly full: number;
  /** Whether it is the list of vertices. */
  readonly taken: boolean;
}

class PlyRows {
  readonly #values: PlyValues;
  readonly #leftOut: LeftOut;
  readonly #slices: Slices;
  readonly #lists: CornerLists;
  readonly #polygons: Polygons;
  readonly #ofVertices: Colors;
  readonly #ofFaces: Colors;
  /** Position and steps that were counted as work. */
  #at = 0;
  #steps = 0;
  /** Where a row was left: its property, and the items of that list that are still to be read. */
  #column = 0;
  #left = 0;

  constructor(
    elements: readonly PlyElement[],
    values: PlyValues,
    leftOut: LeftOut,
    slices: Slices,
  ) {
    this.#values = values;
    this.#leftOut = leftOut;
    this.#slices = slices;
    this.#lists = new CornerLists(countOf(elements, 'vertex'), countOf(elements, 'face'));
    this.#polygons = new Polygons(this.#lists);
    this.#ofVertices = new Colors(this.#lists.colors, 0);
    this.#ofFaces = new Colors(this.#lists.faceColors, 1);
  }

  async read(element: PlyElement): Promise<void> {
    const slices = this.#slices;
    const row: Row = new Float64Array(UNUSED + 1);
    row[ALPHA] = 1;
    const taker = this.#takerOf(element, row);
    const columns = element.properties.map(({ name, type, countType }) => {
      const slot = slotOf(name) ?? UNUSED;
      if (slot === UNUSED && /colou?r/i.test(name)) {
        this.#leftOut.feature(`the property ${clip(name, 40)}`);
      }
      return {
        type,
        countType,
        slot,
        full: slot < COLOR ? 1 : type.full,
        taken: taker.list?.test(name) === true,
      };
    });
    if (taker.list && !columns.some(({ taken }) => taken)) {
      throw new Error('its faces have no list vertex_indices');
    }
    for (let i = 0; i < element.count;) {
      if (this.#readPiece(columns, row, taker)) {
        i += 1;
      }
      if (this.#took()) {
        await slices.pause();
      }
    }
  }

  /** Reads a row, or a part of one with long lists. Whether that was its end. */
  #readPiece(columns: readonly Column[], row: Row, taker: RowTaker): boolean {
    const values = this.#values;
    if (this.#column === 0 && this.#left === 0) {
      if (!values.beginRow()) return false;
      taker.begin?.();
    }
    while (this.#column < columns.length) {
      const { type, countType, slot, full, taken } = columns[this.#column]!;
      if (countType === null) {
        const value = values.next(type);
        row[slot] = full === 1 ? value : Math.min(value / full, 1);
        if (slot < NORMAL && Number.isNaN(value)) {
          this.#leftOut.because('vertex', () => values.problem());
        }
      } else {
        const left = this.#left > 0 ? this.#left : this.#listLength(countType);
        const end = Math.max(0, left - ITEMS_AT_ONCE);
        for (let i = end; i < left; i += 1) {
          const value = values.next(type);
          if (taken) {
            taker.item?.(value);
          }
        }
        this.#left = end;
        if (end > 0) return false;
        if (taken) {
          taker.endList?.();
        }
      }
      this.#column += 1;
    }
    this.#column = 0;
    taker.end?.();
    if (values.endRow()) {
      this.#leftOut.add('surplus');
    }
    return true;
  }

  /** Counts the work since the last call. */
  #took(): boolean {
    const { at } = this.#values;
    const { steps } = this.#polygons;
    const work = (at - this.#at) / 8 + (steps - this.#steps) / 16;
    this.#at = at;
    this.#steps = steps;
    return this.#slices.took(work);
  }

  async finish(): Promise<CornerLists> {
    this.#chooseColors();
    for (const { list, unit } of [this.#ofVertices, this.#ofFaces]) {
      await toFractions(list, this.#slices, unit);
    }
    const { highestVertex, places } = this.#lists;
    if (highestVertex >= places.count) {
      this.#leftOut.because(
        'face',
        () => `a face refers to vertex ${String(highestVertex)} of ${String(places.count)}`,
      );
    }
    return this.#lists;
  }

  #takerOf({ name, count, properties }: PlyElement, row: Row): RowTaker {
    const found = new Set(
      properties.map((property) => (property.countType === null ? slotOf(property.name) : -1)),
    );
    const has = (first: number) => [0, 1, 2].every((i) => found.has(first + i));
    const unit = properties.find((property) => slotOf(property.name) === COLOR)?.type.full;
    if (name === 'vertex') {
      if (!has(PLACE)) throw new Error('its vertices have no x, y and z');
      this.#ofVertices.unit = unit;
      return this.#vertices(row, has(NORMAL), has(COLOR));
    }
    if (name === 'face') {
      this.#ofFaces.unit = unit;
      return this.#faces(row, has(COLOR));
    }
    if (name === 'tristrips') return this.#strips();
    if (count > 0) {
      this.#leftOut.feature(`the element ${clip(name, 40)}`);
    }
    return {};
  }

  #vertices(row: Row, withNormals: boolean, withColors: boolean): RowTaker {
    const { places } = this.#lists;
    const end = (): void => {
      const [x, y, z] = [row[0]!, row[1]!, row[2]!];
      if (!places.push(x, y, z)) {
        this.#leftOut.add('vertex');
        this.#leftOut.because('vertex', () => wrongCoordinate(x, y, z));
      }
      if (withNormals) {
        this.#lists.pushNormal(row[NORMAL]!, row[NORMAL + 1]!, row[NORMAL + 2]!);
      }
      if (withColors) {
        this.#ofVertices.push(row);
      }
    };
    return { end };
  }

  #faces(row: Row, withColors: boolean): RowTaker {
    const colors = this.#ofFaces;
    const polygons = this.#polygons;
    return {
      list: /^vert(ex|ices)?_?ind(ices|ex)$/i,
      begin: () => polygons.begin(UNSTATED, withColors ? colors.list.length / 3 : 0),
      item: (value) => polygons.add(this.#vertexOf(value)),
      endList: () => polygons.end(),
      ...(withColors && { end: () => colors.push(row) }),
    };
  }

  /**
   * Each vertex makes a triangle with the two before it, every second one turned around; -1 begins
   * a new strip.
   */
  #strips(): RowTaker {
    const lists = this.#lists;
    let length = 0;
    let before = 0;
    let last = 0;
    const item = (value: number): void => {
      if (value === -1) {
        length = 0;
        return;
      }
      const next = this.#vertexOf(value);
      if (length >= 2) {
        const even = length % 2 === 0;
        lists.beginTriangle(false);
        lists.pushCorner(even ? before : last);
        lists.pushCorner(even ? last : before);
        lists.pushCorner(next);
      }
      before = last;
      last = next;
      length += 1;
    };
    return { list: /^vertex_indices$/, item, endList: () => (length = 0) };
  }

  /** The vertex with this number, which may come later. */
  #vertexOf(value: number): number {
    if (Number.isInteger(value) && value >= 0 && value < LIMITS.corners) {
      return value;
    }
    this.#leftOut.because('face', () => `a face refers to the vertex ${String(value)}`);
    return NOT_THERE;
  }

  #listLength(type: PlyType): number {
    const count = this.#values.next(type);
    if (Number.isNaN(count)) throw new Error(this.#values.problem());
    if (Number.isInteger(count) && count >= 0) return count;
    throw new Error('a list has no length');
  }

  /**
   * A geometry has one kind of colours: those of faces, unless those of vertices say more, as in
   * other viewers.
   */
  #chooseColors() {
    const [ofVertices, ofFaces] = [this.#ofVertices, this.#ofFaces];
    const both = ofVertices.count > 0 && ofFaces.count > 0;
    const byFace = ofFaces.count > 0 && !(both && ofVertices.differ);
    if (both) {
      this.#leftOut.feature(byFace ? 'the colours of its vertices' : 'the colours of its faces');
    }
    if (!byFace) {
      this.#lists.faceColors.length = this.#lists.triangleColors.length = 0;
    }
    if ((byFace ? ofFaces : ofVertices).hasAlpha) {
      this.#leftOut.feature('alpha');
    }
  }
}

/** Colours of vertices or of faces. */
class Colors {
  readonly list: Growing<Float32Array>;
  /** What they were divided by. */
  unit: number | undefined;
  /** Whether they are not all the same. */
  differ = false;
  readonly #first: number;
  #leastAlpha = Infinity;
  #mostAlpha = 0;

  /** @param first number of the first one in the list; white ones come before it. */
  constructor(list: Growing<Float32Array>, first: number) {
    this.list = list;
    this.#first = 3 * first;
    list.fillTo(this.#first, FULL);
  }

  get count() {
    return (this.list.length - this.#first) / 3;
  }

  get hasAlpha() {
    return this.#leastAlpha < fullOf(this.#mostAlpha, this.unit);
  }

  push(row: Row): void {
    const { list } = this;
    pushColor(list, row[COLOR]!, row[COLOR + 1]!, row[COLOR + 2]!);
    for (let c = 0; c < 3; c += 1) {
      this.differ ||= list.array[this.#first + c] !== list.array[list.length - 3 + c];
    }
    this.#leastAlpha = Math.min(this.#leastAlpha, row[ALPHA]!);
    this.#mostAlpha = Math.max(this.#mostAlpha, row[ALPHA]!);
  }
}

/** The values after a header, one after another, text or binary of either byte order. */
interface PlyValues {
  /** Position of the next byte. */
  readonly at: number;
  /**
   * Goes to the next row. False where it is not there yet: call again. @throws Error at the end of
   * the file.
   */
  beginRow(): boolean;
  /** Whether values are left that no property names. */
  endRow(): boolean;
  /**
   * @throws Error at the end of the file, or of the row if rows are lines. Text that is no number
   * is NaN.
   */
  next(type: PlyType): number;
  /** Why the last value is no number, in words. */
  problem(): string;
}

const truncated = () => new Error('it is truncated: it ends before its last value');

/** `c` and `#`: no number begins with them. */
const COMMENTS: ReadonlySet<number> = new Set([0x63, 0x23]);

class TextValues implements PlyValues {
  readonly #scanner: TextScanner;
  readonly #byLines: boolean;
  #begun = false;

  constructor(bytes: Uint8Array, start: number, byLines: boolean) {
    this.#scanner = new TextScanner(bytes, start);
    this.#byLines = byLines;
  }

  get at() {
    return this.#scanner.at;
  }

  beginRow() {
    if (!this.#byLines) return true;
    const scanner = this.#scanner;
    if (!(this.#begun ? scanner.nextLine() : scanner.nextWord())) throw truncated();
    this.#begun = true;
    return !scanner.atLineEnd() && !COMMENTS.has(scanner.peek());
  }

  endRow() {
    return this.#byLines && !this.#scanner.atLineEnd();
  }

  next() {
    const scanner = this.#scanner;
    if (this.#byLines ? scanner.atLineEnd() : !scanner.nextWord()) throw truncated();
    return scanner.number();
  }

  problem() {
    return `${this.#scanner.quotedWord()} is not a number`;
  }
}

class BinaryValues implements PlyValues {
  readonly #view: DataView;
  readonly #little: boolean;
  at: number;

  constructor(bytes: Uint8Array<ArrayBuffer>, start: number, little: boolean) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.#little = little;
    this.at = start;
  }

  readonly beginRow = () => true;
  readonly endRow = () => false;
  readonly problem = () => 'a value is not a number';

  /** In one function: one for each kind would return every number in an object of its own. */
  next({ kind, bytes }: PlyType) {
    const view = this.#view;
    const little = this.#little;
    const { at } = this;
    this.at += bytes;
    if (this.at > view.byteLength) throw truncated();
    switch (kind) {
      case 'int8':
        return view.getInt8(at);
      case 'uint8':
        return view.getUint8(at);
      case 'int16':
        return view.getInt16(at, little);
      case 'uint16':
        return view.getUint16(at, little);
      case 'int32':
        return view.getInt32(at, little);
      case 'uint32':
        return view.getUint32(at, little);
      case 'float32':
        return view.getFloat32(at, little);
      case 'float64':
        return view.getFloat64(at, little);
    }
  }
}
