// Which lights does a picture have, in which order, and when do its version and its listener
// change?

import { describe, expect, it, vi } from 'vitest';
import { LightSet } from '../../../src/phong/light/light-set.js';
import { LightState } from '../../../src/phong/light/light-state.js';

const three = (): [LightState, LightState, LightState] => [
  new LightState({ name: 'a' }),
  new LightState({ name: 'b' }),
  new LightState({ name: 'c' }),
];

/** The names of the lights, and of their values, which are the same. */
function names({ lights, values }: LightSet) {
  expect(lights.map((one) => one.values)).toStrictEqual(values);
  return values.map(({ name }) => name).join('');
}

/** By how much the set's version grows. */
function growth(set: LightSet, change: () => void) {
  const { version } = set;
  change();
  return set.version - version;
}

describe('a set of lights', () => {
  it('begins empty, and keeps the order in which lights are given, in a list of its own', () => {
    const [a, b, c] = three();
    const set = new LightSet();
    expect([names(set), set.version]).toEqual(['', 0]);
    for (const one of [b, a, c]) {
      set.add(one);
    }
    expect(names(set)).toBe('bac');
    const list = [a, b];
    set.assign(list);
    list.push(c);
    expect(names(set)).toBe('ab');
    set.add(c);
    set.remove(b);
    expect(names(set)).toBe('ac');
    set.assign([]);
    expect(names(set)).toBe('');
  });

  it('increments its version once when lights come, go or change places, and names one that was written to', () => {
    const [a, b, c] = three();
    const told = vi.fn();
    const set = new LightSet();
    set.changed.listen(told);
    set.assign([a, b, c]);
    set.assign([c, b, a]);
    set.remove(b);
    a.set('cutoff', 12);
    expect(set.version).toBe(4);
    expect(told.mock.calls).toStrictEqual([[null], [null], [null], [a]]);
  });

  it('keeps its version while nothing changes', () => {
    const [a, b, c] = three();
    const told = vi.fn();
    const set = new LightSet();
    set.changed.listen(told);
    set.assign([a, b]);
    told.mockClear();
    set.assign([a, b]);
    set.remove(c);
    a.set('name', 'a');
    expect(() => a.set('cutoff', -1)).toThrow();
    expect(set.version).toBe(1);
    expect(told).not.toHaveBeenCalled();
  });

  it('follows a light, once even if it is there twice, until it removes it or another set takes it', () => {
    const [a, b] = three();
    const set = new LightSet();
    set.assign([a, b]);
    set.remove(a);
    expect(growth(set, () => a.set('cutoff', 3))).toBe(0);
    expect(growth(set, () => b.set('cutoff', 3))).toBe(1);
    set.add(a);
    expect(growth(set, () => a.set('cutoff', 4))).toBe(1);
    set.assign([b]);
    expect(growth(set, () => a.set('cutoff', 5))).toBe(0);
    const other = new LightSet();
    other.add(b);
    set.remove(b); // which the other set has taken
    expect(growth(other, () => b.set('cutoff', 5))).toBe(1);
    set.assign([a, a]);
    expect(growth(set, () => a.set('cutoff', 6))).toBe(1);
    set.remove(a);
    expect(names(set)).toBe('');
  });
});
