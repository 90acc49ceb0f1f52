// Attribute text to values, for every kind of field. Colours by name need a browser and are tested there.

import { describe, expect, it } from 'vitest';
import { attributeOf, parseText } from '../../src/element/fields/attribute-text.js';
import { VIEWER_FIELDS } from '../../src/element/fields/viewer-fields.js';
import { LIGHT_FIELDS } from '../../src/light/light-state.js';
import {
  booleanField,
  choiceField,
  colorField,
  homogeneousField,
  numberField,
  orWord,
  presenceField,
  subsetField,
  textField,
  vectorField,
} from '../../src/fields/field.js';
import { MESH_FIELDS } from '../../src/scene/mesh/mesh-fields.js';

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

  it('beyond the range of a double is refused by the field', () => {
    expect(() => number.check(parseText('1e999', number))).toThrow(RangeError);
    expect(number.check(parseText('1e-999', number))).toBe(0);
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

  it('of a hundred thousand numbers, or more blanks, is read in one pass', () => {
    expect(parseText('1 '.repeat(100_000), vector)).toHaveLength(100_000);
    expect(parseText(`1${' '.repeat(300_000)}2`, vector)).toStrictEqual([1, 2]);
    expect(parseText(`${'1'.repeat(300_000)}x 2 3`, vector)).toBeUndefined();
  });

  it('of three is a position, and of one a grey', () => {
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

  it('of a choice are read in any case, and unknown ones are refused by the field', () => {
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

  it('may replace a value, as `auto` does', () => {
    expect(parseText(' Auto', auto)).toBe('auto');
    expect(parseText('1 2 3', auto)).toStrictEqual([1, 2, 3]);
    expect(parseText('automatic', auto)).toBeUndefined();
    expect(parseText('', auto)).toBeUndefined();
  });

  it('may be implied by the empty attribute', () => {
    expect(parseText('', VIEWER_FIELDS.crossOrigin)).toBe('anonymous');
    expect(parseText('use-credentials', VIEWER_FIELDS.crossOrigin)).toBe('use-credentials');
  });

  it('of plain text are kept as they are', () => {
    expect(parseText('  The Sun ', textField())).toBe('  The Sun ');
    expect(parseText('auto', textField())).toBe('auto');
  });
});

it.each([
  ['ka', 'ka'],
  ['autoRotate', 'auto-rotate'],
  ['colorInterpolation', 'color-interpolation'],
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
