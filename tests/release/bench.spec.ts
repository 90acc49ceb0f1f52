// Does `npm run bench` measure its smallest subjects and write complete results? Asserts no times.
import { execFile } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import {
  CODES,
  full,
  MULTISAMPLED,
  PLAIN,
  RMSE,
  ssaa,
  taa,
  TIME,
  WITHIN,
} from '../bench/pictures.mjs';
import type { BenchResult } from '../bench/results.mjs';
import { expect, test } from '../support/test.js';

const BENCH = fileURLToPath(new URL('../bench/bench.mjs', import.meta.url));
const bench = (...options: string[]) => promisify(execFile)(process.execPath, [BENCH, ...options]);

test('@release measures frames, script and bytes, each side equally often', async ({}, info) => {
  test.setTimeout(300_000);
  const file = info.outputPath('result.json');
  const only = ['sphere, 1 light', 'script, turning camera', 'bytes'];
  const chosen = only.flatMap((name) => ['--only', name]);
  const { stdout } = await bench('--quick', '--size', '64x48', ...chosen, '--out', file);
  expect(stdout).toMatch(/\[1\/3, .+ left\] sphere, 1 light: first frames/);
  const result = JSON.parse(readFileSync(file, 'utf8')) as BenchResult;
  expect(result.failures).toEqual([]);
  expect(result.machine['renderer']).toMatch(/SwiftShader|llvmpipe/);
  const sphere = result.measures.filter(({ subject }) => subject === 'sphere, 1 light');
  expect(sphere.map(({ measure }) => measure)).toEqual([
    'first frames',
    'longest frame',
    'usual frame',
    'settled',
  ]);
  for (const { subject, measure, samples } of result.measures) {
    const sides = Object.values(samples);
    for (const values of sides) {
      expect(values.length, `${subject}: ${measure}`).toBe(sides[0]!.length);
      for (const value of values) {
        expect(value, `${subject}: ${measure}`).toBeGreaterThan(0);
      }
    }
  }
});

test('@release measures the first picture of a model in three viewers', async ({}, info) => {
  test.setTimeout(300_000);
  const file = info.outputPath('result.json');
  await bench('--quick', '--only', 'model, suzi, local', '--out', file);
  const { failures, measures } = JSON.parse(readFileSync(file, 'utf8')) as BenchResult;
  expect(failures).toEqual([]);
  expect(measures.map(({ measure }) => measure)).toEqual([
    'first picture',
    'longest task',
    'peak memory',
  ]);
  for (const { measure, samples } of measures) {
    expect(Object.keys(samples)).toEqual(['element', 'model-viewer', 'babylon-viewer']);
    for (const [value] of Object.values(samples)) {
      expect(value, measure).toBeGreaterThan(0);
    }
  }
});

test('@release measures error and time of a whole picture, and adds it to a result', async ({}, info) => {
  test.setTimeout(600_000);
  const file = info.outputPath('result.json');
  const kept = { subject: 'bytes', measure: 'brotli', unit: 'kB', samples: { three: [107] } };
  const before = { stack: 'software', machine: {}, date: '', launches: 1, size: [1, 1] };
  writeFileSync(file, JSON.stringify({ ...before, measures: [kept], failures: [] }));
  const subject = 'whole picture, torus, shininess 2,000';
  await bench('--quick', '--add', '--only', subject, '--size', '64x48', '--out', file);
  const { measures, failures, added } = JSON.parse(readFileSync(file, 'utf8')) as BenchResult;
  expect(failures).toEqual([]);
  expect(measures[0]).toEqual(kept);
  expect(added).toMatchObject([{ subjects: [subject] }]);
  const samplesOf = (measure: string) => measures.find((row) => row.measure === measure)!.samples;
  const [errors, times] = [samplesOf(RMSE.triangles), samplesOf(TIME)];
  for (const side of [full(64), MULTISAMPLED, ssaa(16), taa(0), taa(32), PLAIN]) {
    for (const [value] of [errors[side]!, times[side]!]) {
      expect(value, side).toBeGreaterThan(0);
    }
  }
  // The better the method, the less is left: a wrong equation, camera or triangle would leave more
  // than any of them.
  const [plain, exact] = [errors[PLAIN]![0]!, errors[full(256)]![0]!];
  expect(exact).toBeLessThan(plain / 4);
  expect(errors[MULTISAMPLED]![0]!).toBeLessThan(1.2 * plain);
  expect(errors[taa(32) + CODES]![0]!).toBeLessThan(plain / 2);
  expect(samplesOf(WITHIN)[full(64)]![0]!).toBeGreaterThan(90);
});
