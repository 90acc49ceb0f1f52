import type { WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { SampleSum } from '../../../src/extras/samples/sample-sum.js';

it('a sum of samples that the GPU has no memory for is refused at every attempt', () => {
  const gl = { FRAMEBUFFER: 1, FRAMEBUFFER_COMPLETE: 2, checkFramebufferStatus: () => 3 };
  const sum = new SampleSum({
    extensions: new Set(['EXT_color_buffer_float']),
    setRenderTarget: () => undefined,
    getContext: () => gl,
  } as unknown as WebGLRenderer);
  const size = { width: 8, height: 8 };
  expect([sum.begin(size, 2), sum.begin(size, 2)]).toEqual([false, false]);
});
