// Words and numbers of a text file's bytes, read in one pass without turning the file into strings.
// Numbers are read exactly as `Number` reads them. Lines end with LF, CR LF or CR; a backslash at
// the end of a line continues it.
import { clip } from '../../../phong/fields/clip.js';
import { nameReadings } from './name-readings.js';

const LF = 10;
const CR = 13;
const SPACE = 32;
const BACKSLASH = 92;
const HASH = 35;
const NOTHING = -1;

const latin1 = new TextDecoder('latin1');
const utf8 = new TextDecoder();

/**
 * 10^0 to 10^22, which float64 holds exactly: one product or quotient with them is rounded once.
 */
const POWERS = Array.from({ length: 23 }, (_, exponent) => Number(`1e${String(exponent)}`));
/** A token longer than this is no number: longer ones only cost time. */
const NUMBER_LENGTH = 400;
/** Longest line, word or gap in bytes, 4 MiB: each is skipped in one task. */
const LONGEST = 2 ** 22;

/** Longest name of a solid, an object or a material in bytes. */
export const NAME_LENGTH = 256;

export class TextScanner {
  readonly #bytes: Uint8Array;
  /** Position of the next byte. */
  at: number;
  /** A byte that ends a number as a blank does, and is none itself: it begins a comment. */
  readonly #comment: number;

  /** @param comments whether `#` begins one, also directly behind a number, as in OBJ and MTL. */
  constructor(bytes: Uint8Array, at = 0, comments = false) {
    this.#bytes = bytes;
    this.#comment = comments ? HASH : NOTHING;
    const mark = at === 0 && bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf;
    this.at = mark ? 3 : at; // the byte order mark of UTF-8
  }

  /**
   * Goes to the first word of the next line that has one; false at the end. Comments may end with a
   * backslash, so it does not continue a line here.
   * @throws Error for a line, word or gap that is too long, as all that skips them.
   */
  nextLine(): boolean {
    this.#skipLine();
    return this.nextWord();
  }

  /** Goes to the next word, on this line or a later one. False at the end of the file. */
  nextWord(): boolean {
    const end = this.#farthest;
    for (;;) {
      this.#skipBlanks();
      if (this.at >= this.#bytes.length) return false;
      if (!isLineEnd(this.#bytes[this.at]!)) return true;
      this.at += 1;
      this.#requireBefore(end);
    }
  }

  get #farthest() {
    return Math.min(this.#bytes.length, this.at + LONGEST);
  }

  #requireBefore(end: number) {
    if (this.at >= end && end < this.#bytes.length) {
      throw new Error('a line, a word or a gap in it is longer than 4 MiB');
    }
  }

  #skipLine() {
    const bytes = this.#bytes;
    const end = this.#farthest;
    while (this.at < end && !isLineEnd(bytes[this.at]!)) {
      this.at += 1;
    }
    this.#requireBefore(end);
  }

  /** Whether no word follows on this line. Skips the blanks before it. */
  atLineEnd(): boolean {
    this.#skipBlanks();
    const byte = this.#bytes[this.at];
    return byte === undefined || isLineEnd(byte);
  }

  /** The next byte of this line after blanks; -1 at its end. Stays before it. */
  peek() {
    return this.atLineEnd() ? NOTHING : (this.#bytes[this.at] ?? NOTHING);
  }

  /** The next word of this line; empty at its end. Longer words are cut after 256 bytes. */
  word(): string {
    if (this.atLineEnd()) return '';
    const start = this.at;
    this.skipWord();
    return this.#latin1From(start, 256);
  }

  /** The likeliest of {@link readings}. */
  rest(most?: number) {
    return this.readings(most)[0] ?? '';
  }

  /**
   * The rest of this line in the encodings that it may have, without blanks at its ends, cut after
   * `most` bytes. Stays before the line's end.
   */
  readings(most = 4096): readonly string[] {
    if (this.atLineEnd()) return [];
    const start = this.at;
    this.#skipLine();
    return this.readingsFrom(start, most);
  }

  /**
   * The next word of this line as a number; NaN if there is none or it is not a number. Stays
   * before a comment.
   */
  number(): number {
    if (this.atLineEnd()) return NaN;
    const bytes = this.#bytes;
    const start = this.at;
    if (bytes[start] === this.#comment) return NaN;
    let i = start;
    const sign = bytes[i];
    if (sign === 45 || sign === 43) {
      i += 1;
    }
    let mantissa = 0;
    let seen = 0;
    let exponent = 0;
    let digit = digitOf(bytes[i]);
    for (; digit >= 0 && seen < NUMBER_LENGTH; digit = digitOf(bytes[++i])) {
      mantissa = mantissa * 10 + digit;
      seen += 1;
    }
    if (bytes[i] === 46) {
      digit = digitOf(bytes[++i]);
      for (; digit >= 0 && seen < NUMBER_LENGTH; digit = digitOf(bytes[++i])) {
        mantissa = mantissa * 10 + digit;
        exponent -= 1;
        seen += 1;
      }
    }
    if (seen > 0 && (bytes[i] === 101 || bytes[i] === 69)) {
      const sign = bytes[i + 1];
      let power = 0;
      let at = i + (sign === 45 || sign === 43 ? 2 : 1);
      const first = at;
      const last = first + NUMBER_LENGTH;
      for (digit = digitOf(bytes[at]); digit >= 0 && at < last; digit = digitOf(bytes[++at])) {
        power = power * 10 + digit;
      }
      if (at > first) {
        exponent += sign === 45 ? -power : power;
        i = at;
      }
    }
    if (seen === 0 || i - start > NUMBER_LENGTH || !this.#endsNumber(i)) return this.#noNumber();
    this.at = i;
    // Whole numbers up to 2^53 are exact, and a larger one is not rounded below that.
    const isExact = mantissa <= Number.MAX_SAFE_INTEGER && Math.abs(exponent) <= 22;
    if (!isExact) return Number(this.#latin1From(start, NUMBER_LENGTH));
    const scale = POWERS[Math.abs(exponent)] ?? NaN;
    const size = exponent < 0 ? mantissa / scale : mantissa * scale;
    return sign === 45 ? -size : size;
  }

  /** Why the `count` words from `start` on are no numbers; null if they are. Stays where it is. */
  problemOf(start: number, count: number): string | null {
    const { at } = this;
    this.at = start;
    let problem: string | null = null;
    for (let i = 0; i < count && problem === null; i += 1) {
      const from = this.atLineEnd() ? NOTHING : this.at;
      if (!Number.isNaN(this.number())) continue;
      problem =
        from === NOTHING || this.at === from
          ? 'a number is missing'
          : `${this.#quoted(from)} is not a number`;
    }
    this.at = at;
    return problem;
  }

  /** The word around this byte of the line, quoted for messages. */
  quotedWord(): string {
    let start = this.at;
    const least = Math.max(0, start - NUMBER_LENGTH);
    while (start > least && !isBreak(this.#bytes[start - 1])) {
      start -= 1;
    }
    this.skipWord();
    return this.#quoted(start);
  }

  /** The whole number at this very byte, with a sign or without; NaN if there is none. */
  integerHere(): number {
    const bytes = this.#bytes;
    const negative = bytes[this.at] === 45;
    let i = this.at + (negative || bytes[this.at] === 43 ? 1 : 0);
    let digit = digitOf(bytes[i]);
    if (digit < 0) return NaN;
    let value = 0;
    const end = i + NUMBER_LENGTH;
    for (; digit >= 0 && i < end; digit = digitOf(bytes[++i])) {
      value = value * 10 + digit;
    }
    this.at = i;
    return negative ? -value : value;
  }

  /** Steps over this byte if it is the next one. */
  take(byte: number): boolean {
    if (this.#bytes[this.at] !== byte) return false;
    this.at += 1;
    return true;
  }

  nextIs(byte: number) {
    return this.#bytes[this.at] === byte;
  }

  /** Whether a number ends before the next byte. */
  get atBreak() {
    return this.#endsNumber(this.at);
  }

  #endsNumber(at: number): boolean {
    const byte = this.#bytes[at];
    return isBreak(byte) || byte === this.#comment;
  }

  #quoted(start: number) {
    return JSON.stringify(
      clip(utf8.decode(this.#bytes.subarray(start, Math.min(this.at, start + 4096)))),
    );
  }

  /** The readings of the text from `start` to the next byte. */
  readingsFrom(start: number, most: number): readonly string[] {
    const end = Math.min(this.at, start + most);
    return most === 0 ? [] : nameReadings(this.#bytes.subarray(start, end), end < this.at);
  }

  /** The next bytes of this line, a character each. Stays before them. */
  ahead(most: number): string {
    const bytes = this.#bytes.subarray(this.at, this.at + most);
    const end = bytes.findIndex(isLineEnd);
    return latin1.decode(end < 0 ? bytes : bytes.subarray(0, end));
  }

  /** From `start` to the next byte, a character for each byte. */
  #latin1From(start: number, most: number): string {
    const bytes = this.#bytes.subarray(start, Math.min(this.at, start + most));
    // A decoder or a sum of letters takes longer, and so does a spread: three times.
    return Reflect.apply(String.fromCharCode, null, bytes) as string;
  }

  /** Skips a word that is no number, up to a comment. */
  #noNumber(): number {
    const bytes = this.#bytes;
    const start = this.at;
    this.skipWord();
    const comment = bytes.subarray(start, Math.min(this.at, start + NUMBER_LENGTH)).indexOf(HASH);
    if (this.#comment === HASH && comment > 0) {
      this.at = start + comment;
    }
    return NaN;
  }

  /** Goes to the end of the word that begins at the next byte, if there is one. */
  skipWord(): void {
    const bytes = this.#bytes;
    const end = this.#farthest;
    while (this.at < end && !isBreak(bytes[this.at])) {
      this.at += 1;
    }
    this.#requireBefore(end);
  }

  #skipBlanks() {
    const bytes = this.#bytes;
    const end = this.#farthest;
    for (;;) {
      const byte = bytes[this.at];
      if (byte === undefined) return;
      this.#requireBefore(end);
      if (byte === BACKSLASH) {
        const next = bytes[this.at + 1];
        if (next === LF) {
          this.at += 2;
        } else if (next === CR) {
          this.at += bytes[this.at + 2] === LF ? 3 : 2;
        } else {
          return;
        }
      } else if (byte <= SPACE && !isLineEnd(byte)) {
        this.at += 1;
      } else {
        return;
      }
    }
  }
}

const isLineEnd = (byte: number) => byte === LF || byte === CR;
/** White space, other control characters, and the end of the file. */
const isBreak = (byte: number | undefined) => byte === undefined || byte <= SPACE;

function digitOf(byte: number | undefined) {
  return byte !== undefined && byte >= 48 && byte <= 57 ? byte - 48 : -1;
}
