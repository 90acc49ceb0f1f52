// Base64 in bytes, decoded in tasks and in place: files of hundreds of megabytes are never strings.
import { ModelError } from './model.js';
import type { Slices } from './slices.js';

/** Values of the characters; what is skipped is {@link SKIPPED}, what is wrong {@link WRONG}. */
const SKIPPED = 64;
const WRONG = 65;
const VALUES = /* @__PURE__ */ (() => {
  const values = new Uint8Array(256).fill(WRONG);
  const alphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
  for (let value = 0; value < 64; value += 1) values[alphabet.charCodeAt(value)] = value;
  // White space, padding, and the backslash that JSON allows before a slash.
  for (const character of '\t\n\f\r =\\') values[character.charCodeAt(0)] = SKIPPED;
  return values;
})();

/** Characters between two looks at the clock. */
const SLICE = 2 ** 16;

/**
 * The data behind base64, written over it. Padding and white space are optional.
 * @throws ModelError `bad-model` for anything else.
 */
export async function fromBase64(text: Uint8Array<ArrayBuffer>, slices: Slices): Promise<Uint8Array<ArrayBuffer>> {
  const state = { bits: 0, count: 0, length: 0 };
  for (let from = 0; from < text.length; from += SLICE) {
    decode(text, from, Math.min(from + SLICE, text.length), state);
    await slices.pauseIfDue();
  }
  if (state.count === 6) throw broken();
  return text.subarray(0, state.length);
}

/** `count`: bits that are not written yet. */
function decode(
  text: Uint8Array,
  from: number,
  to: number,
  state: { bits: number; count: number; length: number },
): void {
  let { bits, count, length } = state;
  for (let i = from; i < to; i += 1) {
    const value = VALUES[text[i]!]!;
    if (value >= SKIPPED) {
      if (value === SKIPPED) continue;
      throw broken();
    }
    bits = ((bits << 6) | value) & 0xfff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    text[length] = bits >> count;
    length += 1;
  }
  Object.assign(state, { bits, count, length });
}

const broken = (): ModelError => new ModelError('bad-model', 'A data: URI holds broken base64.');
