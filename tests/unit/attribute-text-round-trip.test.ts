// Does parsing a formatted value give the value back, for every field of every element? Does any text end in a value,
// an error of the field, or nothing?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { formatValue, parseText } from '../../src/element/fields/attribute-text.js';
import { VIEWER_FIELDS } from '../../src/element/fields/viewer-fields.js';
import { sameValue } from '../../src/fields/field-store.js';
import { LIGHT_FIELDS } from '../../src/light/light-state.js';
import {
  booleanField,
  type Field,
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

const fields = Object.entries<Field<unknown>>({
  ...Object.fromEntries(Object.entries<Field<unknown>>(LIGHT_FIELDS).map(([key, f]) => [`light ${key}`, f])),
  ...Object.fromEntries(Object.entries<Field<unknown>>(MESH_FIELDS).map(([key, f]) => [`mesh ${key}`, f])),
  ...Object.fromEntries(
    Object.entries<Field<unknown>>(VIEWER_FIELDS).map(([key, f]) => [`viewer ${key}`, f]),
  ),
});

/** Values that the field accepts: guesses by its kind, and its own choices. */
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
    'flag-or-words': fc.oneof(fc.boolean(), fc.constantFrom(['lights'], ['cutoff', 'theta'])),
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
        if (text === null)
          expect(value === null || value === false || sameValue(value, field.fallback)).toBe(true);
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
    [true, VIEWER_FIELDS.gui, ''],
    [false, VIEWER_FIELDS.gui, null],
    [['cutoff', 'theta'], VIEWER_FIELDS.gui, 'cutoff theta'],
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

  it('gives an accepted value, a TypeError or RangeError, or counts as malformed', () => {
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
