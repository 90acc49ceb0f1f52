// When does a specialised program take over? After 20 drawn frames with the same key, one program of the page in a
// frame.

import { BoxGeometry, Mesh, PerspectiveCamera } from 'three';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { compilingPrograms, ProgramCache } from '../../src/material/program/program-cache.js';
import type { Variant } from '../../src/material/program/variant.js';
import { FakeRenderer } from './fake-renderer.js';

const mesh = new Mesh(new BoxGeometry());
const camera = new PerspectiveCamera();

let gpu = new FakeRenderer();
let cache = new ProgramCache();
beforeEach(() => {
  gpu = new FakeRenderer();
  cache = new ProgramCache();
  // So that the next test finds no take-over in progress.
  cache.begin();
  cache.begin();
});

const variantOf = (key: string): Variant => ({ key, defines: {}, vertexShader: '', fragmentShader: '' });

/** Draws `count` frames with these keys, and returns the keys that the last one drew specialised. */
function draw(count: number, keys: readonly string[] = ['a'], into = cache): string[] {
  let drawn: string[] = [];
  for (let i = 0; i < count; i++) {
    into.begin();
    drawn = keys.filter(
      (key) => into.choose(key, { renderer: gpu.renderer, camera, mesh }, () => variantOf(key)) !== null,
    );
  }
  return drawn;
}

/** Draws until the programs of these keys have taken over, and returns the number of frames. */
function settle(keys: readonly string[]): number {
  for (let frames = 1; frames < 1000; frames++) if (draw(1, keys).length === keys.length) return frames;
  throw new Error('these keys never settle');
}

describe('a specialised program', () => {
  it('is compiled after 20 drawn frames with the same key', () => {
    draw(20);
    expect(gpu.compiled).toHaveLength(0);
    draw(1);
    expect(gpu.compiled).toHaveLength(1);
    expect(draw(1)).toStrictEqual(['a']);
    expect(draw(500)).toStrictEqual(['a']);
    expect(gpu.compiled).toHaveLength(1);
  });

  it('is never requested by a picture that is not redrawn', () => {
    draw(19);
    for (let frame = 0; frame < 100; frame++) cache.begin();
    expect(gpu.compiled).toHaveLength(0);
  });

  it('is not requested for keys that come and go: a frame without the key restarts its count', () => {
    for (let i = 0; i < 100; i++) draw(1, [i % 15 === 0 ? 'other' : 'a']);
    expect(gpu.compiled).toHaveLength(0);
  });

  it('is shared by all meshes with the same key, which count a frame once', () => {
    draw(
      15,
      Array.from({ length: 1000 }, () => 'a'),
    );
    expect(gpu.compiled).toHaveLength(0);
    expect(
      draw(
        20,
        Array.from({ length: 1000 }, () => 'a'),
      ),
    ).toHaveLength(1000);
    expect(gpu.compiled).toHaveLength(1);
  });

  it('is listed as compiling until it has linked, and then used', () => {
    gpu.ready = false;
    draw(21);
    expect(draw(100)).toStrictEqual([]);
    expect(compilingPrograms.has(gpu.programOf(gpu.compiled[0]!))).toBe(true);
    gpu.ready = true;
    expect(draw(1)).toStrictEqual(['a']);
    expect(compilingPrograms.has(gpu.programOf(gpu.compiled[0]!))).toBe(false);
  });

  it('waits a few frames if the browser cannot tell whether it has linked', () => {
    gpu = new FakeRenderer({ tells: false });
    draw(21);
    expect(draw(3)).toStrictEqual([]);
    expect(draw(5)).toStrictEqual(['a']);
  });

  it('is kept while another one draws, and draws again at once', () => {
    settle(['a']);
    draw(3, ['b']);
    expect(draw(1, ['a'])).toStrictEqual(['a']);
    expect(gpu.compiled).toHaveLength(1);
  });
});

describe('the programs of a page', () => {
  it('compile one at a time and take over one per frame, across all caches', () => {
    const caches = [cache, new ProgramCache(), new ProgramCache()];
    const drawn = caches.map(() => 0);
    for (let frame = 0; frame < 100; frame++) {
      const before = [...drawn];
      caches.forEach((one, i) => (drawn[i] = draw(1, ['a', 'b', 'c'], one).length));
      const took = drawn.reduce((sum, n, i) => sum + n - before[i]!, 0);
      expect(took).toBeLessThanOrEqual(1);
    }
    expect(drawn).toStrictEqual([3, 3, 3]);
  });

  it('are dropped after other keys have drawn for long, but never while they draw', () => {
    settle(['a']);
    for (let i = 0; i < 60; i++) draw(2, ['a', `key ${String(i)}`]);
    expect(draw(1)).toStrictEqual(['a']);
    expect(gpu.disposed).toHaveLength(0);
    for (let i = 0; i < 60; i++) draw(2, [`key ${String(i)}`]);
    expect(gpu.disposed).toHaveLength(1);
    expect(draw(1)).toStrictEqual([]);
  });

  it('are freed by disposal, and can come again', () => {
    settle(['a', 'b']);
    cache.dispose();
    expect(gpu.disposed).toHaveLength(2);
    expect(settle(['a', 'b'])).toBeGreaterThan(20);
  });

  it('are freed with their shaders where they were never drawn: three.js deletes these with the first draw', () => {
    settle(['a']);
    gpu.ready = false;
    draw(30, ['a', 'b']);
    cache.dispose();
    const [, undrawn] = gpu.compiled;
    expect(gpu.withoutShaders).toStrictEqual([undrawn]);
  });
});

describe('a program that does not link', () => {
  it('is reported once and freed, and the general one goes on drawing', () => {
    const reported = vi.fn();
    vi.stubGlobal('reportError', reported);
    gpu.links = false;
    expect(draw(500)).toStrictEqual([]);
    expect(gpu.compiled).toHaveLength(1);
    expect(gpu.disposed).toHaveLength(1);
    expect(reported).toHaveBeenCalledTimes(1);
    expect(String(reported.mock.calls[0])).toContain('broken by hand');
    vi.unstubAllGlobals();
  });
});
