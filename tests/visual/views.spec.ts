// Do views show the quantities of the equation? Compared with float64 pixel by pixel, in 8-bit
// codes.

import { srgbEncode } from '../../src/phong/math/color.js';
import { map, type Vec3 } from '../../src/phong/math/vector.js';
import { VIEWS, type View } from '../../src/phong/material/views.js';
import { type LightShare, shade } from '../../src/phong/reference/index.js';
import { assign, settled } from '../element/support/viewer.js';
import { type ViewerLocator, expect, pixels, same, test } from '../support/test.js';
import { patch } from '../support/gltf.js';
import { firstOf, fullOr, repeats, SEED } from '../support/repeats.js';
import { compareWithReference } from './against-reference.js';
import { randomScene, sceneMarkup } from './random-scene.js';
import { cameraOf, type DeclaredScene } from './ray-cast.js';

const SIZE = { width: 60, height: 42 };

/** Views whose colour is a number of the fragment itself. */
const QUANTITIES = VIEWS.filter((view) => !['shaded', 'triangles'].includes(view));
const TERMS: readonly View[] = ['ambient', 'diffuse', 'specular'];

/** A view of a scene, against float64. `only`: the index of the light it is limited to. */
async function errorsOf(
  viewer: ViewerLocator,
  scene: DeclaredScene,
  view: View,
  only: number | null,
) {
  const name = only === null ? '' : `light ${String(only + 1)}`;
  await assign(viewer, { view, viewLight: name });
  const picture = await pixels(viewer, SIZE);
  const camera = cameraOf(scene);
  const isTerm = TERMS.includes(view);
  return compareWithReference(picture, scene, ({ p, mesh, shaded }) => {
    // A term's view shows that term whatever `terms` sums.
    const options = { ...scene.options, camera, ...(isTerm ? { terms: [view as 'ambient'] } : {}) };
    const explained = shade(
      { p, normal: shaded.N, eye: camera.eye },
      scene.meshes[mesh]!,
      scene.lights,
      options,
    );
    const shares = only === null ? explained.shares : [explained.shares[only]!];
    const color = viewColor(view, { N: explained.N, shares });
    return isTerm && scene.options.linear === true ? map(color, srgbEncode) : color;
  });
}

for (const [what, geometry, shading, scenes] of [
  ['random scenes on a plane', 'plane', 'phong', repeats(60)],
  ['random boxes in flat shading', 'box', 'flat', repeats(40)],
] as const) {
  test(`shows each quantity of ${what} within one code, seeds from ${SEED}`, async ({ mount }) => {
    test.setTimeout(1_800_000);
    const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
    let compared = 0;
    let exact = 0;
    for (let seed = SEED; seed < SEED + scenes; seed++) {
      const scene = randomScene(seed, geometry);
      const markup = sceneMarkup(scene, shading);
      await viewer.evaluate((element, text) => (element.outerHTML = text), markup);
      for (const view of QUANTITIES) {
        const both = [null, scene.lights.length - 1];
        const byTurns = (seed + QUANTITIES.indexOf(view)) % 2 === 0 ? both : both.toReversed();
        for (const only of view === 'normals' ? [null] : firstOf(byTurns, 1)) {
          const errors = await errorsOf(viewer, scene, view, only);
          compared += errors.compared;
          exact += errors.exact;
          const which = `seed ${seed}, ${view} of ${String(only)}: ${errors.at}\n${markup}`;
          expect.soft(errors.max, which).toBeLessThanOrEqual(1);
        }
      }
    }
    expect(compared).toBeGreaterThan(fullOr(5e4, 2e4));
    expect(exact / compared).toBeGreaterThan(0.98);
  });
}

/** Pixels of the grid whose neighbours show nearly the same, explained by shadeAt. */
interface Sample {
  readonly x: number;
  readonly y: number;
  readonly explained: Explained & { readonly triangle: number };
}

async function samplesOf(viewer: ViewerLocator, every: number) {
  return viewer.evaluate(
    async (element, { width, height, every: step }) => {
      const found: Sample[] = [];
      for (let y = 2; y < height - 2; y += step) {
        for (let x = 2; x < width - 2; x += step) {
          const at = (dx: number, dy: number) => element.shadeAt(x + dx + 0.5, y + dy + 0.5);
          const here = await at(0, 0);
          const around = await Promise.all([at(-1, 0), at(1, 0), at(0, -1), at(0, 1)]);
          if (!here || !around.every((other) => other?.triangle === here.triangle)) continue;
          const shares = here.shares.map((share) =>
            share === null ? null : { ...share, light: null },
          );
          found.push({ x, y, explained: { N: here.N, shares, triangle: here.triangle } });
        }
      }
      return found;
    },
    { ...SIZE, every },
  );
}

const file = patch({
  material: {
    emissiveFactor: [0.2, 0.1, 0],
    normalTexture: { index: 0, scale: 0.8 },
    pbrMetallicRoughness: {
      baseColorFactor: [0.9, 0.5, 0.2, 1],
      metallicFactor: 0.5,
      roughnessFactor: 0.6,
    },
  },
  textures: [[[128, 128, 255], [160, 140, 240], [100, 128, 250], [128, 90, 245]]], // oxfmt-ignore
});

const lights = `
  <phong-light name="off" active="false"></phong-light>
  <phong-light name="sun" position="1 2 3 0" ambient="20 30 25" diffuse="120 100 80" specular="90"></phong-light>
  <phong-light name="lamp" position="0.5 0.4 1.2 1" diffuse="0 60 60" specular="0" attenuation="1 0.3 0.1"></phong-light>
  <phong-light name="spot" space="camera" position="0.2 0.3 0 1" axis="0 -0.1 -1" aperture="14" cutoff="20" diffuse="0" ambient="30 0 0"></phong-light>`;

for (const shading of firstOf(['phong', 'gouraud', 'flat', 'blinn-phong'] as const, 2)) {
  test(`shows each quantity of a model with a normal map, metal and emission, ${shading}`, async ({
    mount,
  }) => {
    const style = shading === 'blinn-phong' ? 'reflection="blinn-phong"' : `shading="${shading}"`;
    const viewer = await mount(
      `<phong-viewer src="${file}" ${style} theta="20" phi="75" radius="3.5">${lights}</phong-viewer>`,
      SIZE,
    );
    const samples = await samplesOf(viewer, 2);
    expect(samples.length).toBeGreaterThan(80);
    const names = ['off', 'sun', 'lamp', 'spot'];
    for (const view of QUANTITIES) {
      for (const name of ['', 'spot', 'off']) {
        await assign(viewer, { view, viewLight: name });
        const { data } = await pixels(viewer, SIZE);
        let wrong = 0;
        for (const { x, y, explained } of samples) {
          const shares =
            name === '' ? explained.shares : explained.shares.filter((_, i) => names[i] === name);
          const expected = viewColor(view, { ...explained, shares });
          const at = 4 * (y * SIZE.width + x);
          const isRight = expected.every(
            (value, c) => Math.abs(data[at + c]! - Math.round(value * 255)) <= 1,
          );
          wrong += Number(!isRight);
        }
        // A pixel beside a cone's edge or a light's horizon may lie on either side of it.
        expect.soft(wrong / samples.length, `${view} of ${name}`).toBeLessThan(0.01);
      }
    }
  });
}

test('shadeAt explains the shaded picture in every view', async ({ mount }) => {
  const viewer = await mount(
    `<phong-viewer geometry="sphere" segments="8">${lights}</phong-viewer>`,
    SIZE,
  );
  const explain = () =>
    viewer.evaluate(async (element) =>
      JSON.stringify(
        { ...(await element.shadeAt(60, 40)), mesh: '', object: '' },
        (key, value: unknown) => (key === 'light' ? '' : value),
      ),
    );
  const before = await explain();
  for (const view of VIEWS) {
    await assign(viewer, { view });
    expect(await explain(), view).toBe(before);
    await settled(viewer);
    expect(await explain(), view).toBe(before);
  }
});

test('with a single light the shaded picture is that of the scene without the others', async ({
  mount,
}) => {
  const markup = `<phong-viewer src="${file}" theta="20" phi="75" radius="3.5">${lights}</phong-viewer>`;
  const viewer = await mount(markup, SIZE);
  await assign(viewer, { viewLight: 'lamp' });
  const alone = await pixels(viewer, SIZE);
  await assign(viewer, { viewLight: null });
  await viewer.evaluate((element) => {
    for (const light of element.lights) {
      if (light.name !== 'lamp') {
        light.remove();
      }
    }
  });
  same(alone, await pixels(viewer, SIZE));
});

test('gives every triangle a colour, between dark lines', async ({ mount }) => {
  const viewer = await mount(
    `<phong-viewer view="triangles" geometry="sphere" segments="7" radius="1.1">${lights}</phong-viewer>`,
    SIZE,
  );
  const samples = await samplesOf(viewer, 1);
  const { data } = await pixels(viewer, SIZE);
  const colors = new Map<number, Map<string, number>>();
  for (const { x, y, explained } of samples) {
    const at = 4 * (y * SIZE.width + x);
    const counts = colors.get(explained.triangle) ?? new Map<string, number>();
    const color = data.slice(at, at + 3).join();
    colors.set(explained.triangle, counts.set(color, (counts.get(color) ?? 0) + 1));
  }
  const most = [...colors.values()].map((counts) => [...counts].sort(([, a], [, b]) => b - a)[0]!);
  const large = most.filter(([, count]) => count >= 3).map(([color]) => color);
  expect(large.length).toBeGreaterThan(10);
  expect(new Set(large).size).toBe(large.length);
});

/** The part of a result that `shade` and `shadeAt` share. */
interface Explained {
  readonly N: Vec3;
  readonly shares: readonly (LightShare | null)[];
}

const grey = (value: number): Vec3 => [value, value, value];
const clamped = (value: number) => Math.min(Math.max(value, 0), 1);

/**
 * What a view must show of a fragment, 0–1, from the equation's own numbers in float64. `shares`
 * are those of the lights that the view is limited to; a view of one light takes the first active
 * one. Not for `shaded`, `triangles` and `error`. Without `linear`: sums are not encoded.
 */
function viewColor(view: View, { N, shares }: Explained): Vec3 {
  const active = shares.filter((share) => share !== null);
  const [first] = active;
  const sum = (term: 'ambient' | 'diffuse' | 'specular') =>
    [0, 1, 2].map((i) =>
      clamped(active.reduce((all, share) => all + share[term][i]!, 0)),
    ) as unknown as Vec3;
  switch (view) {
    case 'ambient':
    case 'diffuse':
    case 'specular':
      return sum(view);
    case 'normals':
      return [(N[0] + 1) / 2, (N[1] + 1) / 2, (N[2] + 1) / 2];
    case 'n-dot-l':
      return grey(clamped(first?.NoL ?? 0));
    case 'r-dot-v':
      return grey(first !== undefined && first.NoL > 0 ? clamped(first.RoV) : 0);
    case 'attenuation':
      return grey(first?.att ?? 0);
    case 'decay':
      return grey(first?.decay ?? 0);
    default:
      throw new Error(`no colour of a fragment: ${view}`);
  }
}
