// Can numbers be read from the colours of views, and which lights can be counted?
import { describe, expect, it } from 'vitest';
import { HEADER, LIMIT_OPEN, ROWS } from '../../src/light/light-layout.js';
import { emptyPack } from '../../src/light/pack-lights.js';
import { LightState, type LightValues } from '../../src/light/light-state.js';
import { packCounted } from '../../src/material/view/count-lights.js';
import { scaleColor } from '../../src/material/view/scale.js';
import { VIEWS } from '../../src/material/views.js';
import { srgbDecode } from '../../src/math/color.js';
import { barsOf, titleOf } from '../../src/overlay/legend/view-scale.js';

const luminance = (t: number): number => {
  const [r, g, b] = scaleColor(t);
  return 0.2126 * srgbDecode(r) + 0.7152 * srgbDecode(g) + 0.0722 * srgbDecode(b);
};

describe('the scale', () => {
  it('increases in luminance throughout, so that it can be read without colour vision', () => {
    for (let i = 0; i < 255; i++) expect(luminance((i + 1) / 255)).toBeGreaterThan(luminance(i / 255));
    expect(luminance(0)).toBeLessThan(0.02);
    expect(luminance(1)).toBeGreaterThan(0.8);
  });

  it('has distinct colours for 200 counts, all within sRGB', () => {
    const colors = Array.from({ length: 201 }, (_, i) => scaleColor(i / 200));
    expect(new Set(colors.map((color) => color.map((c) => Math.round(255 * c)).join())).size).toBe(201);
    for (const channel of colors.flat()) {
      expect(channel).toBeGreaterThanOrEqual(0);
      expect(channel).toBeLessThanOrEqual(1);
    }
  });

  it('ends at the colours of its first and last number', () => {
    expect(scaleColor(-1)).toEqual(scaleColor(0));
    expect(scaleColor(9)).toEqual(scaleColor(1));
  });
});

describe('the legend', () => {
  it('marks counts from 0 to the number of lights, with a field for each if there is room', () => {
    for (let most = 1; most <= 500; most++) {
      const [bar] = barsOf('light-count', most);
      const { marks, colors, fields } = bar!;
      const numbers = marks.map(({ text }) => Number(text));
      expect(numbers[0], String(most)).toBe(0);
      expect(numbers.at(-1), String(most)).toBe(most);
      expect(numbers, String(most)).toEqual([...new Set(numbers)].sort((a, b) => a - b));
      expect(marks.length, String(most)).toBeLessThanOrEqual(9);
      if (fields) expect(colors).toHaveLength(most + 1);
    }
  });

  it('has a title for every view', () => {
    for (const view of VIEWS) expect(titleOf(view, false), view).not.toBe('');
    expect(titleOf('r-dot-v', true)).toBe('N · H');
  });
});

describe('the lights that are counted', () => {
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const space = { worldToShading: identity, cameraToShading: identity, linear: false };
  const light = (values: Partial<LightValues>): Readonly<LightValues> => new LightState(values).values;
  /** The channels and limits of the lights that are packed, and how many have no cone. */
  const countedOf = (...lights: readonly Partial<LightValues>[]) => {
    const packed = emptyPack();
    const open = packCounted(lights.map(light), space, packed);
    const first = (i: number, row: number): number => (HEADER.rows + i * ROWS.counted.rows + row) * 4;
    const read = Array.from({ length: packed.sent }, (_, i) => ({
      channels: packed.data[first(i, ROWS.counted.position) + 3]!,
      limit: packed.data[first(i, ROWS.counted.axis) + 3]!,
    }));
    expect(packed.counts).toEqual({ directional: 0, point: 0, spot: packed.sent });
    expect(packed.data[HEADER.counts * 4 + 2]).toBe(packed.sent);
    return { open, read };
  };

  it('exclude inactive and black ones', () => {
    const black = { diffuse: [0, 0, 0], specular: [0, 0, 0] } as const;
    expect(countedOf({ active: false }).read).toEqual([]);
    expect(countedOf(black).read).toEqual([]);
    expect(countedOf({ ...black, ambient: [0, 0, 1] }).read).toEqual([{ channels: 4, limit: LIMIT_OPEN }]);
  });

  it('exclude directional lights that miss their own cone', () => {
    const aimed = { position: [0, 1, 0, 0], axis: [0, -1, 0], aperture: 20 } as const;
    expect(countedOf(aimed).open).toBe(1);
    expect(countedOf({ ...aimed, axis: [1, 0, 0] }).read).toEqual([]);
  });

  it('include those without a direction for their ambient light', () => {
    const [nowhere] = countedOf({ position: [0, 0, 0, 0], ambient: [9, 9, 9] }).read;
    expect(nowhere!.channels).toBe(7);
    expect(countedOf({ position: [0, 0, 0, 1], ambient: [9, 9, 9] }).read[0]!.channels).toBe(511);
  });

  it('begin with those without a cone, which the others’ limits tell apart', () => {
    const spot = { position: [0, 1, 0, 1], aperture: 20 } as const;
    const { read, open } = countedOf(spot, {}, spot);
    expect(open).toBe(1);
    expect(read.map(({ limit }) => limit === LIMIT_OPEN)).toEqual([true, false, false]);
  });
});
