// Attribute text to values, and values to text that gives them back, for every kind of field.
// Colours by name need a browser and are tested there.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { formatValue, parseText, valueWarning } from '../../../src/phong/fields/attribute-text.js';
import { VIEWER_FIELDS } from '../../../src/viewer/element/fields/viewer-fields.js';
import { sameValue } from '../../../src/phong/fields/field-store.js';
import {
  booleanField,
  choiceField,
  type Field,
  numberField,
  presenceField,
  subsetField,
  textField,
  vectorField,
} from '../../../src/phong/fields/field.js';
import { LIGHT_FIELDS } from '../../../src/phong/light/light-state.js';
import { MESH_FIELDS } from '../../../src/phong/model/mesh-fields.js';
import { between, triple } from '../arbitraries.js';

const number = numberField(7, { min: -10, max: 10 });
const vector = vectorField([0, 0, 0], { min: -10, max: 10 });

describe('a number', () => {
  it.each([
    '5',
    ' 5\n',
    '+5',
    '-5',
    '5.',
    '.5',
    '-.5e1',
    '1e-3',
    '1E2',
    '007',
    '0.1',
    '1e999',
    '1e-999',
  ])('written %j is what JavaScript makes of it', (text) => {
    expect(parseText(text, number)).toBe(Number(text));
  });

  const malformed =
    'NaN Infinity -Infinity five 5px 5, 1,5 0x10 0b1 1_000 . + - --5 +-5 1e e5 1e1.5 1.2.3 ٣ ½ 5; 5% null true';
  it.each(['', ' ', '5 6', ...malformed.split(' ')])('is not %j', (text) => {
    expect(parseText(text, number)).toBeUndefined();
  });

  // A pattern that backtracks over these lengths would time out.
  it('of hundreds of thousands of digits is read or refused in one pass', () => {
    const digits = '1'.repeat(300_000);
    expect(parseText(digits, number)).toBe(Infinity);
    expect(parseText(`${digits}x`, number)).toBeUndefined();
    expect(parseText(`1.${digits}e`, number)).toBeUndefined();
    expect(parseText(`1${' '.repeat(300_000)}x`, number)).toBeUndefined();
  });
});

describe('a list of numbers', () => {
  it.each([
    ['1 2 3', [1, 2, 3]],
    ['1,2,3', [1, 2, 3]],
    ['1, 2 ,3', [1, 2, 3]],
    ['  1\t2\n3  ', [1, 2, 3]],
    ['1 2', [1, 2]],
    ['1 2 3 4 5', [1, 2, 3, 4, 5]],
    ['-1 +.5 1e1', [-1, 0.5, 10]],
    ['5', [5]],
    ['1 2 1e999', [1, 2, Infinity]],
  ])('written %j is %j', (text, value) => {
    expect(parseText(text, vector)).toStrictEqual(value);
  });

  it.each([
    '',
    ' ',
    ',',
    '1,,2',
    '1,',
    ',1',
    '1 , , 2',
    '1;2;3',
    '1 2 x',
    '[1,2,3]',
    '1 NaN 3',
    'vec3(1)',
  ])('is not %j', (text) => {
    expect(parseText(text, vector)).toBeUndefined();
  });

  it('of a hundred thousand numbers, or more blanks, is read in one pass', () => {
    expect(parseText('1 '.repeat(100_000), vector)).toHaveLength(100_000);
    expect(parseText(`1${' '.repeat(300_000)}2`, vector)).toStrictEqual([1, 2]);
    expect(parseText(`${'1'.repeat(300_000)}x 2 3`, vector)).toBeUndefined();
  });
});

const fields = Object.entries({
  light: LIGHT_FIELDS,
  mesh: MESH_FIELDS,
  viewer: VIEWER_FIELDS,
}).flatMap(([element, table]) =>
  Object.entries<Field<unknown>>(table).map(
    ([key, field]) => [`${element} ${key}`, field] as const,
  ),
);

/** Values that the field accepts: guesses by its kind, and its own choices. */
function valuesOf(field: Field<unknown>) {
  const words = field.expected.replace(/^(one|any) of /, '').split(', ');
  const n = fc.oneof(
    fc.double({ noNaN: true, noDefaultInfinity: true }),
    between(0, 1),
    fc.integer({ min: -512, max: 512 }),
  );
  const shape = {
    number: n,
    numbers: fc.oneof(triple(n), fc.tuple(n, n, n, fc.constantFrom(0, 1))),
    color: triple(n),
    boolean: fc.boolean(),
    presence: fc.boolean(),
    text: fc.string({ unit: 'grapheme' }),
    choice: fc.constantFrom(...words),
    words: fc.subarray(words),
    'flag-or-words': fc.oneof(fc.boolean(), fc.constantFrom(['lights'], ['cutoff', 'theta'])),
  }[field.kind] as fc.Arbitrary<unknown>;
  const inside = shape.map((value) => {
    const shrink = (x: unknown) => (typeof x === 'number' ? Math.abs(x) % 100 : x);
    for (const guess of [value, Array.isArray(value) ? value.map(shrink) : shrink(value)]) {
      try {
        return field.check(guess);
      } catch {
        // outside: the next guess, or the default
      }
    }
    return field.fallback;
  });
  return fc.oneof(
    { weight: 9, arbitrary: inside },
    { weight: 1, arbitrary: fc.constant(field.fallback) },
  );
}

describe('formatting', () => {
  it.each(fields)('%s is undone by parsing, to the last bit', (_, field) => {
    fc.assert(
      fc.property(valuesOf(field), (value) => {
        const text = formatValue(value, field);
        // No attribute: the default, which for these is nothing.
        if (text === null) {
          expect(value === null || value === false || sameValue(value, field.fallback)).toBe(true);
        } else {
          expect(field.check(parseText(text, field))).toStrictEqual(value);
        }
      }),
    );
  });

  it.each([
    [[0.1, -1e-7, 1e21], '0.1 -1e-7 1e+21', vector],
    [true, 'true', booleanField()],
    [false, 'false', booleanField()],
    [true, '', presenceField()],
    [false, null, presenceField()],
    [true, '', VIEWER_FIELDS.gui],
    [false, null, VIEWER_FIELDS.gui],
    [['cutoff', 'theta'], 'cutoff theta', VIEWER_FIELDS.gui],
    [[], '', subsetField(['a'])],
    [null, null, MESH_FIELDS.shading],
    [undefined, null, number],
    ['', '', textField()],
  ])('of %j gives %j', (value, text, field) => {
    expect(formatValue(value, field)).toBe(text);
  });
});

it('any text gives an accepted value, a TypeError or RangeError, or counts as malformed', () => {
  const text = fc.oneof(
    fc.string({ unit: 'grapheme' }),
    fc.string({ unit: fc.constantFrom(...Array.from('0123456789+-.,eE \t')) }),
    fc.constantFrom('', ' ', 'NaN', '1e999', 'toString', '__proto__', 'constructor'),
  );
  const kinds = fields.filter(([, field]) => field.kind !== 'color');
  fc.assert(
    fc.property(fc.constantFrom(...kinds), text, ([, field], attribute) => {
      const value = parseText(attribute, field);
      if (value === undefined) return;
      try {
        for (const x of [field.check(value)].flat()) {
          if (typeof x === 'number') {
            expect(Number.isFinite(x)).toBe(true);
          }
        }
      } catch (error) {
        expect(error instanceof TypeError || error instanceof RangeError).toBe(true);
      }
    }),
    { numRuns: 2000 },
  );
});

const warning = (value: unknown, field: Field<unknown>) =>
  valueWarning('phong-viewer', 'autoRotate', value, field);

it.each([
  [vector, 'far', /auto-rotate="far": expected .+; using 0 0 0 instead\.$/],
  [choiceField(['flat', 'gouraud']), ' GOURAUDD', /using flat instead\. Did you mean "gouraud"\?$/],
  [choiceField(['flat', 'gouraud']), 'toon', /using flat instead\.$/],
  [choiceField(['flat', 'gouraud']), ['gouraud'], /using flat instead\.$/],
  [textField(), 'a', /using none instead\.$/],
  [MESH_FIELDS.shading, 'a', /using none instead\.$/],
])(
  'the warning about a value names what was expected and what is used: %#',
  (field, value, text) => {
    expect(warning(value, field)).toMatch(text);
  },
);
