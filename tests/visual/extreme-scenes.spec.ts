// Does a scene look the same at every size? Compares tiny and huge scenes, fitted by `auto`, with
// the same scene at size 1.
import type { Vec3 } from '../../src/phong/math/vector.js';
import { compare, expect, pixels, test } from '../support/test.js';

const size = { width: 160, height: 120 };

/**
 * A shape `scale` units large. Its directional lights reach any size; highlights need distances
 * above 1e-15.
 */
const scene = (scale: number, geometry: string, ks: number) =>
  `<phong-viewer>
     <phong-mesh geometry="${geometry}" scale="${scale}" kd="200 120 60" ks="${ks}"></phong-mesh>
     <phong-light position="1 2 3 0" ambient="20" diffuse="140"></phong-light>
     <phong-light position="-1 1 1 0" diffuse="60 90 140" axis="1 -0.9 -1" aperture="40" cutoff="4"></phong-light>
   </phong-viewer>`;

const sizes = [
  [1e-20, 0],
  [1e-16, 0],
  [1e-14, 128],
  [1e-9, 128],
  [1e9, 128],
  [2e11, 128],
  [1e12, 128],
] as const;

test('a scene of any size from 1e-20 to 1e12 looks as it does at size 1', async ({
  mount,
  page,
}) => {
  for (const geometry of ['sphere', 'torus-knot']) {
    const usual = (ks: number) => scene(1, geometry, ks);
    await mount(
      [usual(0), usual(128), ...sizes.map(([scale, ks]) => scene(scale, geometry, ks))].join(''),
      size,
    );
    const viewers = await page.locator('phong-viewer').all();
    const [matt, shiny, ...others] = await Promise.all(
      viewers.map((viewer) => pixels(viewer, size)),
    );
    for (const [i, [scale, ks]] of sizes.entries()) {
      const { max, share } = compare(others[i]!, ks === 0 ? matt! : shiny!, 1);
      // Rounding of the camera may move an outline across one of a pixel's samples.
      expect(share, `${geometry} of size ${scale}: at most ${max} codes off`).toBeLessThan(0.001);
    }
  }
});

/** The same scene with its target elsewhere. The lamp's offset is exact there. */
const placed = ([x, y, z]: Vec3) =>
  `<phong-viewer target="${x} ${y} ${z}" radius="3" theta="25" phi="65">
     <phong-mesh geometry="torus-knot" position="${x} ${y} ${z}" kd="200 120 60"></phong-mesh>
     <phong-light position="1 2 3 0" ambient="20" diffuse="100"></phong-light>
     <phong-light position="${x + 1} ${y + 1} ${z + 1} 1" diffuse="90 90 140" attenuation="1 0.1 0.05"></phong-light>
   </phong-viewer>`;

test('a scene whose target is up to 1e15 units away looks as it does at the origin', async ({
  mount,
  page,
}) => {
  const places = [1e9, 1e12, 2 ** 49].map((far): [number, number, number] => [
    far,
    -far / 2,
    far / 4,
  ]);
  await mount([placed([0, 0, 0]), ...places.map(placed)].join(''), size);
  const viewers = await page.locator('phong-viewer').all();
  const [near, ...others] = await Promise.all(viewers.map((viewer) => pixels(viewer, size)));
  for (const [i, place] of places.entries()) {
    const { max, share } = compare(others[i]!, near!, 1);
    expect(share, `target ${place.join(' ')}: at most ${max} codes off`).toBeLessThan(0.001);
  }
});
