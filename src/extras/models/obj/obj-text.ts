// Reads the text of an OBJ file: vertices, polygons as triangles, and which object and material
// each belongs to. Lines, points, curves and surfaces are skipped, and so is a face that refers to
// what is not there.
import { requireAtMost } from '../../../phong/model/budget.js';
import { LIMITS } from '../../../phong/model/limits.js';
import type { LeftOut, LeftOutKind } from '../left-out.js';
import type { Slices } from '../slices.js';
import { NAME_LENGTH, TextScanner } from '../text/text-scanner.js';
import { unquoted } from './mtl.js';
import {
  CornerLists,
  FACETED,
  FULL,
  NONE,
  NOT_THERE,
  pushColor,
  toFractions,
  UNSTATED,
  wrongCoordinate,
} from '../triangles/corner-lists.js';
import type { CornerRange } from '../triangles/indexed-geometry.js';
import { keepSoundFaces } from '../triangles/sound-faces.js';
import { Polygons } from '../triangles/triangulate.js';

/** Consecutive triangles of one object with one material. */
export interface ObjRun extends CornerRange {
  readonly object: string;
  readonly material: string;
}

export interface ObjText {
  readonly lists: CornerLists;
  readonly runs: readonly ObjRun[];
  /** Paths of material libraries, each as it may be read: the likeliest first. */
  readonly libraries: readonly LibraryPaths[];
}

type LibraryPaths = readonly [string, ...string[]];

/**
 * Most changes of object or material: drawings of plants have tens of thousands. More would block
 * the page.
 */
const RUN_LIMIT = 2 ** 17;
/** Material libraries that are read. Files have one, seldom two. */
const LIBRARY_LIMIT = 16;
/** Most corners of a face, which are read in one task: 3 ms. */
const CORNER_LIMIT = 2 ** 16;

const SLASH = 47;
const HASH = 35;

/** @throws ModelError `too-large`. */
export async function readObjText(
  bytes: Uint8Array,
  leftOut: LeftOut,
  slices: Slices,
): Promise<ObjText> {
  const reader = new ObjReader(bytes, leftOut);
  while (reader.readLine()) {
    if (slices.took(reader.work)) {
      await slices.pause();
    }
  }
  const text = reader.finish();
  await toFractions(text.lists.colors, slices);
  await keepSoundFaces(text.lists, leftOut, slices);
  return text;
}

class ObjReader {
  readonly #scanner: TextScanner;
  readonly #leftOut: LeftOut;
  readonly #lists = new CornerLists();
  readonly #polygons = new Polygons(this.#lists);
  readonly #runs: ObjRun[] = [];
  readonly #libraries: LibraryPaths[] = [];
  readonly #materials = new Set<string>();
  #begun = false;
  /** What the last line took, as {@link Slices.took} counts it. */
  work = 0;
  /**
   * Names in force, or where they are: those without a face are not read. Millions of strings stop
   * the collector.
   */
  readonly #names: Record<'o' | 'g' | 'usemtl', string | number> = { o: '', g: '', usemtl: '' };
  #smoothing = UNSTATED;
  /** First corner of the run. */
  #runStart = 0;
  /** The largest numbers used. Lists may follow the polygons that use them. */
  readonly #highest = { face: -1, uv: -1, normal: -1 };

  constructor(bytes: Uint8Array, leftOut: LeftOut) {
    this.#scanner = new TextScanner(bytes, 0, true);
    this.#leftOut = leftOut;
  }

  /** False at the end. */
  readLine(): boolean {
    const { at } = this.#scanner;
    const { steps } = this.#polygons;
    const more = this.#begun ? this.#scanner.nextLine() : this.#scanner.nextWord();
    this.#begun = true;
    if (more) {
      this.#statement();
    }
    this.work = (this.#scanner.at - at) / 8 + (this.#polygons.steps - steps) / 16;
    return more;
  }

  #statement() {
    const scanner = this.#scanner;
    if (scanner.peek() === HASH) return;
    const word = scanner.word().toLowerCase();
    switch (word) {
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
        this.#polygons.begin(this.#smoothing);
        this.#corners();
        break;
      case 'o':
      case 'g':
      case 'usemtl':
        this.#endRun();
        this.#names[word] = scanner.at;
        scanner.rest(0);
        break;
      case 's':
        this.#smoothing = smoothingOf(scanner.number());
        break;
      case 'mtllib':
        this.#nameLibraries(scanner.readings());
        break;
      default: {
        const kind = LEFT_OUT.get(word);
        if (kind !== undefined) {
          this.#leftOut.add(kind);
        }
      }
    }
  }

  finish(): ObjText {
    this.#endRun();
    const lists = this.#lists;
    const counts = {
      face: lists.places.count,
      uv: lists.uvs.length / 2,
      normal: lists.normals.length / 3,
    };
    for (const [kind, what] of KINDS) {
      const index = this.#highest[kind];
      if (index < counts[kind]) continue;
      const reason = `it refers to ${what} ${String(index + 1)}, but there are only ${String(counts[kind])}`;
      this.#leftOut.because(kind, () => reason);
    }
    return { lists, runs: this.#runs, libraries: this.#libraries };
  }

  #vertex() {
    const scanner = this.#scanner;
    const { places, colors } = this.#lists;
    const start = scanner.at;
    const [x, y, z] = [scanner.number(), scanner.number(), scanner.number()];
    if (!places.push(x, y, z)) {
      this.#leftOut.add('vertex');
      this.#leftOut.because(
        'vertex',
        () => scanner.problemOf(start, 3) ?? wrongCoordinate(x, y, z),
      );
    }
    // Four numbers are x y z w, and w matters to curves only. Six are x y z r g b.
    const [red, green, blue] = [scanner.number(), scanner.number(), scanner.number()];
    if (Number.isNaN(blue)) {
      if (colors.length > 0) {
        colors.fillTo(3 * places.count, FULL);
      }
      return;
    }
    // Vertices before the first coloured one are white.
    colors.fillTo(3 * (places.count - 1), FULL);
    pushColor(colors, red, green, blue);
  }

  #textureCoordinates() {
    const { uvs } = this.#lists;
    const u = this.#scanner.number();
    const v = this.#scanner.number();
    uvs.push(Number.isFinite(u) ? u : 0);
    // In OBJ the last row of an image is at v = 0.
    uvs.push(Number.isFinite(v) ? 1 - v : 1);
  }

  /** The corners of a face, and its triangles after the last. */
  #corners() {
    const scanner = this.#scanner;
    for (let i = 0; !scanner.atLineEnd() && scanner.peek() !== HASH; i += 1) {
      requireAtMost(i + 1, CORNER_LIMIT, 'corners in one face');
      this.#corner();
    }
    this.#polygons.end();
  }

  #corner() {
    const scanner = this.#scanner;
    const { places, uvs, normals } = this.#lists;
    const v = this.#index('face', places.count);
    const t = this.#isNext() ? this.#index('uv', uvs.length / 2) : NONE;
    const n = this.#isNext() ? this.#index('normal', normals.length / 3) : NONE;
    this.#polygons.add(scanner.atBreak || !this.#endCorner() ? v : NOT_THERE, t, n);
  }

  /** Steps over a slash. Whether a number follows: in `v//vn` the second slash follows at once. */
  #isNext(): boolean {
    const scanner = this.#scanner;
    return scanner.take(SLASH) && !scanner.nextIs(SLASH) && !scanner.atBreak;
  }

  /** Passes over what is left of a corner. Returns whether its vertex is in doubt. */
  #endCorner(): boolean {
    const scanner = this.#scanner;
    const hasSlash = scanner.take(SLASH);
    while (scanner.take(SLASH)) {
      // with nothing behind it, it does no harm
    }
    if (hasSlash && scanner.atBreak) return false;
    const word = scanner.quotedWord();
    const why = `${word} is not written as v, v/vt, v//vn or v/vt/vn`;
    this.#leftOut.because(hasSlash ? 'corner' : 'face', () => why);
    if (hasSlash) {
      this.#leftOut.add('corner');
    }
    return !hasSlash;
  }

  /** A reference, counted from 0. Negative ones in the file count back from the last item. */
  #index(kind: ReferenceKind, count: number): number {
    const written = this.#scanner.integerHere();
    const index = written > 0 ? written - 1 : count + written;
    if (!(written !== 0 && index >= 0 && index < LIMITS.corners)) {
      // Read now, not by the reason: it steps over the word.
      const why = Number.isNaN(written)
        ? `${this.#scanner.quotedWord()} is not a corner of a face`
        : 'a corner of a face refers to something that is not there';
      this.#leftOut.because(kind, () => why);
      return NOT_THERE;
    }
    this.#highest[kind] = Math.max(this.#highest[kind], index);
    return index;
  }

  #nameLibraries(readings: readonly string[]) {
    const [names = [], ...others] = readings.map(libraryNames);
    for (const [i, name] of names.entries()) {
      if (this.#libraries.length >= LIBRARY_LIMIT) return;
      if (!this.#libraries.some(([other]) => other === name)) {
        this.#libraries.push([name, ...others.flatMap((other) => other[i] ?? [])]);
      }
    }
  }

  #endRun() {
    const end = this.#lists.corners.length;
    if (end > this.#runStart) {
      requireAtMost(this.#runs.length + 1, RUN_LIMIT, 'changes of its object or material');
      const material = this.#nameOf('usemtl');
      this.#materials.add(material);
      // At least one draw each.
      requireAtMost(this.#materials.size, LIMITS.parts, 'materials');
      const object = this.#nameOf('o') || this.#nameOf('g');
      this.#runs.push({ object, material, start: this.#runStart, end });
    }
    this.#runStart = end;
  }

  #nameOf(kind: 'o' | 'g' | 'usemtl'): string {
    const name = this.#names[kind];
    if (typeof name === 'string') return name;
    const scanner = this.#scanner;
    const { at } = scanner;
    scanner.at = name;
    const read = (this.#names[kind] = scanner.rest(NAME_LENGTH));
    scanner.at = at;
    return read;
  }
}

/** Statements that no triangle comes of. */
const LEFT_OUT: ReadonlyMap<string, LeftOutKind> = new Map(
  Object.entries({ l: 'line', p: 'point', curv: 'curve', curv2: 'curve', surf: 'curve' } as const),
);

type ReferenceKind = LeftOutKind & ('face' | 'uv' | 'normal');

const KINDS = [
  ['face', 'vertex'],
  ['uv', 'texture coordinate'],
  ['normal', 'normal'],
] as const;

function smoothingOf(group: number) {
  // `off`, `0` and anything that is not a number mean no group.
  return Number.isInteger(group) && group > 0 && group <= 0x7fffffff ? group : FACETED;
}

/** Names in quotes, or that end in .mtl, apart by blanks, which they may also contain. */
function libraryNames(text: string): string[] {
  // Whatever else there is matches too: the search would begin again at each of its characters.
  const names = /("[^"]+"|[^"]*?\.mtl(?=["\s]|$)|[^"]+$)|[^"]+|"/gi;
  return Array.from(text.matchAll(names), ([, written = '']) =>
    unquoted(written.trim()).replace(/\\/g, '/'),
  ).filter((name) => name !== '' && !name.startsWith('#'));
}
