// Random scenes of low eyes over large faces, with lamps as near as the eye is.
import type { LightValues } from '../../src/light/light-state.js';
import type { Vec3 } from '../../src/math/vector.js';
import { Dice, randomLight } from './random-scene.js';
import type { CastMesh, DeclaredScene } from './ray-cast.js';

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
    attenuation: dice.pick([
      [1, 0.2, 0.3],
      [1, 0, 1],
      [1, 0.5, 0],
    ] as const),
    space: 'world',
  };
}

/**
 * A face `side` units large, seen from `phi` degrees; the eye and the lamps are as far from each other as in a room.
 */
export function floorScene(
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
