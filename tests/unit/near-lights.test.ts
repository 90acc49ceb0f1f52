// How a mesh's lights lie to it is looked at where they were chosen anew, and what costs much is not tried in vain frame after frame.

import { beforeEach, describe, expect, it, vi } from 'vitest';
import * as lightGrid from '../../src/light/light-grid.js';
import type { Box } from '../../src/light/cull-lights.js';
import { LightList } from '../../src/material/light-list.js';
import type { MeshChoice } from '../../src/material/mesh-lights.js';
import { NearLights } from '../../src/material/near-lights.js';
import { light } from './arbitraries.js';
import { pack } from './packed-reader.js';

vi.mock(import('../../src/light/light-grid.js'), async (original) => {
  const module = await original();
  return { ...module, divide: vi.fn(module.divide) };
});

const divided = vi.mocked(lightGrid.divide);
beforeEach(() => {
  divided.mockClear();
});

const SURFACE = { reflectance: { ka: [1, 1, 1], kd: [1, 1, 1], ks: [1, 1, 1] }, surfaceVersion: 1 };
const FLOOR: Box = [-10, 0, -10, 10, 0, 10];

/** 36 spots straight down on a floor, on a grid of places, each as wide as `aperture` says. */
function chosen(aperture: number, version: number, height = 1): MeshChoice {
  const list = new LightList();
  const spots = Array.from({ length: 36 }, (_, i) =>
    light({
      position: [3 * (i % 6) - 7.5, height, 3 * Math.floor(i / 6) - 7.5, 1],
      axis: [0, -1, 0],
      aperture,
    }),
  );
  list.take(pack(spots));
  return { list, left: 0, box: FLOOR, version };
}

const NARROW = 20;
const WIDE = 88; // 29 units from the foot at a height of 1: all of the floor

describe('lights near a mesh', () => {
  it('are divided where each is small, and not where each reaches all of it', () => {
    const near = new NearLights();
    near.update(chosen(NARROW, 1), SURFACE);
    expect(near.cells?.packed.sent).toBe(36);
    near.update(chosen(WIDE, 2), SURFACE);
    expect(near.cells).toBeNull();
  });

  it('are looked at once while the choice stays', () => {
    const near = new NearLights();
    const choice = chosen(NARROW, 1);
    for (let frame = 0; frame < 100; frame++) near.update(choice, SURFACE);
    expect(divided).toHaveBeenCalledTimes(1);
  });

  it('are divided anew in every frame that they move in, where that pays', () => {
    const near = new NearLights();
    for (let frame = 0; frame < 20; frame++) {
      near.update(chosen(NARROW, frame, 1 + frame / 100), SURFACE);
      expect(near.cells?.packed.sent).toBe(36);
    }
    expect(divided).toHaveBeenCalledTimes(20);
  });

  it('are tried ever more rarely while they move and it never pays', () => {
    const near = new NearLights();
    for (let frame = 0; frame < 640; frame++) near.update(chosen(WIDE, frame), SURFACE);
    // In frames 0, 2, 6, 14, 30 and 62, then in each 64th: 126 to 638.
    expect(divided).toHaveBeenCalledTimes(15);
  });

  it('are divided a second after they have become small at the latest, standing still or moving', () => {
    for (const moves of [true, false]) {
      const near = new NearLights();
      for (let frame = 0; frame < 640; frame++) near.update(chosen(WIDE, frame), SURFACE);
      let frames = 0;
      for (; near.cells === null; frames++) near.update(chosen(NARROW, moves ? 640 + frames : 640), SURFACE);
      expect(frames).toBeLessThanOrEqual(64);
    }
  });

  it('are known to stand apart from it in every frame, divided or not', () => {
    const near = new NearLights();
    for (let frame = 0; frame < 9; frame++) {
      near.update(chosen(WIDE, frame, frame % 2), SURFACE);
      expect(near.apart).toBe(frame % 2 === 1);
    }
  });
});
