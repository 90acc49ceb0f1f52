// Attribute text to values and back, for every kind of field and every field that elements have. Colours by name need
// a browser and are tested there.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { attributeOf, formatValue, parseText } from '../../src/element/attribute-text.js';
import { VIEWER_FIELDS } from '../../src/element/viewer-fields.js';
import { LIGHT_FIELDS } from '../../src/light/light-state.js';
import {
  booleanField,
  choiceField,
  colorField,
  type Field,
  homogeneousField,
  numberField,
  orWord,
  presenceField,
  subsetField,
  textField,
  vectorField,
} from '../../src/math/field.js';
import { MESH_FIELDS } from '../../src/scene/mesh-fields.js';

const number = numberField(7, { min: -10, max: 10 });
const vector = vectorField([0, 0, 0], { min: -10, max: 10 });

describe('a number', () => {
  it.each([
    ['5', 5],
    [' 5\n', 5],
    ['+5', 5],
    ['-5', -5],
    ['5.', 5],
    ['.5', 0.5],
    ['-.5e1', -5],
    ['1e-3', 0.001],
    ['1E2', 100],
    ['007', 7],
    ['0.1', 0.1],
    ['1e999', Infinity],
  ])('written %j is %d', (text, value) => {
    expect(parseText(text, number)).toBe(value);
  });

  it.each([
    '',
    ' ',
    'NaN',
    'Infinity',
    '-Infinity',
    'five',
    '5px',
    '5 6',
    '5,',
    '1,5',
    '0x10',
    '0b1',
    '1_000',
    '.',
    '+',
    '-',
    '--5',
    '+-5',
    '1e',
    'e5',
    '1e1.5',
    '1.2.3',
    '٣',
    '½',
    '5;',
    '5%',
    'null',
    'true',
  ])('is not %j', (text) => {
    expect(parseText(text, number)).toBeUndefined();
  });

  it('beyond what a double holds is left to the domain to refuse', () => {
    expect(() => number.check(parseText('1e999', number))).toThrow(RangeError);
    expect(number.check(parseText('1e-999', number))).toBe(0);
  });

  it('of a hundred thousand digits is read, or refused, at once', () => {
    const digits = '1'.repeat(100_000);
    const started = performance.now();
    expect(parseText(digits, number)).toBe(Infinity);
    expect(parseText(`${digits}x`, number)).toBeUndefined();
    expect(parseText(`1.${digits}e`, number)).toBeUndefined();
    expect(parseText(`1${' '.repeat(100_000)}x`, number)).toBeUndefined();
    expect(performance.now() - started).toBeLessThan(1000);
  });
});

describe('a list of numbers', () => {
  it.each<[string, number[]]>([
    ['1 2 3', [1, 2, 3]],
    ['1,2,3', [1, 2, 3]],
    ['1, 2 ,3', [1, 2, 3]],
    ['  1\t2\n3  ', [1, 2, 3]],
    ['1 2', [1, 2]],
    ['1 2 3 4 5', [1, 2, 3, 4, 5]],
    ['-1 +.5 1e1', [-1, 0.5, 10]],
    ['5', [5]],
  ])('written %j is %j', (text, value) => {
    expect(parseText(text, vector)).toStrictEqual(value);
  });

  it.each(['', ' ', ',', '1,,2', '1,', ',1', '1 , , 2', '1;2;3', '1 2 x', '[1,2,3]', '1 NaN 3', 'vec3(1)'])(
    'is not %j',
    (text) => {
      expect(parseText(text, vector)).toBeUndefined();
    },
  );

  it('too long or too short is refused by its field', () => {
    expect(() => vector.check(parseText('1 2', vector))).toThrow(TypeError);
    expect(() => vector.check(parseText('1 2 3 4 5', vector))).toThrow(TypeError);
    expect(() => vector.check(parseText('1 2 1e999', vector))).toThrow(RangeError);
  });

  it('of a hundred thousand numbers, or as many blanks, is read at once', () => {
    const started = performance.now();
    expect(parseText('1 '.repeat(100_000), vector)).toHaveLength(100_000);
    expect(parseText(`1${' '.repeat(100_000)}2`, vector)).toStrictEqual([1, 2]);
    expect(parseText(`${'1'.repeat(100_000)}x 2 3`, vector)).toBeUndefined();
    expect(performance.now() - started).toBeLessThan(1000);
  });

  it('of three stands for a place, and of one for a grey', () => {
    const place = homogeneousField([0, 0, 0, 0], { min: -10, max: 10 });
    expect(place.check(parseText('1 2 3', place))).toStrictEqual([1, 2, 3, 1]);
    const color = colorField([0, 0, 0], { min: 0, max: 1e6 });
    expect(color.check(parseText('80', color))).toStrictEqual([80, 80, 80]);
    expect(color.check(parseText('300, 0 .5', color))).toStrictEqual([300, 0, 0.5]);
  });
});

describe('a flag', () => {
  const flag = booleanField(false);
  it.each<[string, boolean | undefined]>([
    ['', true],
    ['true', true],
    [' TRUE ', true],
    ['false', false],
    ['False', false],
    ['0', undefined],
    ['no', undefined],
    ['active', undefined],
  ])('written %j is %s', (text, value) => {
    expect(parseText(text, flag)).toBe(value);
  });

  it.each<[string, boolean]>([
    ['', true],
    ['gui', true],
    ['anything', true],
    ['true', true],
    ['false', false],
    [' FALSE', false],
  ])('by presence, written %j, is %s', (text, value) => {
    expect(parseText(text, presenceField())).toBe(value);
  });
});

describe('words', () => {
  const choice = choiceField('phong', ['phong', 'blinn-phong']);
  const subset = subsetField(['ambient', 'diffuse', 'specular']);
  const auto = orWord('auto', vector);

  it('of a choice are read in any case, and left to the field to refuse', () => {
    expect(choice.check(parseText(' Blinn-Phong ', choice))).toBe('blinn-phong');
    expect(() => choice.check(parseText('blinn', choice))).toThrow(RangeError);
    expect(() => choice.check(parseText('', choice))).toThrow(RangeError);
  });

  it.each<[string, string[]]>([
    ['', []],
    [' ', []],
    ['ambient', ['ambient']],
    ['Specular, ambient', ['ambient', 'specular']],
    ['diffuse diffuse', ['diffuse']],
    [',diffuse,,', ['diffuse']],
  ])('of a subset written %j are %j', (text, words) => {
    expect(subset.check(parseText(text, subset))).toStrictEqual(words);
  });

  it('that are not in a subset are refused by the field', () => {
    expect(() => subset.check(parseText('ambient glow', subset))).toThrow(RangeError);
  });

  it('may stand for a value', () => {
    expect(parseText(' Auto', auto)).toBe('auto');
    expect(parseText('1 2 3', auto)).toStrictEqual([1, 2, 3]);
    expect(parseText('automatic', auto)).toBeUndefined();
    expect(parseText('', auto)).toBeUndefined();
  });

  it('that are left out may mean one', () => {
    expect(parseText('', VIEWER_FIELDS.crossOrigin)).toBe('anonymous');
    expect(parseText('use-credentials', VIEWER_FIELDS.crossOrigin)).toBe('use-credentials');
  });

  it('of plain text are kept as they are', () => {
    expect(parseText('  The Sun ', textField())).toBe('  The Sun ');
    expect(parseText('auto', textField())).toBe('auto');
  });
});

const fields = Object.entries<Field<unknown>>({
  ...Object.fromEntries(Object.entries<Field<unknown>>(LIGHT_FIELDS).map(([key, f]) => [`light ${key}`, f])),
  ...Object.fromEntries(Object.entries<Field<unknown>>(MESH_FIELDS).map(([key, f]) => [`mesh ${key}`, f])),
  ...Object.fromEntries(
    Object.entries<Field<unknown>>(VIEWER_FIELDS).map(([key, f]) => [`viewer ${key}`, f]),
  ),
});

/** Values that the field takes, from guesses of its shape and what its own words say of choices. */
function valuesOf(field: Field<unknown>): fc.Arbitrary<unknown> {
  const words = field.expected.replace(/^(one|any) of /, '').split(', ');
  const n = fc.oneof(
    fc.double({ noNaN: true, noDefaultInfinity: true }),
    fc.double({ min: 0, max: 1, noNaN: true }),
    fc.integer({ min: -512, max: 512 }),
  );
  const shape = {
    number: n,
    numbers: fc.oneof(fc.tuple(n, n, n), fc.tuple(n, n, n, fc.constantFrom(0, 1))),
    color: fc.tuple(n, n, n),
    boolean: fc.boolean(),
    presence: fc.boolean(),
    text: fc.string({ unit: 'grapheme' }),
    choice: fc.constantFrom(...words),
    words: fc.subarray(words),
  }[field.kind] as fc.Arbitrary<unknown>;
  const inside = shape.map((value) => {
    const shrink = (x: unknown): unknown => (typeof x === 'number' ? Math.abs(x) % 100 : x);
    for (const guess of [value, Array.isArray(value) ? value.map(shrink) : shrink(value)]) {
      try {
        return field.check(guess);
      } catch {
        // outside: the next guess, or the default
      }
    }
    return field.fallback;
  });
  return fc.oneof({ weight: 9, arbitrary: inside }, { weight: 1, arbitrary: fc.constant(field.fallback) });
}

describe('formatting', () => {
  it.each(fields)('%s is undone by parsing, to the last bit', (_, field) => {
    fc.assert(
      fc.property(valuesOf(field), (value) => {
        const text = formatValue(value, field);
        // No attribute: the default, which for these is nothing.
        if (text === null) expect(value === null || value === false).toBe(true);
        else expect(field.check(parseText(text, field))).toStrictEqual(value);
      }),
    );
  });

  it.each<[unknown, Field<unknown>, string | null]>([
    [[1, 2, 3], vector, '1 2 3'],
    [[0.1, -1e-7, 1e21], vector, '0.1 -1e-7 1e+21'],
    [5, number, '5'],
    [true, booleanField(true), 'true'],
    [false, booleanField(true), 'false'],
    [true, presenceField(), ''],
    [false, presenceField(), null],
    [[], subsetField(['a']), ''],
    ['auto', orWord('auto', vector), 'auto'],
    [null, MESH_FIELDS.shading, null],
    [undefined, number, null],
    ['', textField(), ''],
  ])('of %j gives %4$s', (value, field, text) => {
    expect(formatValue(value, field)).toBe(text);
  });
});

describe('any text at all', () => {
  const text = fc.oneof(
    fc.string({ unit: 'grapheme' }),
    fc.string({ unit: fc.constantFrom(...Array.from('0123456789+-.,eE \t')) }),
    fc.constantFrom('', ' ', 'NaN', '1e999', 'toString', '__proto__', 'constructor'),
  );

  it('gives a value that the field takes, or is refused by Type- or RangeError, or is malformed', () => {
    const kinds = fields.filter(([, field]) => field.kind !== 'color');
    fc.assert(
      fc.property(fc.constantFrom(...kinds), text, ([, field], attribute) => {
        const value = parseText(attribute, field);
        if (value === undefined) return;
        try {
          const kept = field.check(value);
          for (const x of [kept].flat()) {
            if (typeof x === 'number') expect(Number.isFinite(x)).toBe(true);
          }
        } catch (error) {
          expect(error instanceof TypeError || error instanceof RangeError).toBe(true);
        }
      }),
      { numRuns: 2000 },
    );
  });
});

it.each([
  ['ka', 'ka'],
  ['autoRotate', 'auto-rotate'],
  ['colorInterpolation', 'color-interpolation'],
  ['errorBudget', 'error-budget'],
  ['crossOrigin', 'crossorigin'],
])('property %s is attribute %s', (key, attribute) => {
  expect(attributeOf(key)).toBe(attribute);
});

it('gives every field of an element an attribute of its own', () => {
  for (const table of [LIGHT_FIELDS, MESH_FIELDS, VIEWER_FIELDS]) {
    const names = Object.keys(table).map(attributeOf);
    expect(new Set(names).size).toBe(names.length);
    for (const name of names) expect(name).toMatch(/^[a-z]+(-[a-z]+)*$/);
  }
});
