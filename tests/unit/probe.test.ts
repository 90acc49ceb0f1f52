// Do the probe's rows, vectors and words agree with the explanation of a fragment?

import fc from 'fast-check';
import { Mesh } from 'three';
import { beforeAll, describe, expect, it, vi } from 'vitest';
import type { PhongViewer } from '../../src/element/phong-viewer.js';
import type { FragmentExplanation, LightExplanation } from '../../src/element/explanation.js';
import { srgbDecode } from '../../src/math/color.js';
import { length, type Vec3 } from '../../src/math/vector.js';
import { Projection } from '../../src/overlay/drawing/projection.js';
import { cellText, columnsOf } from '../../src/overlay/probe/columns.js';
import { drawingOf } from '../../src/overlay/probe/drawing.js';
import { figureOf, MOST_LIGHTS } from '../../src/overlay/probe/figure.js';
import { byShare, shortNumber, shownAbsence, probeSum, tripleText } from '../../src/overlay/probe/sum.js';
import { fragmentText, stepsText } from '../../src/overlay/probe/words.js';
import { LightState, shade, type Surface } from '../../src/reference/index.js';

// Labels are measured by a canvas where there is one.
beforeAll(() => {
  vi.stubGlobal('document', {
    createElement: () => ({ getContext: () => null }),
    documentElement: { lang: '' },
  });
});

const SURFACE: Surface = { ka: [255, 255, 255], kd: [204, 204, 204], ks: [102, 102, 102], shininess: 8 };

interface Given {
  readonly position?: readonly [number, number, number, number];
  readonly diffuse?: Vec3;
  readonly ambient?: Vec3;
  readonly axis?: Vec3;
  readonly aperture?: number;
  readonly active?: boolean;
}

/** The fragment at the origin of a floor, seen at 45 degrees from +z, as shadeAt explains it. */
function explained(
  given: readonly Given[],
  options: { linear?: boolean; normal?: Vec3 } = {},
): FragmentExplanation {
  const { linear = false, normal = [0, 1, 0] } = options;
  const lights = given.map((values) => {
    const light = new LightState();
    for (const [key, value] of Object.entries(values)) light.set(key as 'position', value as never);
    return light.values;
  });
  const { shares, N, V, sum, color } = shade({ p: [0, 0, 0], normal, eye: [0, 2, 2] }, SURFACE, lights, {
    linear,
  });
  return {
    ...{
      p: [0, 0, 0],
      N,
      V,
      sum,
      color,
      triangle: 0,
      ka: [1, 1, 1],
      kd: [0.8, 0.8, 0.8],
      ks: [0.4, 0.4, 0.4],
    },
    ...{
      shininess: 8,
      baseColor: [1, 1, 1],
      emissive: [0, 0, 0],
      metalness: 0,
      unlit: false,
      filtered: false,
      opacity: 1,
    },
    mesh: {} as PhongViewer,
    object: new Mesh(),
    shares: shares.map(
      (share, i): LightExplanation | null => share && { ...share, light: null, name: `light ${i + 1}` },
    ),
  };
}

const TWO: readonly Given[] = [
  { position: [0, 1, 0, 0], diffuse: [40, 50, 60], ambient: [10, 10, 10] },
  { active: false },
  { position: [0, 1, -1, 0], diffuse: [200, 100, 0] },
];

describe('the sum', () => {
  it('has a row for each active light, whose terms add up to its total, and the totals to the sum', () => {
    const fragment = explained(TWO);
    const { rows, totals, color } = probeSum(fragment, false);
    expect(rows.map(({ name }) => name)).toEqual(['light 1', 'light 3']);
    for (const { ambient, diffuse, specular, total } of rows)
      total.forEach((x, i) => expect(x).toBeCloseTo(ambient[i]! + diffuse[i]! + specular[i]!, 10));
    expect(totals.map(({ label }) => label)).toEqual(['sum', 'clamped']);
    totals[0]!.color.forEach((x, i) => expect(x).toBeCloseTo(255 * fragment.sum[i]!, 10));
    expect(color).toEqual(fragment.color.map((x) => 255 * x));
  });

  it('is encoded last in linear light', () => {
    const fragment = explained(TWO, { linear: true });
    const { rows, totals } = probeSum(fragment, true);
    expect(totals.map(({ label }) => label)).toEqual(['sum', 'encoded', 'clamped'].slice(0, totals.length));
    const red = rows.reduce((total, row) => total + row.total[0], 0);
    expect(red / 255).toBeCloseTo(srgbDecode(fragment.sum[0]), 10);
    expect(totals[1]!.color[0]).toBeCloseTo(255 * fragment.sum[0], 10);
  });

  it('adds an emissive colour, and is the base colour alone for unlit surfaces', () => {
    const glowing = { ...explained([]), emissive: [0.1, 0.2, 0] as const, sum: [0.1, 0.2, 0] as const };
    expect(probeSum(glowing, false).totals[0]).toEqual({ label: 'emissive', color: [25.5, 51, 0] });
    const unlit = {
      ...explained(TWO),
      unlit: true,
      baseColor: [1, 0, 0] as const,
      sum: [1, 0, 0] as const,
      color: [1, 0, 0] as const,
    };
    const { rows, totals } = probeSum(unlit, false);
    expect(rows).toEqual([]);
    expect(totals).toEqual([{ label: 'base colour', color: [255, 0, 0] }]);
  });

  it('says why a light adds neither diffuse nor specular', () => {
    const { rows } = probeSum(
      explained([
        { position: [0, -1, 0, 0] },
        { position: [0, 3, 0, 1], axis: [1, 0, 0], aperture: 10 },
        { position: [0, 0, 0, 0] },
        { position: [0, 1, 0, 0] },
      ]),
      false,
    );
    expect(rows.map(({ absence }) => absence)).toEqual([
      ...['behind the surface', 'outside its cone', 'no direction', null],
    ]);
    expect(probeSum(explained(TWO, { normal: [0, 0, 0] }), false).rows[0]!.absence).toBe('no normal');
  });

  it('says it only of terms that are missing: under Gouraud shading the corners may have them', () => {
    const [row] = probeSum(explained([{ position: [0, -1, 0, 0], ambient: [9, 9, 9] }]), false).rows;
    expect(shownAbsence(row!)).toBe('behind the surface');
    expect(shownAbsence({ ...row!, diffuse: [1, 0, 0] })).toBeNull();
    expect(shownAbsence({ ...row!, absence: 'outside its cone' })).toBeNull();
  });

  it('has "…" in place of terms that have no column, in the rows whose sum has them', () => {
    const sum = probeSum(explained([TWO[0]!, { ...TWO[2]!, ambient: [0, 0, 0] }]), false);
    const shown = (left: number): string[] => {
      const shape = { columns: columnsOf(sum, left, true), digits: 0, stacked: false };
      const [first = '…', ...rest] = shape.columns;
      const marks = sum.rows.map((row) => (first === '…' ? cellText(row, first, shape, null) : ''));
      return [[first, ...rest].join(' '), ...marks];
    };
    expect([0, 1, 2, 3, 4, 5].map(shown)).toEqual([
      ['ambient diffuse specular att decay sum', '', ''],
      ['ambient diffuse specular att sum', '', ''],
      ['ambient diffuse specular sum', '', ''],
      ['… diffuse specular sum', '…', ''],
      ['… diffuse sum', '…', '…'],
      ['… sum', '…', '…'],
    ]);
    expect(columnsOf(sum, 0, false), 'under Gouraud the factors are not those of the terms').not.toContain(
      'att',
    );
  });

  it('prints numbers with a typographic minus, none before a zero, and short at any size', () => {
    expect(shortNumber(-0.001, 2, null)).toBe('0.00');
    expect(shortNumber(-1.5, 1, null)).toBe('−1.5');
    expect(shortNumber(Infinity, 1, null)).toBe('∞');
    expect(shortNumber(1.5e300, 1, null)).toBe('1.5e+300');
    expect(tripleText([1, 2.25, 255], 1, null)).toBe('1.0 2.3 255.0');
    expect(tripleText([1, 2.25, 255], 1, { en: 'de' }), 'a wider gap').toBe('1,0\u20022,3\u2002255,0');
  });
});

describe('the figure', () => {
  const figure = (fragment: FragmentExplanation, chosen = 0, options = { alone: false, halfway: false }) => {
    const sum = probeSum(fragment, false);
    return figureOf(fragment, sum, sum.rows[chosen] ?? null, options, null);
  };

  it('has N, L of each light, and R of the chosen one, all unit vectors', () => {
    const { vectors, arcs } = figure(explained(TWO), 1);
    expect(vectors.map(({ name }) => name)).toEqual(['N', 'L light 3', 'L light 1', 'R ∠V 0°']);
    for (const { direction } of vectors) expect(length(direction)).toBeCloseTo(1, 12);
    expect(arcs.map(({ label }) => label)).toEqual(['45°']);
  });

  it('has the angles that the words have', () => {
    const fragment = explained([{ position: [0.3, 1, -0.4, 0] }]);
    const [row] = probeSum(fragment, false).rows;
    const said = [...stepsText(null, row!, fragment, false).matchAll(/cos ([\d.]+°)/g)].map(
      ([, angle]) => angle,
    );
    const { vectors, arcs } = figure(fragment);
    expect([arcs[0]!.label, vectors.at(-1)!.name]).toEqual([said[0], `R ∠V ${said[1]!}`]);
  });

  it('calls an arrow L where its light\u2019s own name stands beside it', () => {
    const fragment = explained(TWO);
    const pose = { theta: 0, phi: 45, radius: Math.sqrt(8), target: [0, 0, 0] } as const;
    const projection = new Projection({ pose, fov: 45, width: 600, height: 400 });
    const at = { x: 300, y: 200 };
    const texts = (left: number): string[] => {
      const names = [{ text: 'light 1', left, top: 90, right: left + 40, bottom: 106 }];
      const room = { left: 0, top: 0, right: 600, bottom: 400 };
      const space = { outline: [], room, boxes: [], names, fontSize: 12 };
      const list = drawingOf(projection, [0, 0, 0], at, figure(fragment), space);
      return list
        .flatMap((each) => (each.kind === 'label' ? [each.text] : []))
        .filter((text) => text.startsWith('L'));
    };
    expect(texts(310).sort()).toEqual(['L', 'L light 3']);
    expect(texts(10).sort()).toEqual(['L light 1', 'L light 3']);
  });

  it('has H and its angle to N under Blinn–Phong', () => {
    const { vectors, arcs } = figure(explained(TWO), 1, { alone: true, halfway: true });
    expect(vectors.map(({ name }) => name)).toEqual(['N', 'L light 3', 'H']);
    expect(arcs).toHaveLength(2);
    expect(vectors[2]!.direction[1]).toBeCloseTo(1, 12); // between (0 1 −1) and (0 1 1)
  });

  it('dashes L of a light behind the surface and omits its R', () => {
    const { vectors } = figure(explained([{ position: [0, -1, 1, 0] }]));
    expect(vectors.map(({ name, dashed }) => [name, dashed])).toEqual([
      ['N', false],
      ['L', true],
    ]);
  });

  it('has arrows for the lights that add most if there are many, and always for the chosen one', () => {
    const many = Array.from({ length: 50 }, (_, i): Given => ({
      position: [0, 1, 0, 0],
      diffuse: [i, i, i],
    }));
    const fragment = explained(many);
    const strongest = byShare(probeSum(fragment, false).rows).slice(0, MOST_LIGHTS);
    const named = figure(fragment, 0)
      .vectors.filter(({ name }) => name.startsWith('L'))
      .map(({ name }) => name);
    expect(named).toEqual([...strongest.map(({ name }) => `L ${name}`), 'L light 1']);
  });

  it('has neither N nor angles where the surface has no normal', () => {
    const { vectors, arcs } = figure(explained(TWO, { normal: [0, 0, 0] }));
    expect(vectors.some(({ name }) => name === 'N')).toBe(false);
    expect(arcs).toEqual([]);
  });

  it('is drawn with finite numbers for every light, pole and size', () => {
    const positions: NonNullable<Given['position']>[] = [
      [0, 1, 0, 0],
      [0, -1, 0, 0],
      [0, 0, 0, 0],
      [0, 0, 0, 1],
      [0, 2, 2, 1],
      [1e15, 1e15, 0, 1],
    ];
    for (const normal of [
      [0, 1, 0],
      [0, -1, 0],
      [0, 0, 0],
      [0, Math.SQRT1_2, Math.SQRT1_2],
    ] as const)
      for (const [width, height] of [
        [600, 400],
        [120, 90],
        [1, 1],
      ] as const)
        for (const halfway of [false, true]) {
          const fragment = explained(
            positions.map((position) => ({ position })),
            { normal },
          );
          const sum = probeSum(fragment, false);
          for (const row of sum.rows) {
            const pose = { theta: 0, phi: 45, radius: Math.sqrt(8), target: [0, 0, 0] } as const;
            const projection = new Projection({ pose, fov: 45, width, height });
            const drawn = figureOf(fragment, sum, row, { alone: false, halfway }, null);
            const list = drawingOf(projection, [0, 0, 0], { x: width / 2, y: height / 2 }, drawn, {
              outline: [],
              room: { left: 0, top: 0, right: width, bottom: height },
              boxes: [],
              names: [],
              fontSize: 12,
            });
            // JSON writes null for what is not finite.
            const text = JSON.stringify(list);
            expect(text).not.toMatch(/"[xy]":null/);
          }
        }
  });
});

describe('the words', () => {
  it('name point, colour and the terms of the lights that add most', () => {
    const fragment = explained(TWO);
    expect(fragmentText(null, fragment, probeSum(fragment, false))).toMatch(
      /^Point 0 0 0\. Colour: red \d+, green \d+, blue \d+\. light 3: ambient 0 0 0, diffuse [\d ]+, specular [\d ]+\. light 1: ambient 10 10 10, diffuse 32 40 48, specular [\d ]+\.$/,
    );
    const many = explained(Array.from({ length: 5 }, () => TWO[0]!));
    expect(fragmentText(null, many, probeSum(many, false))).toMatch(/More lights: 2\.$/);
  });

  it('can be replaced by another language', () => {
    const fragment = explained([]);
    const texts = { 'Point {point}.': 'Punkt {point}.' };
    expect(fragmentText(texts, fragment, probeSum(fragment, false))).toMatch(/^Punkt 0 0 0\./);
  });

  it('show the steps from a light’s angles to its terms', () => {
    const fragment = explained([{ position: [0, 1, -1, 0] }, { position: [0, -1, 0, 0] }]);
    const [first, second] = probeSum(fragment, false).rows;
    expect(stepsText(null, first!, fragment, false)).toBe(
      'light 1: N·L = cos 45° = 0.707; R·V = cos 0° = 1.000, to the power of 8: 1.000.',
    );
    expect(stepsText(null, second!, fragment, false)).toBe(
      'light 2: N·L = cos 180° = −1.000 is not above 0, so only ambient.',
    );
  });

  it('name the limits of the equation, in place of a power or an angle that is none', () => {
    const steps = (given: Given, options?: { normal?: Vec3; shininess?: number; halfway?: boolean }) => {
      const fragment = { ...explained([given], options), shininess: options?.shininess ?? 2 };
      return stepsText(null, probeSum(fragment, false).rows[0]!, fragment, options?.halfway ?? false);
    };
    const away: Given = { position: [0, 1, 3, 0] };
    expect(steps(away)).toBe('light 1: N·L = cos 71.6° = 0.316; R·V = −0.447 is not above 0: no highlight.');
    expect(steps(away, { shininess: 1e-7 })).toBe(
      'light 1: N·L = cos 71.6° = 0.316; R·V = cos 116.57° = −0.447, to the power of 0: 1.000.',
    );
    expect(steps(away, { normal: [0, 0, 0] })).toBe('light 1: no normal here, so only ambient.');
    expect(steps({ position: [0, 0, 0, 1] })).toBe('light 1: no direction, so only ambient.');
    expect(steps({ position: [0, 3, 0, 1], axis: [1, 0, 0], aperture: 10 })).toBe(
      'light 1: 90° from its axis, outside its cone, so it adds nothing.',
    );
  });

  it('are true of the numbers as they are written, for every angle and exponent', () => {
    const unit = fc.double({ min: -1, max: 1, noNaN: true });
    const exponent = fc.oneof(
      fc.double({ min: 0, max: 200, noNaN: true }),
      fc.constantFrom(1e-6, 0.01, 1e4, 1e6),
    );
    const number = (text: string): number => Number(text.replace('−', '-'));
    fc.assert(
      fc.property(unit, unit, exponent, fc.boolean(), (NoL, RoV, shininess, halfway) => {
        fc.pre(RoV <= 0 || RoV > 1e-6); // nine decimals have the rest
        const fragment = { ...explained([{}]), shininess };
        const [row] = probeSum(fragment, false).rows;
        const given = { ...row!, absence: NoL > 0 ? null : ('behind the surface' as const) };
        const text = stepsText(null, { ...given, share: { ...row!.share, NoL, RoV } }, fragment, halfway);
        for (const [, angle, cosine] of text.matchAll(/cos ([\d.]+)° = (−?[\d.]+)/g))
          expect(Math.cos((number(angle!) * Math.PI) / 180), text).toBeCloseTo(number(cosine!), 2.99);
        const power = /(−?[\d.]+), to the power of ([\d.]+): ([\d.]+)\./.exec(text)?.slice(1).map(number);
        if (power !== undefined)
          expect(Math.abs(power[0]! ** power[1]! - power[2]!), text).toBeLessThan(0.01);
        expect(power !== undefined, text).toBe(NoL > 0 && (RoV > 0 || shininess < 1e-6));
      }),
    );
  });

  it('say where the numbers are of one point of a texture that the picture averages', () => {
    const fragment = explained(TWO);
    const said = (filtered: boolean): string =>
      fragmentText(null, { ...fragment, filtered }, probeSum(fragment, false));
    expect(said(true)).toContain('these numbers read it at one point, so they can differ.');
    expect(said(false)).not.toContain('texture');
  });
});
