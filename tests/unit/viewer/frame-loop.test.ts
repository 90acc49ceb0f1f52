// When does text follow the pictures of a page?

import { expect, it } from 'vitest';
import { FrameLoop } from '../../../src/viewer/scene/frame-loop.js';

it('writes text in every other frame, and an explanation between them', () => {
  const frames: FrameRequestCallback[] = [];
  const requestAnimationFrame = (run: FrameRequestCallback) => frames.push(run);
  const loop = new FrameLoop({ requestAnimationFrame } as Window & typeof globalThis);
  let written = '';
  const panel = () => {
    written += 'p';
    throw new Error('broken');
  };
  const probe = () => void (written += 'e');
  for (let frame = 0; frame < 5; frame++) {
    loop.follow(probe, true);
    loop.follow(panel, false);
    try {
      frames.shift()!(0);
    } catch {}
    written += ' ';
  }
  expect(written.trim()).toBe('p e p e p');
  expect(frames).toHaveLength(1);
});
