// Is the picture of `antialias="full"` the mean, over each pixel's square, of what the equation writes there? Against a
// float64 ray caster with 1,024 samples per pixel on the same triangles.

import type { Locator } from '@playwright/test';
import { LIGHT_FIELDS, type LightValues } from '../../src/light/light-state.js';
import { cross, normalize, subtract } from '../../src/math/vector.js';
import { expect, pixels, test, type Picture } from '../support/test.js';
import { assign, type PhongViewer, settled } from '../element/support/viewer.js';
import { type DrawnMesh, type DrawnScene, pixelMeans } from './pixel-means.js';

const lights = `<phong-light position="1 2 3 0" ambient="30 30 40"></phong-light>
  <phong-light position="-2 1 2 1" diffuse="120 80 60"></phong-light>`;

/** What the viewer draws: its shapes' triangles, its camera and its lights. */
async function sceneOf(viewer: Locator): Promise<DrawnScene> {
  const {
    meshes,
    lights: values,
    camera,
    fov,
  } = await viewer.evaluate((element: PhongViewer, keys) => {
    const drawn: DrawnMesh[] = [];
    element.scene.traverse((object) => {
      const { geometry, material } = object as unknown as Partial<{
        geometry: { attributes: Record<string, { array: Float32Array }>; index: { array: Uint16Array } };
        material: { surface: DrawnMesh['surface'] };
      }>;
      if (geometry === undefined || material === undefined) return;
      drawn.push({
        positions: [...geometry.attributes['position']!.array],
        normals: [...geometry.attributes['normal']!.array],
        index: [...geometry.index.array],
        matrix: [...object.matrixWorld.elements],
        surface: { ...material.surface },
      });
    });
    return {
      meshes: drawn,
      lights: element.lights.map((light) =>
        Object.fromEntries(keys.map((key) => [key, Reflect.get(light, key) as unknown])),
      ),
      camera: { ...element.camera },
      fov: element.fov,
    };
  }, Object.keys(LIGHT_FIELDS));
  const { eye, target, up } = camera;
  const back = normalize(subtract(eye, target));
  return { meshes, eye, up, back, right: cross(up, back), fov, lights: values as unknown as LightValues[] };
}

/** Premultiplied, as the canvas has it. */
function errorsOf({ data }: Picture, means: Float64Array): { rmse: number; within: number } {
  let squares = 0;
  let within = 0;
  for (let i = 0; i < data.length; i += 4) {
    const errors = [0, 1, 2].map((k) => Math.round((data[i + k]! * data[i + 3]!) / 255) - means[i + k]!);
    squares += errors.reduce((sum, error) => sum + error ** 2, 0);
    if (errors.every((error) => Math.abs(error) <= 1)) within += 1;
  }
  return { rmse: Math.sqrt(squares / (0.75 * data.length)), within: within / (data.length / 4) };
}

test('a torus converges to the exact mean over each pixel', async ({ mount }) => {
  const size = { width: 60, height: 45 };
  const viewer = await mount(
    `<phong-viewer alt="" geometry="torus" segments="32" phi="60">${lights}</phong-viewer>`,
    size,
  );
  const means = pixelMeans(await sceneOf(viewer), size.width, size.height);
  const plain = errorsOf(await pixels(viewer), means);
  await assign(viewer, { antialias: 'full' });
  await settled(viewer);
  const full = errorsOf(await pixels(viewer), means);
  expect(full.rmse).toBeLessThan(plain.rmse / 4);
  expect(full.within).toBeGreaterThan(plain.within);
});
