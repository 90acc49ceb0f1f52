// Where are the dividers of a comparison, and how far does a key move one?

import { describe, expect, it } from 'vitest';
import { dividerStep, placesOf, rangeOf, withMoved } from '../../../src/extras/compare/divider.js';

describe('the dividers of a comparison', () => {
  it.each<['auto' | readonly number[], number, readonly number[]]>([
    ['auto', 2, [50]],
    ['auto', 4, [25, 50, 75]],
    ['auto', 1, []],
    ['auto', 0, []],
    [[10, 20], 1, []],
    [[10, 20, 30], 3, [10, 20]],
    [[40], 4, [40, 60, 80]],
    [[100], 3, [100, 100]],
  ])('declared as %j for %i viewers share what is left: %j', (declared, viewers, places) => {
    expect(placesOf(declared, viewers)).toEqual(places);
  });

  it('stop at each other and at the edges', () => {
    expect(rangeOf([20, 60], 0)).toEqual([0, 60]);
    expect(rangeOf([20, 60], 1)).toEqual([20, 100]);
    expect(withMoved([20, 60], 0, 80)).toEqual([60, 60]);
    expect(withMoved([20, 60], 1, 180)).toEqual([20, 100]);
    expect(withMoved([20, 60], 0, -5)).toEqual([0, 60]);
  });
});

describe('a key on a divider', () => {
  const step = (key: string, shiftKey = false, vertical = false, rtl = false) =>
    dividerStep({ key, shiftKey }, vertical, rtl);

  it('moves it in the direction of the arrow', () => {
    expect(step('ArrowRight')).toBe(1);
    expect(step('ArrowRight', false, false, true)).toBe(-1);
    expect(step('ArrowDown')).toBeUndefined();
    expect(step('ArrowDown', false, true)).toBe(1);
    expect(step('ArrowRight', false, true)).toBeUndefined();
  });

  it('moves it by 10 % with Shift or by page keys, and all the way by Home and End', () => {
    expect([step('ArrowLeft', true), step('PageUp'), step('PageDown')]).toEqual([-10, -10, 10]);
    expect([step('Home'), step('End')]).toEqual([-Infinity, Infinity]);
    expect(step('a')).toBeUndefined();
  });
});
