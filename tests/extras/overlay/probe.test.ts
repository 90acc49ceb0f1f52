// Do the probe's rows, vectors and words agree with the explanation of a fragment?

import fc from 'fast-check';
import { beforeAll, describe, expect, it, vi } from 'vitest';
import type { FragmentExplanation } from '../../../src/viewer/element/elements.js';
import { LIGHT_FIELDS, type LightValues, TERMS } from '../../../src/phong/light/light-state.js';
import { srgbDecode } from '../../../src/phong/math/color.js';
import { length, normalize } from '../../../src/phong/math/vector.js';
import { Projection } from '../../../src/extras/overlay/drawing/projection.js';
import { drawingOf, figureOf, MOST_LIGHTS } from '../../../src/extras/overlay/probe/figure.js';
import {
  byShare,
  fragmentText,
  shortNumber,
  shownAbsence,
  probeSum,
  stepsText,
  sumText,
  tripleText,
} from '../../../src/extras/overlay/probe/sum.js';
import { cellText, termsOf } from '../../../src/extras/overlay/probe/sum-table.js';
import { between, triple, worldLight } from '../../unit/arbitraries.js';
import { explained } from '../../unit/explained.js';

// Labels are measured by a canvas where there is one.
beforeAll(() => {
  vi.stubGlobal('document', {
    createElement: () => ({ getContext: () => null }),
    documentElement: { lang: '' },
  });
});

const FIRST = { position: [0, 1, 0, 0], diffuse: [40, 50, 60], ambient: [10, 10, 10] } as const;
const THIRD = { position: [0, 1, -1, 0], diffuse: [200, 100, 0] } as const;
/** The second light is not active. */
const TWO: readonly Partial<LightValues>[] = [FIRST, { active: false }, THIRD];

const WHITE = { ambient: [0, 0, 0], diffuse: [255, 255, 255], specular: [255, 255, 255] } as const;

const under = (...lights: readonly Partial<LightValues>[]) => explained({ lights });

describe('the sum', () => {
  it('has a row for each active light, whose totals add up to the sum', () => {
    const fragment = explained({ lights: TWO });
    const { rows, totals, color } = probeSum(fragment, false);
    expect(rows.map(({ name }) => name)).toEqual(['light 1', 'light 3']);
    expect(totals.map(({ label }) => label)).toEqual(['sum', 'clamped']);
    totals[0]!.color.forEach((x, i) => expect(x).toBeCloseTo(255 * fragment.sum[i]!, 10));
    expect(color).toEqual(fragment.color.map((x) => 255 * x));
  });

  it('is encoded last in linear light', () => {
    const fragment = explained({ lights: TWO, linear: true });
    const { rows, totals } = probeSum(fragment, true);
    expect(totals.map(({ label }) => label)).toEqual(
      ['sum', 'encoded', 'clamped'].slice(0, totals.length),
    );
    const red = rows.reduce((total, row) => total + row.total[0], 0);
    expect(red / 255).toBeCloseTo(srgbDecode(fragment.sum[0]), 10);
    expect(totals[1]!.color[0]).toBeCloseTo(255 * fragment.sum[0], 10);
  });

  it('adds an emissive colour, and is the base colour alone for unlit surfaces', () => {
    const glowing = explained({ surface: { emissive: [0.1, 0.2, 0] } });
    expect(probeSum(glowing, false).totals[0]).toEqual({ label: 'emissive', color: [25.5, 51, 0] });
    const unlit = explained({ lights: TWO, surface: { unlit: true, baseColor: [1, 0, 0] } });
    const { rows, totals } = probeSum(unlit, false);
    expect({ rows, totals }).toEqual({
      rows: [],
      totals: [{ label: 'base colour', color: [255, 0, 0] }],
    });
  });

  it('says why a light adds neither diffuse nor specular, but only of terms that are missing', () => {
    const [row] = probeSum(under({ position: [0, -1, 0, 0], ambient: [9, 9, 9] }), false).rows;
    expect(shownAbsence(row!)).toBe('behind the surface');
    expect(
      shownAbsence({ ...row!, diffuse: [1, 0, 0] }),
      'from a corner, under Gouraud shading',
    ).toBeNull();
    expect(shownAbsence({ ...row!, absence: 'outside its cone' }), 'ambient').toBeNull();
  });

  it('has "…" for terms that have no column, in the rows whose sum has them', () => {
    const dark = { ...THIRD, ambient: [0, 0, 0], diffuse: [0, 0, 0], specular: [0, 0, 0] } as const;
    const { rows } = probeSum(under(FIRST, dark), false);
    expect(rows.map(termsOf)).toEqual(['ambient diffuse specular', '']);
    expect(cellText(rows[0]!, 'att', null), 'no decimals for what is exact').toBe('1');
    expect(cellText({ ...rows[0]!, att: NaN }, 'att', null), 'several lights in a row').toBe('');
  });

  it('prints numbers with a typographic minus, none before a zero, and short at any size', () => {
    expect(shortNumber(-0.001, 2, null)).toBe('0.00');
    expect(shortNumber(-1.5, 1, null)).toBe('−1.5');
    expect(shortNumber(Infinity, 1, null)).toBe('∞');
    expect(shortNumber(1.5e300, 1, null)).toBe('1.5e+300');
    expect(tripleText([1, 2.25, 255], 1, null)).toBe('1.0 2.3 255.0');
    expect(tripleText([1, 2.25, 255], 1, { en: 'de' }), 'a wider gap').toBe(
      '1,0\u20022,3\u2002255,0',
    );
  });
});

it('has sums of rows and columns that the digits give, or ≈ (seed 60)', () => {
  const lights = fc.array(worldLight, { minLength: 1, maxLength: 6 });
  const kd = triple(between(0, 255));
  fc.assert(
    fc.property(lights, kd, fc.nat(1), fc.nat(2), (lights, kd, digits, channel) => {
      const { rows } = probeSum(explained({ lights, surface: { kd } }), false);
      const columns = [...TERMS, 'sum'] as const;
      const lines = rows.map((row) => columns.map((each) => cellText(row, each, null, digits)));
      const totals = rows.map(({ total }) => total);
      lines.push([...lines.map((line) => line.at(-1)!), sumText(totals, digits, null)]);
      for (const line of lines) {
        // Black is one zero.
        const numbers = line.map((cell) => Number(cell.replace('≈ ', '').split(' ')[channel] ?? 0));
        const sum = numbers.pop()!;
        if (line.at(-1)!.startsWith('≈')) continue;
        expect(
          numbers.reduce((a, b) => a + b),
          line.join(' + '),
        ).toBeCloseTo(sum, 6);
      }
    }),
    { seed: 60, numRuns: 400 },
  );
});

const PHONG = { alone: false, halfway: false };

describe('the figure', () => {
  const figure = (fragment: FragmentExplanation, chosen = 0, options = PHONG) => {
    const sum = probeSum(fragment, false);
    return figureOf(fragment, sum, sum.rows[chosen] ?? null, options, null);
  };
  const pose = { theta: 0, phi: 45, radius: Math.sqrt(8), target: [0, 0, 0] } as const;

  it.each([
    [
      'N, L of all, and R of the chosen one',
      TWO,
      PHONG,
      ['N', 'L light 3', 'L light 1', 'R ∠V 0°'],
      1,
    ],
    ['H and its angle to N', TWO, { alone: true, halfway: true }, ['N', 'L light 3', 'H'], 2],
    [
      'no R of a light behind the surface',
      [{ position: [0, -1, 1, 0] as const }],
      PHONG,
      ['N', 'L'],
      1,
    ],
  ] as const)('has %s, as unit vectors', (_, lights, options, names, angles) => {
    const { vectors, arcs } = figure(explained({ lights }), lights.length > 1 ? 1 : 0, options);
    expect(vectors.map(({ name }) => name)).toEqual(names);
    expect(arcs).toHaveLength(angles);
    for (const { name, direction, dashed } of vectors) {
      expect(length(direction)).toBeCloseTo(1, 12);
      if (name === 'H') {
        expect(direction[1], 'between (0 1 −1) and (0 1 1)').toBeCloseTo(1, 12);
      }
      expect(dashed, 'L from below').toBe(direction[1] < 0);
    }
  });

  it('has the angles that the words have', () => {
    const fragment = under({ position: [0.3, 1, -0.4, 0] });
    const [row] = probeSum(fragment, false).rows;
    const said = [...stepsText(null, row!, fragment, false).matchAll(/cos ([\d.]+°)/g)].map(
      ([, angle]) => angle,
    );
    const { vectors, arcs } = figure(fragment);
    expect([arcs[0]!.label, vectors.at(-1)!.name]).toEqual([said[0], `R ∠V ${said[1]!}`]);
  });

  it('has arrows for the lights that add most if there are many, and always for the chosen one', () => {
    const fragment = under(
      ...Array.from({ length: 50 }, (_, i) => ({ ...FIRST, diffuse: [i, i, i] as const })),
    );
    const strongest = byShare(probeSum(fragment, false).rows).slice(0, MOST_LIGHTS);
    const named = figure(fragment, 0)
      .vectors.filter(({ name }) => name.startsWith('L'))
      .map(({ name }) => name);
    expect(named).toEqual([...strongest.map(({ name }) => `L ${name}`), 'L light 1']);
  });

  it('has neither N nor angles where the surface has no normal', () => {
    const { vectors, arcs } = figure(explained({ lights: TWO, normal: [0, 0, 0] }));
    expect(vectors.some(({ name }) => name === 'N')).toBe(false);
    expect(arcs).toEqual([]);
  });

  it('is drawn with finite numbers for every light, normal and size', () => {
    const coordinate = fc.constantFrom(0, 1, -1, 2, 1e15);
    const position = fc.tuple(coordinate, coordinate, coordinate, fc.constantFrom(0, 1));
    const normal = triple(fc.constantFrom(0, 1, -1)).map(normalize);
    const size = fc.constantFrom([600, 400] as const, [120, 90] as const, [1, 1] as const);
    fc.assert(
      fc.property(
        position,
        normal,
        size,
        fc.boolean(),
        (position, normal, [width, height], halfway) => {
          const drawn = figure(explained({ lights: [{ position }, THIRD], normal }), 0, {
            alone: false,
            halfway,
          });
          const room = { left: 0, top: 0, right: width, bottom: height };
          const space = { outline: [], room, boxes: [], fontSize: 12 };
          const projection = new Projection({ pose, fov: 45, width, height });
          const list = drawingOf(
            projection,
            [0, 0, 0],
            { x: width / 2, y: height / 2 },
            drawn,
            space,
          );
          // JSON writes null for what is not finite.
          expect(JSON.stringify(list)).not.toMatch(/"[xy]":null/);
        },
      ),
      { numRuns: 300 },
    );
  });
});

describe('the words', () => {
  it('name point, colour and the terms of the lights that add most', () => {
    const fragment = explained({ lights: TWO });
    expect(fragmentText(null, fragment, probeSum(fragment, false))).toMatch(
      /^Point 0 0 0\. Colour: red \d+, green \d+, blue \d+\. light 3: ambient 0 0 0, diffuse [\d ]+, specular [\d ]+\. light 1: ambient 10 10 10, diffuse 32 40 48, specular [\d ]+\.$/,
    );
    const averaged = fragmentText(null, { ...fragment, filtered: true }, probeSum(fragment, false));
    expect(averaged).toContain('these numbers read it at one point, so they can differ.');
    const many = under(...Array<Partial<LightValues>>(5).fill(FIRST));
    expect(fragmentText(null, many, probeSum(many, false))).toMatch(/More lights: 2\.$/);
  });

  const away = { position: [0, 1, 3, 0] } as const;
  it.each([
    [THIRD, {}, 'N·L = cos 45° = 0.707; R·V = cos 0° = 1.000, to the power of 8: 1.000.'],
    [{ position: [0, -1, 0, 0] }, {}, 'N·L = cos 180° = −1.000 is not above 0, so only ambient.'],
    [away, {}, 'N·L = cos 71.6° = 0.316; R·V = −0.447 is not above 0: no highlight.'],
    [
      away,
      { shininess: 1e-7 },
      'N·L = cos 71.6° = 0.316; R·V = cos 116.57° = −0.447, to the power of 0: 1.000.',
    ],
    [away, { N: [0, 0, 0] }, 'no normal here, so only ambient.'],
    [{ position: [0, 0, 0, 1] }, {}, 'no direction, so only ambient.'],
    [
      { position: [0, 3, 0, 1], axis: [1, 0, 0], aperture: 10 },
      {},
      '90° from its axis, outside its cone, so it adds nothing.',
    ],
  ] as const)('show the steps from the angles of %j to its terms (%#)', (light, changed, text) => {
    const fragment = { ...under(light), ...changed };
    const [row] = probeSum(fragment, false).rows;
    expect(stepsText(null, row!, fragment, false)).toBe(`light 1: ${text}`);
  });

  it('or the columns differ where a value of a light changes what it adds by ten codes', () => {
    const shown = (one: LightValues) => {
      const fragment = under({ ...one, ...WHITE });
      const row = probeSum(fragment, false).rows[0]!;
      const columns = [cellText(row, 'att', null), cellText(row, 'decay', null)];
      return { words: stepsText(null, row, fragment, false) + columns, total: row.total[0] };
    };
    const lights = fc.sample(worldLight, { seed: 57, numRuns: 200 });
    for (const key of Object.keys(LIGHT_FIELDS)) {
      for (const [i, one] of lights.entries()) {
        const before = shown(one);
        const after = shown({ ...one, [key]: lights.at(i - 1)![key as 'axis'] });
        if (before.words === after.words) {
          expect(Math.abs(before.total - after.total), key).toBeLessThan(10);
        }
      }
    }
  });

  it('are true of the numbers as they are written, for every angle and exponent', () => {
    const unit = fc.oneof(between(-1, 1), between(0.8, 1));
    const exponent = fc.constantFrom(1e-6, 5, 17.4321, 1e6);
    const number = (text: string) => Number(text.replace('−', '-'));
    fc.assert(
      fc.property(unit, unit, exponent, fc.boolean(), (NoL, RoV, shininess, halfway) => {
        fc.pre(RoV <= 0 || RoV > 1e-6); // nine decimals have the rest
        const fragment = { ...under({}), shininess };
        const [row] = probeSum(fragment, false).rows;
        const given = { ...row!, absence: NoL > 0 ? null : ('behind the surface' as const) };
        const text = stepsText(null, { ...given, NoL, RoV }, fragment, halfway);
        for (const [, angle, cosine] of text.matchAll(/cos ([\d.]+)° = (−?[\d.]+)/g)) {
          expect(Math.cos((number(angle!) * Math.PI) / 180), text).toBeCloseTo(
            number(cosine!),
            2.99,
          );
        }
        const power = /(−?[\d.]+), to the power of ([\d.]+): ([\d.]+)\./
          .exec(text)
          ?.slice(1)
          .map(number);
        if (power !== undefined) {
          expect(Math.abs(power[0]! ** power[1]! - power[2]!), text).toBeLessThan(0.0006);
        }
        expect(power !== undefined, text).toBe(NoL > 0 && (RoV > 0 || shininess < 1e-6));
      }),
    );
  });
});
