// Reads the header of a PLY file: elements with their counts and properties, and how the values are written.
import { TextScanner } from '../text/text-scanner.js';

type PlyEncoding = 'text' | 'little-endian' | 'big-endian';

export type PlyType = 'int8' | 'uint8' | 'int16' | 'uint16' | 'int32' | 'uint32' | 'float32' | 'float64';

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
export const countOf = (elements: readonly PlyElement[], name: string): number =>
  elements.reduce((sum, element) => sum + (element.name === name ? element.count : 0), 0);

const TYPES: Readonly<Record<string, PlyType>> = {
  char: 'int8',
  int8: 'int8',
  uchar: 'uint8',
  uint8: 'uint8',
  short: 'int16',
  int16: 'int16',
  ushort: 'uint16',
  uint16: 'uint16',
  int: 'int32',
  int32: 'int32',
  uint: 'uint32',
  uint32: 'uint32',
  float: 'float32',
  float32: 'float32',
  double: 'float64',
  float64: 'float64',
};

export const PLY_TYPE_SIZES: Readonly<Record<PlyType, number>> = {
  int8: 1,
  uint8: 1,
  int16: 2,
  uint16: 2,
  int32: 4,
  uint32: 4,
  float32: 4,
  float64: 8,
};

const ENCODINGS: Readonly<Record<string, PlyEncoding>> = {
  ascii: 'text',
  binary_little_endian: 'little-endian',
  binary_big_endian: 'big-endian',
};

/** Most elements and properties. Files have two elements and about ten properties. */
const DECLARATION_LIMIT = 1000;

/** Most bytes of a header: it is read in one piece. */
const HEADER_LIMIT = 2 ** 20;

const LF = 10;
const CR = 13;

/** @throws Error for a header that is broken, or that claims more values than the file has bytes for. */
export function readPlyHeader(bytes: Uint8Array): PlyHeader {
  const scanner = new TextScanner(bytes.subarray(0, HEADER_LIMIT));
  scanner.word(); // `ply`
  let encoding: PlyEncoding | null = null;
  const elements: { name: string; count: number; properties: PlyProperty[] }[] = [];
  let declarations = 0;
  let hasTexture = false;
  while (scanner.nextLine()) {
    const at = scanner.at;
    const keyword = scanner.word();
    if (keyword === 'end_header') {
      if (encoding === null) throw new Error('its header has no format');
      const header = { encoding, elements, hasTexture, end: afterLineEnd(bytes, scanner.at) };
      requireBytes(header, bytes.byteLength - header.end);
      return header;
    }
    if (keyword === 'format') {
      const written = scanner.word();
      encoding = entryOf(ENCODINGS, written);
      if (encoding === null) throw wrong(scanner, at, `the format ${written} is unknown`);
    } else if (keyword === 'element') {
      const name = scanner.word();
      const count = scanner.number();
      if (!Number.isSafeInteger(count) || count < 0) throw wrong(scanner, at, 'an element has no count');
      elements.push({ name, count, properties: [] });
    } else if (keyword === 'property') {
      const element = elements.at(-1);
      if (!element) throw wrong(scanner, at, 'a property comes before any element');
      element.properties.push(readProperty(scanner, at));
    } else {
      hasTexture ||= keyword === 'comment' && scanner.word() === 'TextureFile';
      continue; // comments, and what other programs add
    }
    declarations += 1;
    if (declarations > DECLARATION_LIMIT) throw new Error('its header has more than 1000 lines');
  }
  throw new Error('its header has no end');
}

function readProperty(scanner: TextScanner, at: number): PlyProperty {
  const read = (): PlyType => {
    const written = scanner.word();
    const type = entryOf(TYPES, written);
    if (type === null) throw wrong(scanner, at, `the type ${written} is unknown`);
    return type;
  };
  const start = scanner.at;
  if (scanner.word() !== 'list') {
    scanner.at = start;
    const type = read();
    return { name: scanner.word(), type, countType: null };
  }
  const countType = read();
  const type = read();
  return { name: scanner.word(), type, countType };
}

const entryOf = <T>(table: Readonly<Record<string, T>>, key: string): T | null =>
  Object.hasOwn(table, key) ? (table[key] ?? null) : null;

const wrong = (scanner: TextScanner, at: number, what: string): Error =>
  new Error(`line ${String(scanner.lineAt(at))}: ${what}`);

/** Where CR alone ends lines, a following LF is the first byte of the data. */
function afterLineEnd(bytes: Uint8Array, at: number): number {
  let end = at;
  while (end < bytes.length && bytes[end] !== LF && bytes[end] !== CR) end += 1;
  const loneReturns = bytes[3] === CR && bytes[4] !== LF;
  if (bytes[end] === CR && !loneReturns) end += 1;
  return end + (bytes[end] === LF || loneReturns ? 1 : 0);
}

function requireBytes({ encoding, elements }: PlyHeader, available: number): void {
  let needed = 0;
  for (const { count, properties } of elements) {
    // In text, each value takes at least a digit and a blank; only the last needs no blank.
    const sizes = properties.map(({ type, countType }) =>
      encoding === 'text' ? 2 : PLY_TYPE_SIZES[countType ?? type],
    );
    needed += count * sizes.reduce((sum, size) => sum + size, 0);
  }
  if (needed <= available + 1) return;
  throw new Error(
    `it is truncated: its header announces at least ${String(needed)} bytes of data, and it has ${String(available)}`,
  );
}
