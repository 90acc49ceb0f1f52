// @ts-check
// How much room text takes in a chart, without a browser to ask, and how numbers are written in it.

/**
 * Pixels, rather too many: as wide as DejaVu Sans, the widest of the usual sans-serif fonts.
 * @param {string} text @param {number} size of the font, pixels
 */
export function widthOf(text, size) {
  let ems = 0;
  for (const character of text) ems += EMS.find(([set]) => set.test(character))?.[1] ?? 0.64;
  return size * ems;
}

/** @type {readonly (readonly [RegExp, number])[]} */
const EMS = [
  [/[ijlI'’|,.:; \u00a0·]/, 0.35],
  [/[rtf()[\]!"\-]/, 0.42],
  [/[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]/, 0.47],
  [/[A-Z×–]/, 0.74],
  [/[mwMW@%—→]/, 1],
];

/** Lines no wider than `width` where words allow it. @param {string} text @param {number} size @param {number} width */
export function wrapped(text, size, width) {
  /** @type {string[]} */
  const lines = [];
  for (const word of text.split(' ')) {
    const longer = `${lines.at(-1) ?? ''} ${word}`;
    if (lines.length > 0 && widthOf(longer, size) <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

/** As few lines as `wrapped` makes, of about one length. @param {string} text @param {number} size @param {number} width */
export function balanced(text, size, width) {
  let lines = wrapped(text, size, width);
  for (let less = width - size; less > 0; less -= size / 2) {
    const tighter = wrapped(text, size, less);
    if (tighter.length > lines.length) break;
    lines = tighter;
  }
  return lines;
}

/** At a tick: as it is where it is short, else as a power of ten. @param {number} x > 0 */
export function tickText(x) {
  if (x >= 1e-3 && x < 1e5) return String(x);
  const [digits = '', exponent = ''] = x.toExponential().split('e');
  const power = `10${[...String(Number(exponent))].map((character) => SUPERSCRIPT[character]).join('')}`;
  return digits === '1' ? power : `${digits}·${power}`;
}

/** @type {Record<string, string>} */
const SUPERSCRIPT = {
  ...{ '-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴' },
  ...{ 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹' },
};

/** The same of a figure with three significant digits. @param {number} x >= 0 */
export const figureText = (x) => (x === 0 ? '0' : tickText(Number(x.toPrecision(3))));

/** Three significant digits, no idle zeros. @param {number} x @param {number} [digits] */
export function short(x, digits = 3) {
  if (!Number.isFinite(x)) return '–';
  const rounded = Number(x.toPrecision(digits));
  if (rounded !== 0 && Math.abs(rounded) < 1e-3) return rounded.toExponential();
  return String(rounded);
}

/** A median with its quartiles; what was measured once has none. @param {import('../statistics.mjs').Spread} spread */
export const range = ({ median, low, high, count }) =>
  count <= 1 ? short(median) : `${short(median)} (${short(low)}–${short(high)})`;
