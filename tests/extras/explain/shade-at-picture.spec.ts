// Does shadeAt explain the drawn colours? Compares fragments inside triangles with the pixels of
// toBlob, in 8-bit codes.

import type { Vec3 } from '../../../src/phong/math/vector.js';
import { readFileSync } from 'node:fs';
import { expect as equationExpect } from '../../support/built-playwright.js';
import { patch, type Texel } from '../../support/gltf.js';
import { firstOf, fullOr, SEED } from '../../support/repeats.js';
import { expect, pixelAt, pixels, test } from '../../support/test.js';
import { randomScene, sceneMarkup } from '../../visual/random-scene.js';
import { comparedWithPicture, type Compared, errorOf, isClear, show } from './shade-at-support.js';
import { assign, cameraOf } from '../../element/support/viewer.js';

const SIZE = { width: 160, height: 120 };
/** For more or other scenes: PHONG_VIEWER_SCENES=100 PHONG_VIEWER_SEED=1000. */
const SCENES = Number(process.env['PHONG_VIEWER_SCENES'] ?? fullOr(4, 2));

class Tally {
  max = 0;
  worst = '';
  channels = 0;
  exact = 0;

  /** Channels whose explained colour rounds to the drawn code count as exact. */
  add(compared: readonly Compared[], what: string): void {
    for (const fragment of compared.filter(isClear)) {
      const { drawn, explained } = fragment;
      this.channels += 3;
      this.exact += explained.filter((x, channel) => Math.round(x) === drawn[channel]).length;
      const error = errorOf(fragment);
      const max = Math.max(this.max, error); // keeps NaN
      if (!Object.is(max, this.max)) {
        this.worst = `${what}: ${JSON.stringify(fragment)}`;
      }
      this.max = max;
    }
  }
}

test.describe('shadeAt explains the picture', () => {
  test('within one code on random scenes of every shape and shading, at the origin and far away', async ({
    mount,
  }) => {
    test.setTimeout(1_800_000);
    const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
    const tally = new Tally();
    for (const geometry of ['plane', 'box', 'sphere', 'torus'] as const) {
      for (const [i, shading] of ['phong', 'flat', 'gouraud'].entries()) {
        for (let seed = SEED + i; seed < SEED + 3 * SCENES; seed += 3) {
          const scene = randomScene(seed, geometry === 'torus' ? 'sphere' : geometry);
          const far = seed % 2 === 0 ? ([1e6, -3e6, 2e6] as const) : ([0, 0, 0] as const);
          const sphere = sceneMarkup(moved(scene, far), shading);
          const markup = sphere.replace('geometry="sphere"', `geometry="${geometry}"`);
          await show(viewer, markup);
          tally.add(await comparedWithPicture(viewer, 15), `seed ${seed}, ${markup}`);
        }
      }
    }
    expect(tally.max, tally.worst).toBeLessThanOrEqual(1);
    // The rest lies next to a half, within what float32 rounds: 0.15 % of the channels of 360
    // scenes.
    expect(tally.exact / tally.channels).toBeGreaterThan(0.995);
    expect(tally.channels).toBeGreaterThan(3 * fullOr(500, 300));
  });

  test('within one code on a model, stretched shapes, inside, behind others, on dense screens', async ({
    mount,
  }) => {
    const lights = `<phong-light position="0.3 0.8 0.6 1" ambient="40 30 20" diffuse="150" specular="120"></phong-light>
      <phong-light space="camera" position="0.5 0.5 0 1" axis="0 0 -1" cutoff="3" diffuse="60 90 40" specular="0"></phong-light>`;
    const viewer = await mount('<phong-viewer></phong-viewer>', {
      width: 40,
      height: 30,
      deviceScaleFactor: 2,
    });
    const scenes = [
      '<phong-mesh geometry="box" scale="2 0 2"></phong-mesh>',
      '<phong-mesh geometry="box"></phong-mesh><phong-mesh geometry="cone" segments="7" position="0 0.6 0.9"></phong-mesh>',
      '<phong-mesh geometry="plane" scale="2 1e12 -2"></phong-mesh>',
      '<phong-mesh geometry="sphere" segments="9" scale="9 9 -9"></phong-mesh>',
    ];
    const pixels = fullOr(1e4, 300);
    for (const meshes of firstOf(scenes, 2)) {
      await show(
        viewer,
        `<phong-viewer radius="3" target="0 0 0">${meshes}${lights}</phong-viewer>`,
      );
      await equationExpect(viewer, meshes).toShowTheEquation({ share: 0.2, pixels });
    }
    const bunny = '/assets/models/bunny.glb';
    await show(viewer, `<phong-viewer src="${bunny}" shininess="60">${lights}</phong-viewer>`);
    // Close by, so that triangles are larger than a few pixels.
    await assign(viewer, { radius: (await cameraOf(viewer)).radius / 4 });
    await equationExpect(viewer).toShowTheEquation({ share: 0.1, pixels });
  });

  test('within one code on textures, filtered, wrapped and moved, and on vertex colours', async ({
    mount,
  }) => {
    const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
    const tally = new Tally();
    const blended: number[] = [];
    for (const magFilter of [NEAREST, LINEAR]) {
      for (const wrap of [MIRRORED, CLAMPED]) {
        for (const alphaMode of ['OPAQUE', 'BLEND']) {
          const interpolation = alphaMode === 'OPAQUE' ? 'linear' : 'srgb';
          const markup = model(texturedModel(magFilter, wrap, alphaMode), interpolation);
          await show(viewer, markup);
          const compared = await comparedWithPicture(viewer, 10);
          if (alphaMode === 'OPAQUE') {
            tally.add(compared, markup);
          } else {
            blended.push(...compared.map(blendedError));
          }
        }
      }
    }
    await show(viewer, model('/fixtures/models/vertex-colours.glb'));
    tally.add(await comparedWithPicture(viewer, 10), 'vertex colours');
    expect(tally.max, tally.worst).toBeLessThanOrEqual(1);
    expect(tally.channels).toBeGreaterThan(3 * 500);
    expect(blended.length).toBeGreaterThan(50);
    expect(Math.max(...blended)).toBeLessThan(1);
  });

  test('within one code, or says that the picture averages a texture, at every size of it', async ({
    mount,
  }) => {
    const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
    const columns = (size: number): Texel[] =>
      Array.from({ length: size * size }, (_, i) => (i % 2 === 0 ? [255, 255, 255] : [0, 0, 0]));
    const noise = (size: number): Texel[] =>
      Array.from({ length: size * size }, (_, i) => [
        (i * 37) % 256,
        (i * 91) % 256,
        (i * 53) % 256,
      ]);
    const pbrMetallicRoughness = { metallicFactor: 0, baseColorTexture: { index: 0 } };
    /** The square's edge is 64 pixels wide at this distance. */
    const radius = 120 / 64 / Math.tan(Math.PI / 8);
    const shown = async (texels: Texel[], attributes: string) => {
      const src = patch({ material: { pbrMetallicRoughness }, textures: [texels], mipmaps: true });
      await show(
        viewer,
        `<phong-viewer src="${src}" target="0 0 0.27" ${attributes}>${AMBIENT}</phong-viewer>`,
      );
      const all = await comparedWithPicture(viewer, 3);
      // A sixteenth of a pixel changes a steep texture by more than a code.
      const excess = ({ drawn, explained, steepness }: Compared) =>
        Math.max(...explained.map((x, i) => Math.abs(Math.round(x) - drawn[i]!))) - steepness / 16;
      const [filtered, others] = [true, false].map((is) =>
        all.filter((here) => here.filtered === is).map(excess),
      );
      return { filtered: filtered!, others: others! };
    };
    const half = await shown(columns(64), `theta="0" phi="90" radius="${2 * radius}"`);
    expect(half.others, 'two texels a pixel').toEqual([]);
    expect(half.filtered.filter((x) => x > 1).length).toBeGreaterThan(50);
    const near = await shown(noise(16), `theta="0" phi="90" radius="${radius}"`);
    expect(near.filtered, 'four pixels a texel').toEqual([]);
    const slanted = await shown(noise(64), `theta="62" phi="70" radius="${radius / 2.5}"`);
    expect(
      Math.min(slanted.filtered.length, slanted.others.length),
      'both in one picture',
    ).toBeGreaterThan(30);
    expect(Math.max(...near.others, ...slanted.others)).toBeLessThanOrEqual(1);
    // The picture may keep what a mask cuts out of its largest level, and the other way round.
    const holes = columns(64).map(([c]): Texel => [c, c, c, c]);
    const src = patch({
      material: { alphaMode: 'MASK', pbrMetallicRoughness },
      textures: [holes],
      mipmaps: true,
    });
    await show(
      viewer,
      `<phong-viewer target="0 0 0.27" theta="0" phi="90" radius="${2 * radius}"><phong-mesh src="${src}"></phong-mesh>
         <phong-mesh geometry="box" scale="3" position="0 0 -3"></phong-mesh>${AMBIENT}</phong-viewer>`,
    );
    const seen = await viewer.evaluate(async (element) => {
      const found: string[] = [];
      for (let x = 70; x < 90; x++) {
        const fragment = await element.shadeAt(x, 60);
        found.push(`${fragment!.object.geometry.type} ${fragment!.filtered}`);
      }
      return [...new Set(found)].sort();
    });
    expect(seen).toEqual(['BoxGeometry true', 'BufferGeometry true']);
  });

  test('by hitting nothing where a mask is transparent', async ({ mount }) => {
    const viewer = await mount(model(texturedModel(LINEAR, MIRRORED, 'MASK')), SIZE);
    const picture = await pixels(viewer);
    const found = await viewer.evaluate(async (element) => {
      const places: (readonly [x: number, y: number, isHit: boolean])[] = [];
      for (let y = 3; y < 120; y += 4) {
        for (let x = 3; x < 160; x += 4) {
          places.push([x, y, (await element.shadeAt(x, y)) !== null]);
        }
      }
      return places;
    });
    const wrong = found.filter(([x, y, isHit]) => pixelAt(picture, x, y)[3] === (isHit ? 0 : 255));
    expect(wrong).toEqual([]);
    const hits = found.filter(([, , isHit]) => isHit).length;
    expect(Math.min(hits, found.length - hits)).toBeGreaterThan(200);
  });
});

const AMBIENT =
  '<phong-light position="0 0 1 0" ambient="255" diffuse="0" specular="0"></phong-light>';

// glTF's numbers, which are OpenGL's.
const [NEAREST, LINEAR] = [9728, 9729];
/** Along u and v: repeated and mirrored, clamped and repeated. */
const MIRRORED = { wrapS: 10497, wrapT: 33648 };
const CLAMPED = { wrapS: 33071, wrapT: 10497 };

/** A square with a texture of 2 × 2 texels, one of them half transparent, as a data: address. */
function texturedModel(magFilter: number, wrap: typeof MIRRORED, alphaMode: string) {
  const file = new URL('../../fixtures/models/data-uris.gltf', import.meta.url);
  const document = JSON.parse(readFileSync(file, 'utf8')) as Record<string, unknown>;
  document['samplers'] = [{ magFilter, minFilter: magFilter, ...wrap }];
  document['extensionsUsed'] = ['KHR_texture_transform'];
  const transform = { offset: [0.13, -0.4], scale: [1.7, 1.3], rotation: 0.4 };
  document['materials'] = [
    {
      alphaMode,
      alphaCutoff: 0.7,
      pbrMetallicRoughness: {
        baseColorFactor: [0.9, 0.7, 1, 0.95],
        baseColorTexture: { index: 0, extensions: { KHR_texture_transform: transform } },
      },
    },
  ];
  return `data:model/gltf+json,${encodeURIComponent(JSON.stringify(document))}`;
}

const model = (src: string, interpolation = 'srgb') =>
  `<phong-viewer src="${src}" color-interpolation="${interpolation}" theta="20" phi="75" radius="1.1">
     <phong-light position="0.3 0.3 1 1" ambient="60" specular="40"></phong-light>
   </phong-viewer>`;

/**
 * How far a blended pixel is off, in units of what it can say: 8 bits are multiplied by alpha,
 * rounded, divided and rounded again. Alpha itself is off by no more than a code.
 */
function blendedError({ drawn, explained, opacity }: Compared) {
  const alpha = drawn[3]!;
  const off = Math.max(
    ...[0, 1, 2].map((channel) => Math.abs(explained[channel]! - drawn[channel]!)),
  );
  return Math.max(off / (1 + 255 / alpha), Math.abs(alpha - opacity * 255));
}

type Scene = ReturnType<typeof randomScene>;

/** The same scene elsewhere. */
function moved(scene: Scene, by: Vec3): Scene {
  const shift = (v: Vec3): Vec3 => [v[0] + by[0], v[1] + by[1], v[2] + by[2]];
  return {
    ...scene,
    pose: { ...scene.pose, target: shift(scene.pose.target) },
    meshes: scene.meshes.map((mesh) => ({ ...mesh, position: shift(mesh.position) })),
    lights: scene.lights.map((light) => {
      const [x, y, z, w] = light.position;
      if (w === 0 || light.space === 'camera') return light;
      return { ...light, position: [...shift([x, y, z]), w] };
    }),
  };
}
