import type { WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { SampleSum } from '../../../src/extras/samples/sample-sum.js';

it('a sum of samples that the GPU has no memory for is refused at every attempt', () => {
  const gl = { FRAMEBUFFER: 1, FRAMEBUFFER_COMPLETE: 2, checkFramebufferStatus: () => 3 };
  const sum = new SampleSum({
    setRenderTarget: () => undefined,
    getContext: () => gl,
  } as unknown as WebGLRenderer);
  const size = { width: 8, height: 8 };
  expect([sum.begin(size), sum.begin(size)]).toEqual([false, false]);
});
