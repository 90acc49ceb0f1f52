// Reads the header of a PLY file: elements with their counts and properties, and how the values are
// written.
import type { Slices } from '../slices.js';
import { TextScanner } from '../text/text-scanner.js';

type PlyEncoding = 'text' | 'little-endian' | 'big-endian';

/**
 * `full` is the number that means full intensity of a colour. Whole numbers of other widths are
 * written for bytes.
 */
const TYPES = [
  { kind: 'int8', word: 'char', bytes: 1, full: 255 },
  { kind: 'uint8', word: 'uchar', bytes: 1, full: 255 },
  { kind: 'int16', word: 'short', bytes: 2, full: 255 },
  { kind: 'uint16', word: 'ushort', bytes: 2, full: 65535 },
  { kind: 'int32', word: 'int', bytes: 4, full: 255 },
  { kind: 'uint32', word: 'uint', bytes: 4, full: 255 },
  { kind: 'float32', word: 'float', bytes: 4, full: 1 },
  { kind: 'float64', word: 'double', bytes: 8, full: 1 },
] as const;

export type PlyType = (typeof TYPES)[number];

export interface PlyProperty {
  readonly name: string;
  readonly type: PlyType;
  /** Type of the number of items, if the property is a list. */
  readonly countType: PlyType | null;
}

export interface PlyElement {
  readonly name: string;
  readonly count: number;
  readonly properties: readonly PlyProperty[];
}

export interface PlyHeader {
  readonly encoding: PlyEncoding;
  readonly elements: readonly PlyElement[];
  /** Whether it names a texture, in a comment as MeshLab does. */
  readonly hasTexture: boolean;
  /** Position of the first byte after the header. */
  readonly end: number;
}

/** How many rows the elements of this name have. */
export const countOf = (elements: readonly PlyElement[], name: string) =>
  elements.reduce((sum, element) => sum + (element.name === name ? element.count : 0), 0);

const ENCODINGS: ReadonlyMap<string, PlyEncoding> = new Map([
  ['ascii', 'text'],
  ['binary_little_endian', 'little-endian'],
  ['binary_big_endian', 'big-endian'],
]);

/** Most bytes of a header, and most elements and properties: files have about ten. */
const HEADER_LIMIT = 2 ** 20;
const DECLARATION_LIMIT = 1000;

const LF = 10;
const CR = 13;

/** What the lines so far say. */
interface Draft {
  encoding: PlyEncoding | null;
  readonly elements: (PlyElement & { readonly properties: PlyProperty[] })[];
  hasTexture: boolean;
  declarations: number;
}

/**
 * @throws Error for a header that is broken, or that claims more values than the file has bytes
 * for.
 */
export async function readPlyHeader(bytes: Uint8Array, slices: Slices): Promise<PlyHeader> {
  const scanner = new TextScanner(bytes.subarray(0, HEADER_LIMIT));
  scanner.word(); // `ply`
  const draft: Draft = { encoding: null, elements: [], hasTexture: false, declarations: 0 };
  while (scanner.nextLine()) {
    const keyword = scanner.word();
    if (keyword === 'end_header') {
      const { encoding } = draft;
      if (encoding === null) throw new Error('its header has no format');
      const header = { ...draft, encoding, end: afterLineEnd(bytes, scanner.at) };
      requireBytes(header, bytes.byteLength - header.end);
      return header;
    }
    if (slices.took(1 / 2)) {
      await slices.pause();
    }
    readDeclaration(keyword, scanner, draft);
  }
  throw new Error('its header has no end');
}

/** Comments, and what other programs add, are skipped. */
function readDeclaration(keyword: string, scanner: TextScanner, draft: Draft) {
  if (/^(element|property)$/.test(keyword)) {
    draft.declarations += 1;
  }
  if (draft.declarations > DECLARATION_LIMIT) {
    throw new Error('its header has over 1,000 elements and properties');
  }
  if (keyword === 'format') {
    const written = scanner.word();
    draft.encoding = ENCODINGS.get(written) ?? null;
    if (draft.encoding === null) throw new Error(`the format ${written} is unknown`);
  } else if (keyword === 'element') {
    const name = scanner.word();
    const count = scanner.number();
    if (!Number.isSafeInteger(count) || count < 0) throw new Error('an element has no count');
    draft.elements.push({ name, count, properties: [] });
  } else if (keyword === 'property') {
    const element = draft.elements.at(-1);
    if (!element) throw new Error('a property comes before any element');
    const first = scanner.word();
    const countType = first === 'list' ? typeNamed(scanner.word()) : null;
    const type = typeNamed(countType === null ? first : scanner.word());
    element.properties.push({ name: scanner.word(), type, countType });
  } else if (keyword === 'comment') {
    draft.hasTexture ||= scanner.word() === 'TextureFile';
  }
}

function typeNamed(written: string): PlyType {
  const type = TYPES.find(({ kind, word }) => kind === written || word === written);
  if (type === undefined) throw new Error(`the type ${written} is unknown`);
  return type;
}

/** Where CR alone ends lines, a following LF is the first byte of the data. */
function afterLineEnd(bytes: Uint8Array, at: number): number {
  let end = at;
  while (end < bytes.length && bytes[end] !== LF && bytes[end] !== CR) {
    end += 1;
  }
  const loneReturns = bytes[3] === CR && bytes[4] !== LF;
  if (bytes[end] === CR && !loneReturns) {
    end += 1;
  }
  return end + (bytes[end] === LF || loneReturns ? 1 : 0);
}

function requireBytes({ encoding, elements }: PlyHeader, available: number) {
  let needed = 0;
  for (const { count, properties } of elements) {
    // In text, each value takes at least a digit and a blank; only the last needs no blank.
    const sizes = properties.map(({ type, countType }) =>
      encoding === 'text' ? 2 : (countType ?? type).bytes,
    );
    needed += count * sizes.reduce((sum, size) => sum + size, 0);
  }
  if (needed <= available + 1) return;
  throw new Error(
    `it is truncated: its header announces at least ${String(needed)} bytes of data, and it has ${String(available)}`,
  );
}
