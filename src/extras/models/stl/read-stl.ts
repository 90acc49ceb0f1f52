// Reads an STL file, binary or text. Each triangle has its own normal, taken from its corners: the
// normals in files are often zero or stale. Colours of the two 15-bit conventions. A separate
// chunk.
import { BufferAttribute, BufferGeometry } from 'three';
import type { Vec3 } from '../../../phong/math/vector.js';
import { faceNormals, type ModelReader, ownedModel } from '../model-reader.js';
import { LeftOut } from '../left-out.js';
import { type BaseLook, PLAIN_LOOK } from '../../../phong/material/file-surface.js';
import { requireAtMost } from '../../../phong/model/budget.js';
import { LIMITS } from '../../../phong/model/limits.js';
import type { ContentPart } from '../../../phong/model/model.js';
import type { ModelBudget } from '../../../phong/model/model-budget.js';
import { Slices } from '../slices.js';
import { NAME_LENGTH, TextScanner } from '../text/text-scanner.js';
import { Positions, wrongCoordinate } from '../triangles/corner-lists.js';
import { holdsTriangles, isTextStl, STL_HEADER, STL_TRIANGLE } from './stl-kind.js';

export const read: ModelReader = async ({ bytes, signal, budget }) => {
  const slices = new Slices(signal, budget);
  const leftOut = new LeftOut();
  const asText = !holdsTriangles(bytes) && isTextStl(bytes);
  if (asText) {
    budget.add({ text: bytes.byteLength });
  }
  const solids = asText
    ? await readStlText(bytes, leftOut, slices)
    : [await readBinary(bytes, leftOut, slices)];
  const parts: ContentPart[] = [];
  for (const solid of solids) {
    if (solid.places.count > 0) {
      parts.push(await partOf(solid, budget, slices));
    }
    if (slices.took(16)) {
      await slices.pause();
    }
  }
  if (parts.length === 0) throw leftOut.error('it has no triangles');
  return { ...ownedModel(parts), dropped: leftOut.names };
};

/** A body as it is read. */
interface StlSolid {
  readonly name: string;
  /** Three per triangle. */
  readonly places: Positions;
  /** Gives the colour of a triangle, encoded sRGB, 0 to 1. Null if none has its own. */
  readonly colorOf: ((triangle: number) => Vec3) | null;
  /** Colour of the whole body. Encoded sRGB, 0 to 1. */
  readonly color: Vec3;
  /** 0 to 1. */
  readonly opacity: number;
}

async function readBinary(
  bytes: Uint8Array<ArrayBuffer>,
  leftOut: LeftOut,
  slices: Slices,
): Promise<StlSolid> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = countOf(view);
  // Before anything is allocated.
  requireAtMost(3 * count, LIMITS.corners, 'triangle corners');
  const header = headerColor(view);
  const places = new Positions(3 * count);
  /** The colour bits of the triangles that are kept. */
  const bits = new Uint16Array(count);
  const coordinate = (at: number) => view.getFloat32(at, true);
  let colored = false;
  let anyBits = 0;
  for (let i = 0; i < count; i += 1) {
    if (slices.took(1 / 4)) {
      await slices.pause();
    }
    const at = STL_HEADER + i * STL_TRIANGLE;
    const kept = places.count;
    for (let corner = at + 12; corner < at + 48; corner += 12) {
      const [x, y, z] = [coordinate(corner), coordinate(corner + 4), coordinate(corner + 8)];
      if (places.push(x, y, z)) continue;
      places.cut(kept);
      leftOut.add('triangle');
      leftOut.because('triangle', () => wrongCoordinate(x, y, z));
      break;
    }
    if (places.count === kept) continue;
    const own = view.getUint16(at + 48, true);
    bits[kept / 3] = own;
    anyBits |= own;
    colored ||= triangleColor(own, header !== null) !== null;
  }
  // All 0: the writer knows no colours of triangles. By Magics' convention they would be black.
  colored &&= anyBits > 0;
  const color = header?.color ?? WHITE;
  return {
    name: '',
    places,
    colorOf: colored
      ? (triangle) => triangleColor(bits[triangle] ?? 0, header !== null) ?? color
      : null,
    color: colored ? WHITE : color,
    opacity: header?.opacity ?? 1,
  };
}

/**
 * The number of triangles. 0 in files whose writer did not go back to fill it in: then as many as
 * there are.
 */
function countOf(view: DataView): number {
  if (view.byteLength < STL_HEADER) throw new Error('it ends inside its header');
  const there = Math.floor((view.byteLength - STL_HEADER) / STL_TRIANGLE);
  const count = view.getUint32(STL_HEADER - 4, true) || there;
  if (count === 0) throw new Error('it has no triangles');
  if (count <= there) return count;
  const size = STL_HEADER + count * STL_TRIANGLE;
  throw new Error(
    `it is truncated: ${String(view.byteLength)} of ${String(size)} bytes for ${String(count)} triangles`,
  );
}

const WHITE: Vec3 = [1, 1, 1];

/** The body's colour as Magics writes it: `COLOR=` and four bytes r g b a in the header. */
function headerColor(view: DataView): { readonly color: Vec3; readonly opacity: number } | null {
  const at = String.fromCharCode(
    ...new Uint8Array(view.buffer, view.byteOffset, STL_HEADER - 8),
  ).indexOf('COLOR=');
  if (at < 0) return null;
  const [r = 0, g = 0, b = 0] = [6, 7, 8].map((i) => view.getUint8(at + i) / 255);
  const alpha = view.getUint8(at + 9);
  // Some writers leave it 0, and do not mean an invisible body. Others write three bytes and a
  // space.
  return { color: [r, g, b], opacity: [0, 0x20].includes(alpha) ? 1 : alpha / 255 };
}

/**
 * A triangle's colour, five bits per channel; null if it has none. Magics (files with `COLOR=`):
 * red in the low bits, bit 15 clear. VisCAM and SolidView: blue in the low bits, bit 15 set.
 */
function triangleColor(bits: number, magics: boolean): Vec3 | null {
  if (((bits & 0x8000) === 0) !== magics) return null;
  const channels: Vec3 = [(bits & 31) / 31, ((bits >> 5) & 31) / 31, ((bits >> 10) & 31) / 31];
  return magics ? channels : [channels[2], channels[1], channels[0]];
}

async function partOf(solid: StlSolid, budget: ModelBudget, slices: Slices): Promise<ContentPart> {
  const { name, places, colorOf, color, opacity } = solid;
  const corners = places.count;
  budget.add({ parts: 1, corners, values: corners * (colorOf === null ? 6 : 9) });
  const geometry = new BufferGeometry();
  // What lies behind them was never written, so it takes no memory.
  const positions = places.array.subarray(0, 3 * corners);
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', await faceNormals(positions, slices));
  if (colorOf !== null) {
    const colors = new Float32Array(3 * corners);
    await slices.over(corners / 3, (from, to) => {
      for (let triangle = from; triangle < to; triangle += 1) {
        const own = colorOf(triangle);
        for (let corner = 0; corner < 3; corner += 1) {
          colors.set(own, 9 * triangle + 3 * corner);
        }
      }
    });
    geometry.setAttribute('color', new BufferAttribute(colors, 3));
  }
  const alphaMode = opacity < 1 ? 'blend' : 'opaque';
  const look: BaseLook = {
    ...PLAIN_LOOK,
    baseColor: color,
    opacity,
    alphaMode,
    vertexColors: colorOf !== null,
  };
  return { name, geometry, matrix: places.matrix, look, sides: 'double', surface: {} };
}

/**
 * The triangles of a text: `solid name`, then `facet` … `vertex x y z` … `endfacet`, then
 * `endsolid`. Stated normals are skipped, and a facet without three sound vertices is left out.
 * Words may be upper case, and anywhere on a line.
 * @throws Error for a file that ends inside a facet; ModelError `too-large`.
 */
async function readStlText(
  bytes: Uint8Array,
  leftOut: LeftOut,
  slices: Slices,
): Promise<readonly StlSolid[]> {
  const reader = new StlTextReader(bytes, leftOut);
  for (let { at, names } = reader; reader.readWord(); { at, names } = reader) {
    if (slices.took((reader.at - at) / 8 + (reader.names - names) * NAME_WORK)) {
      await slices.pause();
    }
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

  get at() {
    return this.#scanner.at;
  }

  /** Reads a word and what belongs to it. False at the end. */
  readWord(): boolean {
    const scanner = this.#scanner;
    if (!scanner.nextWord()) return false;
    // The others are skipped unread: `normal` and its numbers, `outer`, `loop`.
    if (!KEYWORD_STARTS.includes(scanner.peek() | 32)) {
      scanner.skipWord();
      return true;
    }
    switch (scanner.word().toLowerCase()) {
      case 'solid':
        this.#endFacet();
        this.#endSolid();
        this.#name = this.#readName();
        break;
      case 'endsolid':
        this.#endFacet();
        this.#readName();
        break;
      case 'facet':
        this.#endFacet();
        this.#corners = 0;
        this.#isSound = true;
        break;
      case 'vertex':
        if (this.#corners !== null) {
          this.#vertex();
        }
        break;
      case 'endfacet':
        this.#endFacet();
        break;
    }
    return true;
  }

  finish(): readonly StlSolid[] {
    if (this.#corners !== null) throw new Error('it is truncated: it ends inside a facet');
    this.#endSolid();
    return this.#solids;
  }

  #vertex() {
    const scanner = this.#scanner;
    if (this.#corners === 3) {
      this.#spoil('a facet has more than three vertices');
    }
    if (!this.#isSound) return;
    requireAtMost(this.#total + 1, LIMITS.corners, 'triangle corners');
    const start = scanner.at;
    const [x, y, z] = [scanner.number(), scanner.number(), scanner.number()];
    this.#corners = (this.#corners ?? 0) + 1;
    this.#total += 1;
    if (!this.#places.push(x, y, z)) {
      this.#spoil(scanner.problemOf(start, 3) ?? wrongCoordinate(x, y, z));
    }
  }

  #spoil(why: string) {
    this.#leftOut.because('triangle', () => why);
    this.#isSound = false;
  }

  #endFacet() {
    if (this.#corners === null) return;
    if (this.#isSound && this.#corners < 3) {
      this.#spoil('a facet has fewer than three vertices');
    }
    if (!this.#isSound) {
      this.#leftOut.add('triangle');
      this.#places.cut(this.#places.count - this.#corners);
      this.#total -= this.#corners;
    }
    this.#corners = null;
  }

  #endSolid() {
    if (this.#places.count === 0) return;
    this.#solids.push({
      name: this.#name,
      places: this.#places,
      colorOf: null,
      color: WHITE,
      opacity: 1,
    });
    requireAtMost(this.#solids.length, LIMITS.parts, 'solids');
    this.#places = new Positions();
  }

  /**
   * The rest of the line, which may be made of the format's words; where the file has no lines, a
   * part of it.
   */
  #readName(): string {
    const scanner = this.#scanner;
    if (scanner.atLineEnd()) return '';
    this.names += 1;
    const start = scanner.at;
    const end = AFTER_NAME.exec(scanner.ahead(NAME_SEARCH))?.index;
    if (end === undefined) return scanner.rest(NAME_LENGTH);
    scanner.at = start + end;
    return scanner.readingsFrom(start, NAME_LENGTH)[0] ?? '';
  }
}

/**
 * Bytes of a line in which the end of a name is looked for, and what that takes, as {@link
 * Slices.took} counts it.
 */
const NAME_SEARCH = 1024;
const NAME_WORK = 4;

/**
 * What ends a name where the file has no lines: words of the format that no name would have in this
 * order.
 */
const AFTER_NAME = /\b(?:facet\s+normal\s+\S+\s+\S+\s+\S+\s+outer\s+loop|endsolid|solid)\b/i;
