// The bench's report: it judges every aim, keeps its tables regular, and draws readable charts. On made-up results.
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';
import { AIMS, judge, missedLimits } from '../bench/aims.mjs';
import { CODES, full, MULTISAMPLED, PLAIN, RMSE, SSAA, ssaa, TAA, taa, TIME, WITHIN } from '../bench/pictures.mjs';
import { reportOf } from '../bench/report.mjs';
import { addSamples, type BenchResult } from '../bench/results.mjs';
import { modelSubjects, NETWORKS, pictureSubject, PICTURES, SPHERE_LIGHTS, SUBJECTS } from '../bench/subjects.mjs';

function resultOf(stack: string): BenchResult {
  const result: BenchResult = {
    ...{ stack, machine: { renderer: 'some GPU' }, date: '2026-01-01', launches: 1, size: [480, 360] },
    ...{ measures: [], fronts: [], failures: [{ subject: 'bunny', message: 'no | model' }] },
  };
  for (const count of SPHERE_LIGHTS) {
    const subject = count === 1 ? 'sphere, 1 light' : `sphere, ${count} lights`;
    for (const measure of ['first frames', 'settled'])
      for (const element of [0.8, 1, 1.2]) addSamples(result, subject, measure, 'ms', { element, three: 2 });
    addSamples(result, subject, 'longest frame', 'ms', { element: 60, three: 5 });
    addSamples(result, subject, 'usual frame', 'ms', { element: 5, three: 5 });
  }
  addSamples(result, '20 turning viewers', 'frame rate', 'frames/s', { twenty: 30, one: 40 });
  addSamples(result, 'connecting 5,000 lights', 'time', 'ms', { element: 1200 });
  addSamples(result, 'start', 'first picture', 'ms', { standalone: 11, bundled: 13, three: 10 });
  const scripts = { element: 20, three: 15, unlit: 10 };
  addSamples(result, 'script, 128 moving lights', 'script per frame', 'µs', scripts);
  for (const network of NETWORKS)
    for (const subject of modelSubjects(network))
      for (const measure of ['first picture', 'longest task', 'peak memory', 'upload', 'first draw'])
        addSamples(result, subject, measure, 'ms', {
          ...{ element: 10, 'model-viewer': 40, 'babylon-viewer': network === 'local' ? 20 : 12.5 },
        });
  addPictures(result);
  result.fronts.push({
    ...{ subject: 'front, 8 lights', title: '8 lights', variants: ['as specified', 'shipped'], base: 0 },
    errors: [
      { rmse: 0, p999: 0, max: 0 },
      { rmse: 0.1, p999: 0.2, max: 0.3 },
    ],
    ms: [
      [2, 4],
      [1, 2],
    ],
  });
  return result;
}

/** Errors of the passes: 3 as shipped and 2 of codes with any number of samples. */
function addPictures(result: BenchResult): void {
  const ours = { [full(16)]: 1, [full(64)]: 0.5, [full(256)]: 0.4 };
  const theirs = [...SSAA.map(ssaa), ...TAA.map(taa)];
  const all = (error: (side: string) => number): Record<string, number> =>
    Object.fromEntries(theirs.map((side) => [side, error(side)]));
  for (const picture of Object.keys(PICTURES) as (keyof typeof PICTURES)[]) {
    const subject = pictureSubject(picture);
    const codes = Object.fromEntries(theirs.map((side) => [side + CODES, 2]));
    const first = picture === 'torus' ? 2.2 : 1.8;
    const errors = { ...ours, [MULTISAMPLED]: 2.4, ...all(() => 3), ...codes, [PLAIN]: first };
    addSamples(result, subject, RMSE.triangles, 'codes', errors);
    addSamples(result, subject, WITHIN, '%', { [full(64)]: 97.5, [PLAIN]: 90 });
    if (PICTURES[picture][1]) addSamples(result, subject, RMSE.round, 'codes', { ...ours, [PLAIN]: 3.8 });
    for (const ms of [10, 12])
      addSamples(result, subject, TIME, 'ms', {
        ...{ [full(16)]: 8 * ms, [full(64)]: 20 * ms, [full(256)]: 70 * ms },
        ...{ [MULTISAMPLED]: ms, ...all((side) => ms * Number(side.split(', ')[1]) + ms), [PLAIN]: ms },
      });
  }
}

const { report, charts } = reportOf([resultOf('h200-vulkan'), resultOf('software')]);
const row = (start: string): string | undefined => report.split('\n').find((line) => line.startsWith(`| ${start}`));

describe('an aim', () => {
  const models = 'first picture of a model to the better of two viewers’';
  const worst = 'RMSE to three.js’s best pass, worst picture';
  test.each([
    [`${models}, local`, 'software', { met: true, measured: { median: 0.5, count: 10 } }],
    [`${models}, 10 Mbit/s`, 'software', { met: false, measured: { median: 0.8 } }],
    ['teapot on a floor, RMSE, 256 samples', 'software', { met: true }],
    ['sphere, RMSE, 256 samples', 'software', { met: false, most: 0.35 }],
    [
      'textured GLB, % of pixels within one code, 64 samples',
      'h200-vulkan',
      { met: false, measured: { median: 97.5 } },
    ],
    [`${worst}: first one`, 'software', { met: false, measured: { median: 1.1, count: 1 } }],
    [`${worst}: 16 samples`, 'software', { met: true, measured: { median: 0.5 } }],
  ])('for %s on %s is judged: %o', (label, stack, verdict) => {
    const aim = AIMS.find((one) => one.label === label)!;
    expect(judge(aim, resultOf(stack))).toMatchObject(verdict);
  });

  test('that is a limit is missed where even the better quartile lies beyond it', () => {
    const missed = missedLimits(resultOf('software'));
    expect(missed).toContain('connecting 5,000 lights, ms: 1.20e+3, limit 1000');
    expect(missed.join()).not.toMatch(/RMSE, 64 samples/);
    const noisy = resultOf('software');
    for (const element of [900, 900]) addSamples(noisy, 'connecting 5,000 lights', 'time', 'ms', { element });
    expect(missedLimits(noisy).join()).not.toContain('connecting');
  });

  test('names subjects and a measure that exist', () => {
    for (const { label, subject, subjects = [] } of AIMS)
      for (const name of [subject, ...subjects]) expect(Object.keys(SUBJECTS), label).toContain(name);
  });
});

describe('the report', () => {
  test('puts each limit and aim beside what was measured', () => {
    expect(row('sphere, 8 lights, settled')).toBe(
      '| sphere, 8 lights, settled | ✓ 0.5 (0.45–0.55), limit ≤ 0.82 | **✗** 0.5 (0.45–0.55), limit ≤ 0.3 |',
    );
    expect(row('connecting 5,000 lights, ms')).toContain('**✗** 1200, limit ≤ 1000');
  });

  test('has figures of every kind of subject', () => {
    expect(row('sphere, 4 lights |')).toContain('0.5 (0.45–0.55) = 1 : 2');
    expect(row('script, 128 moving lights, script per frame, three')).toContain('| 15 |');
    expect(row('pmndrs')).toContain('| 0.5 = 10 : 40 : 20 | 0.8 = 10 : 40 : 12.5 |');
    expect(row('median ratio')).toContain('| 0.5 (0.5–0.5) | 0.8 (0.8–0.8) |');
    expect(row('8 lights: shipped')).toContain('0.50, error 0.3');
    expect(row('full, 64 samples | ')).toMatch(/^\| full, 64 samples( \| 0\.5 in 20){6} \|$/);
    expect(row('SSAARenderPass, 16')).toContain('| 3 or 2 in 17 |');
    expect(row('edges: RMSE to the round shape')).toContain('| 3.8 | 3.8 | – |');
    expect(report).toContain('- software, bunny: no \\| model');
  });

  test('has as many cells in each row of a table as in its head', () => {
    let cells = 0;
    for (const line of report.split('\n')) {
      const count = line.startsWith('|') ? line.replaceAll('\\|', '').split('|').length : 0;
      if (cells > 0 && count > 0) expect(count, line).toBe(cells);
      cells = count;
    }
  });

  test('stays short for three stacks', () => {
    const three = reportOf(['h200-opengl', 'h200-vulkan', 'software'].map(resultOf));
    expect(three.report.split('\n').length).toBeLessThan(380);
    expect(three.charts.size).toBeLessThanOrEqual(6);
  });
});

test('npm run bench:report writes the report and its charts into the folder of the results', () => {
  const folder = mkdtempSync(join(tmpdir(), 'phong-viewer-'));
  try {
    mkdirSync(join(folder, 'results'));
    writeFileSync(join(folder, 'results/software.json'), JSON.stringify(resultOf('software')));
    const program = fileURLToPath(new URL('../bench/report.mjs', import.meta.url));
    execFileSync(process.execPath, [program, '--folder', folder]);
    const alone = reportOf([resultOf('software')]);
    expect(readFileSync(join(folder, 'REPORT.md'), 'utf8')).toBe(alone.report);
    expect(readdirSync(join(folder, 'charts')).sort()).toEqual([...alone.charts.keys()].sort());
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('every chart is an SVG with a title, its series named in it, and is shown in the report', () => {
  expect(charts.size).toBeGreaterThan(0);
  for (const [file, svg] of charts) {
    expect(svg, file).toMatch(/^<svg [^]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"[^]*<\/svg>$/);
    expect(svg, file).not.toContain('NaN');
    expect(report).toContain(`](charts/${file})`);
  }
  expect(charts.get('software-fronts.svg')).toContain('>shipped</text>');
  for (const text of ['TAARenderPass', 'nine viewers'])
    expect(charts.get('software-pictures.svg')).toContain(`>${text}</text>`);
});
