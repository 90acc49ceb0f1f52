// What does each kind of field accept, and what does it refuse, in which words? Values in HTML's
// units; no DOM.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  booleanField,
  choiceField,
  colorField,
  type Field,
  type FieldKind,
  flagOrWordsField,
  homogeneousField,
  numberField,
  numbersField,
  optional,
  orAuto,
  presenceField,
  scaleField,
  subsetField,
  textField,
  vectorField,
} from '../../../src/phong/fields/field.js';

/**
 * Made anew by each test, so that `npm run mutation` connects what makes a field to the tests that
 * notice it.
 */
const makers = {
  number: () => numberField(5, { min: 0, max: 10 }),
  'positive number': () => numberField(4, { above: 0, max: 1e15 }),
  'whole number': () => numberField(1, { min: 1, max: 512, integer: true }),
  'any number': () => numberField(0, {}),
  vector: () => vectorField([1, 2, 3], { min: -10, max: 10 }),
  homogeneous: () => homogeneousField([1, 1, 1, 0], { min: -10, max: 10 }),
  scale: () => scaleField([1, 1, 1], { min: -2, max: 2 }),
  color: () => colorField([0, 0, 0], { min: 0, max: 1e6 }),
  ascending: () => numbersField('places from 0 to 1', 0, 1),
  boolean: () => booleanField(),
  presence: () => presenceField(),
  text: () => textField(),
  choice: () => choiceField(['red', 'green', '']),
  subset: () => subsetField(['a', 'b', 'c']),
  'flag or words': () =>
    flagOrWordsField('gui', 'a flag, or words of one list', [
      ['a', 'b'],
      ['c', 'd'],
    ]),
  'optional number': () => optional(numberField(5, { min: 0, max: 10 })),
  'number or word': () => orAuto(numberField(5, { min: 0, max: 10 })),
} satisfies Record<string, () => Field<unknown>>;

type Kind = keyof typeof makers;
const kinds = Object.keys(makers) as Kind[];
const fieldOf = (kind: Kind) => makers[kind]();

describe('a field', () => {
  it.each<[Kind, FieldKind, unknown, string]>([
    ['number', 'number', 5, 'a number from 0 to 10'],
    ['positive number', 'number', 4, 'a number above 0, up to 1e15'],
    ['whole number', 'number', 1, 'a whole number from 1 to 512'],
    ['any number', 'number', 0, 'a number'],
    ['vector', 'numbers', [1, 2, 3], '3 numbers, each a number from -10 to 10'],
    [
      'homogeneous',
      'numbers',
      [1, 1, 1, 0],
      '3 or 4 numbers x y z w, each a number from -10 to 10, w 0 or 1',
    ],
    ['scale', 'numbers', [1, 1, 1], '1 or 3 numbers, each a number from -2 to 2'],
    ['color', 'color', [0, 0, 0], 'r g b (or one number), each a number from 0 to 1e6 with 255 full, or a CSS colour in sRGB'], // oxfmt-ignore
    ['ascending', 'numbers', [], 'places from 0 to 1'],
    ['boolean', 'boolean', true, 'true or false'],
    ['presence', 'presence', false, 'true or false'],
    ['text', 'text', '', 'text'],
    ['choice', 'choice', 'red', 'one of red, green, (empty)'],
    ['subset', 'words', ['a', 'b', 'c'], 'any of a, b, c'],
    ['flag or words', 'flag-or-words', false, 'a flag, or words of one list'],
    ['optional number', 'number', null, 'a number from 0 to 10'],
    ['number or word', 'number', 'auto', 'auto or a number from 0 to 10'],
  ])(
    'of a %s is written as %s, with the default %j, and expects %s',
    (kind, written, fallback, expected) => {
      expect(fieldOf(kind)).toMatchObject({ kind: written, fallback, expected });
    },
  );

  it.each([
    [{ max: 3 }, 'a number'],
    [{ min: 3 }, 'a number'],
    [{ above: 3 }, 'a number'],
    [{ min: 99_999, max: 100_000 }, 'a number from 99999 to 1e5'],
    [{ min: -100_000, max: 0 }, 'a number from -1e5 to 0'],
    [{ above: -100_000, max: 0 }, 'a number above -1e5, up to 0'],
  ])('names the bounds of %o', (range, expected) => {
    expect(numberField(0, range).expected).toBe(expected);
  });

  it.each<Kind>(['vector', 'homogeneous', 'scale', 'color', 'subset'])(
    'of a %s copies the given list, and its default is frozen',
    (kind) => {
      const field = fieldOf(kind);
      expect(Object.isFrozen(field.fallback)).toBe(true);
      const given = [...(field.fallback as unknown[])];
      const kept = field.check(given);
      given[0] = 9;
      expect(kept).toStrictEqual(field.fallback);
    },
  );
});

describe('what a field accepts', () => {
  // Strictly equal numbers have the same sign of zero.
  it.each<[Kind, unknown, unknown]>([
    ['number', -0, 0],
    ['positive number', 5e-324, 5e-324],
    ['any number', Number.MAX_VALUE, Number.MAX_VALUE],
    ['vector', new Float32Array([1, 2, 3]), [1, 2, 3]],
    ['homogeneous', [1, 2, 3], [1, 2, 3, 1]],
    ['scale', 2, [2, 2, 2]],
    ['color', 80, [80, 80, 80]],
    ['ascending', 0.5, [0.5]],
    ['subset', ['c', 'a', 'c'], ['a', 'c']],
    ['flag or words', ['gui'], true],
    ['flag or words', [], false],
  ])('%s keeps %j as %j', (kind, value, kept) => {
    expect(fieldOf(kind).check(value)).toStrictEqual(kept);
  });

  it.each([
    ['ascending', 0],
    ['subset', 'a'],
    ['flag or words', 'a'],
  ] as const)('%s takes a thousand items, and no more', (kind, item) => {
    const field = fieldOf(kind);
    expect(() => field.check(Array(1000).fill(item))).not.toThrow();
    expect(() => field.check(Array(1001).fill(item))).toThrow(TypeError);
  });
});

describe('what a field refuses', () => {
  const holes = Object.assign(['a'], { length: 3 });
  const withoutText: unknown = Object.create(null);

  it.each<[Kind, string, unknown]>([
    ['number', '"5"', '5'],
    ['number', '5', 5n],
    ['number', 'true', true],
    ['number', 'an object', new Date(0)],
    ['number', 'null', null],
    ['number', 'a function', () => 5],
    ['number', 'Symbol(s)', Symbol('s')],
    ['vector', '"1 2 3"', '1 2 3'],
    ['vector', '[1, 2]', [1, 2]],
    ['vector', '[1, 2, 3, 4, 5]', [1, 2, 3, 4, 5]],
    ['vector', '[1, 2, 3, 4, 5, ...]', [1, 2, 3, 4, 5, 6]],
    ['vector', '[1, "2", null]', [1, '2', null]],
    ['vector', '[1, undefined, 3]', [1, undefined, 3]],
    ['vector', 'an object', { 0: 1, 1: 2, 2: 3, length: 3 }],
    ['vector', 'an object', new DataView(new ArrayBuffer(24))],
    ['vector', 'an object', withoutText],
    ['vector', '[an object]', [withoutText]],
    ['vector', '["a", , ]', holes],
    ['ascending', '[0, "1"]', [0, '1']],
    ['presence', '""', ''],
    ['choice', 'an object', { toString: null }],
    ['subset', '[1]', [1]],
    ['subset', '["a", null]', ['a', null]],
    ['subset', '["a", , ]', holes],
    ['flag or words', 'an object', { length: 0 }],
    ['number or word', '"none"', 'none'],
  ])('%s throws a TypeError that shows %s', (kind, shown, value) => {
    const field = fieldOf(kind);
    const error = new TypeError(`expected ${field.expected}, got ${shown}`);
    expect(() => field.check(value)).toThrow(error);
  });

  it.each<[Kind, string, unknown]>([
    ['number', '-1e-300', -1e-300],
    ['number', '10.000000001', 10.000000001],
    ['positive number', '0', 0],
    ['whole number', '1.5', 1.5],
    ['any number', 'Infinity', Infinity],
    ['vector', '10.1', [0, 0, 10.1]],
    ['homogeneous', '[1, 2, 3, 0.5]', [1, 2, 3, 0.5]],
    ['color', '-1', -1],
    ['color', '1000001', [0, 0, 1e6 + 1]],
    ['ascending', '[0, 0.5, 0.4, 1]', [0, 0.5, 0.4, 1]],
    ['choice', '"toString"', 'toString'],
    ['subset', '"d"', ['a', 'd']],
    ['flag or words', '["a", "c"]', ['a', 'c']],
    ['flag or words', '["gui", "a"]', ['gui', 'a']],
    ['optional number', '11', 11],
    ['number or word', '11', 11],
  ])('%s throws a RangeError that shows %s', (kind, shown, value) => {
    const field = fieldOf(kind);
    const error = new RangeError(`expected ${field.expected}, got ${shown}`);
    expect(() => field.check(value)).toThrow(error);
  });

  it('is anything else, by one of these two errors', () => {
    const value = fc.anything({
      withBigInt: true,
      withTypedArray: true,
      withNullPrototype: true,
      withSparseArray: true,
    });
    fc.assert(
      fc.property(fc.constantFrom(...kinds.map(fieldOf)), value, (field, given) => {
        try {
          field.check(given);
        } catch (error) {
          expect(error instanceof TypeError || error instanceof RangeError).toBe(true);
          expect((error as Error).message).toContain(`expected ${field.expected}, got `);
        }
      }),
      { numRuns: 3000 },
    );
  });

  it('is shown by no more than a sentence, at once, however long it is or claims to be', () => {
    const long = 'x'.repeat(1e5);
    const itself: unknown[] = [];
    itself.push(itself);
    const values = [
      long,
      [long],
      Array(1e5).fill(7),
      Array(1e5).fill(long),
      itself,
      [[itself]],
      10n ** 9999n,
      new Array(2 ** 32 - 1),
    ];
    for (const kind of kinds) {
      for (const value of values) {
        try {
          fieldOf(kind).check(value);
        } catch (error) {
          expect((error as Error).message.length, kind).toBeLessThan(800);
        }
      }
    }
  });
});
