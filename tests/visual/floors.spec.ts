// Are large floors and walls right where the eye and the lamps are near? Against the equation at points of rays in
// float64.
import { expect, pixels, test } from '../support/test.js';
import { innerPixels } from './against-reference.js';
import { floorScene } from './floor-scenes.js';
import { sceneMarkup } from './random-scene.js';
import type { DeclaredScene } from './ray-cast.js';

const SIZE = { width: 96, height: 64 };
const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

test('shades floors and walls up to 1,000 times as large as the eye is near', async ({ mount }) => {
  const scenes: readonly DeclaredScene[] = [
    floorScene(FIRST, 30, 80),
    floorScene(FIRST + 1, 100, 75),
    floorScene(FIRST + 2, 1000, 60),
    floorScene(FIRST + 3, 0, 70, { rotation: [0, 40, 8], scale: [-200, 1, 300] }),
    floorScene(FIRST + 4, 500, 65, { geometry: 'box' }),
  ];
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const holes: string[] = [];
  let off = 0;
  let compared = 0;
  for (const [i, scene] of scenes.entries()) {
    await viewer.evaluate((element, text) => (element.outerHTML = text), sceneMarkup(scene));
    const { data, width, height } = await pixels(viewer, SIZE);
    for (const { x, y, hit } of innerPixels(scene, width, height)) {
      const at = 4 * (y * width + x);
      if (data[at + 3] !== 255) holes.push(`seed ${FIRST + i}: ${x}, ${y}`);
      hit.shaded.color.forEach((value, channel) => {
        compared += 1;
        if (Math.abs(Math.round(255 * value) - data[at + channel]!) > 1) off += 1;
      });
    }
  }
  expect(holes).toEqual([]);
  expect(compared).toBeGreaterThan(2000 * scenes.length);
  // Of a floor of one segment 34 % are, at 1,000.
  expect(off / compared).toBeLessThan(0.001);
});
