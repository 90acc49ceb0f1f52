// Do shapes stand out with defaults alone, on white and black pages, and do the README's lights
// keep their tones? Tones are in codes; a face is one of the picture's most frequent tones.

import { readmeSnippet } from '../../.ci/readme-picture.mjs';
import { GEOMETRIES } from '../../src/phong/model/shapes/shapes.js';
import { expect, pixels, test, type Picture } from '../support/test.js';

const size = { width: 240, height: 200 };
const lightings = [
  ['without a light', ''],
  ['under the default light', '<phong-light></phong-light>'],
] as const;

/** The brightest channel of every pixel that is covered entirely. */
function tones({ data }: Picture): readonly number[] {
  const whole = Array.from(data.keys()).filter((i) => i % 4 === 0 && data[i + 3] === 255);
  return whole.map((i) => Math.max(...data.subarray(i, i + 3)));
}

const share = (all: readonly number[], which: (tone: number) => boolean) =>
  all.filter(which).length / all.length;

for (const [lighting, light] of lightings) {
  test(`shapes stand out from white and black, and faces from each other, ${lighting}`, async ({
    page,
    mount,
  }) => {
    const kinds = GEOMETRIES.map((geometry) => `geometry="${geometry}"`);
    const matte = 'geometry="box" ks="0"';
    await mount(
      [...kinds, matte].map((kind) => `<phong-viewer ${kind}>${light}</phong-viewer>`).join(''),
      size,
    );
    const tonesAt = async (i: number) => tones(await pixels(page.locator('phong-viewer').nth(i)));
    for (const [i, kind] of kinds.entries()) {
      const found = await tonesAt(i);
      expect(found.length, kind).toBeGreaterThan(1000);
      // A highlight may reach white: a streak along a cone is the largest, at 9 %.
      expect(
        share(found, (tone) => tone === 255),
        `${kind} is white`,
      ).toBeLessThan(0.1);
      expect(
        share(found, (tone) => tone < 24),
        `${kind} is black`,
      ).toBeLessThan(0.03);
    }
    const counts = new Map<number, number>();
    for (const tone of await tonesAt(kinds.length)) {
      counts.set(tone, (counts.get(tone) ?? 0) + 1);
    }
    const faces = [...counts]
      .sort(([, a], [, b]) => b - a)
      .slice(0, 3)
      .map(([tone]) => tone);
    const [dark, middle, bright] = faces.sort((a, b) => a - b);
    expect(middle! - dark!).toBeGreaterThan(20);
    expect(bright! - middle!).toBeGreaterThan(20);
  });
}

test("the README's first scene reaches full brightness only in the centres of its highlights", async ({
  mount,
}) => {
  const viewer = await mount(readmeSnippet().replace('full', 'edges'), {
    csp: '',
    width: 380,
    height: 210,
  });
  const found = tones(await pixels(viewer));
  expect(share(found, (tone) => tone === 255)).toBeLessThan(0.005);
});
