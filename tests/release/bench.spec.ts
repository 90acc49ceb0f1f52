// Does `npm run bench` measure its smallest subjects and write complete results? Asserts no times.
import { execFile } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import type { BenchResult } from '../bench/results.mjs';
import { expect, test } from '../support/test.js';

const BENCH = fileURLToPath(new URL('../bench/bench.mjs', import.meta.url));
const bench = (...options: string[]) => promisify(execFile)(process.execPath, [BENCH, ...options]);

test('@release measures frames, script, bytes and a front, each side equally often', async ({}, info) => {
  test.setTimeout(300_000);
  const file = info.outputPath('result.json');
  const only = 'sphere, 1 light;script, 1 moving light;bytes;front, 8 lights';
  const { stdout } = await bench('--quick', '--size', '64x48', '--only', only, '--out', file);
  expect(stdout).toMatch(/\[1\/4, .+ left\] sphere, 1 light: first frames/);
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
      for (const value of values) expect(value, `${subject}: ${measure}`).toBeGreaterThan(0);
    }
  }
  const [front] = result.fronts;
  const shipped = front!.variants.indexOf('shipped');
  expect(front!.errors[shipped]!.max).toBeLessThan(0.02);
  expect(front!.errors[front!.variants.indexOf('Schlick’s lobe')]!.max).toBeGreaterThan(1);
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
    'upload',
    'first draw',
  ]);
  for (const { measure, samples } of measures) {
    expect(Object.keys(samples)).toEqual(['element', 'model-viewer', 'babylon-viewer']);
    // Uploads can be shorter than the clock's step.
    if (measure === 'upload') continue;
    for (const [value] of Object.values(samples)) expect(value, measure).toBeGreaterThan(0);
  }
});
