// Is the picture of `antialias="full"` the mean, over each pixel's square, of what the equation
// writes there? Against a float64 ray caster on the same triangles.

import { patch, type Texel } from '../support/gltf.js';
import { expect, pixels, test, type Picture } from '../support/test.js';
import { castPicture } from '../support/cast.mjs';
import { drawnScene } from '../support/drawn-scene.js';
import type { CastTexture } from '../../src/extras/still/cast-scene.js';

const size = { width: 48, height: 36 };
const full = 'alt="" antialias="full" samples="64"';

const lights = `<phong-light position="1 2 3 0" ambient="30 30 40"></phong-light>
  <phong-light position="-2 1 2 1" diffuse="120 80 60"></phong-light>`;
const bright =
  '<phong-light position="1 2 3 0" ambient="0" diffuse="255" specular="255"></phong-light>';
/** Its edge crosses the picture. */
const cone =
  '<phong-light position="0.6 1.8 1.4 1" axis="-0.6 -1.85 -1.35" aperture="9" ambient="0"></phong-light>';

/** Checks of eight texels, so fine that each pixel has about four texels along its side. */
const CHECKS = 256;
const checked = (x: number, y: number): Texel =>
  ((x >> 3) + (y >> 3)) % 2 === 0 ? [230, 200, 120] : [60, 90, 150];
const texels = Array.from({ length: CHECKS ** 2 }, (_, i) =>
  checked(i % CHECKS, Math.floor(i / CHECKS)),
);
const texture: CastTexture = {
  width: CHECKS,
  height: CHECKS,
  data: new Uint8Array(texels.flatMap(([r, g, b]) => [r, g, b, 255])),
};
const material = { pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0 } };

interface HardPicture {
  readonly markup: string;
  readonly texture?: CastTexture;
  /**
   * Largest error in codes, a fifth or more above what is measured: pictures this small are all
   * outline.
   */
  readonly rmse: number;
  /** Least share of pixels within one code. */
  readonly within: number;
}

/** By what is hard about them. */
const PICTURES: Readonly<Record<string, HardPicture>> = {
  outlines: {
    markup: `<phong-viewer ${full} geometry="torus" segments="32" phi="60">${lights}</phong-viewer>`,
    rmse: 0.75,
    within: 0.93,
  },
  'thin highlights': {
    markup: `<phong-viewer ${full} geometry="torus-knot" shininess="2000" ks="255">${bright}</phong-viewer>`,
    rmse: 0.75,
    within: 0.93,
  },
  'a cone edge': {
    markup: `<phong-viewer ${full} phi="65" radius="1.25" target="0 -0.05 0">${cone}
      <phong-mesh geometry="plane" position="0 -0.5 0" scale="3"></phong-mesh>
      <phong-mesh geometry="teapot" segments="16" shininess="120"></phong-mesh></phong-viewer>`,
    rmse: 0.75,
    within: 0.93,
  },
  'a fine texture': {
    markup: `<phong-viewer ${full} phi="70" shininess="32" src="${patch({ material, textures: [texels], mipmaps: true })}">
      ${lights}</phong-viewer>`,
    texture,
    rmse: 1.2,
    within: 0.75,
  },
};

/** Premultiplied, as the canvas has it. */
function errorsOf({ data }: Picture, means: Float64Array) {
  let squares = 0;
  let within = 0;
  for (let i = 0; i < data.length; i += 4) {
    const errors = [0, 1, 2].map(
      (k) => Math.round((data[i + k]! * data[i + 3]!) / 255) - means[i + k]!,
    );
    squares += errors.reduce((sum, error) => sum + error ** 2, 0);
    if (errors.every((error) => Math.abs(error) <= 1)) {
      within += 1;
    }
  }
  return { rmse: Math.sqrt(squares / (0.75 * data.length)), within: within / (data.length / 4) };
}

test('hard pictures converge to the exact mean over each pixel', async ({ page, mount }) => {
  const markup = Object.values(PICTURES).map((picture) => picture.markup);
  await mount(markup.join(''), size);
  for (const [i, [what, { texture, rmse, within }]] of Object.entries(PICTURES).entries()) {
    const viewer = page.locator('phong-viewer').nth(i);
    const scene = await drawnScene(viewer, texture);
    const means = await castPicture(scene, { ...size, samples: 144 });
    const errors = errorsOf(await pixels(viewer), means);
    expect(errors.rmse, what).toBeLessThan(rmse);
    expect(errors.within, what).toBeGreaterThan(within);
  }
});
