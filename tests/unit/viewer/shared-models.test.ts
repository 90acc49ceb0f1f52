// Do meshes with the same source share one download and one content, each with a motion, a look and
// a budget of its own?
import { Scene } from 'three';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { MeshValues } from '../../../src/phong/model/mesh-fields.js';
import type { SceneMesh } from '../../../src/viewer/scene/mesh/scene-mesh.js';
import { bar } from '../../support/animated-gltf.js';
import { pngOf } from '../../fuzz/glb.js';
import { texturedGlb, triangleGlb } from '../../fuzz/models.js';
import { bitmapOf } from '../../extras/models/model-files.js';
import { meshHost, meshOf } from '../scene-host.js';

const files = new Map<string, Uint8Array<ArrayBuffer> | null>();
const requests: { readonly path: string; readonly signal: AbortSignal }[] = [];
let bitmaps = 0;
let closed = 0;

beforeEach(() => {
  files.clear();
  requests.length = bitmaps = closed = 0;
  files.set('/triangle.glb', new Uint8Array(triangleGlb()));
  files.set('/bar.gltf', new TextEncoder().encode(JSON.stringify(bar())));
  files.set('/textured.glb', new Uint8Array(texturedGlb([pngOf(64, 64, 32)], [{ source: 0 }])));
  vi.stubGlobal('document', Object.assign(new EventTarget(), { baseURI: 'https://shop.example/' }));
  vi.stubGlobal('createImageBitmap', (blob: Blob) => {
    bitmaps += 1;
    return bitmapOf(blob, () => (closed += 1));
  });
  vi.stubGlobal('fetch', async (url: URL, { signal }: { signal: AbortSignal }) => {
    requests.push({ path: url.pathname, signal });
    await new Promise((resolve) => setTimeout(resolve, 5));
    signal.throwIfAborted();
    const file = files.get(url.pathname) ?? null;
    return new Response(file, { status: file === null ? 404 : 200 });
  });
});

const added = new Set<SceneMesh>();

afterEach(() => {
  for (const mesh of added) {
    mesh.dispose();
  }
  added.clear();
  vi.unstubAllGlobals();
});

/** A viewer of such meshes. */
function viewerOf() {
  const errors: string[] = [];
  const host = meshHost({
    ended: (_mesh, _url, error) => error !== null && errors.push((error as { code: string }).code),
  });
  const scene = new Scene();
  const add = (values: Partial<MeshValues>) => {
    const one = meshOf(host, scene, values);
    added.add(one.mesh);
    return one;
  };
  return { budget: host.picture.budget, errors, add };
}

const there = (...meshes: readonly { readonly mesh: SceneMesh }[]) =>
  expect.poll(() => meshes.filter(({ mesh }) => mesh.shown.root === null)).toEqual([]);
const geometryOf = ({ mesh }: { readonly mesh: SceneMesh }) => mesh.shown.parts[0]!.mesh.geometry;
const positionsOf = (one: { readonly mesh: SceneMesh }) =>
  one.mesh.shown.parts.flatMap(({ mesh }) => [
    ...mesh.geometry.getAttribute('position').array,
    ...mesh.matrix.elements,
  ]);

describe('meshes with the same source', () => {
  it('on several viewers are one download, geometry and image, of own materials, until the last one goes', async () => {
    const [a, b] = [viewerOf(), viewerOf()];
    const src = '/textured.glb';
    const meshes = [a.add({ src }), a.add({ src }), b.add({ src, ka: [1, 2, 3] })] as const;
    await there(...meshes);
    expect([requests.length, bitmaps]).toEqual([1, 1]);
    expect(new Set(meshes.map(geometryOf)).size).toBe(1);
    expect(new Set(meshes.map(({ mesh }) => mesh.shown.parts[0]!.material.look.map)).size).toBe(1);
    const [one, , other] = meshes.map(({ mesh }) => mesh.shown.parts[0]!.material.surface.ka);
    expect(other).toEqual([1, 2, 3]);
    expect(one).not.toEqual(other);
    expect(a.budget.used).toBe(b.budget.used);
    const disposed = vi.fn();
    geometryOf(meshes[0]).addEventListener('dispose', disposed);
    meshes[0].mesh.dispose();
    meshes[2].set({ src: '', geometry: 'box' });
    await there(meshes[2]);
    expect([disposed.mock.calls.length, closed]).toEqual([0, 0]);
    meshes[1].mesh.dispose();
    await expect.poll(() => closed).toBe(1);
    expect(disposed).toHaveBeenCalledOnce();
    expect(a.budget.used).toBe(0);
    await there(a.add({ src }));
    expect(requests).toHaveLength(2);
  });

  it('but another type or another File are not shared; the same File is', async () => {
    const { add } = viewerOf();
    const [one, other] = [
      new File([new Uint8Array(triangleGlb())], 'a.glb'),
      new File([new Uint8Array(triangleGlb())], 'a.glb'),
    ];
    const meshes = [one, one, other].map((src) => add({ src }));
    const typed = [add({ src: '/triangle.glb' }), add({ src: '/triangle.glb', type: 'gltf' })];
    await there(...meshes, ...typed);
    expect(new Set(meshes.map(geometryOf)).size).toBe(2);
    expect(requests).toHaveLength(2);
  });

  it('are in poses of their own, those of a model that is alone', async () => {
    const motions = [
      [{ autoplay: false }, 0],
      [{ autoplay: true, animationName: 'bend' }, 0.5],
      [{ autoplay: true, animationName: 'swell' }, 0.5],
      [{ autoplay: true, animationName: 'bend' }, 1.25],
      [{ autoplay: false }, 0],
    ] as const;
    const alone: number[][] = [];
    for (const [values, seconds] of motions) {
      const one = viewerOf().add({ src: '/bar.gltf', ...values });
      await there(one);
      one.mesh.shown.animation?.advance(seconds);
      alone.push(positionsOf(one));
      one.mesh.dispose();
    }
    expect(requests).toHaveLength(5);
    const { add, budget } = viewerOf();
    const meshes = motions.map(([values]) => add({ src: '/bar.gltf', ...values }));
    await there(...meshes);
    expect(requests).toHaveLength(6);
    for (const [i, [, seconds]] of motions.entries()) {
      meshes[i]!.mesh.shown.animation?.advance(seconds);
    }
    expect(meshes.map(positionsOf)).toEqual(alone);
    const late = add({ src: '/bar.gltf' });
    await there(late);
    expect(positionsOf(late)).toEqual(alone[0]);
    meshes[3]!.mesh.dispose();
    meshes[1]!.set({ autoplay: false });
    expect(positionsOf(meshes[1]!)).toEqual(alone[0]);
    expect(positionsOf(meshes[2]!)).toEqual(alone[2]);
    for (const { mesh } of [...meshes, late]) {
      mesh.dispose();
    }
    expect(budget.used).toBe(0);
  });

  it('all fail with a download, and a retry is one more', async () => {
    const { add, errors } = viewerOf();
    const meshes = [0, 1, 2].map(() => add({ src: '/late.glb' }));
    await expect.poll(() => errors).toEqual(['load-failed', 'load-failed', 'load-failed']);
    expect(requests).toHaveLength(1);
    files.set('/late.glb', new Uint8Array(triangleGlb()));
    for (const { mesh } of meshes) {
      mesh.retry();
      mesh.update();
    }
    await there(...meshes);
    expect(requests).toHaveLength(2);
  });

  it('are refused by the viewer that has no room, and shown by the other', async () => {
    const [small, large] = [viewerOf(), viewerOf()];
    small.budget.limit = 0;
    small.add({ src: '/triangle.glb' });
    const shown = large.add({ src: '/triangle.glb' });
    await there(shown);
    expect([small.errors, large.errors]).toEqual([['too-large'], []]);
    expect(requests).toHaveLength(1);
    expect(small.budget.used).toBe(0);
  });

  it('download on until nobody wants the model', async () => {
    const { add } = viewerOf();
    const [first, second] = [add({ src: '/triangle.glb' }), add({ src: '/triangle.glb' })];
    first.mesh.dispose();
    expect(requests[0]!.signal.aborted).toBe(false);
    await there(second);
    const third = add({ src: '/bar.gltf' });
    third.mesh.dispose();
    await expect.poll(() => requests[1]!.signal.aborted).toBe(true);
  });
});
