// The arithmetic of the bench: statistics, results, progress, scenes and errors, without a browser.
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { errorOf } from '../bench/front/errors.js';
import { glbOf } from '../bench/glb.mjs';
import { readTrace } from '../bench/measure/model.mjs';
import { MODELS, writeModels } from '../bench/models.mjs';
import { mixedLights } from '../bench/pages/scenes.js';
import { PICTURE_SCENES } from '../bench/pages/picture-scenes.js';
import {
  addSamples,
  type BenchResult,
  ratioOf,
  ratioOverSubjects,
  ratioToBest,
  valueOf,
} from '../bench/results.mjs';
import { interleaved, pairedRatios, quantile, spread } from '../bench/statistics.mjs';
import { PICTURES } from '../bench/subjects.mjs';

describe('statistics', () => {
  test('interpolate between neighbours where no sample lies at the quantile', () => {
    expect(quantile([4, 1, 3, 2], 0.5)).toBe(2.5);
    expect(quantile([4, 1, 3, 2, 5], 0.25)).toBe(2);
    expect(spread([7])).toEqual({ median: 7, low: 7, high: 7, count: 1 });
  });

  test('divide samples of the same round', () => {
    expect(pairedRatios([1, 20], [2, 10])).toEqual([0.5, 2]);
  });

  test('reverse the order of sides in every other round', async () => {
    const order: string[] = [];
    const samples = await interleaved(['a', 'b'], 3, (subject) => {
      order.push(subject);
      return Promise.resolve(order.length);
    });
    expect(order.join('')).toBe('abbaab');
    expect(samples).toEqual([
      [1, 4, 5],
      [2, 3, 6],
    ]);
  });
});

describe('a result', () => {
  const result = (): BenchResult => ({
    ...{ stack: 'software', machine: {}, date: '', launches: 1, size: [1, 1] },
    ...{ measures: [], fronts: [], failures: [] },
  });

  test('keeps samples by side and divides by the last one', () => {
    const kept = result();
    addSamples(kept, 'sphere', 'settled', 'ms', { element: 2, three: 4 });
    addSamples(kept, 'sphere', 'settled', 'ms', { element: 3.00004, three: 4 });
    expect(kept.measures).toHaveLength(1);
    expect(kept.measures[0]!.samples).toEqual({ element: [2, 3], three: [4, 4] });
    expect(ratioOf(kept.measures[0]!)?.median).toBe(0.625);
    expect(valueOf(kept.measures[0]!, 'three').median).toBe(4);
  });

  test('has no ratio where a subject has one side', () => {
    const kept = result();
    addSamples(kept, 'connecting', 'time', 'ms', { element: 900 });
    expect(ratioOf(kept.measures[0]!)).toBeUndefined();
  });
});

describe('the ratio to other viewers', () => {
  test('is to the better one, and counts every model once', () => {
    const kept: BenchResult = {
      ...{ stack: 'software', machine: {}, date: '', launches: 1, size: [1, 1] },
      ...{ measures: [], fronts: [], failures: [] },
    };
    for (const element of [10, 12, 14])
      addSamples(kept, 'a', 'first picture', 'ms', { element, one: 40, other: 20 });
    addSamples(kept, 'b', 'first picture', 'ms', { element: 10, one: 10, other: 20 });
    expect(ratioToBest(kept.measures[0]!)?.median).toBe(0.6);
    expect(ratioOverSubjects(kept, ['a', 'b', 'c'], 'first picture')).toMatchObject({
      median: 0.8,
      count: 2,
    });
    expect(ratioOverSubjects(kept, ['c'], 'first picture')).toBeUndefined();
  });
});

describe('models', () => {
  test('are at most 5 MB, and their views lie within their buffers', () => {
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
        const json = JSON.parse(
          text ? file.toString() : file.toString('utf8', 20, 20 + file.readUInt32LE(12)),
        ) as {
          readonly bufferViews: readonly { readonly byteOffset?: number; readonly byteLength: number }[];
          readonly buffers: readonly { readonly byteLength: number }[];
        };
        const { byteLength: size } = json.buffers[0]!;
        expect(size, name).toBeLessThanOrEqual(
          text ? readFileSync(join(folder, '2CylinderEngine.bin')).length : file.length,
        );
        for (const { byteOffset = 0, byteLength } of json.bufferViews)
          expect(byteOffset + byteLength, name).toBeLessThanOrEqual(size);
      }
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
});

describe('a trace of a page', () => {
  test('gives frames and the longest task of the page since its navigation', () => {
    const task = (ts: number, dur: number, tid = 1) => ({ name: 'RunTask', pid: 1, tid, ts, dur, args: {} });
    const navigation = (ts: number, documentLoaderURL: string) => ({
      ...{ name: 'navigationStart', pid: 1, tid: 1, ts },
      args: { data: { documentLoaderURL } },
    });
    const frame = (ts: number, snapshot: string) => ({
      name: 'Screenshot',
      pid: 2,
      tid: 2,
      ts,
      args: { snapshot },
    });
    const traceEvents = [
      ...[navigation(0, ''), task(100, 900_000), frame(200, 'before')],
      ...[
        navigation(1000, 'http://localhost/'),
        task(2000, 30_000),
        task(3000, 70_000, 2),
        frame(41_000, 'after'),
      ],
    ];
    expect(readTrace(Buffer.from(JSON.stringify({ traceEvents })))).toEqual({
      frames: [{ ms: 40, jpeg: 'after' }],
      longestTask: 30,
    });
    expect(() => readTrace(Buffer.from('{"traceEvents":[]}'))).toThrow('the trace holds no navigation');
  });
});

describe('lights', () => {
  test('alternate between directional, point and spot, and every cone contains the sphere', () => {
    const lights = mixedLights(256);
    expect(lights.filter(({ position }) => position[3] === 0)).toHaveLength(86);
    expect(lights.filter(({ axis }) => axis !== undefined)).toHaveLength(85);
    for (const { position, aperture = 180 } of lights.filter((light) => light.axis !== undefined)) {
      const distance = Math.hypot(...position.slice(0, 3));
      expect((Math.asin(0.5 / distance) * 180) / Math.PI).toBeLessThan(aperture);
    }
  });
});

describe('errors', () => {
  test('are the root mean square, the 99.9th percentile and the maximum over all channels', () => {
    const truth = Float64Array.from([10, 20, 30]);
    expect(errorOf(truth, truth)).toEqual({ rmse: 0, p999: 0, max: 0 });
    expect(errorOf(Float64Array.from([13, 20, 26]), truth)).toMatchObject({
      rmse: Math.sqrt(25 / 3),
      max: 4,
    });
  });
});

test('every whole picture has markup for each of its cells', () => {
  for (const [scene] of Object.values(PICTURES)) {
    const { columns, rows, viewers } = PICTURE_SCENES[scene];
    expect(viewers, scene).toHaveLength(columns * rows);
  }
});

test('a binary glTF states its own length and holds its triangles', () => {
  const positions = Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  const normals = Float32Array.from([0, 0, 1, 0, 0, 1, 0, 0, 1]);
  const file = glbOf({ positions, normals, indices: Uint32Array.from([0, 1, 2]) });
  const view = new DataView(file.buffer);
  expect(new TextDecoder().decode(file.subarray(0, 4))).toBe('glTF');
  expect(view.getUint32(8, true)).toBe(file.length);
  const at = 20 + view.getUint32(12, true) + 8;
  expect(new Float32Array(file.slice(at, at + 36).buffer)).toEqual(positions);
});
