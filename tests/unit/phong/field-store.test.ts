// The declared values of one element: defaults, checks, and one listener that is notified of
// changes.

import { describe, expect, it, vi } from 'vitest';
import { FieldStore, sameValue } from '../../../src/phong/fields/field-store.js';
import { Signal } from '../../../src/phong/fields/signal.js';
import {
  booleanField,
  colorField,
  numberField,
  optional,
  orAuto,
  textField,
} from '../../../src/phong/fields/field.js';
import type { Vec3 } from '../../../src/phong/math/vector.js';

interface Lamp {
  power: number;
  tint: Vec3;
  on: boolean;
  label: string;
  segments: number | null;
  radius: number | 'auto';
}

const lamp = () =>
  new FieldStore<Lamp>({
    power: numberField(60, { min: 0, max: 100 }),
    tint: colorField([255, 255, 255], { min: 0, max: 1e6 }),
    on: booleanField(),
    label: textField(),
    segments: optional(numberField(1, { min: 1, max: 512, integer: true })),
    radius: orAuto(numberField(4, { above: 0, max: 10 })),
  });

const defaults: Lamp = {
  power: 60,
  tint: [255, 255, 255],
  on: true,
  label: '',
  segments: null,
  radius: 'auto',
};
const keys = Object.keys(defaults) as (keyof Lamp)[];

describe('a store of declared values', () => {
  it('starts with every default and nothing given, whatever is in other stores', () => {
    lamp().set('power', 5);
    const one = lamp();
    expect({ ...one.values }).toStrictEqual(defaults);
    expect(keys.filter((key) => one.given(key))).toEqual([]);
  });

  it('keeps values as their fields give them', () => {
    const one = lamp();
    one.set('tint', 80);
    one.assign({ power: -0, on: false });
    expect({ ...one.values }).toStrictEqual({
      ...defaults,
      tint: [80, 80, 80],
      power: 0,
      on: false,
    });
    expect(keys.filter((key) => one.given(key))).toEqual(['power', 'tint', 'on']);
  });

  it.each([null, undefined])(
    'takes %s as the default, and leaves other given values given',
    (nothing) => {
      const one = lamp();
      one.assign({ power: 5, on: false, segments: 8, radius: 2 });
      for (let i = 0; i < 2; i++) {
        one.set('power', nothing);
      }
      one.assign({ segments: nothing, radius: nothing } as unknown as Partial<Lamp>);
      expect({ ...one.values }).toStrictEqual({ ...defaults, on: false });
      expect(keys.filter((key) => one.given(key))).toEqual(['on']);
    },
  );

  it.each([
    ['power', '5', TypeError],
    ['power', 101, RangeError],
    ['power', NaN, RangeError],
    ['segments', 1.5, RangeError],
    ['radius', 'none', TypeError],
  ] as const)('throws for %s = %o and changes nothing', (key, value, error) => {
    const one = lamp();
    one.set(key, 5);
    const listener = vi.fn();
    one.listen(listener);
    expect(() => one.set(key, value)).toThrow(error);
    expect(() => one.assign({ on: false, [key]: value })).toThrow(error);
    expect({ ...one.values }).toStrictEqual({ ...defaults, [key]: 5 });
    expect(one.given(key)).toBe(true);
    expect(listener).not.toHaveBeenCalled();
  });

  it('names a value that it does not have', () => {
    expect(() => lamp().assign({ colour: 5 } as unknown as Partial<Lamp>)).toThrow(/colour/);
    const misspelled = { pwoer: 5 } as unknown as Partial<Lamp>;
    expect(() => lamp().assign(misspelled)).toThrow('"pwoer". Did you mean "power"?');
  });
});

describe('the listener', () => {
  it('is called once after each change, also by a value equal to the default that is set or removed', () => {
    const one = lamp();
    one.notify('on'); // without a listener
    const heard: unknown[] = [];
    one.listen((key) => heard.push([key, one.values[key]]));
    one.notify('on');
    one.set('power', 5);
    one.assign({ power: 6, on: false });
    one.set('power', null);
    one.set('power', 60);
    one.set('power', null);
    expect(heard).toStrictEqual([
      ['on', true],
      ['power', 5],
      ['power', 6],
      ['on', false],
      ...Array.from({ length: 3 }, () => ['power', 60]),
    ]);
  });

  it('is not called for a value that is already there', () => {
    const one = lamp();
    one.assign({ power: 5, tint: [1, 2, 3], radius: 'auto' });
    const listener = vi.fn();
    one.listen(listener);
    one.assign({ power: 5, tint: [1, 2, 3], radius: 'auto' });
    one.set('tint', new Float32Array([1, 2, 3]));
    one.set('label', null);
    expect(listener).not.toHaveBeenCalled();
  });

  it('is replaced by the next one, and removed by null, or by `unlisten` while it is the current one', () => {
    const one = lamp();
    const [first, second] = [vi.fn(), vi.fn()];
    one.listen(first);
    one.listen(second);
    one.unlisten(first);
    one.set('power', 5);
    one.unlisten(second);
    one.set('power', 6);
    one.listen(second);
    one.listen(null);
    one.set('power', 7);
    expect(first).not.toHaveBeenCalled();
    expect(second).toHaveBeenCalledTimes(1);
  });
});

it.each<[unknown, unknown, boolean]>([
  [[1, 2], [1, 2], true],
  [[1, 2], [1, 3], false],
  [[1], [1, 2], false],
  [[1, undefined], [1], false],
  [[], [], true],
  ['auto', 'auto', true],
  [null, null, true],
  [0, false, false],
  [[1], 1, false],
  [1, [1], false],
  [[], '', false],
  ['auto', [0, 0, 0], false],
])('sameValue compares %j and %j, lists item by item: %s', (a, b, same) => {
  expect(sameValue(a, b)).toBe(same);
});

it('a signal calls those who listen, in their order', () => {
  const signal = new Signal<number>();
  const heard: string[] = [];
  signal.listen((value) => heard.push(`first ${value}`));
  signal.listen((value) => heard.push(`second ${value}`));
  signal.emit(1);
  signal.emit(2);
  expect(heard).toEqual(['first 1', 'second 1', 'first 2', 'second 2']);
});
