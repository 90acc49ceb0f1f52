// Reads the header of a PLY file: elements with their counts and properties, and how the values are
// written.
import type { Slices } from '../slices.js';
import { lineOf, TextScanner } from '../text/text-scanner.js';

type PlyEncoding = 'text' | 'little-endian' | 'big-endian';

export interface PlyType {
  readonly names: readonly string[];
  readonly bytes: number;
  /**
   * The number that means full intensity of a colour. Whole numbers of other widths are written for
   * bytes.
   */
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
  {
    names: ['short', 'int16'],
    bytes: 2,
    full: 255,
    read: (view, at, little) => view.getInt16(at, little),
  },
  {
    names: ['ushort', 'uint16'],
    bytes: 2,
    full: 65535,
    read: (view, at, little) => view.getUint16(at, little),
  },
  {
    names: ['int', 'int32'],
    bytes: 4,
    full: 255,
    read: (view, at, little) => view.getInt32(at, little),
  },
  {
    names: ['uint', 'uint32'],
    bytes: 4,
    full: 255,
    read: (view, at, little) => view.getUint32(at, little),
  },
  {
    names: ['float', 'float32'],
    bytes: 4,
    full: 1,
    read: (view, at, little) => view.getFloat32(at, little),
  },
  {
    names: ['double', 'float64'],
    bytes: 8,
    full: 1,
    read: (view, at, little) => view.getFloat64(at, little),
  },
];

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
    const { at } = scanner;
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
    try {
      readDeclaration(keyword, scanner, draft);
    } catch (cause) {
      const line = await lineOf(bytes, at, slices);
      throw new Error(`line ${String(line)}: ${(cause as Error).message}`, { cause });
    }
  }
  throw new Error('its header has no end');
}

/** Comments, and what other programs add, are skipped. */
function readDeclaration(keyword: string, scanner: TextScanner, draft: Draft): void {
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
  const type = TYPES.find(({ names }) => names.includes(written));
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

function requireBytes({ encoding, elements }: PlyHeader, available: number): void {
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
