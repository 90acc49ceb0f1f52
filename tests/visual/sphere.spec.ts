// How exact is a sphere's picture? Measures the error of the arithmetic, against the element's own triangles in
// float64, and the error of the tessellation, those triangles against a sphere. Random scenes; their seeds are printed.
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { length, subtract } from '../../src/math/vector.js';
import { expect, pixels, test } from '../support/test.js';
import { compareWithIdeal, compareWithTriangles, type TessellationErrors } from './against-triangles.js';
import { subpixelBitsOf } from './program-scenes.js';
import { Dice, randomScene, sceneMarkup } from './random-scene.js';
import type { DeclaredScene } from './ray-cast.js';

const SIZE = { width: 120, height: 84 };
/** For more or other scenes: PHONG_VIEWER_SCENES=500 PHONG_VIEWER_SEED=1000. */
const release = process.env['PHONG_VIEWER_RELEASE'] !== undefined;
const SCENES = Number(process.env['PHONG_VIEWER_SCENES'] ?? (release ? 300 : 12));
const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

const SHADINGS = ['phong', 'flat', 'gouraud'] as const;

/** The shape's own number among them, and as few as there can be: triangles as large as the picture. */
const FINENESS = [64, 3, 8, 16, 32, 128] as const;

/** Scenes of each shading. */
const EACH = Math.ceil(SCENES / SHADINGS.length);

test('shades a sphere within one code of its own triangles in float64', async ({ mount, page }) => {
  test.setTimeout(1_800_000);
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const subpixelBits = await subpixelBitsOf(page);
  expect(subpixelBits).toBeGreaterThanOrEqual(4); // what OpenGL ES promises
  for (const shading of SHADINGS) {
    const sum = { compared: 0, exact: 0, snapped: 0 };
    for (let seed = FIRST; seed < FIRST + EACH; seed++) {
      const base = randomScene(seed, 'sphere');
      const segments = new Dice(seed).pick(FINENESS);
      const mesh = { ...base.meshes[0]!, segments };
      const scene: DeclaredScene = { ...base, meshes: [mesh] };
      const markup = sceneMarkup(scene, shading);
      await viewer.evaluate((element, text) => (element.outerHTML = text), markup);
      const errors = compareWithTriangles(await pixels(viewer, SIZE), scene, shading, subpixelBits);
      expect.soft(errors.max, `seed ${seed}, ${errors.at}\n${markup}`).toBeLessThanOrEqual(1);
      sum.compared += errors.compared;
      sum.exact += errors.exact;
      sum.snapped += errors.snapped;
    }
    console.log(`${shading}, seeds ${FIRST} to ${FIRST + EACH - 1}: ${JSON.stringify(sum)}`);
    expect(sum.compared).toBeGreaterThan(1e4);
    expect(sum.exact / sum.compared).toBeGreaterThan(0.98);
    // Measured: 1.2e-4, where vertices lie on sixteenths of a pixel.
    expect(sum.snapped / sum.compared).toBeLessThan(3e-4);
  }
});

/** Far enough away for all of the sphere to lie before the eye. */
function fromOutside(scene: DeclaredScene): DeclaredScene {
  const [mesh] = scene.meshes;
  const reach =
    Math.max(...mesh!.scale.map(Math.abs)) / 2 + length(subtract(mesh!.position, scene.pose.target));
  return { ...scene, pose: { ...scene.pose, radius: Math.max(scene.pose.radius, 1.5 * reach) } };
}

test('approaches the ideal sphere with the square of its segments', ({}, testInfo) => {
  test.setTimeout(1_800_000);
  const scenes = Math.ceil(SCENES / 6);
  const levels = release ? [8, 16, 32, 64, 128, 256, 512] : [8, 16, 32, 64, 128];
  const table = levels.map((segments) => {
    const errors = Array.from({ length: scenes }, (_, i) =>
      compareWithIdeal(fromOutside(randomScene(FIRST + i, 'sphere')), segments, SIZE),
    );
    const mean = (of: (e: TessellationErrors) => number): number =>
      errors.reduce((sum, e) => sum + of(e), 0) / scenes;
    return {
      segments,
      rmse: Math.sqrt(mean((e) => e.rmse ** 2)),
      percentile999: mean((e) => e.percentile999),
      max: Math.max(...errors.map((e) => e.max)),
      medianNormalDegrees: mean((e) => e.medianNormal),
      outlineShare: mean((e) => e.outline / e.pixels),
    };
  });
  const figures = `${JSON.stringify({ first: FIRST, scenes, table }, null, 1)}\n`;
  writeFileSync(testInfo.outputPath('tessellation.json'), figures);
  // The report quotes these.
  if (process.env['UPDATE_PICTURES'] !== undefined)
    writeFileSync(fileURLToPath(new URL('tessellation.json', import.meta.url)), figures);
  console.log(figures);
  for (const [i, row] of table.entries()) {
    const before = table[i - 1];
    if (before === undefined) continue;
    // A chord's middle is π²/2n² of the radius below the arc, and the ray meets another normal there. Measured: 3.9 to
    // 4.0.
    const ratio = before.medianNormalDegrees / row.medianNormalDegrees;
    expect(ratio, `normals at ${row.segments} segments`).toBeGreaterThan(3.6);
    expect(ratio, `normals at ${row.segments} segments`).toBeLessThan(4.4);
    expect(row.rmse, `colours at ${row.segments} segments`).toBeLessThan(before.rmse);
  }
  // Cones' edges and the ends of highlights move by a share of a pixel and then jump: colours fall less regularly, by
  // more than half a doubling. Measured over 3 to 15 scenes: by 1.9 to 3.4 a doubling, on average.
  const [coarsest, finest] = [table[0]!, table.at(-1)!];
  expect(coarsest.rmse / finest.rmse).toBeGreaterThan(1.5 ** (table.length - 1));
});
