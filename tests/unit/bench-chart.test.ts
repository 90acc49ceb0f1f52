// Can a chart be read: by a parser, by a page without styles, by people who hear it, and are its labels where they hide nothing?
import { describe, expect, test } from 'vitest';
import { frontChart, growthChart, PAGE } from '../bench/chart.mjs';
import { logAxis } from '../bench/chart/axis.mjs';
import { overlap, placeLabels } from '../bench/chart/labels.mjs';
import { balanced, figureText, tickText, widthOf, wrapped } from '../bench/chart/text.mjs';
import { growthOf } from '../bench/growth.mjs';
import { Random } from '../stress/random.js';
import { frontOf, pointOf } from './bench-made-up.js';

const front = frontOf([
  pointOf('exact', 10, 0),
  pointOf('fast', 4, 0.2),
  pointOf('rough', 2, 9),
  pointOf('pointless', 12, 9),
]);

const growths = [
  growthOf(
    'drawn <exactly>',
    'lights',
    'GPU timer',
    [1, 10, 100].map((at) => ({ at, ms: [at, 1.1 * at] })),
  ),
  growthOf(
    'looked up',
    'lights',
    'GPU timer',
    [1, 10, 100].map((at) => ({ at, ms: [2, 2.1] })),
  ),
];

const charts = {
  'a front': frontChart(front),
  'a narrow front': frontChart(front, { width: 340, height: 300 }),
  'a front for pages': frontChart(front, { colors: PAGE }),
  'a growth': growthChart(growths),
  'a narrow growth': growthChart(growths, { width: 340, height: 300 }),
};

describe.each(Object.entries(charts))('%s', (_, chart) => {
  test('is well-formed XML', () => {
    expect(() => elementsOf(chart)).not.toThrow();
  });

  test('has presentation attributes alone, as pages without styles need', () => {
    for (const { name, attributes } of elementsOf(chart)) {
      expect(['svg', 'g', 'title', 'rect', 'line', 'path', 'circle', 'text']).toContain(name);
      for (const key of Object.keys(attributes)) expect(key).not.toMatch(/^(style|class|id|on.*|href)$/);
    }
  });

  test('is a picture with a name', () => {
    const { name, attributes } = elementsOf(chart)[0]!;
    expect(name).toBe('svg');
    expect(attributes['role']).toBe('img');
    expect(attributes['aria-label']).not.toBe('');
    expect(attributes['viewBox']).toBe(`0 0 ${attributes['width']!} ${attributes['height']!}`);
  });

  test('stays within its picture', () => {
    const elements = elementsOf(chart);
    const [width, height] = ['width', 'height'].map((key) => Number(elements[0]!.attributes[key]));
    for (const { attributes, text, name } of elements.filter((one) => one.name === 'text')) {
      if (attributes['transform'] !== undefined) continue;
      const [x, y] = [Number(attributes['x']), Number(attributes['y'])];
      const length = widthOf(text, Number(attributes['font-size']));
      const anchor = attributes['text-anchor'] ?? 'start';
      const left = x - (anchor === 'end' ? length : anchor === 'middle' ? length / 2 : 0);
      expect(left, `${name} ${text}`).toBeGreaterThanOrEqual(0);
      expect(left + length, text).toBeLessThanOrEqual(width!);
      expect(y, text).toBeLessThan(height!);
    }
  });
});

describe('a front’s chart', () => {
  test.each([
    ['beside the points', {}],
    ['in a list where it is narrow', { width: 340, height: 300 }],
  ])('names every variant %s', (_, options) => {
    const texts = textsOf(frontChart(front, options)).join(' ');
    for (const { label } of front.points) expect(texts).toContain(label);
    expect(texts).toContain('variant exact (base)');
    expect(texts).toContain('variant fast (ships)');
  });

  test('numbers its variants, and names them in a list, where names would crowd', () => {
    const crowd = frontOf(
      Array.from({ length: 18 }, (_, i) =>
        pointOf(`of a long name, number ${i}`, 5 + i / 50, 1 + ((i * 7) % 18) / 50),
      ),
    );
    const texts = textsOf(frontChart(crowd));
    // On the point and in the list.
    expect(texts.filter((text) => text === '18')).toHaveLength(2);
    for (const { label } of crowd.points) expect(texts.join(' ')).toContain(label);
  });

  test('marks another variant as shipped where asked', () => {
    expect(textsOf(frontChart(front, { shipped: 'rough' })).join(' ')).toContain('variant rough (ships)');
  });

  test('says each point’s figures to those who hover', () => {
    const titles = elementsOf(charts['a front']).filter(({ name }) => name === 'title');
    expect(titles.map(({ text }) => text.split(';')[0]).sort()).toEqual([
      'variant exact (base): 10 (9.5–11) ms',
      'variant fast (ships): 4 (3.8–4.4) ms',
      'variant pointless: 12 (11.4–13.2) ms',
      'variant rough: 2 (1.9–2.2) ms',
    ]);
    expect(titles.find(({ text }) => text.startsWith('variant fast'))!.text).toContain(
      'RMSE 0.2, 99.9 % within 0.6, largest 1',
    );
  });

  test('has a band for errors of zero only where there are some', () => {
    expect(textsOf(charts['a front'])).toContain('exact');
    const inexact = frontOf(front.points.filter(({ error }) => error.rmse > 0));
    expect(textsOf(frontChart(inexact))).not.toContain('exact');
  });

  test('can be of variants that are all exact', () => {
    const exact = frontOf([pointOf('a', 3, 0), pointOf('b', 4, 0)]);
    expect(textsOf(frontChart(exact)).join(' ')).toContain('variant b');
  });

  test('draws hollow and pale what another variant makes pointless', () => {
    const fills = marksOf(charts['a front']);
    expect(Object.keys(fills).filter((name) => fills[name] === '#ffffff')).toEqual(['variant pointless']);
  });

  test('can show another error', () => {
    const texts = textsOf(frontChart(front, { key: 'flip' }));
    expect(texts).toContain('error: mean FLIP');
    expect(texts).not.toContain('error: RMSE of channels, 1/255');
  });

  test('escapes what its data say', () => {
    const evil = `<script>&"'\u0001`;
    const chart = frontChart({
      ...frontOf([{ ...pointOf('a', 1, 1), label: evil, note: evil }]),
      title: evil,
    });
    expect(chart).not.toContain('<script');
    expect(textsOf(chart)).toContain(`<script>&"'`);
    expect(() => elementsOf(chart)).not.toThrow();
  });

  test('is the same text every time', () => {
    expect(frontChart(front)).toBe(charts['a front']);
  });
});

describe('a growth’s chart', () => {
  test('names every line with its slope', () => {
    for (const chart of [charts['a growth'], charts['a narrow growth']]) {
      const texts = textsOf(chart).join(' ');
      expect(texts).toContain('drawn <exactly> slope 1.00, upper half 1.00');
      expect(texts).toContain('looked up slope 0.00, upper half 0.00');
    }
  });

  test('is of one unit', () => {
    expect(() => growthChart([...growths, { ...growths[0]!, unit: 'pixels' }])).toThrow(
      'one chart of lights and pixels',
    );
    expect(() => growthChart([])).toThrow('one chart of nothing');
  });
});

describe('labels', () => {
  const inside = { x: 60, y: 50, width: 640, height: 350 };
  const seed = Math.floor(Math.random() * 2 ** 31);

  test(`cover neither points nor each other, or say that they do (seed ${seed})`, () => {
    const random = new Random(seed);
    for (let trial = 0; trial < 30; trial++) {
      const wanted = Array.from({ length: 12 }, () => ({
        x: random.from(inside.x, inside.x + inside.width),
        y: random.from(inside.y, inside.y + inside.height),
        ...{ width: random.from(20, 120), height: 15 },
      }));
      const marks = wanted.map(({ x, y }) => ({ x: x - 6, y: y - 6, width: 12, height: 12 }));
      const placed = placeLabels(wanted, inside, { marks, lines: [] });
      for (const [i, { box, leader, overlaps }] of placed.entries()) {
        const covered = [...marks, ...placed.filter((_, k) => k !== i).map((other) => other.box)];
        if (covered.some((other) => overlap(box, other))) expect(overlaps).toBe(true);
        if (!overlaps) {
          expect(box.x).toBeGreaterThanOrEqual(inside.x);
          expect(box.x + box.width).toBeLessThanOrEqual(inside.x + inside.width);
        }
        // Without a line to it, a label is beside its point.
        const gap = Math.max(
          box.x - wanted[i]!.x,
          wanted[i]!.x - box.x - box.width,
          box.y - wanted[i]!.y,
          wanted[i]!.y - box.y - box.height,
        );
        if (leader === null) expect(gap).toBeLessThanOrEqual(10);
      }
    }
  });

  test('find room for numbers on points that lie on each other', () => {
    const wanted = Array.from({ length: 8 }, () => ({ x: 300, y: 200, width: 12, height: 15 }));
    const marks = wanted.map(({ x, y }) => ({ x: x - 6, y: y - 6, width: 12, height: 12 }));
    expect(placeLabels(wanted, inside, { marks, lines: [] }).map(({ overlaps }) => overlaps)).toEqual(
      wanted.map(() => false),
    );
  });
});

describe('a logarithmic axis', () => {
  test.each([
    ['one decade', [1, 10], [1, 2, 5, 10]],
    ['two decades', [0.02, 3], [0.02, 0.05, 0.1, 0.2, 0.5, 1, 2]],
    ['six decades', [1e-5, 10], [1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1, 10]],
    ['thirty decades', [1e-15, 1e15], [1e-16, 1e-12, 1e-8, 1e-4, 1, 1e4, 1e8, 1e12, 1e16]],
    ['less than a factor of two', [2.1, 3.4], [2, 2.5, 3, 3.5]],
    ['one value', [7], [6.4, 6.6, 6.8, 7, 7.2, 7.4, 7.6]],
  ])('of %s has ticks that are read at a glance', (_, values, ticks) => {
    expect(logAxis(values, 0, 400, 40).ticks).toEqual(ticks);
  });

  test('has its values inside, lower ones first, whichever way it runs', () => {
    for (const [from, to] of [
      [60, 700],
      [400, 50],
    ] as const) {
      const { at } = logAxis([0.5, 80], from, to, 40);
      const places = [0.5, 6.3, 80].map(at);
      expect([...places].sort((a, b) => (a - b) * Math.sign(to - from))).toEqual(places);
      expect(Math.min(...places)).toBeGreaterThan(Math.min(from, to));
      expect(Math.max(...places)).toBeLessThan(Math.max(from, to));
      expect(at(Math.sqrt(0.5 * 80))).toBeCloseTo((from + to) / 2, 9);
    }
  });
});

describe('text', () => {
  test('wraps at words, and only a word is wider than it may be', () => {
    const text = 'any number of lights, rows in a texture';
    const lines = wrapped(text, 12, 120);
    expect(lines.join(' ')).toBe(text);
    expect(Math.max(...lines.map((line) => widthOf(line, 12)))).toBeLessThanOrEqual(120);
    expect(wrapped('Donaudampfschifffahrt', 12, 20)).toEqual(['Donaudampfschifffahrt']);
  });

  test('is balanced over no more lines than it needs', () => {
    expect(wrapped('power from a table of 256', 12, 150)).toEqual(['power from a table of', '256']);
    expect(balanced('power from a table of 256', 12, 150)).toEqual(['power from a', 'table of 256']);
  });

  test.each([
    [0.001, '0.001'],
    [20000, '20000'],
    [1e-5, '10⁻⁵'],
    [2e-4, '2·10⁻⁴'],
    [1e12, '10¹²'],
  ])('says %d as %s', (x, text) => {
    expect(tickText(x)).toBe(text);
  });

  test('gives figures three digits', () => {
    expect([0, 1.23456, 1.85e-5, 1234.5].map(figureText)).toEqual(['0', '1.23', '1.85·10⁻⁵', '1230']);
  });
});

interface Parsed {
  readonly name: string;
  readonly attributes: Record<string, string>;
  /** Directly within it, entities resolved. */
  text: string;
}

/** A parser of as much XML as charts use; throws at whatever else it finds. */
function elementsOf(xml: string): Parsed[] {
  const all: Parsed[] = [];
  const open: Parsed[] = [];
  let at = 0;
  const tag = /^<(\/?)([a-z]+)((?: [a-zA-Z0-9:-]+="[^"<]*")*)(\/?)>/;
  while (at < xml.length) {
    const rest = xml.slice(at);
    const [whole, closing, name, attributes, empty] = tag.exec(rest) ?? [];
    if (whole === undefined) {
      const text = /^[^<]+/.exec(rest)?.[0];
      if (text === undefined || open.length === 0) throw new Error(`not XML at ${rest.slice(0, 40)}`);
      open.at(-1)!.text += resolved(text);
      at += text.length;
      continue;
    }
    at += whole.length;
    if (closing === '/') {
      if (open.pop()?.name !== name) throw new Error(`</${name!}> closes something else`);
      continue;
    }
    if (open.length === 0 && all.length > 0) throw new Error('a second root');
    const pairs = [...attributes!.matchAll(/ ([a-zA-Z0-9:-]+)="([^"]*)"/g)].map(
      ([, key, value]) => [key!, resolved(value!)] as const,
    );
    if (new Set(pairs.map(([key]) => key)).size < pairs.length)
      throw new Error(`an attribute twice: ${whole}`);
    const parsed = { name: name!, attributes: Object.fromEntries(pairs), text: '' };
    all.push(parsed);
    if (empty !== '/') open.push(parsed);
  }
  if (open.length > 0) throw new Error(`<${open.at(-1)!.name}> is never closed`);
  return all;
}

function resolved(text: string): string {
  if (/&(?!(amp|lt|gt|quot);)|[\u0000-\u0008\u000b\u000c\u000e-\u001f]/.test(text))
    throw new Error(`not XML: ${text}`);
  const entities = { '&lt;': '<', '&gt;': '>', '&quot;': '"', '&amp;': '&' } as const;
  return text.replaceAll(/&(lt|gt|quot|amp);/g, (entity) => entities[entity as keyof typeof entities]);
}

const textsOf = (chart: string): string[] =>
  elementsOf(chart)
    .filter(({ name }) => name === 'text')
    .map(({ text }) => text);

/** What each point's dot is filled with, by the first words of its title. */
function marksOf(chart: string): Record<string, string> {
  const elements = elementsOf(chart);
  const fills: Record<string, string> = {};
  for (const [i, { name, text }] of elements.entries()) {
    if (name !== 'title') continue;
    const mark = elements
      .slice(i)
      .find((one) => (one.name === 'circle' || one.name === 'path') && one.attributes['fill'] !== 'none');
    fills[text.replace(/[:(].*/, '').trim()] = mark!.attributes['fill']!;
  }
  return fills;
}
