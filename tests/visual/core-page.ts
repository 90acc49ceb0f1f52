// Pictures by `phong-viewer/core`, on the driver at hand or with the programs that a GPU gets.

import type { Page } from '@playwright/test';
import type { Drawn, Step } from '../glsl/page/core.js';
import type { LightValues } from '../../src/phong/light/light-state.js';
import { compare, expect, type Picture } from '../support/test.js';
import { Dice, dimmed, randomLight } from './random-scene.js';

export const SIZE = { width: 56, height: 42 };

/** Frames after which all specialised programs have taken over. */
export const SETTLED = 40;

/**
 * `gpu`: software under another renderer name, so that it gets uniform arrays and counted loops.
 */
export type Device = 'software' | 'gpu';

export async function openCore(page: Page, device: Device = 'software'): Promise<void> {
  if (device === 'gpu') {
    await page.addInitScript(() => {
      const gl = WebGL2RenderingContext.prototype;
      const real = Object.getOwnPropertyDescriptor(gl, 'getParameter')
        ?.value as typeof gl.getParameter;
      const names = [0x9246, gl.RENDERER]; // UNMASKED_RENDERER_WEBGL
      gl.getParameter = function (this: WebGL2RenderingContext, what: number): unknown {
        return names.includes(what) ? 'A GPU' : (Reflect.apply(real, this, [what]) as unknown);
      };
    });
  }
  await page.goto('/harness/core.html');
  await page.waitForFunction(() => 'drawCore' in window);
}

export const drawCore = (page: Page, ...steps: readonly Step[]): Promise<Drawn[]> =>
  page.evaluate(([size, list]) => window.drawCore(size, list), [SIZE, steps] as const);

/** Checks that two pictures differ by at most one code, on at most 0.02 % of the channels. */
export function expectSame(a: Drawn, b: Drawn, message: string): void {
  const picture = ({ codes }: Drawn): Picture => ({ ...SIZE, data: codes });
  const { max, share } = compare(picture(a), picture(b));
  expect.soft(max, message).toBeLessThanOrEqual(1);
  expect.soft(share, message).toBeLessThanOrEqual(2e-4);
}

/** Channels that are neither dark nor full: only these can show a difference. */
export const tellingChannels = ({ codes }: Drawn): number =>
  codes.filter((code, i) => i % 4 < 3 && code > 0 && code < 255).length;

/** Lights of every kind in turn, whose sum stays within range. */
export function mixedLights(count: number, seed = 1): Partial<LightValues>[] {
  const dice = new Dice(seed);
  return Array.from({ length: count }, (_, i) => {
    const light = dimmed(randomLight(dice), Math.min(1, 6 / count));
    const [x, y, z] = light.position;
    return {
      ...light,
      active: true,
      position: [x, y, z, i % 3 === 0 ? 0 : 1],
      ...(i % 3 === 2
        ? { aperture: [45, 80, 120][(i % 9) % 3]!, cutoff: [0, 1, 4][i % 3]! }
        : { aperture: 180, cutoff: 0 }),
    };
  });
}
