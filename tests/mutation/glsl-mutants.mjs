// @ts-check
// Which wrong versions does a GLSL text have? Each operator below is a pattern; nothing here knows
// a chunk. Comments, directives and the heads of loops stay as they are: a loop that never ends
// would hang the driver.

/**
 * @typedef {object} GlslMutant
 * @property {string} what the operator, in words
 * @property {number} line
 * @property {string} before the text that is replaced
 * @property {string} after
 * @property {string} text the whole text of the mutant
 */

/**
 * @typedef {{ what: string, pattern: RegExp, after: (match: RegExpExecArray) => string }} Operator
 */

/** @type {Record<string, string>} */
const SWAPPED = {
  '<': '>=',
  '>': '<=',
  '<=': '>',
  '>=': '<',
  '==': '!=',
  '!=': '==',
  '+': '-',
  '-': '+',
  '+=': '-=',
  '-=': '+=',
  min: 'max',
  max: 'min',
  '&&': '||',
  '||': '&&',
};
/** @param {RegExpExecArray} match */
const swapped = ([text]) => SWAPPED[text] ?? text;

/**
 * A type's name at the start makes a statement a declaration: without it the text does not compile.
 */
const TYPES =
  /^(const|highp|mediump|in|out|uniform|float|int|uint|bool|[biu]?vec[234]|mat[234]|[A-Z]\w*|return|else|if|for|break|continue|precision|struct)\b/;

/** @type {readonly Operator[]} */
const OPERATORS = [
  { what: 'flip a comparison', pattern: /(?<![<>=!])(<=|>=|==|!=|<|>)(?![<>=])/g, after: swapped },
  {
    // Between operands only: neither a sign nor part of 1e-20.
    what: 'swap + and -',
    pattern: /(?<=[\w)\]]\s*)(?<![\d.][eE])(?<!return\s*)([+-]=?)(?![+-])(?<!\+\+|--)/g,
    after: swapped,
  },
  { what: 'swap min and max', pattern: /\b(min|max)(?=\()/g, after: swapped },
  { what: 'swap && and ||', pattern: /&&|\|\|/g, after: swapped },
  { what: 'drop a sign', pattern: /(?<=[(=,*?:]\s*|return\s+)-(?=[\w(])/g, after: () => '' },
  {
    what: 'change a constant',
    pattern: /(?<![\w.])(?<!\de[+-])\d+(\.\d*(e[+-]?\d+)?|e[+-]?\d+)/g,
    after: ([text]) => changedFloat(text),
  },
  {
    what: 'change a constant',
    pattern: /(?<![\w.])(?<!\de[+-])\d+(?![\w.])/g,
    after: ([text]) => String(text === '1' ? 0 : Number(text) + 1),
  },
  {
    what: 'never take a branch',
    pattern: /(?<=\bif \()[^;{}]*?(?=\) (\w|\{))/g,
    after: () => 'false',
  },
  { what: 'drop a statement', pattern: /(?<=[;{}]\s*)[a-z][^;{}]*;/g, after: () => ';' },
];

/** 0 and 1 become each other, other numbers double. @param {string} text */
function changedFloat(text) {
  const value = Number(text);
  if (value === 0) return '1.0';
  if (value === 1) return '0.0';
  return (2 * value).toExponential().replace(/^(-?\d+)e/, '$1.0e');
}

/**
 * All mutants of a text, in the order of their places. @param {string} text @returns {GlslMutant[]}
 */
export function glslMutants(text) {
  const code = onlyCode(text);
  /** @type {(GlslMutant & { at: number })[]} */
  const mutants = [];
  for (const { what, pattern, after } of OPERATORS) {
    for (const match of code.matchAll(pattern)) {
      const [before] = match;
      if (what === 'drop a statement' && TYPES.test(before)) continue;
      if (what === 'never take a branch' && !isBalanced(before)) continue;
      const changed = after(/** @type {RegExpExecArray} */ (match));
      const at = match.index;
      const [start, end] = [text.slice(0, at), text.slice(at + before.length)];
      const line = start.split('\n').length;
      mutants.push({ what, at, line, before, after: changed, text: start + changed + end });
    }
  }
  return mutants.sort((a, b) => a.at - b.at);
}

/**
 * The text with everything that is left alone as spaces, each character in its place. @param
 * {string} text
 */
function onlyCode(text) {
  const blank = (/** @type {string} */ part) => part.replace(/[^\n]/g, ' ');
  return text
    .replace(/\/\*[^]*?\*\/|\/\/[^\n]*/g, blank)
    .replace(/^[ \t]*#[^\n]*(?:\\\n[^\n]*)*/gm, blank)
    .replace(/\bfor \([^;]*;[^;]*;[^{;]*\)(?= [\w{])/g, blank);
}

/** @param {string} text */
function isBalanced(text) {
  let depth = 0;
  for (const character of text) {
    if (character === '(') {
      depth += 1;
    }
    if (character === ')') {
      depth -= 1;
    }
    if (depth < 0) return false;
  }
  return depth === 0;
}
