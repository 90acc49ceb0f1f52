// The arithmetic of the bench: statistics, results, progress, scenes and errors, without a browser.
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { errorOf } from '../bench/front/errors.js';
import { glbOf } from '../bench/glb.mjs';
import { endOfUploads, readTrace } from '../bench/measure/model.mjs';
import { MODELS, writeModels } from '../bench/models.mjs';
import { mixedLights, sceneOf } from '../bench/pages/scenes.js';
import { pictureError } from '../bench/picture-error.mjs';
import { PICTURE_SCENES } from '../bench/pages/picture-scenes.js';
import { readOptions } from '../bench/options.mjs';
import { Progress } from '../bench/progress.mjs';
import {
  addSamples,
  type BenchResult,
  ratioOf,
  ratioOverSubjects,
  ratioToBest,
  valueOf,
} from '../bench/results.mjs';
import { interleaved, pairedRatios, quantile, spread } from '../bench/statistics.mjs';
import { chosenSubjects, PICTURES, SUBJECTS } from '../bench/subjects.mjs';

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

  test('ends the uploads once only the uniforms of frames are left', () => {
    const upload = (end: number, bytes: number) => ({ start: end - 1, end, bytes });
    expect(endOfUploads([upload(5, 0), upload(10, 9000), upload(20, 900), upload(30, 100)])).toBe(20);
    expect(endOfUploads([])).toBeNaN();
  });
});

describe('options', () => {
  test('take flags that begin with dashes, separated by spaces', () => {
    const { flags, launches, minutes } = readOptions(['--flags', '--use-angle=gl --no-vsync', '--quick']);
    expect(flags).toEqual(['--use-angle=gl', '--no-vsync']);
    expect([launches, minutes]).toEqual([1, Infinity]);
  });
});

describe('progress', () => {
  test('estimates a part by its own earlier runs, and an unknown one by the average', () => {
    const progress = new Progress(['a', 'b', 'a', 'b']);
    expect(progress.left).toBe(0);
    progress.finish(60_000);
    expect(progress.left).toBe(180_000);
    progress.finish(180_000);
    expect(progress.left).toBe(240_000);
    expect(progress.toString()).toBe('[2/4, about 4 min left]');
  });
});

describe('subjects', () => {
  test('are chosen by parts of their names, in their own order', () => {
    expect(chosenSubjects(['bytes', 'sphere, 1 '])).toEqual(['sphere, 1 light', 'bytes']);
    expect(chosenSubjects(['a teapot'])).toEqual([]);
    expect(chosenSubjects([])).toEqual(Object.keys(SUBJECTS));
  });

  test('name scenes that exist', () => {
    for (const subject of Object.values(SUBJECTS))
      if (subject.kind === 'picture') expect(Object.keys(PICTURE_SCENES)).toContain(subject.scene);
      else if ('scene' in subject) expect(sceneOf(subject.scene).meshes.length).toBeGreaterThan(0);
    expect(() => sceneOf('teapot:1')).toThrow('no scene is called teapot:1');
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

  test('refuse other sizes and NaN', () => {
    expect(() => errorOf(new Float64Array(3), new Float64Array(6))).toThrow(RangeError);
    expect(() => errorOf(Float64Array.from([NaN]), new Float64Array(1))).toThrow('not a number');
  });
});

describe('the error of a whole picture', () => {
  const means = Float64Array.from([10, 20.4, 30, 255, 0, 0, 0, 0]);

  test('is taken over the three colours of each pixel, whatever their alpha', () => {
    const { rmse, within } = pictureError(Uint8Array.from([10, 20, 30, 0, 0, 0]), means);
    expect(rmse).toBeCloseTo(Math.sqrt(0.4 ** 2 / 6), 12);
    expect(within).toBe(1);
  });

  test('counts a pixel as within one code if all its channels are', () => {
    expect(pictureError(Uint8Array.from([11, 21, 29, 0, 2, 0]), means).within).toBe(0.5);
    expect(pictureError(Uint8Array.from([12, 20, 30, 0, 0, 0]), means).within).toBe(0.5);
  });

  test('refuses a picture of another size', () => {
    expect(() => pictureError(new Uint8Array(3), means)).toThrow(RangeError);
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
