// Which lights does a picture have, in which order, and when do its version and its listener change?

import { describe, expect, it, vi } from 'vitest';
import { LightSet } from '../../src/light/light-set.js';
import { LightState } from '../../src/light/light-state.js';

const three = (): [LightState, LightState, LightState] => [
  new LightState({ name: 'a' }),
  new LightState({ name: 'b' }),
  new LightState({ name: 'c' }),
];
const names = (set: LightSet): string => set.lights.map(({ values }) => values.name).join('');

describe('a set of lights', () => {
  it('begins empty', () => {
    const set = new LightSet();
    expect(set.lights).toStrictEqual([]);
    expect(set.version).toBe(0);
  });

  it('keeps the order in which lights are given', () => {
    const [a, b, c] = three();
    const set = new LightSet();
    set.add(b);
    set.add(a);
    set.add(c);
    expect(names(set)).toBe('bac');
    set.assign([a, b, c]);
    expect(names(set)).toBe('abc');
    set.remove(b);
    expect(names(set)).toBe('ac');
    set.assign([]);
    expect(names(set)).toBe('');
  });

  it('increments its version and notifies once when lights are added, removed or reordered', () => {
    const [a, b, c] = three();
    const told = vi.fn();
    const set = new LightSet(told);
    set.assign([a, b, c]);
    set.assign([c, b, a]);
    set.remove(b);
    expect(set.version).toBe(3);
    expect(told.mock.calls).toStrictEqual([[null], [null], [null]]);
  });

  it('increments its version and names the light that was written to', () => {
    const [a, b] = three();
    const told = vi.fn();
    const set = new LightSet(told);
    set.assign([a, b]);
    told.mockClear();
    b.set('cutoff', 12);
    expect(set.version).toBe(2);
    expect(told).toHaveBeenCalledExactlyOnceWith(b);
  });

  it('keeps its version while nothing changes', () => {
    const [a, b, c] = three();
    const told = vi.fn();
    const set = new LightSet(told);
    set.assign([a, b]);
    told.mockClear();
    set.assign([a, b]);
    set.remove(c);
    a.set('name', 'a');
    expect(() => {
      a.set('cutoff', -1);
    }).toThrow();
    expect(set.version).toBe(1);
    expect(told).not.toHaveBeenCalled();
  });

  it('says whether a change can concern more than a light’s place', () => {
    const [a, b] = three();
    const set = new LightSet();
    set.assign([a]);
    const changes = (change: () => void): boolean => {
      const { kindVersion } = set;
      change();
      return set.kindVersion !== kindVersion;
    };
    expect(changes(() => a.set('active', false))).toBe(true);
    expect(changes(() => a.set('position', [3, 2, 1, 0]))).toBe(false);
    expect(changes(() => a.set('position', [3, 2, 1, 1]))).toBe(true);
    expect(changes(() => a.set('aperture', 30))).toBe(true);
    expect(changes(() => a.set('space', 'camera'))).toBe(true);
    expect(changes(() => set.add(b))).toBe(true);
    expect(changes(() => set.remove(b))).toBe(true);
    expect(changes(() => set.assign([]))).toBe(true);
  });

  it('ignores a light that was removed', () => {
    const [a, b] = three();
    const set = new LightSet();
    set.assign([a, b]);
    set.remove(a);
    const { version } = set;
    a.set('cutoff', 3);
    expect(set.version).toBe(version);
    b.set('cutoff', 3);
    expect(set.version).toBe(version + 1);
  });

  it('follows a light that was added again', () => {
    const [a] = three();
    const set = new LightSet();
    set.add(a);
    set.remove(a);
    set.add(a);
    const { version } = set;
    a.set('cutoff', 3);
    expect(set.version).toBe(version + 1);
  });

  it('copies the list that it is given', () => {
    const [a, b, c] = three();
    const list = [a, b];
    const set = new LightSet();
    set.assign(list);
    list.push(c);
    expect(names(set)).toBe('ab');
  });

  it('keeps a light that it took from another set, whichever changes first', () => {
    const [a] = three();
    const from = new LightSet();
    const to = new LightSet();
    from.add(a);
    to.add(a);
    from.remove(a);
    const { version } = to;
    a.set('cutoff', 3);
    expect(to.version).toBe(version + 1);
  });

  it('counts a light that it contains twice as one change', () => {
    const [a] = three();
    const set = new LightSet();
    set.assign([a, a]);
    a.set('cutoff', 3);
    expect(set.version).toBe(2);
    set.remove(a);
    expect(set.lights).toStrictEqual([]);
  });
});
