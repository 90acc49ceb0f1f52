// The declared values of one element: defaults, checks, and one listener that is notified of changes.

import { describe, expect, it, vi } from 'vitest';
import { FieldStore, sameValue } from '../../src/fields/field-store.js';
import { Signal } from '../../src/fields/signal.js';
import {
  booleanField,
  colorField,
  numberField,
  optional,
  orWord,
  textField,
} from '../../src/fields/field.js';
import type { Vec3 } from '../../src/math/vector.js';

interface Lamp {
  power: number;
  tint: Vec3;
  on: boolean;
  label: string;
  segments: number | null;
  radius: number | 'auto';
}

const lamp = (): FieldStore<Lamp> =>
  new FieldStore<Lamp>({
    power: numberField(60, { min: 0, max: 100 }),
    tint: colorField([255, 255, 255], { min: 0, max: 1e6 }),
    on: booleanField(true),
    label: textField(),
    segments: optional(numberField(1, { min: 1, max: 512, integer: true })),
    radius: orWord('auto', numberField(4, { above: 0, max: 10 })),
  });

const defaults: Lamp = {
  power: 60,
  tint: [255, 255, 255],
  on: true,
  label: '',
  segments: null,
  radius: 'auto',
};

describe('a store of declared values', () => {
  it('starts with every default and nothing given', () => {
    const one = lamp();
    expect({ ...one.values }).toStrictEqual(defaults);
    for (const key of Object.keys(defaults) as (keyof Lamp)[]) expect(one.given(key)).toBe(false);
  });

  it('keeps values as their fields give them', () => {
    const one = lamp();
    one.set('tint', 80);
    one.set('power', -0);
    expect(one.values.tint).toStrictEqual([80, 80, 80]);
    expect(Object.is(one.values.power, 0)).toBe(true);
    expect(one.given('tint')).toBe(true);
  });

  it.each([null, undefined])('takes %s as the default', (nothing) => {
    const one = lamp();
    for (const [key, value] of Object.entries({ power: 5, segments: 8, radius: 2 })) {
      one.set(key as keyof Lamp, value);
      one.set(key as keyof Lamp, nothing);
      expect(one.given(key as keyof Lamp)).toBe(false);
    }
    expect({ ...one.values }).toStrictEqual(defaults);
  });

  it('is independent of other stores', () => {
    const one = lamp();
    one.set('power', 5);
    expect(lamp().values.power).toBe(60);
  });

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
    expect(() => {
      one.set(key, value);
    }).toThrow(error);
    expect(one.values[key]).toBe(5);
    expect(one.given(key)).toBe(true);
    expect(listener).not.toHaveBeenCalled();
  });
});

describe('assigning several values', () => {
  it('writes them all', () => {
    const one = lamp();
    one.assign({ power: 5, on: false });
    expect({ ...one.values }).toStrictEqual({ ...defaults, power: 5, on: false });
  });

  it('writes none if one is wrong', () => {
    const one = lamp();
    expect(() => {
      one.assign({ power: 5, tint: [0, 0, -1] });
    }).toThrow(RangeError);
    expect({ ...one.values }).toStrictEqual(defaults);
  });

  it('takes null as the default, also if the default is null', () => {
    const one = lamp();
    one.assign({ segments: 8, radius: 2 });
    one.assign({ segments: null, radius: 'auto' });
    expect({ ...one.values }).toStrictEqual(defaults);
    expect(one.given('segments')).toBe(false);
  });

  it('names a value that it does not have', () => {
    expect(() => {
      lamp().assign({ colour: 5 } as unknown as Partial<Lamp>);
    }).toThrow(/colour/);
  });
});

describe('the listener', () => {
  it('is called once after each change', () => {
    const one = lamp();
    const heard: unknown[] = [];
    one.listen((key) => heard.push([key, one.values[key]]));
    one.set('power', 5);
    one.assign({ power: 6, on: false });
    one.set('power', null);
    expect(heard).toStrictEqual([
      ['power', 5],
      ['power', 6],
      ['on', false],
      ['power', 60],
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

  it('is called when a value equal to the default is set or removed', () => {
    const one = lamp();
    const listener = vi.fn();
    one.listen(listener);
    one.set('power', 60);
    one.set('power', null);
    expect(listener).toHaveBeenCalledTimes(2);
  });

  it('is replaced by the next one, and removed by null', () => {
    const one = lamp();
    const first = vi.fn();
    const second = vi.fn();
    one.listen(first);
    one.listen(second);
    one.set('power', 5);
    one.listen(null);
    one.set('power', 6);
    expect(first).not.toHaveBeenCalled();
    expect(second).toHaveBeenCalledTimes(1);
  });
});

it('is removed by `unlisten` only while it is the current one', () => {
  const one = lamp();
  const first = vi.fn();
  const second = vi.fn();
  one.listen(first);
  one.listen(second);
  one.unlisten(first);
  one.set('power', 5);
  expect(second).toHaveBeenCalledTimes(1);
  one.unlisten(second);
  one.set('power', 6);
  expect(second).toHaveBeenCalledTimes(1);
});

it('sameValue compares lists item by item', () => {
  expect(sameValue([1, 2], [1, 2])).toBe(true);
  expect(sameValue([1, 2], [1, 3])).toBe(false);
  expect(sameValue([1], [1, 2])).toBe(false);
  expect(sameValue([], [])).toBe(true);
  expect(sameValue('auto', 'auto')).toBe(true);
  expect(sameValue('auto', [0, 0, 0])).toBe(false);
  expect(sameValue(null, null)).toBe(true);
  expect(sameValue(0, false)).toBe(false);
});

it('a default that is restored leaves other given values given', () => {
  const one = lamp();
  one.set('power', 5);
  one.set('on', false);
  one.set('power', 6);
  one.set('power', null);
  expect([one.given('power'), one.given('on'), one.values.on]).toEqual([false, true, false]);
  one.set('power', null);
  expect(one.given('on')).toBe(true);
});

it('a list is never the same as a value that is none', () => {
  expect(sameValue([1], 1)).toBe(false);
  expect(sameValue(1, [1])).toBe(false);
  expect(sameValue([], '')).toBe(false);
  expect(sameValue([1, 2], [1, 2])).toBe(true);
  expect(sameValue([1, undefined], [1])).toBe(false);
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
