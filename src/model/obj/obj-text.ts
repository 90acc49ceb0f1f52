// Reads the text of an OBJ file: vertices, polygons as triangles, and which object and material each belongs to. Lines,
// points, curves and surfaces are skipped.
import { CORNER_LIMIT, PART_LIMIT } from '../limits.js';
import { ModelError } from '../model.js';
import type { Slices } from '../slices.js';
import { TextScanner } from '../text/text-scanner.js';
import { CornerLists, FACETED, NONE, setItem, UNSTATED } from '../triangles/corner-lists.js';
import { requirePolygon, Triangulator } from '../triangles/triangulate.js';

/** Consecutive triangles of one object with one material. */
export interface ObjRun {
  readonly object: string;
  readonly material: string;
  /** First corner. */
  readonly start: number;
  /** The corner after the last. */
  readonly end: number;
}

export interface ObjText {
  readonly lists: CornerLists;
  readonly runs: readonly ObjRun[];
  /** Material libraries, as they are named. */
  readonly libraries: readonly string[];
}

/**
 * Most changes of object or material: drawings of plants have tens of thousands of objects. More would block the page.
 */
const RUN_LIMIT = 2 ** 17;
/** Material libraries that are read. Files have one, seldom two. */
const LIBRARY_LIMIT = 16;
/** Lines between two looks at the clock, minus 1. */
const LINE_MASK = 0x3f;

const SLASH = 47;
const HASH = 35;

/** @throws Error that names the line, for broken text; ModelError `too-large`. */
export async function readObjText(bytes: Uint8Array, slices: Slices): Promise<ObjText> {
  const reader = new ObjReader(bytes);
  try {
    for (let line = 0; reader.readLine(); line += 1) {
      if ((line & LINE_MASK) === 0 && slices.due) await slices.pause();
    }
    return reader.finish();
  } catch (cause) {
    if (!(cause instanceof Error) || cause instanceof ModelError || cause.name === 'AbortError') throw cause;
    throw new Error(`line ${String(reader.line)}: ${cause.message}`, { cause });
  }
}

class ObjReader {
  readonly #scanner: TextScanner;
  readonly #lists = new CornerLists();
  readonly #triangulator = new Triangulator(this.#lists.places);
  readonly #runs: ObjRun[] = [];
  readonly #libraries: string[] = [];
  readonly #materials = new Set<string>();
  #begun = false;
  #lineStart = 0;
  #object = '';
  #group = '';
  #material = '';
  #smoothing = UNSTATED;
  /** First corner of the run. */
  #runStart = 0;
  /** The current polygon: position, texture coordinates and normal of each corner. */
  readonly #polygon: { readonly v: number[]; readonly t: number[]; readonly n: number[] } = {
    v: [],
    t: [],
    n: [],
  };
  /** The largest numbers used, and where. Lists may follow the polygons that use them. */
  readonly #highest = {
    v: { index: -1, at: 0 },
    t: { index: -1, at: 0 },
    n: { index: -1, at: 0 },
  };

  constructor(bytes: Uint8Array) {
    this.#scanner = new TextScanner(bytes);
  }

  /** For messages. */
  get line(): number {
    return this.#scanner.lineAt(this.#lineStart);
  }

  /** False at the end. */
  readLine(): boolean {
    const scanner = this.#scanner;
    if (!(this.#begun ? scanner.nextLine() : scanner.nextWord())) return false;
    this.#begun = true;
    this.#lineStart = scanner.at;
    if (scanner.peek() === HASH) return true;
    switch (scanner.word()) {
      case 'v':
        this.#vertex();
        break;
      case 'vn':
        this.#lists.pushNormal(scanner.number(), scanner.number(), scanner.number());
        break;
      case 'vt':
        this.#textureCoordinates();
        break;
      case 'f':
      case 'fo': // an older spelling
        this.#face();
        break;
      case 'o':
        this.#endRun();
        this.#object = scanner.rest(NAME_LENGTH);
        break;
      case 'g':
        this.#endRun();
        this.#group = scanner.rest(NAME_LENGTH);
        break;
      case 'usemtl':
        this.#endRun();
        this.#material = scanner.rest(NAME_LENGTH);
        break;
      case 's':
        this.#smoothing = smoothingOf(scanner.word());
        break;
      case 'mtllib':
        this.#libraryNames(scanner.rest());
        break;
    }
    return true;
  }

  finish(): ObjText {
    this.#endRun();
    const lists = this.#lists;
    const counts = { v: lists.places.count, t: lists.uvs.length / 2, n: lists.normals.length / 3 };
    for (const [kind, what] of KINDS) {
      const { index, at } = this.#highest[kind];
      if (index < counts[kind]) continue;
      this.#lineStart = at;
      throw new Error(
        `it refers to ${what} ${String(index + 1)}, but there are only ${String(counts[kind])}`,
      );
    }
    return { lists, runs: this.#runs, libraries: this.#libraries };
  }

  #vertex(): void {
    const scanner = this.#scanner;
    const { places, colors } = this.#lists;
    places.push(scanner.requiredNumber(), scanner.requiredNumber(), scanner.requiredNumber());
    if (scanner.atLineEnd()) {
      if (colors.length > 0) pushColor(colors, 1, 1, 1);
      return;
    }
    // Four numbers are x y z w, and w matters to curves only. Six are x y z r g b.
    const red = scanner.number();
    const green = scanner.number();
    const blue = scanner.number();
    if (Number.isNaN(blue)) {
      if (colors.length > 0) pushColor(colors, 1, 1, 1);
      return;
    }
    // Vertices before the first coloured one are white.
    while (colors.length < 3 * (places.count - 1)) pushColor(colors, 1, 1, 1);
    pushColor(colors, red, green, blue);
  }

  #textureCoordinates(): void {
    const { uvs } = this.#lists;
    const u = this.#scanner.number();
    const v = this.#scanner.number();
    uvs.push(Number.isFinite(u) ? u : 0);
    // In OBJ the last row of an image is at v = 0.
    uvs.push(Number.isFinite(v) ? 1 - v : 1);
  }

  #face(): void {
    const scanner = this.#scanner;
    const { v, t, n } = this.#polygon;
    v.length = t.length = n.length = 0;
    const lists = this.#lists;
    while (!scanner.atLineEnd() && scanner.peek() !== HASH) {
      requirePolygon(v.length);
      v.push(this.#index('v', lists.places.count));
      const slash = scanner.take(SLASH);
      t.push(slash && !this.#endsHere ? this.#index('t', lists.uvs.length / 2) : NONE);
      n.push(slash && scanner.take(SLASH) ? this.#index('n', lists.normals.length / 3) : NONE);
      if (!scanner.atBreak) throw new Error('a corner of a face is not written as v, v/vt, v//vn or v/vt/vn');
    }
    if (v.length < 3) return; // a point or a line
    if (lists.corners.length + 3 * (v.length - 2) > CORNER_LIMIT) {
      const most = CORNER_LIMIT.toLocaleString('en');
      throw new ModelError('too-large', `The model has more than ${most} triangle corners.`);
    }
    this.#triangulator.cut(v, this.#emit);
  }

  readonly #emit = (a: number, b: number, c: number): void => {
    const { v, t, n } = this.#polygon;
    const lists = this.#lists;
    if (this.#smoothing !== UNSTATED) setItem(lists.groups, lists.triangles, this.#smoothing);
    for (const i of [a, b, c]) {
      const corner = lists.corners.length;
      lists.corners.push(v[i] ?? 0);
      setItem(lists.cornerUvs, corner, t[i] ?? NONE);
      setItem(lists.cornerNormals, corner, n[i] ?? NONE);
    }
  };

  /** In `v//vn` the second slash follows at once. */
  get #endsHere(): boolean {
    return this.#scanner.nextIs(SLASH) || this.#scanner.atBreak;
  }

  /** A reference, counted from 0. Negative ones in the file count back from the last item. */
  #index(kind: 'v' | 't' | 'n', count: number): number {
    const written = this.#scanner.integerHere();
    if (Number.isNaN(written)) throw new Error(`${this.#scanner.quotedWord()} is not a corner of a face`);
    const index = written > 0 ? written - 1 : count + written;
    if (!(written !== 0 && index >= 0 && index < CORNER_LIMIT)) {
      throw new Error(`a corner of a face refers to something that is not there`);
    }
    const highest = this.#highest[kind];
    if (index > highest.index) {
      highest.index = index;
      highest.at = this.#lineStart;
    }
    return index;
  }

  /** Names that end in .mtl, apart by blanks, which they may also contain. */
  #libraryNames(text: string): void {
    for (const written of text.split(/(?<=\.mtl)\s+/i)) {
      const name = written.replace(/\\/g, '/');
      if (name !== '' && !this.#libraries.includes(name) && this.#libraries.length < LIBRARY_LIMIT) {
        this.#libraries.push(name);
      }
    }
  }

  #endRun(): void {
    const end = this.#lists.corners.length;
    if (end > this.#runStart) {
      if (this.#runs.length >= RUN_LIMIT) {
        throw new ModelError(
          'too-large',
          `The model changes its object or material more than ${RUN_LIMIT.toLocaleString('en')} times.`,
        );
      }
      this.#materials.add(this.#material);
      // At least one draw each.
      if (this.#materials.size > PART_LIMIT) {
        throw new ModelError(
          'too-large',
          `The model has more than ${PART_LIMIT.toLocaleString('en')} materials.`,
        );
      }
      const object = this.#object === '' ? this.#group : this.#object;
      this.#runs.push({ object, material: this.#material, start: this.#runStart, end });
    }
    this.#runStart = end;
  }
}

const KINDS = [
  ['v', 'vertex'],
  ['t', 'texture coordinate'],
  ['n', 'normal'],
] as const;

/** Longest name of an object or material in bytes. */
const NAME_LENGTH = 256;

function smoothingOf(word: string): number {
  const group = Number(word);
  // `off`, `0` and anything that is not a number mean no group.
  return Number.isInteger(group) && group > 0 && group <= 0x7fffffff ? group : FACETED;
}

function pushColor(
  colors: { push: (value: number) => void },
  ...channels: readonly [r: number, g: number, b: number]
): void {
  for (const value of channels) colors.push(value > 0 ? Math.min(value, 1) : 0);
}
