// The programs' text: every chunk where it belongs, once, and no shared number written a second time by hand.

import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { layoutDefines, ROWS } from '../../src/light/light-layout.js';
import { AVERAGES_GLSL } from '../../src/material/averaged-highlights.js';
import { LIGHT_LOOP_GLSL } from '../../src/material/light-loop-glsl.js';
import { bringAverages, lightLoop, shadersOf } from '../../src/material/program/source.js';

bringAverages(AVERAGES_GLSL);

const folder = new URL('../../shaders/', import.meta.url);
const chunks = new Map(
  readdirSync(folder)
    .filter((name) => name.endsWith('.glsl'))
    .map((name) => [name, readFileSync(new URL(name, folder), 'utf8')]),
);
const chunk = (name: string): string => chunks.get(`${name}.glsl`)!;

/** A stage's text under some defines. */
const shader = (stage: 'vertex' | 'fragment', on: readonly string[]): string =>
  shadersOf(Object.fromEntries(on.map((name) => [name, ''])))[`${stage}Shader`];

const withoutComments = (glsl: string): string => glsl.replace(/\/\*[^]*?\*\/|\/\/.*/g, '');

const count = (text: string, part: string): number => text.split(part).length - 1;

/** What stands before the first chunk. */
const head = LIGHT_LOOP_GLSL.slice(0, LIGHT_LOOP_GLSL.indexOf(chunk('guard')));
const defined = [...head.matchAll(/^#define (\w+) (\S+)$/gm)].map(([, name, value]) => ({
  name: name!,
  value: value!,
}));

const BLOCK = 'LIGHT_STORAGE_BLOCK';

/** An `#if`'s condition, as the chunks have them: storages, where none is named the texture, and `defined(…)` joined by ||. */
function holds(condition: string, on: ReadonlySet<string>): boolean {
  const [, storage] = /^LIGHT_STORAGE == STORAGE_(\w+)$/.exec(condition) ?? [];
  if (storage === 'TEXTURE') return ![...on].some((name) => name.startsWith('LIGHT_STORAGE_'));
  if (storage !== undefined) return on.has(`LIGHT_STORAGE_${storage}`);
  return condition.split('||').some((part) => on.has(/^\s*defined\((\w+)\)\s*$/.exec(part)![1]!));
}

/** What is left of a program under some defines: `#ifdef`, `#ifndef`, `#elif`, `#else`, `#endif`, as the chunks use them. */
function preprocess(glsl: string, on: ReadonlySet<string>): string {
  const taken: { now: boolean; before: boolean }[] = [];
  const next = (condition: boolean): void => {
    const { now, before } = taken.pop()!;
    taken.push({ now: condition && !now && !before, before: now || before });
  };
  const lines = withoutComments(glsl)
    .split('\n')
    .filter((line) => {
      const [, directive, rest = ''] =
        /^\s*#(ifdef|ifndef|if|elif|else|endif)\b\s*(.*?)\s*$/.exec(line) ?? [];
      if (directive === undefined) return taken.every(({ now }) => now);
      if (directive === 'ifdef') taken.push({ now: on.has(rest), before: false });
      else if (directive === 'ifndef') taken.push({ now: !on.has(rest), before: false });
      else if (directive === 'if') taken.push({ now: holds(rest, on), before: false });
      else if (directive === 'elif') next(holds(rest, on));
      else if (directive === 'else') next(true);
      else taken.pop();
      return false;
    });
  expect(taken).toStrictEqual([]);
  return lines.join('\n');
}

describe('the chunks', () => {
  const asked = ['cell_list.glsl', 'constant_rows.glsl'];

  it.each([...chunks.keys()].filter((name) => !asked.includes(name)))('%s is in the programs', (name) => {
    const text = chunks.get(name)!;
    const inFragments = shader('fragment', ['FILTER_HIGHLIGHTS']).includes(text);
    expect(shader('vertex', []).includes(text) || inFragments).toBe(true);
  });

  it.each([
    'guard',
    'power',
    'attenuation',
    'spot',
    'diffuse_lobe',
    'light_rows',
    'light_loop',
    'specular_phong',
    'specular_blinn_phong',
    'surface_color',
  ])('%s is in the light loop once', (name) => {
    expect(count(LIGHT_LOOP_GLSL, chunk(name))).toBe(1);
  });

  it.each([
    ['cell_list', 'cellList('],
    ['constant_rows', 'vec4 rowOf('],
  ])('%s stands before the loop that asks for it, and in no other', (name, word) => {
    const text = lightLoop(chunk(name));
    expect(text.indexOf(word)).toBeGreaterThan(text.indexOf(chunk('light_rows')));
    expect(text.indexOf(word)).toBeLessThan(text.indexOf(chunk('light_loop')));
    expect(LIGHT_LOOP_GLSL).not.toContain(word);
  });

  it('begin and end on lines of their own, whatever is asked for at once', () => {
    const asked = [chunk('cell_list'), chunk('constant_rows')];
    for (const more of asked) {
      const { fragmentShader } = shadersOf({ FILTER_HIGHLIGHTS: '' }, more);
      for (const text of [AVERAGES_GLSL, more]) expect(`\n${fragmentShader}\n`).toContain(`\n${text}\n`);
    }
  });

  it('are declared before they are used, whichever lobe is chosen', () => {
    for (const on of [[BLOCK], [BLOCK, 'REFLECTION_BLINN_PHONG']]) {
      const text = preprocess(LIGHT_LOOP_GLSL, new Set([...on, 'HAS_SPOT', 'HAS_POINT', 'HAS_SPECULAR']));
      for (const name of [
        'unitOrZero',
        'powerNearOne',
        'attenuation',
        'insideCone',
        'specularLobe',
        'lightRow',
      ]) {
        const declaration = text.search(new RegExp(`(float|vec3|vec4|bool) ${name}\\(`));
        expect(declaration).toBeGreaterThanOrEqual(0);
        expect(text.indexOf(`${name}(`)).toBeGreaterThanOrEqual(declaration);
      }
    }
  });

  const stages = ['vertex', 'fragment'] as const;
  const variants = [
    [],
    ['SHADING_GOURAUD'],
    ['REFLECTION_BLINN_PHONG', 'IS_LINEAR'],
    ['FILTER_HIGHLIGHTS'],
    ['FILTER_HIGHLIGHTS', 'REFLECTION_BLINN_PHONG', 'HAS_ALPHA_MASK'],
    ['SHADING_GOURAUD', 'REFLECTION_BLINN_PHONG', 'IS_LINEAR'],
  ];
  it.each(stages)('define no function twice in the %s stage, and one main', (stage) => {
    for (const variant of variants) {
      const text = preprocess(shader(stage, variant), new Set([BLOCK, ...variant]));
      const functions = [
        ...text.matchAll(/^(?:void|float|vec[34]|bool|LightSums) (\w+)\(([^)]*)\)\s*{/gm),
      ].map(([, name]) => name!);
      expect(functions).toContain('main');
      expect(new Set(functions).size).toBe(functions.length);
    }
  });

  it('have nothing of filtered highlights in programs that do not ask for them', () => {
    const traces = /dFdx|dFdy|Footprint|\bSeen\b|seenNear|FARTHEST|masked/;
    for (const on of [[], ['REFLECTION_BLINN_PHONG'], ['HAS_ALPHA_MASK', 'HAS_SPOT', 'HAS_POINT']]) {
      const text = (more: string[] = []): string =>
        preprocess(shader('fragment', []), new Set([BLOCK, 'HAS_SPECULAR', ...on, ...more]));
      expect(text()).not.toMatch(traces);
      expect(text(['FILTER_HIGHLIGHTS'])).toMatch(traces);
    }
  });

  it('average highlights only in programs that are to', () => {
    expect(shader('fragment', ['FILTER_HIGHLIGHTS'])).toContain(chunk('averaged_phong'));
    expect(shader('fragment', [])).not.toContain('averagedLobe(');
    expect(shader('vertex', ['FILTER_HIGHLIGHTS'])).not.toContain('averagedLobe(');
  });

  it('take derivatives before the first loop, and discard after them', () => {
    for (const on of [[], ['REFLECTION_BLINN_PHONG']]) {
      const text = preprocess(
        shader('fragment', ['FILTER_HIGHLIGHTS']),
        new Set([BLOCK, 'FILTER_HIGHLIGHTS', 'HAS_ALPHA_MASK', 'HAS_POINT', ...on]),
      );
      const sums = text.slice(text.indexOf('LightSums lightSums('));
      expect(sums.indexOf('seenAcross(')).toBeGreaterThan(0);
      expect(sums.indexOf('seenAcross(')).toBeLessThan(sums.indexOf('for ('));
      expect(count(text, 'seenAcross(')).toBe(2);
      const main = text.slice(text.indexOf('void main()'));
      expect(main.indexOf('discard')).toBeGreaterThan(main.indexOf('surfaceColor('));
      expect(count(main, 'discard')).toBe(1);
    }
  });

  it('sum the lights in one stage only, and the other has nothing of the loop', () => {
    const has = (stage: 'vertex' | 'fragment', on: string[]): boolean => {
      const text = shader(stage, on);
      const loop = text.includes(chunk('light_loop'));
      expect(preprocess(text, new Set(on)).includes('lightSums(')).toBe(loop);
      return loop;
    };
    expect(has('vertex', [])).toBe(false);
    expect(has('fragment', [])).toBe(true);
    expect(has('vertex', ['SHADING_GOURAUD'])).toBe(true);
    expect(has('fragment', ['SHADING_GOURAUD'])).toBe(false);
  });

  it('declare uniforms in the programs and the storage of lights only', () => {
    const declaring = [...chunks].filter(([, text]) => /\buniform\b/.test(withoutComments(text)));
    expect(declaring.map(([name]) => name).sort()).toStrictEqual([
      'light_rows.glsl',
      'phong.frag.glsl',
      'phong.vert.glsl',
    ]);
  });

  it.each([...chunks])('%s closes every condition that it opens', (_, text) => {
    expect(() => preprocess(text, new Set())).not.toThrow();
  });

  it.each([...chunks])('%s asks for no precision below highp and trusts no NaN', (_, text) => {
    expect(withoutComments(text)).not.toMatch(/\b(mediump|lowp|isnan|isinf)\b/);
  });
});

describe('numbers that TypeScript and GLSL share', () => {
  it('stand before everything in the loop, each once', () => {
    expect(LIGHT_LOOP_GLSL.startsWith(layoutDefines())).toBe(true);
    const names = defined.map(({ name }) => name);
    expect(new Set(names).size).toBe(names.length);
  });

  it('are real numbers where GLSL calculates with floats', () => {
    for (const { name, value } of defined) {
      if (/^(SRGB_|LIMIT_|NEAREST|LEAST_|TINY)/.test(name)) expect(value).toMatch(/^[\d.]+(e[+-]?\d+)?$/);
      if (/^(SRGB_|LIMIT_|NEAREST|LEAST_|TINY)/.test(name)) expect(value).toMatch(/[.e]/);
      else expect(value).toMatch(/^\d+$/);
    }
  });

  it.each([...chunks])('%s defines none of them itself', (_, text) => {
    for (const { name } of defined) {
      expect(text).not.toMatch(new RegExp(`#define ${name}\\b|const \\w+ ${name}\\b`));
    }
  });

  it.each([...chunks])('%s writes none of their values by hand', (_, text) => {
    // Small whole numbers mean many things; every other shared value would be a copy.
    // Nor is a bit of an exponent that is multiplied out: k & 16.
    const numbers = (
      withoutComments(text)
        .replace(/\bk & \d+/g, '')
        .match(/(?<![\w.])\d+\.?\d*(e[+-]?\d+)?/gi) ?? []
    ).map(Number);
    const shared = defined.map(({ value }) => Number(value)).filter((n) => !Number.isInteger(n) || n > 10);
    for (const n of shared) expect(numbers).not.toContain(n);
  });

  it('index rows by name alone', () => {
    for (const [, text] of chunks) {
      expect(withoutComments(text)).not.toMatch(/lightRow\([^)]*\d/);
      expect(withoutComments(text)).not.toMatch(/\brow \+ \d|uLightRows\[\d/);
    }
  });

  it('name every row that the loop reads, and the loop reads every row', () => {
    const loop = chunk('light_loop');
    const rows = defined
      .map(({ name }) => name)
      .filter((name) => /^(DIRECTIONAL|POINT|SPOT|HEADER)_/.test(name));
    // All kinds begin with the same rows, which the loop reads by a point light's names.
    const begins = rows.filter((name) =>
      /^(DIRECTIONAL|SPOT)_(DIRECTION|POSITION|DIFFUSE|SPECULAR)$/.test(name),
    );
    const used = new Set(loop.match(/\b(?<!KIND_)(DIRECTIONAL|POINT|SPOT|HEADER)_[A-Z]+\b/g));
    expect([...used, ...begins].sort()).toStrictEqual([...rows].sort());
    const { directional, point, spot } = ROWS;
    const begin = [point.position, point.diffuse, point.specular];
    expect([directional.direction, directional.diffuse, directional.specular]).toStrictEqual(begin);
    expect([spot.position, spot.diffuse, spot.specular]).toStrictEqual(begin);
  });
});

describe('code for what no light has', () => {
  const loopWith = (...on: string[]): string => preprocess(LIGHT_LOOP_GLSL, new Set([BLOCK, ...on]));
  const facts = [
    ...['DIRECTIONAL', 'POINT', 'SPOT', 'ATTENUATION', 'CONE', 'DECAY'],
    ...['AMBIENT', 'DIFFUSE', 'SPECULAR'],
  ].map((name) => `HAS_${name}`);

  it.each([
    ['HAS_DIRECTIONAL', 'if (i < counts.x) kind = KIND_DIRECTIONAL;'],
    ['HAS_POINT', 'if (i < spots) kind = KIND_POINT;'],
    ['HAS_SPOT', 'if (kind == KIND_SPOT) {'],
    ['HAS_ATTENUATION', '+ SHAPE_ATTENUATED'],
    ['HAS_CONE', '+ SHAPE_NARROW + SHAPE_WIDE'],
    ['HAS_DECAY', '+ SHAPE_DECAY'],
    ['HAS_AMBIENT', 'HEADER_AMBIENT)'],
    ['HAS_AMBIENT', '+ SHAPE_AMBIENT'],
    ['HAS_DIFFUSE', '+ SHAPE_DIFFUSE'],
    ['HAS_SPECULAR', '+ SHAPE_SPECULAR'],
  ])('without %s is not in the loop: %s', (fact, code) => {
    const others = facts.filter((name) => name !== fact);
    expect(loopWith(...others)).not.toContain(code);
    expect(count(loopWith(...facts), code)).toBe(1);
  });

  it.each([
    ['SHAPE_ATTENUATED', /attenuation\(vec3\(/],
    ['SHAPE_AMBIENT', /sums\.ambient \+=/],
    ['SHAPE_DIFFUSE', /addColor\(sums\.diffuse|diffuseLobe\(/],
    ['SHAPE_SPECULAR', /addColor\(sums\.specular|specularLobe\(/],
  ])('goes where a light has no %s', (bit, code) => {
    const statements = withoutComments(chunk('light_loop')).match(
      /if \([^{};]*\) (\{[^}]*\}|[^{};]*;)|[^{};]*;/g,
    )!;
    const guarded = statements.filter((statement) => code.test(statement));
    expect(guarded.length).toBeGreaterThan(0);
    for (const statement of guarded) expect(statement).toContain(`if (has(shape, ${bit})) `);
  });

  it('asks each light for its shape alone where programs are for exactly these lights', () => {
    const exact = loopWith(...facts, 'EXACT_LIGHTS');
    expect(exact).not.toMatch(/\bDECLARED_SHAPE\b|\bcounts\b|\bfor \(/);
    expect(count(exact, 'EXACT_LIGHTS')).toBe(1);
    expect(loopWith(...facts)).not.toContain('EXACT_LIGHTS');
  });
});
