// The triangles of a text STL file: `solid name`, then `facet` … `vertex x y z` … `endfacet`, then `endsolid`. Stated
// normals are skipped, and a facet without three sound vertices is left out. Words may be upper case, and anywhere on a
// line.
import { requireAtMost } from '../budget.js';
import type { LeftOut } from '../left-out.js';
import { CORNER_LIMIT, PART_LIMIT } from '../limits.js';
import type { Slices } from '../slices.js';
import { TextScanner } from '../text/text-scanner.js';
import { Positions, wrongCoordinate } from '../triangles/corner-lists.js';
import type { StlSolid } from './read-stl.js';

/** @throws Error for a file that ends inside a facet; ModelError `too-large`. */
export async function readStlText(bytes: Uint8Array, leftOut: LeftOut, slices: Slices): Promise<readonly StlSolid[]> {
  const reader = new StlTextReader(bytes, leftOut);
  for (let { at, names } = reader; reader.readWord(); { at, names } = reader) {
    if (slices.took((reader.at - at) / 8 + (reader.names - names) * NAME_WORK)) await slices.pause();
  }
  return reader.finish();
}

/** Lower case: s, e, f, v. */
const KEYWORD_STARTS = [115, 101, 102, 118];

class StlTextReader {
  readonly #scanner: TextScanner;
  readonly #leftOut: LeftOut;
  readonly #solids: StlSolid[] = [];
  #name = '';
  #places = new Positions();
  /** Corners of the current facet; null outside of facets. */
  #corners: number | null = null;
  #isSound = true;
  #total = 0;
  /** Names read so far. */
  names = 0;

  constructor(bytes: Uint8Array, leftOut: LeftOut) {
    this.#scanner = new TextScanner(bytes);
    this.#leftOut = leftOut;
  }

  get at(): number {
    return this.#scanner.at;
  }

  /** Reads a word and what belongs to it. False at the end. */
  readWord(): boolean {
    const scanner = this.#scanner;
    if (!scanner.nextWord()) return false;
    const { at } = scanner;
    // The others are skipped unread: `normal` and its numbers, `outer`, `loop`.
    const isKeyword = KEYWORD_STARTS.includes(scanner.peek() | 32);
    switch (scanner.word(isKeyword ? 16 : 0).toLowerCase()) {
      case 'solid':
        this.#endFacet(at);
        this.#endSolid();
        this.#name = this.#readName();
        break;
      case 'endsolid':
        this.#endFacet(at);
        this.#readName();
        break;
      case 'facet':
        this.#endFacet(at);
        this.#corners = 0;
        this.#isSound = true;
        break;
      case 'vertex':
        if (this.#corners !== null) this.#vertex(at);
        break;
      case 'endfacet':
        this.#endFacet(at);
        break;
    }
    return true;
  }

  finish(): readonly StlSolid[] {
    if (this.#corners !== null) throw new Error('it is truncated: it ends inside a facet');
    this.#endSolid();
    return this.#solids;
  }

  #vertex(at: number): void {
    const scanner = this.#scanner;
    if (this.#corners === 3) this.#spoil('a facet has more than three vertices', at);
    if (!this.#isSound) return;
    requireAtMost(this.#total + 1, CORNER_LIMIT, 'triangle corners');
    const start = scanner.at;
    const [x, y, z] = [scanner.number(), scanner.number(), scanner.number()];
    this.#corners = (this.#corners ?? 0) + 1;
    this.#total += 1;
    if (!this.#places.push(x, y, z)) this.#spoil(scanner.problemOf(start, 3) ?? wrongCoordinate(x, y, z), at);
  }

  #spoil(why: string, at: number): void {
    this.#leftOut.because('triangle', why, at);
    this.#isSound = false;
  }

  #endFacet(at: number): void {
    if (this.#corners === null) return;
    if (this.#isSound && this.#corners < 3) this.#spoil('a facet has fewer than three vertices', at);
    if (!this.#isSound) {
      this.#leftOut.add('triangle');
      this.#places.cut(this.#places.count - this.#corners);
      this.#total -= this.#corners;
    }
    this.#corners = null;
  }

  #endSolid(): void {
    if (this.#places.count === 0) return;
    this.#solids.push({
      name: this.#name,
      places: this.#places,
      colorOf: null,
      color: [1, 1, 1],
      opacity: 1,
    });
    requireAtMost(this.#solids.length, PART_LIMIT, 'solids');
    this.#places = new Positions();
  }

  /** The rest of the line, which may be made of the format's words; where the file has no lines, a part of it. */
  #readName(): string {
    const scanner = this.#scanner;
    if (scanner.atLineEnd()) return '';
    this.names += 1;
    const start = scanner.at;
    const end = AFTER_NAME.exec(scanner.ahead(NAME_SEARCH))?.index;
    if (end === undefined) return scanner.rest(NAME_LENGTH);
    scanner.at = start + end;
    return scanner.textFrom(start, NAME_LENGTH);
  }
}

/** Bytes of a line in which the end of a name is looked for, and what that takes, as {@link Slices.took} counts it. */
const NAME_SEARCH = 1024;
const NAME_WORK = 4;

/** Longest name of a solid in bytes. */
const NAME_LENGTH = 256;

/** What ends a name where the file has no lines: words of the format that no name would have in this order. */
const AFTER_NAME = /\b(?:facet\s+normal\s+\S+\s+\S+\s+\S+\s+outer\s+loop|endsolid|solid)\b/i;
