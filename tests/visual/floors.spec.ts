// Are large floors and walls right where the eye and the lamps are near? Against the equation at
// points of rays in float64.
import type { LightValues } from '../../src/phong/light/light-state.js';
import type { Vec3 } from '../../src/phong/math/vector.js';
import { firstOf, SEED } from '../support/repeats.js';
import { expect, pixels, test } from '../support/test.js';
import { compareWithReference, innerPixels } from './against-reference.js';
import { Dice, randomLight, sceneMarkup } from './random-scene.js';
import type { CastMesh, DeclaredScene } from './ray-cast.js';

const SIZE = { width: 96, height: 64 };

test('shades floors and walls up to 1,000 times as large as the eye is near', async ({ mount }) => {
  const scenes: readonly DeclaredScene[] = [
    floorScene(SEED, 30, 80),
    floorScene(SEED + 1, 100, 75),
    floorScene(SEED + 2, 1000, 60),
    floorScene(SEED + 3, 0, 70, { rotation: [0, 40, 8], scale: [-200, 1, 300] }),
    floorScene(SEED + 4, 500, 65, { geometry: 'box' }),
  ];
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const holes: string[] = [];
  let off = 0;
  let compared = 0;
  for (const [i, scene] of scenes.entries()) {
    await viewer.evaluate((element, text) => (element.outerHTML = text), sceneMarkup(scene));
    const { data, width, height } = await pixels(viewer, SIZE);
    for (const { x, y, hit } of innerPixels(scene, width, height, 1)) {
      const at = 4 * (y * width + x);
      if (data[at + 3] !== 255) {
        holes.push(`seed ${SEED + i}: ${x}, ${y}`);
      }
      hit.shaded.color.forEach((value, channel) => {
        compared += 1;
        if (!(Math.abs(Math.round(255 * value) - data[at + channel]!) <= 1)) {
          off += 1;
        }
      });
    }
  }
  expect(holes).toEqual([]);
  expect(compared).toBeGreaterThan(2000 * scenes.length);
  // Of a floor of one segment 34 % are, at 1,000.
  expect(off / compared).toBeLessThan(0.001);
});

test('shades floors seen edge-on, wherever the eye stands on them', async ({ mount }) => {
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const wrong: string[] = [];
  let compared = 0;
  const size = { width: 192, height: 128 };
  // Cut into 64 segments, those of seeds 24 and 28 are wrong, by up to 60 codes.
  const scenes = firstOf([23, 27, 16, 17, 18, 19, 20, 21, 22, 24, 25, 26], 4);
  for (const i of scenes) {
    const scene = edgeOn(SEED + i, [10, 30, 100, 1000][i % 4]!);
    await viewer.evaluate((element, text) => (element.outerHTML = text), sceneMarkup(scene));
    const errors = compareWithReference(await pixels(viewer, size), scene);
    compared += errors.compared;
    if (!(errors.max <= 1)) {
      wrong.push(`seed ${SEED + i}: ${errors.max} codes, ${errors.at}`);
    }
  }
  expect(compared).toBeGreaterThan(25_000 * scenes.length);
  expect(wrong).toEqual([]);
});

/** A lamp or a spot near the target, that reaches a few units far. */
function lamp(dice: Dice, height: number): LightValues {
  const place: Vec3 = [dice.from(-2, 2), height * dice.from(0.3, 3), dice.from(-2, 2)];
  const spot = dice.chance(0.4);
  return {
    ...randomLight(dice),
    active: true,
    position: [...place, 1],
    axis: spot ? [dice.from(-1, 1), -1, dice.from(-1, 1)] : [0, 0, -1],
    aperture: spot ? dice.pick([20, 45, 80]) : 180,
    cutoff: spot ? dice.pick([0, 1, 4, 20]) : 0,
    attenuation: dice.pick([[1, 0.2, 0.3], [1, 0, 1], [1, 0.5, 0]] as const), // oxfmt-ignore
    space: 'world',
  };
}

/** An eye 0.05 above a floor, anywhere on it, near the lamps. */
function edgeOn(seed: number, side: number): DeclaredScene {
  const dice = new Dice(seed);
  const scene = floorScene(seed, side, 90);
  const target: Vec3 = [dice.from(-0.4, 0.4) * side, 0, dice.from(-0.4, 0.4) * side];
  const { pose, lights } = scene;
  return {
    ...scene,
    pose: { ...pose, phi: (Math.acos(0.05 / pose.radius) * 180) / Math.PI, target },
    lights: lights.map((light) => {
      const [x, y, z] = light.position;
      return { ...light, position: [x + target[0], y, z + target[2], 1] };
    }),
  };
}

/**
 * A face `side` units large, seen from `phi` degrees; the eye and the lamps are as far from each
 * other as in a room.
 */
function floorScene(
  seed: number,
  side: number,
  phi: number,
  mesh: Partial<CastMesh> = {},
): DeclaredScene {
  const dice = new Dice(seed);
  const scale: Vec3 = [side, mesh.geometry === 'box' ? dice.from(0.5, 2) : 1, side];
  const radius = dice.from(2, 4);
  return {
    pose: {
      theta: dice.from(-180, 180),
      phi,
      radius,
      target: [0, mesh.geometry === 'box' ? scale[1] / 2 : 0, 0],
    },
    fov: dice.from(30, 60),
    meshes: [
      {
        geometry: 'plane',
        position: [0, 0, 0],
        rotation: [0, 0, 0],
        scale,
        ka: dice.color(255),
        kd: dice.color(255),
        ks: dice.color(255),
        shininess: dice.pick([1, 5, 32, 100]),
        ...mesh,
      },
    ],
    lights: [1, 2, 3].map(() => lamp(dice, 0.5)),
    options: {
      reflection: dice.chance(0.3) ? 'blinn-phong' : 'phong',
      terms: ['ambient', 'diffuse', 'specular'],
      linear: false,
    },
  };
}
