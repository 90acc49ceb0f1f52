// Reads the header of a PLY file: elements with their counts and properties, and how the values are written.
import { TextScanner } from '../text/text-scanner.js';

type PlyEncoding = 'text' | 'little-endian' | 'big-endian';

export interface PlyType {
  readonly names: readonly string[];
  readonly bytes: number;
  /** The number that means full intensity of a colour. Whole numbers of other widths are written for bytes. */
  readonly full: number;
  readonly read: (view: DataView, at: number, isLittleEndian: boolean) => number;
}

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

const TYPES: readonly PlyType[] = [
  { names: ['char', 'int8'], bytes: 1, full: 255, read: (view, at) => view.getInt8(at) },
  { names: ['uchar', 'uint8'], bytes: 1, full: 255, read: (view, at) => view.getUint8(at) },
  { names: ['short', 'int16'], bytes: 2, full: 255, read: (view, at, little) => view.getInt16(at, little) },
  { names: ['ushort', 'uint16'], bytes: 2, full: 65535, read: (view, at, little) => view.getUint16(at, little) },
  { names: ['int', 'int32'], bytes: 4, full: 255, read: (view, at, little) => view.getInt32(at, little) },
  { names: ['uint', 'uint32'], bytes: 4, full: 255, read: (view, at, little) => view.getUint32(at, little) },
  { names: ['float', 'float32'], bytes: 4, full: 1, read: (view, at, little) => view.getFloat32(at, little) },
  { names: ['double', 'float64'], bytes: 8, full: 1, read: (view, at, little) => view.getFloat64(at, little) },
];

const ENCODINGS: ReadonlyMap<string, PlyEncoding> = new Map([
  ['ascii', 'text'],
  ['binary_little_endian', 'little-endian'],
  ['binary_big_endian', 'big-endian'],
]);

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
      encoding = ENCODINGS.get(written) ?? null;
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
  const typeNamed = (written: string): PlyType => {
    const type = TYPES.find(({ names }) => names.includes(written));
    if (type === undefined) throw wrong(scanner, at, `the type ${written} is unknown`);
    return type;
  };
  const first = scanner.word();
  const countType = first === 'list' ? typeNamed(scanner.word()) : null;
  const type = typeNamed(countType === null ? first : scanner.word());
  return { name: scanner.word(), type, countType };
}

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
    const sizes = properties.map(({ type, countType }) => (encoding === 'text' ? 2 : (countType ?? type).bytes));
    needed += count * sizes.reduce((sum, size) => sum + size, 0);
  }
  if (needed <= available + 1) return;
  throw new Error(
    `it is truncated: its header announces at least ${String(needed)} bytes of data, and it has ${String(available)}`,
  );
}
