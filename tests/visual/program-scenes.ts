// Scenes that are drawn by two programs each: every look that has code of its own, and random ones.

import type { Page } from '@playwright/test';
import { expect } from '../support/test.js';
import type { LightValues } from '../../src/phong/light/light-state.js';
import { lightWith } from '../stress/case.js';
import { compareWithReference } from './against-reference.js';
import { compareWithTriangles } from './against-triangles.js';
import { A_PAGE, betweenPrograms, bothPictures, DifferenceSum } from './between-programs.js';
import { Dice, randomScene, sceneMarkup } from './random-scene.js';
import type { CastMesh, DeclaredScene } from './ray-cast.js';

export const SIZE = { width: 84, height: 60 };

// oxfmt-ignore
const LIGHTS: readonly LightValues[] = ([
  { ambient: [20, 25, 30], diffuse: [120, 110, 100], specular: [90, 90, 90], position: [1, 2, 1, 0] },
  { ambient: [5, 0, 0], diffuse: [90, 120, 160], specular: [120, 60, 60], position: [-1.5, 1.2, 1, 1],
    attenuation: [0.8, 0.1, 0.05] },
  { ambient: [0, 10, 0], diffuse: [160, 90, 60], specular: [80, 160, 80], position: [0.5, 2, 0.5, 1],
    axis: [-0.2, -1, -0.2], aperture: 35, cutoff: 3 },
] as const).map((light) => lightWith(light));

const SPHERE: CastMesh = {
  geometry: 'sphere',
  position: [0, 0, 0],
  rotation: [10, 20, 30],
  scale: [1.6, 1.6, 1.6],
  ka: [255, 255, 255],
  kd: [220, 200, 180],
  ks: [150, 150, 150],
  shininess: 32,
  segments: 16,
};

interface Look {
  readonly mesh?: Partial<CastMesh>;
  readonly shading?: 'phong' | 'gouraud' | 'flat';
  readonly options?: DeclaredScene['options'];
  readonly light?: Partial<LightValues>;
}

/**
 * Looks for which the code of general and specialised programs differs, one at a time; the last
 * eight stand for few.
 */
const LOOKS: Readonly<Record<string, Look>> = {
  'shininess 32': {},
  'shininess 33.5': { mesh: { shininess: 33.5 } },
  matte: { mesh: { ks: [0, 0, 0] } },
  'blinn-phong': { mesh: { geometry: 'box', segments: 1 }, options: { reflection: 'blinn-phong' } },
  gouraud: { shading: 'gouraud' },
  'gouraud, linear, blinn-phong': {
    shading: 'gouraud',
    options: { linear: true, reflection: 'blinn-phong' },
  },
  flat: { shading: 'flat' },
  linear: { options: { linear: true } },
  mirrored: { mesh: { scale: [-1.5, 1.7, 1.3] } },
  'diffuse alone': { options: { terms: ['diffuse'] } },
  'specular alone': { options: { terms: ['specular'] } },
  'no ambient': { options: { terms: ['diffuse', 'specular'] } },
  'a cone of more than a right angle': { light: { aperture: 120 } },
  'no cone, only decay': { light: { aperture: 180, cutoff: 7 } },
  'a cone without decay': { light: { cutoff: 0 } },
  'a spot of the camera': {
    light: { space: 'camera', position: [0.3, 0.3, 0, 1], axis: [0, 0, -1] },
  },
  'shininess 64, the last that is multiplied out': { mesh: { shininess: 64 } },
  'shininess 0': { mesh: { shininess: 0 } },
  'shininess 1': { mesh: { shininess: 1 } },
  'shininess 1e3': { mesh: { shininess: 1e3 } },
  'blinn-phong, shininess 200': {
    mesh: { shininess: 200 },
    options: { reflection: 'blinn-phong' },
  },
  'a cutoff of 64': { light: { cutoff: 64 } },
  'a cutoff that is not whole': { light: { cutoff: 2.5 } },
  'ambient alone': { options: { terms: ['ambient'] } },
};

/** A scene of three lights for each of {@link LOOKS}. */
export const lookScenes = (): DrawnScene[] =>
  Object.entries(LOOKS).map(([name, { mesh, shading = 'phong', options, light }]) => ({
    name,
    shading,
    scene: {
      pose: { theta: 25, phi: 55, radius: 3, target: [0, 0, 0] },
      fov: 45,
      meshes: [{ ...SPHERE, ...mesh }],
      lights: LIGHTS.map((one, i) => (i === 2 ? { ...one, ...light } : one)),
      options: {
        reflection: 'phong',
        terms: ['ambient', 'diffuse', 'specular'],
        linear: false,
        ...options,
      },
    },
  }));

/** The rasteriser's SUBPIXEL_BITS: vertices snap to this power of two of a pixel. */
const subpixelBitsOf = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl2');
    return Number(gl?.getParameter(gl.SUBPIXEL_BITS));
  });

/** A random scene of any shape that the reference can compute. */
export function drawnScene(seed: number): DrawnScene {
  const name = `seed ${seed}`;
  const dice = new Dice(seed);
  const geometry = dice.pick(['plane', 'box', 'sphere'] as const);
  const shading = dice.pick(['phong', 'phong', 'flat', 'gouraud'] as const);
  const scene = randomScene(seed, geometry);
  // The shape's own number among them, and as few as there can be: triangles as large as the
  // picture.
  const segments = dice.pick([3, 8, 16, 24, 64]);
  if (geometry !== 'sphere') {
    return { name, scene, shading: shading === 'gouraud' ? 'phong' : shading };
  }
  return {
    name,
    scene: { ...scene, meshes: scene.meshes.map((mesh) => ({ ...mesh, segments })) },
    shading,
  };
}

interface DrawnScene {
  readonly name: string;
  readonly scene: DeclaredScene;
  readonly shading: string;
}

/**
 * Draws scenes by general and specialised programs and compares both with each other and with
 * float64. `least`: channels of each picture that are compared with float64.
 */
export async function compareScenes(
  page: Page,
  scenes: readonly DrawnScene[],
  least = 0,
): Promise<Record<'compared' | 'exact' | 'snapped', number>> {
  const subpixelBits = await subpixelBitsOf(page);
  expect(subpixelBits).toBeGreaterThanOrEqual(4); // what OpenGL ES promises
  const sum = new DifferenceSum();
  const errors = { compared: 0, exact: 0, snapped: 0 };
  for (let from = 0; from < scenes.length; from += A_PAGE) {
    const drawn = scenes.slice(from, from + A_PAGE);
    const markups = drawn.map(({ scene, shading }) => sceneMarkup(scene, shading));
    const pictures = await bothPictures(page, markups, SIZE);
    for (const [i, { general, specialised }] of pictures.entries()) {
      const { name, scene, shading } = drawn[i]!;
      const difference = betweenPrograms(general, specialised);
      sum.add(difference);
      const which = `${name}\n${markups[i]!}`;
      expect.soft(difference.max, which).toBeLessThanOrEqual(1);
      for (const picture of [general, specialised]) {
        const found =
          scene.meshes[0]!.geometry === 'sphere'
            ? compareWithTriangles(picture, scene, shading, subpixelBits)
            : { ...compareWithReference(picture, scene), snapped: 0 };
        expect.soft(found.max, `${which}\n${found.at}`).toBeLessThanOrEqual(1);
        expect(found.compared, which).toBeGreaterThanOrEqual(least);
        errors.compared += found.compared;
        errors.exact += found.exact;
        errors.snapped += found.snapped;
      }
    }
  }
  const exactly = ((100 * errors.exact) / errors.compared).toFixed(2);
  console.log(
    `${scenes.length} scenes, two programs each: ${String(sum)}; ${errors.compared} against float64, ${exactly} % exact`,
  );
  sum.expectPromise();
  return errors;
}
