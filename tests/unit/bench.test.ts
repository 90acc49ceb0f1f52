// Are the published report, its charts and the README's sentence what the results say, and which
// missed limits fail? And the arithmetic of the bench, without a browser.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { AIMS, missedLimits } from '../bench/aims.mjs';
import { accuracySentence, type Accuracy, WAYS } from '../bench/accuracy-words.mjs';
import { accuracyFile } from '../bench/picture-chart.mjs';
import { errorsOf, largest } from '../bench/front/errors.js';
import { readTrace } from '../bench/measure/model.mjs';
import { mixedLights } from '../bench/pages/scenes.js';
import { PICTURE_SCENES } from '../bench/pages/picture-scenes.js';
import { readAccuracies, readmeSentence, reportOf } from '../bench/report.mjs';
import { addSamples, type BenchResult, readResults } from '../bench/results.mjs';
import { interleaved } from '../bench/statistics.mjs';
import { PICTURES, SUBJECTS } from '../bench/subjects.mjs';

const bench = fileURLToPath(new URL('../bench/', import.meta.url));
const results = readResults(join(bench, 'results'));
const accuracies = readAccuracies(join(bench, 'accuracy'));
const { report, charts } = reportOf(results, accuracies);

test('REPORT.md and the README say what the results say: otherwise run npm run bench:report', () => {
  expect(readFileSync(join(bench, 'REPORT.md'), 'utf8')).toBe(report);
  expect(readFileSync(join(bench, '../../README.md'), 'utf8')).toContain(readmeSentence(results));
});

test('every chart is an SVG that the report shows, with its series and pictures named in it', () => {
  expect(readdirSync(join(bench, 'charts')).sort()).toEqual([...charts.keys()].sort());
  for (const [file, svg] of charts) {
    // Not by toContain, which would print all of it.
    expect(/^<svg [^]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"[^]*<\/svg>$/.test(svg), file).toBe(
      true,
    );
    const named = file.endsWith('-accuracy.svg')
      ? [
          '← faster: time of a frame, the plain loop = 1',
          'Schlick’s formula',
          'its exponent n is 32, 1,000, 100,000.',
        ]
      : ['TAARenderPass', 'sphere'];
    for (const text of named) {
      expect(svg.includes(`>${text}</text>`), file).toBe(true);
    }
    const frames = svg.match(/<rect [^>]*fill="none" height="170"/g)?.length;
    expect(svg.match(/<image /g)?.length, file).toBe(frames);
    expect([svg.includes('NaN'), report.includes(`](charts/${file})`)], file).toEqual([
      false,
      true,
    ]);
  }
});

test('an aim names subjects that exist', () => {
  for (const { label, subject, subjects = [] } of AIMS) {
    for (const name of [subject, ...subjects]) {
      expect(Object.keys(SUBJECTS), label).toContain(name);
    }
  }
});

test('a limit is missed where even the better quartile lies beyond it', () => {
  const about = { stack: 'software', machine: {}, date: '', launches: 1, size: [1, 1] as const };
  const result: BenchResult = { ...about, measures: [], failures: [] };
  const subject = 'script, toggling one of 5,000 lights';
  const took = (element: number) =>
    addSamples(result, subject, 'script per frame', 'µs', { element });
  took(2400.04);
  expect(result.measures[0]!.samples).toEqual({ element: [2400] }); // rounded to four digits
  expect(missedLimits(result)).toEqual(['toggling one of 5,000 lights, µs: 2.40e+3, limit 2000']);
  for (const time of [1800, 2400, 1800]) {
    took(time);
  }
  expect(missedLimits(result)).toEqual([]);
  // An aim that is not reached yet is no limit.
  addSamples(result, 'start', 'first picture', 'ms', { standalone: 20, bundled: 13, three: 10 });
  expect(missedLimits(result)).toEqual([]);
});

test('every other round measures the sides in reverse order', async () => {
  const order: string[] = [];
  const samples = await interleaved(['a', 'b'], 3, (subject) => {
    order.push(subject);
    return Promise.resolve(order.length);
  });
  expect(order.join('')).toBe('abbaab');
  expect(samples.flat()).toEqual([1, 4, 5, 2, 3, 6]);
});

test('a trace of a page gives frames and the longest task since its navigation', () => {
  const event = (name: string, ts: number, args: object) => ({ name, pid: 1, tid: 1, ts, args });
  const task = (ts: number, dur: number, tid = 1) => ({ ...event('RunTask', ts, {}), tid, dur });
  const navigation = (ts: number, documentLoaderURL: string) =>
    event('navigationStart', ts, { data: { documentLoaderURL } });
  const frame = (ts: number, snapshot: string) => ({
    ...event('Screenshot', ts, { snapshot }),
    pid: 2,
  });
  const traceEvents = [
    navigation(0, ''),
    task(100, 900_000),
    frame(200, 'before'),
    ...[navigation(1000, 'http://localhost/'), task(2000, 30_000), task(3000, 70_000, 2)],
    frame(41_000, 'after'),
  ];
  expect(readTrace(Buffer.from(JSON.stringify({ traceEvents })))).toEqual({
    frames: [{ ms: 40, jpeg: 'after' }],
    longestTask: 30,
  });
  expect(() => readTrace(Buffer.from('{"traceEvents":[]}'))).toThrow(
    'the trace holds no navigation',
  );
});

test('lights alternate between directional, point and spot, and every cone contains the sphere', () => {
  const lights = mixedLights(256);
  expect(lights.filter(({ position }) => position[3] === 0)).toHaveLength(86);
  const spots = lights.filter(({ axis }) => axis !== undefined);
  expect(spots).toHaveLength(85);
  for (const { position, aperture = 180 } of spots) {
    const distance = Math.hypot(...position.slice(0, 3));
    expect((Math.asin(0.5 / distance) * 180) / Math.PI).toBeLessThan(aperture);
  }
});

/** Made up: every way is 1.5 times as wrong as the one before. */
const made: Accuracy = {
  renderer: 'none',
  browser: 'none',
  date: '2000-01-01',
  size: [4, 4],
  points: WAYS.flatMap(({ way }, i) =>
    [32, 1000, 100_000].map((exponent, k) => ({
      way,
      exponent,
      ms: 1,
      time: way === 'plain' ? 1 : 0.8 + 0.1 * i + 0.01 * k,
      error: 0.01 * 1.5 ** i * 10 ** k,
    })),
  ),
  pictures: [{ way: 'plain', png: 'data:image/png;base64,' }],
};

test('the sentence about accuracy has the least and the most time, and the largest errors', () => {
  expect(accuracySentence(made)).toBe(
    'On this machine exactness costs 0.90 to 1.02 times the plain loop’s time: phong-viewer is wrong by at most 2.3 of a colour’s 256 steps, the plain loop by 1, a usual approximation (Schlick’s) by 3.4.',
  );
});

// A phone of 320 pixels has 285 for it.
test.each([285, 680])('at %d pixels the plot has all dots, and no text is cut', (width) => {
  for (const accuracy of [made, ...accuracies.map((one) => one.accuracy)]) {
    const svg = accuracyFile(accuracy, width);
    expect(svg).not.toMatch(/NaN|Infinity|undefined|style=/);
    expect(svg.match(/<circle/g)).toHaveLength(18);
    for (const [, at = '', text = ''] of svg.matchAll(/<text([^>]*)>([^<]+)</g)) {
      // 12 pixels high, in the wider fonts.
      const [, x = 0] = / x="(\d+)"/.exec(at) ?? [];
      expect(Number(x) + 6.3 * text.length, text).toBeLessThan(width);
    }
  }
});

test('an error is that of a channel, and what is no number is as wrong as can be', () => {
  const truth = Float64Array.from([10, 20, 30]);
  expect(largest(errorsOf(truth, truth))).toBe(0);
  const errors = errorsOf(Float64Array.from([13, NaN, 26]), truth);
  expect([...errors]).toEqual([3, 255, 4]);
  expect(largest(errors)).toBe(255);
  expect(() => errorsOf(truth, truth.subarray(1))).toThrow(RangeError);
});

test('every whole picture has markup for each of its cells', () => {
  for (const [scene] of Object.values(PICTURES)) {
    const { columns, rows, viewers } = PICTURE_SCENES[scene];
    expect(viewers, scene).toHaveLength(columns * rows);
  }
});
