// What becomes of a bench run's samples: fronts, growth and the report.
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import { dominated, frontier } from '../bench/front.mjs';
import { growthOf, slopeSpread } from '../bench/growth.mjs';
import { spread } from '../bench/statistics.mjs';
import { reportOf } from '../bench/report-text.mjs';
import { writeReport } from '../bench/write-report.mjs';
import { about, frontOf, pointOf, resultOf } from './bench-made-up.js';

describe('a front', () => {
  test('leaves out what another variant beats in time or error and loses to in neither', () => {
    const points = [
      pointOf('exact', 10, 0),
      pointOf('slow', 12, 1),
      pointOf('rough', 5, 2),
      pointOf('worse', 5, 3),
      pointOf('late', 6, 2),
    ];
    expect([...dominated(points)].sort()).toEqual(['late', 'slow', 'worse']);
    expect(frontier(points).map(({ id }) => id)).toEqual(['rough', 'exact']);
  });

  test('keeps variants that are equal in both', () => {
    const points = [pointOf('a', 5, 1), pointOf('b', 5, 1), pointOf('c', 7, 1)];
    expect([...dominated(points)]).toEqual(['c']);
  });

  test('keeps the only one', () => {
    expect(dominated([pointOf('a', 5, 1)]).size).toBe(0);
  });

  test('can be of another error', () => {
    const points = [pointOf('a', 5, 1, { flip: 0.3 }), pointOf('b', 6, 2, { flip: 0.1 })];
    expect([...dominated(points)]).toEqual(['b']);
    expect([...dominated(points, 'flip')]).toEqual([]);
  });
});

describe('growth', () => {
  test.each([
    ['linear', 1],
    ['quadratic', 2],
    ['constant', 0],
    ['with the root', 0.5],
  ])('that is %s has the slope %d', (_, power) => {
    const samples = [1, 4, 16, 64, 256].map((at) => ({ at, ms: [3 * at ** power] }));
    const { slope, slopeUpper } = growthOf('shade', 'lights', 'GPU timer', samples);
    // Rounding of the logarithms: measured 4.4e-16.
    expect(slope).toBeCloseTo(power, 14);
    expect(slopeUpper).toBeCloseTo(power, 14);
  });

  test('has its slope from medians, and its upper slope from the larger counts alone', () => {
    const ms = [[4], [4], [9, 8, 7], [16], [32]];
    const samples = [1, 2, 4, 8, 16].map((at, i) => ({ at, ms: ms[i]! })).reverse();
    const { points, slope, slopeUpper } = growthOf('shade', 'lights', 'clock', samples, 'a note');
    expect(points.map(({ at }) => at)).toEqual([1, 2, 4, 8, 16]);
    expect(points[2]!.time).toEqual(spread([7, 8, 9]));
    expect(slopeUpper).toBeCloseTo(1, 14);
    // log2: 2, 2, 3, 4, 5 over 0 … 4.
    expect(slope).toBeCloseTo(0.8, 14);
  });

  test('has a slope as uncertain as its quartiles allow', () => {
    const points = [1, 2].map((at) => ({ at, time: { median: at, low: at / 2, high: at * 2, count: 5 } }));
    // From 2 to 1, and from 1/2 to 4.
    const { median, low, high } = slopeSpread(points);
    expect([median, low]).toEqual([1, -1]);
    expect(high).toBeCloseTo(3, 14);
  });

  test.each([
    ['one count', [{ at: 4, ms: [1] }], 'one count has no slope'],
    [
      'a count twice',
      [
        { at: 4, ms: [1] },
        { at: 4, ms: [2] },
        { at: 8, ms: [2] },
      ],
      'a count twice',
    ],
    [
      'no time',
      [
        { at: 4, ms: [0] },
        { at: 8, ms: [2] },
      ],
      '0 ms at 4 lights',
    ],
    [
      'no samples',
      [
        { at: 4, ms: [] },
        { at: 8, ms: [2] },
      ],
      'NaN ms at 4 lights',
    ],
  ])('is not made of %s', (_, samples, message) => {
    expect(() => growthOf('shade', 'lights', 'clock', samples)).toThrow(message);
  });
});

describe('the report', () => {
  const run = resultOf({
    fronts: [
      frontOf([
        pointOf('exact', 10, 0),
        pointOf('fast', 4, 0.2),
        { ...pointOf('slow', 12, 0.3), label: 'a | b <c> *d*', note: 'a note' },
      ]),
    ],
    growth: [
      growthOf(
        'all',
        'lights',
        'GPU timer',
        [1, 8, 64].map((at) => ({ at, ms: [at] })),
      ),
    ],
    peers: [
      {
        ...{ what: 'distance', peer: '<model-viewer>', version: '4', unit: '/255' },
        value: about(3, 1),
        note: 'first',
      },
      {
        ...{ what: 'distance', peer: '<model-viewer>', version: '4', unit: '/255' },
        value: about(5, 1),
        note: 'second',
      },
      {
        ...{ what: 'distance', peer: 'X_ITE', version: '15', unit: '/255' },
        value: about(0, 0),
        note: 'cannot be asked',
      },
      {
        ...{ what: 'start', peer: 'X_ITE', version: '15', unit: 'ms' },
        value: about(900),
        ratio: about(2.5),
      },
    ],
    figures: {
      frame: [
        {
          ...{ name: '8 lights', unit: 'ms', value: about(1), peer: about(2), ratio: about(0.5) },
          atMost: 0.6,
        },
        {
          ...{ name: '16 lights', unit: 'ms', value: about(2), peer: about(2), ratio: about(1) },
          atMost: 0.6,
        },
        { name: 'no aim', unit: 'ms', value: about(2), peer: about(2), ratio: about(1) },
      ],
    },
  });
  const stacks = [
    { ...run, stack: 'SwiftShader' },
    { ...resultOf({ fronts: run.fronts }), stack: 'NVIDIA-H200-Vulkan', machine: { renderer: 'H200' } },
  ];
  const { report, charts } = reportOf(stacks, '## What was found\n\nProse with `code`.\n');
  const row = (start: string): string =>
    report.split('\n').find((line) => line.startsWith(`| ${start}`)) ?? '';

  test('has a chart for each front and each unit of growth on each stack, and shows them', () => {
    const names = [
      'SwiftShader-loops-8-mixed.svg',
      'SwiftShader-growth-lights.svg',
      'NVIDIA-H200-Vulkan-loops-8-mixed.svg',
    ];
    expect([...charts.keys()]).toEqual(names);
    for (const name of names) expect(report).toContain(`](charts/${name})`);
  });

  test('has a row for each variant, with what is on the front, the base and what ships', () => {
    expect(row('● | **variant fast** (ships)')).toBe(
      '| ● | **variant fast** (ships) | 0.4 (0.381–0.444) | 4 | 0.2 | 0.6 | 1 | 0.2 % | 0.0222 | 0.001 |  |',
    );
    expect(row('● | variant exact (base)')).toContain('| 10 | 0 | 0 | 0 | 0 % | 0 | 0 |');
    expect(row('○ | a')).toContain('a \\| b &lt;c&gt; \\*d\\*');
    expect(row('○ | a')).toMatch(/a note \|$/);
  });

  test('has as many cells in every row of a table as in its head', () => {
    let cells = 0;
    for (const line of report.split('\n')) {
      const count = line.startsWith('|') ? line.replaceAll('\\|', '').split('|').length : 0;
      if (cells > 0 && count > 0) expect(count, line).toBe(cells);
      cells = count;
    }
  });

  test('has peers with each thing that was asked of them', () => {
    expect(row('&lt;model-viewer&gt; 4')).toBe('| &lt;model-viewer&gt; 4 | 3 | first |');
    expect(report).toContain('| &lt;model-viewer&gt; 4 | 5 | second |');
    expect(report).toContain('| X\\_ITE 15 | – | cannot be asked |');
    expect(report).toContain('| X\\_ITE 15 | 900 (882–918) × 2.5 |  |');
  });

  test('says whose note it is where stacks’ notes differ', () => {
    const other = { ...run, stack: 'llvmpipe', peers: run.peers.map((peer) => ({ ...peer, note: 'other' })) };
    const both = reportOf([{ ...run, stack: 'SwiftShader' }, other]).report;
    expect(both).toContain('| &lt;model-viewer&gt; 4 | 3 | 3 | SwiftShader: first; llvmpipe: other |');
  });

  test('counts the aims that are met', () => {
    expect(report).toContain('1 of 2 met');
    expect(row('8 lights')).toContain('0.5 (0.49–0.51), meets 0.6: 1 of 2 ms');
    expect(row('16 lights')).toContain('**misses 0.6**');
    expect(row('no aim')).not.toMatch(/meets|misses/);
  });

  test('has slopes, machines, the findings as they are, and how to measure again', () => {
    expect(row('SwiftShader | all')).toBe(
      '| SwiftShader | all | 1.00 | 1.00 | 1 ms at 1 | 64 ms at 64 | GPU timer |  |',
    );
    expect(row('renderer')).toBe('| renderer | some GPU | H200 |');
    expect(report).toContain('\n\n## What was found\n\nProse with `code`.\n\n');
    expect(report).toContain('npm run bench -- --compare');
  });

  test('leaves out what was not measured', () => {
    const bare = reportOf([{ ...resultOf({}), stack: 'SwiftShader' }]);
    expect(bare.report.match(/^## .*$/gm)).toEqual(['## Machines and versions', '## Measuring it again']);
    expect(bare.charts.size).toBe(0);
  });

  test('refuses two charts of one name', () => {
    const [front] = run.fronts;
    expect(() =>
      reportOf([{ ...resultOf({ fronts: [front!, { ...front!, scene: '8-mixed' }] }), stack: 'a' }]),
    ).toThrow('two charts are called a-loops-8-mixed.svg');
  });

  describe('in its folder', () => {
    let folder = '';
    beforeEach(() => {
      folder = mkdtempSync(join(tmpdir(), 'phong-viewer-'));
      mkdirSync(join(folder, 'results'));
    });
    afterEach(() => {
      rmSync(folder, { recursive: true });
    });

    test('is written with its charts, and old charts go', () => {
      for (const { stack, ...result } of stacks)
        writeFileSync(join(folder, 'results', `${stack}.json`), JSON.stringify(result));
      mkdirSync(join(folder, 'charts'));
      writeFileSync(join(folder, 'charts/old.svg'), '');
      writeFileSync(join(folder, 'charts/README.md'), '');
      writeFileSync(join(folder, 'FINDINGS.md'), '## What was found\n\nProse with `code`.\n');
      expect(writeReport(folder)).toEqual({ stacks: 2, charts: 3 });
      expect(readdirSync(join(folder, 'charts')).sort()).toEqual([...charts.keys(), 'README.md'].sort());
      // In the order of the files' names.
      expect(readFileSync(join(folder, 'REPORT.md'), 'utf8')).toBe(
        reportOf([...stacks].reverse(), '## What was found\n\nProse with `code`.\n').report,
      );
      expect(readFileSync(join(folder, 'charts/SwiftShader-loops-8-mixed.svg'), 'utf8')).toMatch(
        /^<svg .*<\/svg>\n$/s,
      );
    });

    test('takes a run that measured only a part, and needs no findings', () => {
      const { machine, seed, launches, rounds, fronts } = run;
      writeFileSync(
        join(folder, 'results/a.json'),
        JSON.stringify({ machine, seed, launches, rounds, fronts }),
      );
      writeReport(folder);
      expect(readFileSync(join(folder, 'REPORT.md'), 'utf8')).not.toContain('What was found');
    });

    test('is not written of nothing', () => {
      expect(() => writeReport(folder)).toThrow('no results');
    });
  });
});
