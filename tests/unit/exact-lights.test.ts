// The text that adds exactly some lights: one call a light or loops for all of them, in words that the light loop has.

import fc from 'fast-check';
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { HEADER, layoutDefines, ROWS, SHAPE } from '../../src/light/light-layout.js';
import type { LightValues } from '../../src/light/light-state.js';
import type { PackedLights } from '../../src/light/pack-lights.js';
import {
  constant,
  constantRows,
  counted,
  inLoops,
  isAllConstant,
  literal,
  MOST_CONSTANT,
  writtenOut,
} from '../../src/material/exact-lights.js';
import { anyLight, light } from './arbitraries.js';
import { pack } from './packed-reader.js';

const TERMS = SHAPE.ambient + SHAPE.diffuse + SHAPE.specular;
const BITS = (1 << SHAPE.powerShift) - 1;
const TINTS = SHAPE.tintedDiffuse + SHAPE.tintedSpecular;

/** A shape less what only terms need that are not summed. */
const without = (shape: number, terms: number): number => {
  const summed = (term: number, tint: number): number => ((terms & term) !== 0 ? term + tint : 0);
  const kept =
    summed(SHAPE.ambient, 0) +
    summed(SHAPE.diffuse, SHAPE.tintedDiffuse) +
    summed(SHAPE.specular, SHAPE.tintedSpecular);
  return shape & (~(TERMS + TINTS) | kept);
};

const loop = readFileSync(new URL('../../shaders/light_loop.glsl', import.meta.url), 'utf8');
const defines = new Map(
  [...layoutDefines().matchAll(/^#define (\w+) (\S+)$/gm)].map(([, name, value]) => [name!, value!]),
);

const lamp = (values: Partial<LightValues> = {}): LightValues => light({ position: [1, 2, 3, 1], ...values });
const spot = (values: Partial<LightValues> = {}): LightValues =>
  lamp({ ambient: [9, 9, 9], aperture: 20, ...values });

const KINDS = { directional: 'KIND_DIRECTIONAL', point: 'KIND_POINT', spot: 'KIND_SPOT' } as const;

interface Call {
  readonly kind: string;
  readonly args: readonly string[];
}

/** The calls of addLight in a text, in order, with the layout's names as their numbers. */
const callsIn = (text: string): Call[] =>
  [...text.matchAll(/\baddLight\(((?:[^()]|\(\w+\))*)\)/g)].map(([, list = '']) => {
    const args = list.split(',').map((arg) => defines.get(arg.trim()) ?? arg.trim());
    return { kind: args[2]!, args };
  });

const shapesIn = (text: string): number[] => callsIn(text).map(({ args }) => Number(args.at(-1)));

/** Name, first row and shape of each packed light, as they have to be called. */
function expected({ counts, shapes }: PackedLights, terms: number): (string | number)[][] {
  let [row, i] = [HEADER.rows as number, 0];
  return (['directional', 'point', 'spot'] as const).flatMap((kind) =>
    Array.from({ length: counts[kind] }, () => {
      const first = row;
      row += ROWS[kind].rows;
      return [KINDS[kind], first, without(shapes[i++]!, terms)];
    }),
  );
}

describe('lights written out', () => {
  it('are one call each, with its first row and its shape, less the terms that are not summed', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 9 }), fc.integer({ min: 0, max: 7 }), (lights, terms) => {
        const packed = pack(lights);
        const calls = callsIn(writtenOut(packed, terms));
        expect(calls.map(({ kind, args }) => [kind, Number(args[1]), Number(args.at(-1))])).toStrictEqual(
          expected(packed, terms),
        );
      }),
      { numRuns: 300 },
    );
  });

  it('are nothing without lights', () => {
    expect(writtenOut(pack([]), TERMS)).toBe('');
  });

  it('have no loops and no counts: literals alone', () => {
    const text = writtenOut(pack([light(), lamp(), spot()]), TERMS);
    expect(text).not.toMatch(/for|counts|lightRow/);
    for (const { args } of callsIn(text)) expect(args[1]).toMatch(/^\d+$/);
  });
});

describe('counted lights', () => {
  /** Kind, row and shape of every turn of every loop and of every call, as they run. */
  function run(text: string): (string | number)[][] {
    const statement =
      /(?:for\(int i=0;i<(\d+);i\+\+\))?addLight\(sums,(\d+)(?:\+i\*(\w+))?,(\w+),([^()]*)\)/g;
    return [...text.matchAll(statement)].flatMap(
      ([, turns = '1', row = '', step = '', kind = '', rest = '']) =>
        Array.from({ length: Number(turns) }, (_, i) => [
          kind,
          Number(row) + i * Number(defines.get(step) ?? 0),
          Number(rest.split(',').at(-1)),
        ]),
    );
  }

  it('are each light once, with its first row and its shape, less the terms that are not summed', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 40 }), fc.integer({ min: 0, max: 7 }), (lights, terms) => {
        const packed = pack(lights);
        expect(run(counted(packed, terms))).toStrictEqual(expected(packed, terms));
      }),
      { numRuns: 200 },
    );
  });

  it('are loops of one kind each, also where kinds have a shape in common', () => {
    expect(run(counted(pack([light(), lamp()]), TERMS)).map(([kind]) => kind)).toStrictEqual([
      KINDS.directional,
      KINDS.point,
    ]);
  });

  it('are loops of 32 turns at most, which drivers write out one by one', () => {
    const text = counted(pack(Array.from({ length: 70 }, () => lamp())), TERMS);
    expect([...text.matchAll(/i<(\d+)/g)].map(([, turns]) => Number(turns))).toStrictEqual([32, 32, 6]);
    expect(text).not.toMatch(/counts|lightRow/);
  });

  it('take the shape that all of a kind have in common where there are more than 64 loops', () => {
    const alternating = (count: number): LightValues[] =>
      Array.from({ length: count }, (_, i) => lamp(i % 2 === 0 ? {} : { specular: [0, 0, 0] }));
    expect(new Set(shapesIn(counted(pack(alternating(64)), TERMS))).size).toBe(2);
    const many = counted(pack(alternating(66)), TERMS);
    expect(new Set(shapesIn(many))).toStrictEqual(new Set([SHAPE.diffuse + SHAPE.specular]));
    expect(run(many)).toHaveLength(66);
  });

  it('are nothing without lights', () => {
    expect(counted(pack([]), TERMS)).toBe('');
  });
});

describe('numbers in a program’s text', () => {
  it('are floats to GLSL, and read back as the very same', () => {
    const float = fc.float({ noNaN: true, noDefaultInfinity: true });
    fc.assert(
      fc.property(fc.array(float, { minLength: 3, maxLength: 4 }), (numbers) => {
        const [, size, list = ''] = /^vec([34])\((.*)\)$/.exec(literal(numbers))!;
        expect(Number(size)).toBe(numbers.length);
        const parts = list.split(',');
        for (const part of parts) expect(part).toMatch(/^-?\d\.\d+e[+-]\d+$/);
        expect(parts.map((part) => Math.fround(Number(part)) + 0)).toStrictEqual(numbers.map((x) => x + 0));
      }),
    );
  });

  /** Of all kinds, each with numbers of its own. */
  const mixed = (count: number): LightValues[] =>
    Array.from({ length: count }, (_, i) => {
      const own = { diffuse: [i, 2 * i, 1], ambient: [0.25, 0.5, 0.125] } as const;
      return [light(own), lamp({ attenuation: [1, i, 0], ...own }), spot(own)][i % 3]!;
    });

  it('are the rows of the lights, in order, and the ambient light of all', () => {
    const packed = pack(mixed(9));
    const rows = constantRows(packed).match(/vec4\([^)]+\)/g)!;
    const { data } = packed;
    const expectedRows = Array.from({ length: packed.rows }, (_, i) => literal(data.slice(i * 4, i * 4 + 4)));
    expect(rows).toEqual(expectedRows.slice(HEADER.rows));
    const ambient = `sums.ambient=${expectedRows[HEADER.ambient]!}.rgb;`;
    expect(ambient).not.toContain('vec4(0.0');
    expect(constant(packed, TERMS).startsWith(ambient)).toBe(true);
    expect(constant(packed, TERMS - SHAPE.ambient)).not.toContain('ambient');
  });

  it('are where the calls say that they are, under the shapes of lights written out and a mark', () => {
    const packed = pack(mixed(9));
    const own = callsIn(constant(packed, TERMS));
    const written = callsIn(writtenOut(packed, TERMS));
    expect(own.map(({ kind }) => kind)).toEqual(written.map(({ kind }) => kind));
    own.forEach(({ args }, i) => {
      const [, row, ...others] = written[i]!.args;
      const shape = Number(others.pop());
      expect(shape & SHAPE.constant).toBe(0);
      expect(args).toEqual([
        'sums',
        String(Number(row) - HEADER.rows),
        ...others,
        String(shape | SHAPE.constant),
      ]);
    });
    expect(isAllConstant(packed)).toBe(true);
    expect(constant(packed, TERMS)).not.toContain('for(');
  });

  it.each([MOST_CONSTANT, MOST_CONSTANT + 1, MOST_CONSTANT + 30, 3 * MOST_CONSTANT])(
    'of %i lights are those of the last 64; the others are in loops of their number over what they have in common',
    (count) => {
      const packed = pack(mixed(count));
      const others = count - MOST_CONSTANT;
      expect(isAllConstant(packed)).toBe(others === 0);
      const text = constant(packed, TERMS);
      const turns = [...text.matchAll(/for\(int i=0;i<(\d+);i\+\+,row\+=(\w+)\)/g)];
      expect(turns.reduce((sum, [, times]) => sum + Number(times), 0)).toBe(others);
      const kinds = turns.map(([, times, step]) => [step, Number(times)]);
      const { directional, point, spot: spots } = packed.counts;
      const left = (before: number, own: number): number => Math.min(Math.max(others - before, 0), own);
      const expectedKinds = [
        ['DIRECTIONAL_ROWS', left(0, directional)],
        ['POINT_ROWS', left(directional, point)],
        ['SPOT_ROWS', left(directional + point, spots)],
      ].filter(([, times]) => times !== 0);
      expect(kinds).toEqual(expectedKinds);
      expect(text.includes('int row=HEADER_ROWS;')).toBe(others > 0);

      const calls = callsIn(text);
      const inText = calls.filter(({ args }) => (Number(args.at(-1)) & SHAPE.constant) !== 0);
      expect(inText).toHaveLength(Math.min(count, MOST_CONSTANT));
      expect(calls.slice(0, -inText.length).map(({ args }) => args[1])).toEqual(turns.map(() => 'row'));
      const rows = constantRows(packed).match(/vec4\([^)]+\)/g)!;
      const firstRow = packed.rows - rows.length;
      const written = callsIn(writtenOut(packed, TERMS)).slice(-inText.length);
      inText.forEach(({ args }, i) => expect(Number(args[1]) + firstRow).toBe(Number(written[i]!.args[1])));
      rows.forEach((text, i) => {
        const at = (firstRow + i) * 4;
        expect(text).toBe(literal(packed.data.slice(at, at + 4)));
      });
    },
  );

  it('leave to the loops what only their own lights have in common', () => {
    const dark = Array.from({ length: 10 }, () => light({ specular: [0, 0, 0], diffuse: [9, 9, 9] }));
    const bright = Array.from({ length: MOST_CONSTANT }, () =>
      light({ diffuse: [9, 9, 9], specular: [9, 9, 9] }),
    );
    const shapes = shapesIn(constant(pack([...dark, ...bright]), TERMS));
    expect(shapes[0]).toBe(SHAPE.diffuse);
    expect(new Set(shapes.slice(1))).toEqual(new Set([SHAPE.diffuse + SHAPE.specular + SHAPE.constant]));
  });
});

describe('lights in loops', () => {
  it('are one loop a kind that there is, in the order of their rows', () => {
    const text = inLoops(pack([spot(), light(), spot(), light()]), TERMS);
    expect(callsIn(text).map(({ kind }) => kind)).toStrictEqual([KINDS.directional, KINDS.spot]);
    expect(callsIn(inLoops(pack([lamp()]), TERMS)).map(({ kind }) => kind)).toStrictEqual([KINDS.point]);
    expect(callsIn(inLoops(pack([]), TERMS))).toStrictEqual([]);
  });

  it('begin at the first row, count by the header, and step by a light', () => {
    const text = inLoops(pack([spot(), light(), lamp()]), TERMS);
    const numbers = text.replace(/\b[A-Z_]{5,}\b/g, (name) => defines.get(name) ?? name);
    expect(numbers).toContain(`counts=ivec3(lightRow(${String(HEADER.counts)}).xyz)`);
    expect(numbers).toContain(`int row=${String(HEADER.rows)};`);
    for (const [kind, component] of [
      ['directional', 'x'],
      ['point', 'y'],
      ['spot', 'z'],
    ] as const)
      expect(numbers).toContain(
        `i<counts.${component};i++,row+=${String(ROWS[kind].rows)})addLight(sums,row,${KINDS[kind]},`,
      );
  });

  it.each<[string, LightValues[], number]>([
    [
      'the terms of any',
      [lamp({ diffuse: [0, 0, 0] }), lamp({ specular: [0, 0, 0] })],
      SHAPE.diffuse + SHAPE.specular,
    ],
    ['no term that none has', [lamp({ diffuse: [0, 0, 0] }), lamp({ diffuse: [0, 0, 0] })], SHAPE.specular],
    [
      'an attenuation',
      [lamp(), lamp({ attenuation: [1, 1, 1] })],
      SHAPE.diffuse + SHAPE.specular + SHAPE.attenuated + SHAPE.linear,
    ],
    [
      'a cone on either side',
      [spot({ aperture: 3 }), spot({ aperture: 120 })],
      TERMS + SHAPE.narrow + SHAPE.wide + SHAPE.chords,
    ],
    [
      'the cutoff that all share',
      [spot({ cutoff: 5 }), spot({ cutoff: 5 })],
      TERMS + SHAPE.wide + (5 << SHAPE.powerShift),
    ],
    ...(
      [
        ['for different cutoffs', 5, 6],
        ['for a cutoff that one lacks', 5, 0],
        ['where the first lacks it', 0, 5],
        ['beside a cutoff that is not whole', 5, 5.5],
        ['beside a cutoff that is not whole, and one that is', 5.5, 5],
        ['for a third cutoff', 5, 6, 5],
        ['for none and two alike', 0, 5, 5],
        ['for cutoffs that are not whole', 0.5, 5.5],
      ] as const
    ).map(
      ([name, ...cutoffs]) =>
        [
          `any mild decay ${name}`,
          cutoffs.map((cutoff) => spot({ cutoff })),
          TERMS +
            SHAPE.wide +
            SHAPE.decay +
            SHAPE.mild +
            (cutoffs.some((c: number) => c > 0 && c < 1) ? SHAPE.chords : 0),
        ] as [string, LightValues[], number],
    ),
    ...(
      [
        [65, 66],
        [5, 65],
        [65, 5],
        [0, 65],
        [65, 0],
        [0.5, 65, 0.5],
        [65, 0.5, 5],
      ] as const
    ).map(
      (cutoffs) =>
        [
          `any decay for cutoffs ${cutoffs.join()}`,
          cutoffs.map((cutoff) => spot({ cutoff })),
          TERMS + SHAPE.wide + SHAPE.decay + SHAPE.chords,
        ] as [string, LightValues[], number],
    ),
    ['no decay where none has one', [spot(), spot()], TERMS + SHAPE.wide],
  ])('have %s in common', (_, lights, shape) => {
    expect(shapesIn(inLoops(pack(lights), TERMS))).toStrictEqual([shape]);
  });

  it('have nothing of another kind in common', () => {
    const [directional, point, cone] = shapesIn(
      inLoops(
        pack([light({ specular: [0, 0, 0] }), lamp({ diffuse: [0, 0, 0] }), spot({ cutoff: 3 })]),
        TERMS,
      ),
    );
    expect([directional, point]).toStrictEqual([SHAPE.diffuse, SHAPE.specular]);
    expect(cone).toBe(TERMS + SHAPE.wide + (3 << SHAPE.powerShift));
  });

  it('have what each of them needs, and no bit that none does, whichever terms are summed', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 12 }), fc.integer({ min: 0, max: 7 }), (lights, terms) => {
        const packed = pack(lights);
        const wanted = expected(packed, terms);
        for (const { kind, args } of callsIn(inLoops(packed, terms))) {
          const shape = Number(args.at(-1));
          const shapes = wanted.filter(([call]) => call === kind).map((call) => Number(call[2]));
          const bits = shapes.reduce((sum, one) => sum | (one & BITS), 0);
          const powers = new Set(shapes.map((one) => one >> SHAPE.powerShift));
          const DECAYS = SHAPE.decay + SHAPE.mild;
          const decays = new Set(shapes.map((one) => one & (DECAYS | ~BITS)));
          expect(shape & BITS & ~DECAYS).toBe(bits & ~DECAYS);
          expect(shape >> SHAPE.powerShift).toBe(decays.size === 1 ? [...powers][0] : 0);
          expect((shape & SHAPE.decay) !== 0).toBe((bits & SHAPE.decay) !== 0 || decays.size > 1);
          const strong = shapes.some((one) => (one & DECAYS) === SHAPE.decay);
          if ((shape & SHAPE.decay) !== 0) expect((shape & SHAPE.mild) !== 0).toBe(!strong);
        }
      }),
      { numRuns: 300 },
    );
  });
});

describe('the words', () => {
  const [, body = ''] = /LightSums lightSums\(([^]*)/.exec(loop) ?? [];

  it.each(Object.values(KINDS))('of %s are those of the declaration', (kind) => {
    expect(loop).toContain(`const int ${kind} = `);
    const [, declared = ''] = /void addLight\(([^)]*)\)/.exec(loop) ?? [];
    const names = declared.split(',').map((parameter) => parameter.trim().split(' ').at(-1)!);
    expect(names).toContain('shape');
    for (const text of [writtenOut, constant, inLoops].map((make) =>
      make(pack([light(), lamp(), spot()]), TERMS),
    )) {
      const { args } = callsIn(text).find((call) => call.kind === kind)!;
      expect(args).toHaveLength(names.length);
      names.forEach((parameter, i) => {
        if (parameter === 'kind') expect(args[i]).toBe(kind);
        else if (/row|shape/.test(parameter)) expect(args[i]).toMatch(/^(\d+|row)$/);
        else expect(args[i]).toBe(parameter);
      });
    }
  });

  it('are known where the lights are added', () => {
    const before = body.slice(0, body.indexOf('EXACT_LIGHTS'));
    for (const name of ['p', 'N', 'n', 'sums', 'seen'])
      expect(before).toMatch(new RegExp(`\\b\\w+ ${name}\\b`));
    for (const text of [writtenOut, constant, inLoops].map((make) =>
      make(pack([light(), lamp(), spot()]), TERMS),
    )) {
      for (const word of text.match(/\b[a-zA-Z_]\w*/g) ?? []) {
        const own = ['i', 'xyz', 'x', 'y', 'z'].includes(word) || defines.has(word);
        if (!own) expect(loop, word).toMatch(new RegExp(`\\b${word}\\b`));
      }
    }
  });

  it('fit on the one line of a define', () => {
    expect(inLoops(pack([light(), lamp(), spot()]), TERMS)).not.toMatch(/[\n\\#]|\/\//);
    for (const make of [writtenOut, constant])
      expect(make(pack([light(), lamp(), spot()]), TERMS)).not.toMatch(/[\n\\#]|\/\//);
  });
});
