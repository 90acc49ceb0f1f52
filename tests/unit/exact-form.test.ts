// Which form exact programs take: on GPUs loops of literal length as far as a block holds the lights, in software each light by
// itself, and with its numbers once they have stood still for as long as that takes to compile.

import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { WebGLRenderer } from 'three';
import { LARGE_BLOCK_ROWS } from '../../src/light/light-layout.js';
import { LightList } from '../../src/material/light-list.js';
import type { PhongMaterial } from '../../src/material/phong-material.js';
import { FormChoice, isSettled } from '../../src/scene/exact-form.js';
import { light } from './arbitraries.js';
import { pack } from './packed-reader.js';

const GPU = 'ANGLE (NVIDIA, NVIDIA H200/PCIe, OpenGL 4.6)';
const SOFTWARE = 'ANGLE (Google, Vulkan 1.3 (SwiftShader Device (Subzero)), SwiftShader driver)';

/** As much of a renderer as tells of its device; `masked`: the browser keeps the extension to itself. */
function rendererOf(name: string, { blockBytes = 65_536, masked = false } = {}): WebGLRenderer {
  const gl = {
    ...{ RENDERER: 1, MAX_UNIFORM_BLOCK_SIZE: 2 },
    getExtension: () => (masked ? null : { UNMASKED_RENDERER_WEBGL: 3 }),
    getParameter: (what: number) => ({ 1: masked ? name : 'WebKit WebGL', 2: blockBytes, 3: name })[what],
  };
  return { getContext: () => gl } as unknown as WebGLRenderer;
}

const listOf = (count: number, intensity = 1): LightList => {
  const list = new LightList();
  list.take(pack(Array.from({ length: count }, () => light({ diffuse: [intensity, 0, 0] }))));
  return list;
};

const surface = (version = 1): PhongMaterial => ({ surfaceVersion: version }) as unknown as PhongMaterial;

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

describe('on a GPU', () => {
  const first = (renderer: WebGLRenderer, count: number, cells = false): string =>
    new FormChoice().of(renderer, listOf(count), cells, surface());

  it.each([1, 2, 16, 64, 1024])('%i lights are counted, however long they stand still', (count) => {
    const [choice, renderer, list] = [new FormChoice(), rendererOf(GPU), listOf(count)];
    for (let frame = 0; frame < 100; frame++) {
      expect(choice.of(renderer, list, false, surface())).toBe('counted');
      vi.advanceTimersByTime(1000);
    }
  });

  it('lights are in loops of any length beyond 1,024, or beyond what a block holds', () => {
    expect(first(rendererOf(GPU), 1025)).toBe('loops');
    const { rows } = listOf(100).packed;
    expect(rows).toBeLessThan(LARGE_BLOCK_ROWS);
    expect(first(rendererOf(GPU, { blockBytes: 16 * rows }), 100)).toBe('counted');
    expect(first(rendererOf(GPU, { blockBytes: 16 * rows - 16 }), 100)).toBe('loops');
  });

  it('no block is larger than programs have one for', () => {
    const most = Array.from({ length: 1024 }, (_, i) => i + 1).filter((count) => listOf(count).packed.rows <= LARGE_BLOCK_ROWS); // prettier-ignore
    const last = most.at(-1)!;
    const huge = rendererOf(GPU, { blockBytes: 2 ** 31 - 1 });
    expect(first(huge, last)).toBe('counted');
    if (last < 1024) expect(first(huge, last + 1)).toBe('loops');
  });

  it('lights in cells stay in cells', () => {
    expect(first(rendererOf(GPU), 64, true)).toBe('cells');
  });
});

describe('in software', () => {
  /** The form of each frame, so many milliseconds apart. */
  function forms(
    count: number,
    frames: number,
    step: number,
    change?: (frame: number) => LightList,
  ): string[] {
    const [choice, renderer] = [new FormChoice(), rendererOf(SOFTWARE)];
    let list = listOf(count);
    return Array.from({ length: frames }, (_, frame) => {
      if (change !== undefined) list = change(frame);
      const form = choice.of(renderer, list, false, surface());
      vi.advanceTimersByTime(step);
      return form;
    });
  }

  it.each([
    'SwiftShader',
    'llvmpipe (LLVM 15)',
    'softpipe',
    'Software Rasterizer',
    'Microsoft Basic Render Driver',
  ])('is what calls itself %s, also where the browser hides the rest', (name) => {
    for (const masked of [false, true])
      expect(new FormChoice().of(rendererOf(name, { masked }), listOf(4), false, surface())).toBe('written');
  });

  it('16 lights are written out at once, and have their numbers in the text after three tenths of a second', () => {
    const found = forms(16, 32, 10);
    expect(found.slice(0, 30)).toEqual(Array(30).fill('written'));
    expect(found.slice(30)).toEqual(['constant', 'constant']);
  });

  it('more lights are in loops until as many as a text may hold would be compiled', () => {
    for (const count of [17, 64, 65, 256]) {
      const found = forms(count, 100, 50);
      expect(new Set(found)).toEqual(new Set(['loops', 'constant']));
      expect(found.indexOf('constant')).toBe(found.lastIndexOf('loops') + 1);
    }
  });

  it('of 257 lights too few would gain by it', () => {
    expect(new Set(forms(257, 200, 50))).toEqual(new Set(['loops']));
  });

  it('numbers are waited for as long as they take to compile: two seconds and a half for 64', () => {
    const at = (count: number, step: number): number => step * forms(count, 200, step).indexOf('constant');
    expect(at(64, 40)).toBe(2440); // of 2406 ms the next frame
    expect(at(256, 40)).toBe(2440); // of which 64 are compiled
    expect(at(32, 16)).toBe(800); // of 794
    expect(at(16, 10)).toBe(300); // of 294
    expect(at(1, 10)).toBe(200); // twenty frames
  });

  it('a smooth picture does not halt for 64, and for 32 it does', () => {
    for (const count of [64, 256]) expect(forms(count, 1000, 16)).not.toContain('constant');
    expect(forms(32, 1000, 16)).toContain('constant');
  });

  it('numbers in the text stay there, however fast they make the frames', () => {
    const [choice, renderer, list] = [new FormChoice(), rendererOf(SOFTWARE), listOf(64)];
    const found = Array.from({ length: 2000 }, (_, frame) => {
      vi.advanceTimersByTime(frame < 100 ? 50 : 2);
      return choice.of(renderer, list, false, surface());
    });
    expect(found.lastIndexOf('loops')).toBeLessThan(found.indexOf('constant'));
  });

  it('slow pictures wait for three frames and a third of a second', () => {
    expect(forms(4, 6, 150).indexOf('constant')).toBe(3);
    expect(forms(4, 6, 99).indexOf('constant')).toBe(4);
  });

  it('lights that move are never numbers in a text, nor under a surface that changes', () => {
    expect(forms(4, 60, 16, (frame) => listOf(4, frame + 1))).not.toContain('constant');
    const [choice, renderer, list] = [new FormChoice(), rendererOf(SOFTWARE), listOf(4)];
    for (let frame = 0; frame < 60; frame++) {
      expect(choice.of(renderer, list, false, surface(frame))).toBe('written');
      vi.advanceTimersByTime(16);
    }
  });

  it('numbers that change in place are waited for anew', () => {
    const [choice, renderer, list] = [new FormChoice(), rendererOf(SOFTWARE), listOf(4)];
    const frames = (count: number): string[] =>
      Array.from({ length: count }, () => {
        const form = choice.of(renderer, list, false, surface());
        vi.advanceTimersByTime(10);
        return form;
      });
    expect(frames(30).at(-1)).toBe('constant');
    list.take(pack(Array.from({ length: 4 }, () => light({ diffuse: [9, 9, 9] }))));
    expect(frames(20)).toEqual(Array(20).fill('written'));
    expect(frames(1)).toEqual(['constant']);
  });

  it('lights in cells stay in cells', () => {
    const [choice, renderer, list] = [new FormChoice(), rendererOf(SOFTWARE), listOf(30)];
    for (let frame = 0; frame < 60; frame++) {
      expect(choice.of(renderer, list, true, surface())).toBe('cells');
      vi.advanceTimersByTime(16);
    }
  });
});

describe('what stands still', () => {
  it('is so after twenty frames, or after three and a third of a second, and no sooner than is asked', () => {
    vi.setSystemTime(0);
    const since = performance.now();
    expect(isSettled(19, since)).toBe(false);
    expect(isSettled(20, since)).toBe(true);
    expect(isSettled(20, since, 1)).toBe(false);
    vi.advanceTimersByTime(299);
    expect(isSettled(3, since)).toBe(false);
    vi.advanceTimersByTime(1);
    expect(isSettled(2, since)).toBe(false);
    expect(isSettled(3, since)).toBe(true);
    expect(isSettled(3, since, 301)).toBe(false);
  });
});
