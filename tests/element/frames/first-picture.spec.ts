// What does the first picture send to the GPU?

import { expect, test } from '../../support/test.js';
import { glSpent, logGl } from '../support/gl-log.js';

/** Of a sphere's vertices (place, normal and texture coordinates as floats) and 16-bit indices. */
const bytesOf = (segments: number): number => {
  const rows = segments / 2;
  return 4 * (3 + 3 + 2) * (segments + 1) * (rows + 1) + 2 * 3 * 2 * segments * (rows - 1);
};

test('the first pictures of equal spheres send one level of them, once', async ({ page, mount }) => {
  await logGl(page);
  const sphere = '<phong-viewer geometry="sphere"></phong-viewer>';
  await mount(sphere + sphere, { width: 120, height: 120 });
  const { bufferBytes, draws } = await glSpent(page);
  expect(draws).toBe(2);
  expect(bufferBytes).toBe(bytesOf(64));
});
