// Do whole pictures follow the equation? Random scenes on a plane, pixel by pixel against float64, by markup alone.
import { expect, type Mount, pixels, test, type Picture } from '../support/test.js';
import type { Vec3 } from '../../src/math/vector.js';
import { Dice, randomLight, randomScene, sceneMarkup } from './random-scene.js';
import { caster, type CastScene } from './ray-cast.js';

const SIZE = { width: 200, height: 140 };
/** Nearer to a cone's edge than this, in radians, a pixel may be on either side: the rasteriser snaps vertices. */
const CONE_EDGE = 3e-3;

interface Errors {
  /** Largest difference of a channel in 1/255, and where. */
  max: number;
  at: string;
  compared: number;
  exact: number;
}

/** Pixels whose neighbours all hit the same face: their insides are one sample each. */
function compareWithReference(picture: Picture, scene: CastScene): Errors {
  const { width, height } = picture;
  const cast = caster(scene, width, height);
  const hits = Array.from({ length: width * height }, (_, i) => cast(i % width, Math.floor(i / width)));
  const errors: Errors = { max: 0, at: '', compared: 0, exact: 0 };
  for (let y = 2; y < height - 2; y++) {
    for (let x = 2; x < width - 2; x++) {
      const hit = hits[y * width + x];
      const inside = [-2, 0, 2].every((dy) =>
        [-2, 0, 2].every((dx) => hits[(y + dy) * width + x + dx]?.face === hit?.face),
      );
      if (!hit || !inside || hit.coneMargin < CONE_EDGE) continue;
      for (let channel = 0; channel < 3; channel++) {
        const expected = Math.round(hit.shaded.color[channel]! * 255);
        const actual = picture.data[4 * (y * width + x) + channel]!;
        const error = Math.abs(expected - actual);
        errors.compared += 1;
        if (error === 0) errors.exact += 1;
        if (error > errors.max) {
          errors.max = error;
          errors.at = `pixel ${x}, ${y} channel ${channel}: ${actual} instead of ${hit.shaded.color[channel]! * 255}`;
        }
      }
    }
  }
  return errors;
}

/** More scenes, or others: PHONG_VIEWER_SCENES=500 PHONG_VIEWER_SEED=1000. */
const SCENES = Number(process.env['PHONG_VIEWER_SCENES'] ?? 30);
const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

async function holds(
  mount: Mount,
  geometry: 'plane' | 'box',
  scenes: number,
  shading = 'phong',
): Promise<void> {
  let compared = 0;
  let exact = 0;
  for (let seed = FIRST; seed < FIRST + scenes; seed++) {
    const scene = randomScene(seed, geometry);
    const markup = sceneMarkup(scene, shading);
    const viewer = await mount(markup, SIZE);
    const errors = compareWithReference(await pixels(viewer, SIZE), scene);
    compared += errors.compared;
    exact += errors.exact;
    expect.soft(errors.max, `seed ${seed}, ${errors.at}\n${markup}`).toBeLessThanOrEqual(1);
  }
  expect(compared).toBeGreaterThan(1e4);
  expect(exact / compared).toBeGreaterThan(0.98);
}

test('shades random scenes on a plane within one code of the equation in float64', async ({ mount }) => {
  test.setTimeout(600_000);
  await holds(mount, 'plane', SCENES);
});

test('shades random boxes, turned and mirrored, within one code', async ({ mount }) => {
  test.setTimeout(600_000);
  await holds(mount, 'box', Math.ceil(SCENES / 3));
});

test('shades flat faces with the triangles’ own normals within one code', async ({ mount }) => {
  test.setTimeout(600_000);
  await holds(mount, 'box', Math.ceil(SCENES / 6), 'flat');
});

test('sums as many lights as there are, more than any uniforms hold', async ({ mount }) => {
  test.setTimeout(120_000);
  const small = { width: 60, height: 42 };
  const scene = randomScene(4);
  const dice = new Dice(7);
  const lights = Array.from({ length: 400 }, () => {
    const light = randomLight(dice);
    // Dim, so that the sum stays in range; rounded, as an author would write it.
    const dim = (c: Vec3): Vec3 => [Math.round(c[0]) / 100, Math.round(c[1]) / 100, Math.round(c[2]) / 100];
    return {
      ...light,
      // No cones: so many would leave no pixel away from every edge.
      aperture: 180,
      ambient: dim(light.ambient),
      diffuse: dim(light.diffuse),
      specular: dim(light.specular),
    };
  });
  for (const count of [200, 400]) {
    const crowd: CastScene = { ...scene, lights: lights.slice(0, count) };
    const viewer = await mount(sceneMarkup(crowd), small);
    const errors = compareWithReference(await pixels(viewer, small), crowd);
    expect.soft(errors.max, `${count} lights, ${errors.at}`).toBeLessThanOrEqual(1);
    expect(errors.compared).toBeGreaterThan(1000);
  }
});
