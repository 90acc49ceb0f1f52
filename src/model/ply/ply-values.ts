// The values after a PLY header, one after another, whether they are text or binary of either byte order.
import { TextScanner } from '../text/text-scanner.js';
import type { PlyHeader, PlyType } from './ply-header.js';

export interface PlyValues {
  /** Position of the next byte. */
  readonly at: number;
  /** Goes to the next row. False where it is not there yet: call again. @throws Error at the end of the file. */
  beginRow(): boolean;
  /** Whether values are left that no property names. */
  endRow(): boolean;
  /** @throws Error at the end of the file, or of the row if rows are lines. Text that is no number is NaN. */
  next(type: PlyType): number;
  /** Why the last value is no number, in words. */
  problem(): string;
  /** Passes over as many of `count` values as can be passed at once, and returns their number. */
  skip(type: PlyType, count: number): number;
}

/** @param byLines whether each row of a text is a line, and may have more values than its header names. */
export function plyValues(bytes: Uint8Array<ArrayBuffer>, { encoding, end }: PlyHeader, byLines: boolean): PlyValues {
  return encoding === 'text' ? textValues(bytes, end, byLines) : binaryValues(bytes, end, encoding === 'little-endian');
}

const truncated = (): Error => new Error('it is truncated: it ends before its last value');

/** `c` and `#`: no number begins with them. */
const COMMENTS: ReadonlySet<number> = new Set([0x63, 0x23]);

function textValues(bytes: Uint8Array, start: number, byLines: boolean): PlyValues {
  const scanner = new TextScanner(bytes, start);
  let begun = false;
  const next = (): number => {
    if (byLines ? scanner.atLineEnd() : !scanner.nextWord()) throw truncated();
    return scanner.number();
  };
  return {
    get at() {
      return scanner.at;
    },
    beginRow: () => {
      if (!byLines) return true;
      if (!(begun ? scanner.nextLine() : scanner.nextWord())) throw truncated();
      begun = true;
      return !scanner.atLineEnd() && !COMMENTS.has(scanner.peek());
    },
    endRow: () => byLines && !scanner.atLineEnd(),
    next,
    problem: () => `${scanner.quotedWord()} is not a number`,
    skip: () => {
      next();
      return 1;
    },
  };
}

function binaryValues(bytes: Uint8Array<ArrayBuffer>, start: number, little: boolean): PlyValues {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = start;
  const take = (length: number): number => {
    const from = at;
    at += length;
    if (at > view.byteLength) throw truncated();
    return from;
  };
  return {
    get at() {
      return at;
    },
    beginRow: () => true,
    endRow: () => false,
    problem: () => 'a value is not a number',
    skip: ({ bytes: size }, count) => {
      take(size * count);
      return count;
    },
    next: (type) => type.read(view, take(type.bytes), little),
  };
}
