// @ts-check
// The normal matrix: cofactors, their scaling and their sign.

import { mutantsOf } from './mutants-of.mjs';

/** Each cofactor is a difference of two products; one of them goes. */
const COFACTORS = [
  'c0 = e * i - f * h',
  'c1 = f * g - d * i',
  'c2 = d * h - e * g',
  'c3 = h * c - i * b',
  'c4 = i * a - g * c',
  'c5 = g * b - h * a',
  'c6 = b * f - c * e',
  'c7 = c * d - a * f',
  'c8 = a * e - b * d',
];

export const normalMutants = mutantsOf('src/material/normal-matrix.ts', [
  ['the guard of a matrix of zeros', 'if (!(largest > 0)) {', 'if (false) {'],
  ['the scaling before cofactors are taken', 'const largest = Math.max(', 'const largest = 1 || Math.max('],
  [
    'division by the largest entry: its inverse overflows',
    'const a = m[0] / largest',
    'const a = m[0] * (1 / largest)',
  ],
  ['the scaling of the second column', 'const d = m[4] / largest', 'const d = m[4]'],
  ['the scaling of the third column', 'const g = m[8] / largest', 'const g = m[8]'],
  ...COFACTORS.map((text) => {
    const [, first, second] = /** @type {RegExpExecArray} */ (/= (.+) - (.+)$/.exec(text));
    const to = text.replace(`${first} - ${second}`, `${first} + ${second}`);
    return /** @type {const} */ ([`the sign in ${text}`, text, to]);
  }),
  ['the first term of the determinant', 'a * c0 + b * c1 + c * c2', 'b * c1 + c * c2'],
  ['the second term of the determinant', 'a * c0 + b * c1 + c * c2', 'a * c0 + c * c2'],
  ['the third term of the determinant', 'a * c0 + b * c1 + c * c2', 'a * c0 + b * c1'],
  ['the determinant’s sign', 'determinant < 0 ? -top : top', 'top'],
  [
    'the guard of meshes flattened to a line',
    'top > 0 ? (determinant < 0 ? -top : top) : 1',
    'determinant < 0 ? -top : top',
  ],
  [
    'the scaling to a largest entry of 1',
    '(elements[k] ?? 0) / signed',
    '(elements[k] ?? 0) * Math.sign(signed)',
  ],
  ['the largest cofactor: those of the third column', '    Math.abs(c6), Math.abs(c7), Math.abs(c8),\n', ''],
  [
    'cofactors by columns',
    'out.set(c0, c3, c6, c1, c4, c7, c2, c5, c8)',
    'out.set(c0, c1, c2, c3, c4, c5, c6, c7, c8)',
  ],
]);
