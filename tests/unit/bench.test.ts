// The arithmetic of the bench: statistics, results, progress, scenes and errors, without a browser.
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { errorOf } from '../bench/front/errors.js';
import { readTrace } from '../bench/measure/model.mjs';
import { MODELS, writeModels } from '../bench/models.mjs';
import { mixedLights } from '../bench/pages/scenes.js';
import { PICTURE_SCENES } from '../bench/pages/picture-scenes.js';
import { addSamples, type BenchResult, ratioOf, ratioOverSubjects, ratioToBest, valueOf } from '../bench/results.mjs';
import { interleaved, pairedRatios, quantile, spread } from '../bench/statistics.mjs';
import { PICTURES } from '../bench/subjects.mjs';

test('statistics interpolate between neighbours, and divide samples of the same round', () => {
  expect(quantile([4, 1, 3, 2], 0.5)).toBe(2.5);
  expect(quantile([4, 1, 3, 2, 5], 0.25)).toBe(2);
  expect(spread([7])).toEqual({ median: 7, low: 7, high: 7, count: 1 });
  expect(pairedRatios([1, 20], [2, 10])).toEqual([0.5, 2]);
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

describe('a result', () => {
  const newResult = (): BenchResult => ({
    ...{ stack: 'software', machine: {}, date: '', launches: 1, size: [1, 1] },
    ...{ measures: [], fronts: [], failures: [] },
  });

  test('keeps samples by side and divides by the last one, if there are two', () => {
    const result = newResult();
    addSamples(result, 'sphere', 'settled', 'ms', { element: 2, three: 4 });
    addSamples(result, 'sphere', 'settled', 'ms', { element: 3.00004, three: 4 });
    addSamples(result, 'connecting', 'time', 'ms', { element: 900 });
    const [sphere, connecting] = result.measures;
    expect(sphere!.samples).toEqual({ element: [2, 3], three: [4, 4] });
    expect(ratioOf(sphere!)?.median).toBe(0.625);
    expect(valueOf(sphere!, 'three').median).toBe(4);
    expect(ratioOf(connecting!)).toBeUndefined();
  });

  test('has the ratio to the better of other viewers, and counts every model once', () => {
    const result = newResult();
    for (const element of [10, 12, 14]) addSamples(result, 'a', 'first picture', 'ms', { element, one: 40, other: 20 });
    addSamples(result, 'b', 'first picture', 'ms', { element: 10, one: 10, other: 20 });
    expect(ratioToBest(result.measures[0]!)?.median).toBe(0.6);
    const over = (subjects: string[]) => ratioOverSubjects(result, subjects, 'first picture');
    expect(over(['a', 'b', 'c'])).toMatchObject({ median: 0.8, count: 2 });
    expect(over(['c'])).toBeUndefined();
  });
});

test('models are at most 5 MB, and their views lie within their buffers', () => {
  const folder = mkdtempSync(join(tmpdir(), 'phong-viewer-'));
  try {
    writeModels(folder);
    const names = readdirSync(folder);
    expect(names.sort()).toEqual([...Object.values(MODELS), '2CylinderEngine.bin', 'checks.glb'].sort());
    for (const name of names) {
      const file = readFileSync(join(folder, name));
      expect(file.length, name).toBeLessThan(5e6);
      if (name.endsWith('.bin')) continue;
      const text = name.endsWith('.gltf');
      const end = text ? file.length : 20 + file.readUInt32LE(12);
      if (!text) {
        expect([file.toString('latin1', 0, 4), file.readUInt32LE(8)], name).toEqual(['glTF', file.length]);
        expect(file.toString('latin1', end + 4, end + 8), name).toBe('BIN\0');
      }
      const json = JSON.parse(file.toString('utf8', text ? 0 : 20, end)) as {
        readonly bufferViews: readonly { readonly byteOffset?: number; readonly byteLength: number }[];
        readonly buffers: readonly { readonly byteLength: number }[];
      };
      const { byteLength: size } = json.buffers[0]!;
      const bin = text ? readFileSync(join(folder, '2CylinderEngine.bin')) : file;
      expect(size, name).toBeLessThanOrEqual(bin.length);
      for (const { byteOffset = 0, byteLength } of json.bufferViews)
        expect(byteOffset + byteLength, name).toBeLessThanOrEqual(size);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('a trace of a page gives frames and the longest task since its navigation', () => {
  const event = (name: string, ts: number, args: object) => ({ name, pid: 1, tid: 1, ts, args });
  const task = (ts: number, dur: number, tid = 1) => ({ ...event('RunTask', ts, {}), tid, dur });
  const navigation = (ts: number, documentLoaderURL: string) =>
    event('navigationStart', ts, { data: { documentLoaderURL } });
  const frame = (ts: number, snapshot: string) => ({ ...event('Screenshot', ts, { snapshot }), pid: 2 });
  const traceEvents = [
    ...[navigation(0, ''), task(100, 900_000), frame(200, 'before')],
    ...[navigation(1000, 'http://localhost/'), task(2000, 30_000), task(3000, 70_000, 2)],
    frame(41_000, 'after'),
  ];
  expect(readTrace(Buffer.from(JSON.stringify({ traceEvents })))).toEqual({
    frames: [{ ms: 40, jpeg: 'after' }],
    longestTask: 30,
  });
  expect(() => readTrace(Buffer.from('{"traceEvents":[]}'))).toThrow('the trace holds no navigation');
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

test('errors are the root mean square, the 99.9th percentile and the maximum over all channels', () => {
  const truth = Float64Array.from([10, 20, 30]);
  expect(errorOf(truth, truth)).toEqual({ rmse: 0, p999: 0, max: 0 });
  const found = errorOf(Float64Array.from([13, 20, 26]), truth);
  expect(found).toMatchObject({ rmse: Math.sqrt(25 / 3), max: 4 });
});

test('every whole picture has markup for each of its cells', () => {
  for (const [scene] of Object.values(PICTURES)) {
    const { columns, rows, viewers } = PICTURE_SCENES[scene];
    expect(viewers, scene).toHaveLength(columns * rows);
  }
});
