// Does a light have the documented defaults and domains, also when it is made from a plain object?

import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import { LIGHT_FIELDS, LightState, type LightValues, LIMITS } from '../../src/light/light-state.js';
import { anyLight } from './arbitraries.js';

describe('a light', () => {
  it('has the documented defaults', () => {
    expect({ ...new LightState().values }).toStrictEqual({
      name: '',
      active: true,
      ambient: [0, 0, 0],
      diffuse: [255, 255, 255],
      specular: [255, 255, 255],
      position: [1, 2, 3, 0],
      axis: [0, 0, -1],
      aperture: 180,
      cutoff: 0,
      attenuation: [1, 0, 0],
      space: 'world',
    });
  });

  const domain: [keyof LightValues, unknown, unknown][] = [
    ['name', 'sun', 5],
    ['active', false, 'false'],
    ['ambient', 1e6, 1e6 + 1],
    ['diffuse', [0, 0, 0], [0, 0, -0.1]],
    ['specular', [1, 2, 3], [1, 2]],
    ['position', [-1e15, 1e15, 0, 1], [0, 0, 1.1e15, 1]],
    ['position', [1, 2, 3], [1, 2, 3, 0.5]],
    ['axis', [0, 0, 0], [0, 0, -2e15]],
    ['aperture', 180, 180.5],
    ['aperture', 0, -1e-9],
    ['cutoff', 1e6, 1.1e6],
    ['attenuation', [0, 0, 0], [1, -1, 0]],
    ['attenuation', [1e6, 1e6, 1e6], [1e7, 0, 0]],
    ['space', 'camera', 'view'],
  ];
  it.each(domain)('accepts %s %j and refuses %j', (key, good, bad) => {
    const one = new LightState();
    one.set(key, good);
    const before = one.values[key];
    expect(one.given(key)).toBe(true);
    expect(() => {
      one.set(key, bad);
    }).toThrow();
    expect(one.values[key]).toBe(before);
  });

  it('is made from any subset of values, or not at all if one is wrong', () => {
    expect(new LightState({ cutoff: 12, diffuse: [1, 2, 3] }).values).toMatchObject({
      cutoff: 12,
      diffuse: [1, 2, 3],
      aperture: 180,
    });
    expect(() => new LightState({ cutoff: -1 })).toThrow(RangeError);
    expect(() => new LightState({ space: 'view' as 'world' })).toThrow(RangeError);
  });

  it('keeps every value of its domains unchanged', () => {
    fc.assert(
      fc.property(anyLight, (values) => {
        const kept = { ...new LightState(values).values };
        // 0 and -0 are the same value; which one was drawn does not matter.
        expect(JSON.stringify(kept)).toBe(JSON.stringify(values));
      }),
    );
  });

  it('notifies a listener before it is in any set', () => {
    const one = new LightState();
    const told = vi.fn();
    one.listen(told);
    one.set('aperture', 30);
    expect(told).toHaveBeenCalledExactlyOnceWith('aperture');
  });
});

it('keeps every product of the equation inside float32', () => {
  const { coordinate, color, attenuation } = LIMITS;
  const largest = 2 ** 127;
  // Places, fragments and origins may stand at opposite ends.
  const d2 = 3 * (4 * coordinate) ** 2;
  expect(attenuation * d2 + attenuation * Math.sqrt(d2) + attenuation).toBeLessThan(largest);
  const decoded = ((color / 255 + 0.055) / 1.055) ** 2.4;
  expect(decoded * decoded * 1e6).toBeLessThan(largest);
});

it('describes the domain of every field in words', () => {
  for (const field of Object.values(LIGHT_FIELDS)) expect(field.expected).not.toBe('');
});
