// What does each kind of field accept, and what does it refuse, in which words? Values in HTML's units; no DOM.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  booleanField,
  choiceField,
  colorField,
  type Field,
  flagOrWordsField,
  homogeneousField,
  numberField,
  numbersField,
  optional,
  orWord,
  presenceField,
  scaleField,
  subsetField,
  textField,
  vectorField,
} from '../../src/fields/field.js';

const kinds = {
  number: numberField(5, { min: 0, max: 10 }),
  'positive number': numberField(4, { above: 0, max: 1e15 }),
  'whole number': numberField(1, { min: 1, max: 512, integer: true }),
  vector: vectorField([1, 2, 3], { min: -10, max: 10 }),
  homogeneous: homogeneousField([1, 1, 1, 0], { min: -10, max: 10 }),
  scale: scaleField([1, 1, 1], { min: -2, max: 2 }),
  color: colorField([0, 0, 0], { min: 0, max: 1e6 }),
  boolean: booleanField(true),
  presence: presenceField(),
  text: textField(),
  choice: choiceField('red', ['red', 'green']),
  subset: subsetField(['a', 'b', 'c']),
  'flag or words': flagOrWordsField('gui', 'a flag, or words of one list', [
    ['a', 'b'],
    ['c', 'd'],
  ]),
  'optional number': optional(numberField(5, { min: 0, max: 10 })),
  'number or word': orWord('auto', numberField(5, { min: 0, max: 10 })),
} as const satisfies Record<string, Field<unknown>>;

type Kind = keyof typeof kinds;

describe('what a field accepts', () => {
  const rows: [Kind, unknown, unknown][] = [
    ['number', 0, 0],
    ['number', 10, 10],
    ['number', 5e-324, 5e-324],
    ['positive number', 5e-324, 5e-324],
    ['positive number', 1e15, 1e15],
    ['whole number', 512, 512],
    ['vector', [1, -10, 10], [1, -10, 10]],
    ['vector', new Float32Array([1, 2, 3]), [1, 2, 3]],
    ['vector', new Int8Array([1, 2, 3]), [1, 2, 3]],
    ['homogeneous', [1, 2, 3, 0], [1, 2, 3, 0]],
    ['homogeneous', [1, 2, 3], [1, 2, 3, 1]],
    ['homogeneous', [1, 2, 3, -0], [1, 2, 3, 0]],
    ['scale', 2, [2, 2, 2]],
    ['scale', [2], [2, 2, 2]],
    ['scale', [1, -2, 0], [1, -2, 0]],
    ['color', 80, [80, 80, 80]],
    ['color', [1e6, 0, 0.5], [1e6, 0, 0.5]],
    ['boolean', false, false],
    ['presence', true, true],
    ['text', '', ''],
    ['choice', 'green', 'green'],
    ['subset', [], []],
    ['subset', ['c', 'a', 'c'], ['a', 'c']],
    ['flag or words', true, true],
    ['flag or words', false, false],
    ['flag or words', ['gui'], true],
    ['flag or words', [], false],
    ['flag or words', ['b', 'a', 'b'], ['b', 'a']],
    ['flag or words', ['a'], ['a']],
    ['flag or words', Array.from({ length: 1000 }, () => 'd'), ['d']],
    ['optional number', 3, 3],
    ['number or word', 'auto', 'auto'],
    ['number or word', 3, 3],
  ];
  it.each(rows)('%s accepts %j as %j', (kind, value, kept) => {
    expect(kinds[kind].check(value)).toStrictEqual(kept);
  });

  it.each<[Kind, unknown]>([
    ['number', -0],
    ['vector', [-0, -0, -0]],
    ['scale', -0],
    ['color', [-0, 0, -0]],
    ['homogeneous', [-0, 0, -0, -0]],
  ])('%s keeps %j without the sign of zero', (kind, value) => {
    const kept = kinds[kind].check(value);
    for (const n of [kept].flat()) expect(Object.is(n, -0)).toBe(false);
  });
});

describe('what a field refuses', () => {
  const types: [Kind, unknown][] = [
    ['number', '5'],
    ['number', 5n],
    ['number', true],
    ['number', [5]],
    ['number', new Date(0)],
    ['number', null],
    ['number', undefined],
    ['vector', 5],
    ['vector', '1 2 3'],
    ['vector', [1, 2]],
    ['vector', [1, 2, 3, 4]],
    ['vector', [1, '2', 3]],
    ['vector', [1, undefined, 3]],
    ['vector', { 0: 1, 1: 2, 2: 3, length: 3 }],
    ['vector', new DataView(new ArrayBuffer(24))],
    ['vector', new BigInt64Array(3)],
    ['vector', null],
    ['vector', []],
    ['homogeneous', [1, 2]],
    ['homogeneous', [1, 2, 3, 0, 0]],
    ['scale', [1, 2]],
    ['scale', []],
    ['color', '#fff'],
    ['color', [1, 2, 3, 4]],
    ['boolean', 'true'],
    ['boolean', 1],
    ['presence', ''],
    ['text', 5],
    ['text', null],
    ['choice', 0],
    ['choice', new String('red')],
    ['subset', 'a'],
    ['subset', [1]],
    ['subset', [undefined]],
    ['subset', ['a', null]],
    ['subset', new Set(['a'])],
    ['flag or words', 'a'],
    ['flag or words', { length: 0 }],
    ['flag or words', Array.from({ length: 1001 }, () => 'd')],
    ['optional number', '5'],
    ['number or word', true],
  ];
  it.each(types)('%s throws TypeError for %o', (kind, value) => {
    const field: Field<unknown> = kinds[kind];
    expect(() => field.check(value)).toThrow(TypeError);
    expect(() => field.check(value)).toThrow(field.expected);
  });

  const outside: [Kind, unknown][] = [
    ['number', -1e-300],
    ['number', 10.000000001],
    ['number', NaN],
    ['number', Infinity],
    ['number', -Infinity],
    ['positive number', 0],
    ['positive number', -0],
    ['positive number', NaN],
    ['whole number', 1.5],
    ['whole number', 0],
    ['whole number', 513],
    ['vector', [0, 0, 10.1]],
    ['vector', [0, NaN, 0]],
    ['vector', [0, 0, -Infinity]],
    ['vector', new Float64Array([0, 0, NaN])],
    ['homogeneous', [1, 2, 3, 0.5]],
    ['homogeneous', [1, 2, 3, 2]],
    ['homogeneous', [11, 2, 3, 1]],
    ['scale', 2.5],
    ['scale', NaN],
    ['color', -1],
    ['color', [0, 0, 1e6 + 1]],
    ['choice', 'blue'],
    ['choice', 'RED'],
    ['choice', ''],
    ['choice', 'toString'],
    ['subset', ['a', 'd']],
    ['subset', ['']],
    ['optional number', 11],
    ['number or word', 11],
    ['number or word', NaN],
  ];
  it.each(outside)('%s throws RangeError for %o', (kind, value) => {
    const field: Field<unknown> = kinds[kind];
    expect(() => field.check(value)).toThrow(RangeError);
    expect(() => field.check(value)).toThrow(field.expected);
  });

  it('a list with holes in it', () => {
    const holes: unknown[] = ['a'];
    holes.length = 3;
    expect(() => kinds.subset.check(holes)).toThrow(TypeError);
    expect(() => kinds.vector.check(holes)).toThrow(TypeError);
  });

  it('a word where none is allowed, and words other than the allowed one', () => {
    expect(() => kinds.number.check('auto')).toThrow(TypeError);
    expect(() => kinds['number or word'].check('none')).toThrow(TypeError);
  });

  it('anything by one of these two errors', () => {
    fc.assert(
      fc.property(
        fc.constantFrom(...Object.values<Field<unknown>>(kinds)),
        fc.anything({
          withBigInt: true,
          withTypedArray: true,
          withNullPrototype: true,
          withSparseArray: true,
        }),
        (field, value) => {
          try {
            field.check(value);
          } catch (error) {
            expect(error instanceof TypeError || error instanceof RangeError).toBe(true);
            expect((error as Error).message).toContain(`expected ${field.expected}, got `);
          }
        },
      ),
      { numRuns: 3000 },
    );
  });
});

describe('what a field gives', () => {
  it.each(Object.entries<Field<unknown>>(kinds))('%s accepts its own default, if it has one', (_, field) => {
    if (field.fallback !== null) expect(field.check(field.fallback)).toStrictEqual(field.fallback);
  });

  it('is a copy of the given list, and its default is frozen', () => {
    for (const kind of ['vector', 'homogeneous', 'scale', 'color', 'subset'] as const) {
      const field: Field<unknown> = kinds[kind];
      expect(Object.isFrozen(field.fallback)).toBe(true);
      const given = [...(field.fallback as unknown[])];
      const kept = field.check(given);
      given[0] = 9;
      expect(kept).toStrictEqual(field.fallback);
    }
  });

  it('stays the same when it is checked again', () => {
    const vector = fc.tuple(
      fc.double({ min: -10, max: 10 }),
      fc.double({ min: -10, max: 10 }),
      fc.double({ min: -10, max: 10 }),
    );
    fc.assert(
      fc.property(vector, (v) => {
        fc.pre(v.every((x) => !Number.isNaN(x)));
        for (const field of [kinds.vector, kinds.homogeneous]) {
          expect(field.check(field.check(v))).toStrictEqual(field.check(v));
        }
      }),
    );
  });
});

describe('the words for a domain', () => {
  it.each<[Kind, string]>([
    ['number', 'a number from 0 to 10'],
    ['positive number', 'a number above 0, up to 1e15'],
    ['whole number', 'a whole number from 1 to 512'],
    ['vector', '3 numbers, each a number from -10 to 10'],
    ['homogeneous', '3 or 4 numbers x y z w, each a number from -10 to 10, w 0 or 1'],
    ['scale', '1 or 3 numbers, each a number from -2 to 2'],
    ['color', 'r g b (or one number), each a number from 0 to 1e6 with 255 full, or a CSS colour in sRGB'],
    ['boolean', 'true or false'],
    ['text', 'text'],
    ['choice', 'one of red, green'],
    ['subset', 'any of a, b, c'],
    ['optional number', 'a number from 0 to 10'],
    ['number or word', 'auto or a number from 0 to 10'],
  ])('of %s are "%s"', (kind, words) => {
    expect(kinds[kind].expected).toBe(words);
  });

  it('show the value that was refused', () => {
    expect(() => kinds.number.check('5')).toThrow('expected a number from 0 to 10, got "5"');
    expect(() => kinds.vector.check([1, 'x', null])).toThrow('got [1, "x", null]');
    expect(() => kinds.number.check({})).toThrow('got an object');
    expect(() => kinds.number.check(NaN)).toThrow('got NaN');
    expect(() => kinds.subset.check(['a', 'z'])).toThrow('got "z"');
  });
});

describe('the error repeats what was given', () => {
  const messageOf = (field: Field<unknown>, value: unknown): string => {
    try {
      field.check(value);
    } catch (error) {
      return (error as Error).message;
    }
    return '';
  };

  it('no longer than a sentence, however long it is', () => {
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
    ];
    for (const [kind, field] of Object.entries(kinds))
      for (const value of values) expect(messageOf(field, value).length, kind).toBeLessThan(800);
  });

  it('even if it cannot become text', () => {
    const values = [Object.create(null), Symbol('s'), { toString: null }, [Object.create(null)], () => 0];
    for (const field of [kinds.vector, kinds.number, kinds.choice])
      for (const value of values) expect(() => field.check(value)).toThrow(TypeError);
  });

  it('at once, however long a list claims to be', () => {
    for (const field of [kinds.vector, kinds.color, kinds.subset])
      expect(messageOf(field, new Array(2 ** 32 - 1)).length).toBeLessThan(800);
  });

  it('and marks where a list was cut', () => {
    expect(messageOf(kinds.vector, [1, 2, 3, 4, 5, 6])).toContain('got [1, 2, 3, 4, 5, ...]');
    expect(messageOf(kinds.vector, [1, [2], 3])).toContain('got [1, an object, 3]');
  });
});

describe('what a field expects, in words,', () => {
  const words: Record<Kind, string> = {
    number: 'a number from 0 to 10',
    'positive number': 'a number above 0, up to 1e15',
    'whole number': 'a whole number from 1 to 512',
    vector: '3 numbers, each a number from -10 to 10',
    homogeneous: '3 or 4 numbers x y z w, each a number from -10 to 10, w 0 or 1',
    scale: '1 or 3 numbers, each a number from -2 to 2',
    color: 'r g b (or one number), each a number from 0 to 1e6 with 255 full, or a CSS colour in sRGB',
    boolean: 'true or false',
    presence: 'true or false',
    text: 'text',
    choice: 'one of red, green',
    subset: 'any of a, b, c',
    'flag or words': 'a flag, or words of one list',
    'optional number': 'a number from 0 to 10',
    'number or word': 'auto or a number from 0 to 10',
  };
  it.each(Object.entries(words) as [Kind, string][])('is right for a %s', (kind, expected) => {
    expect(kinds[kind].expected).toBe(expected);
  });

  it.each([
    [{}, 'a number'],
    [{ max: 3 }, 'a number'],
    [{ min: 3 }, 'a number'],
    [{ above: 3 }, 'a number'],
    [{ min: 99_999, max: 100_000 }, 'a number from 99999 to 1e5'],
    [{ min: -100_000, max: 0 }, 'a number from -1e5 to 0'],
  ])('names the bounds of %o', (range, expected) => {
    expect(numberField(0, range).expected).toBe(expected);
  });

  it('names an empty choice', () => {
    expect(choiceField<'' | 'a'>('', ['', 'a']).expected).toBe('one of (empty), a');
  });
});

describe('numbers in ascending order', () => {
  const field = numbersField('places from 0 to 1', 0, 1);

  it('may be equal, and one may stand alone', () => {
    expect(field.check([0, 0.5, 0.5, 1])).toEqual([0, 0.5, 0.5, 1]);
    expect(field.check(0.5)).toEqual([0.5]);
    expect(field.check([0.5])).toEqual([0.5]);
  });

  it('must ascend', () => {
    expect(() => field.check([0.5, 0.4])).toThrow(
      new RangeError('expected places from 0 to 1, got [0.5, 0.4]'),
    );
    expect(() => field.check([0, 0.5, 0.4, 1])).toThrow(RangeError);
  });

  it('are at least one, at most a thousand, and numbers', () => {
    expect(() => field.check([])).toThrow(new TypeError('expected places from 0 to 1, got []'));
    expect(field.check(new Array(1000).fill(0))).toHaveLength(1000);
    expect(() => field.check(new Array(1001).fill(0))).toThrow(TypeError);
    expect(() => field.check('0.5')).toThrow(TypeError);
  });
});

describe('a message', () => {
  const messageFor = (value: unknown): string => {
    try {
      return String(kinds.vector.check(value));
    } catch (error) {
      return (error as Error).message;
    }
  };

  it('repeats up to five items whole', () => {
    expect(messageFor([1, 2, 3, 4, 5])).toContain('got [1, 2, 3, 4, 5]');
  });

  it('names functions and objects by what they are', () => {
    expect(messageFor(() => 0)).toContain('got a function');
    expect(messageFor({})).toContain('got an object');
    expect(messageFor(null)).toContain('got null');
  });
});

it('a list of a thousand words is still a list of words', () => {
  expect(kinds.subset.check(new Array(1000).fill('a'))).toEqual(['a']);
  expect(() => kinds.subset.check(new Array(1001).fill('a'))).toThrow(TypeError);
});
