// Scenes that a near plane may cut: eyes just above floors, inside rooms, beside walls and boxes,
// many of them far larger than the distance of the eye.
import type { Vec3 } from '../../src/phong/math/vector.js';
import type { CoverageMesh, CoverageScene } from './coverage.js';
import { Dice } from './random-scene.js';

const VIEW = { theta: 30, phi: 70, radius: 3, target: [0, 0, 0], fov: 45 } as const;
const named = (
  name: string,
  change: Partial<CoverageScene>,
  ...meshes: CoverageMesh[]
): CoverageScene => ({
  ...VIEW,
  name,
  ...change,
  meshes,
});
const cube = (size: number): Vec3 => [size, size, size];

/** One of each kind. */
export const LOW_EYES: readonly CoverageScene[] = [
  named('a floor of 300 at phi 89', { phi: 89 }, { geometry: 'plane', scale: cube(300) }),
  named('a floor of 1000 at phi 89', { phi: 89 }, { geometry: 'plane', scale: cube(1000) }),
  named('a floor of 1000, mirrored', { phi: 89 }, { geometry: 'plane', scale: [-1000, 1, 1000] }),
  named('a floor of 300 from below', { phi: 91 }, { geometry: 'plane', scale: cube(300) }),
  named(
    'a floor of 1000 by a rotated wall, from below',
    { phi: 91 },
    { geometry: 'plane', scale: cube(1000) },
    { geometry: 'plane', scale: [-1000, 1, 400], rotation: [70, 20, 90], position: [3, 0, -4] },
  ),
  named('a floor of 1e5', {}, { geometry: 'plane', scale: cube(1e5) }),
  named('a floor of 1e6 at phi 89', { phi: 89 }, { geometry: 'plane', scale: cube(1e6) }),
  named('a box of 1e6 × 1 × 1', {}, { geometry: 'box', scale: [1e6, 1, 1] }),
  named(
    'a box of 1e6 × 1 × 1, mirrored',
    { theta: 0, phi: 45 },
    { geometry: 'box', scale: [-1e6, 1, 1] },
  ),
  named('inside a box of 1e6', { theta: 0, phi: 45 }, { geometry: 'box', scale: cube(1e6) }),
  named(
    'on a box of 1e6',
    { phi: 85 },
    { geometry: 'box', scale: cube(1e6), position: [0, -5e5, 0] },
  ),
  named('inside a sphere of 1e6', {}, { geometry: 'sphere', scale: cube(1e6) }),
  named(
    'an eye in the plane of a floor, before a box',
    { phi: 90 },
    { geometry: 'plane', scale: cube(1e4) },
    { geometry: 'box', scale: cube(1), position: [0, 0.6, 0] },
  ),
  named(
    'a wall beside the eye',
    { theta: 0, phi: 90, radius: 5 },
    { geometry: 'plane', scale: [2000, 1, 2000], rotation: [0, 0, 90], position: [0.01, 0, 0] },
    { geometry: 'box', scale: cube(3), position: [-4, 0, -9] },
  ),
];

/** Floors and boxes from 100 to 1e6, in both windings, seen from above and from below. */
export function floorsOfAllSizes(): readonly CoverageScene[] {
  return [100, 300, 1e3, 1e4, 1e5, 1e6].flatMap((size) =>
    [1, -1].flatMap((mirror) =>
      [70, 88, 89, 89.7, 90.1, 91, 100].flatMap((phi) => [
        named(
          `a floor of ${size * mirror} at phi ${phi}`,
          { phi },
          { geometry: 'plane', scale: [mirror * size, 1, size] },
        ),
        named(
          `a box of ${size * mirror} under the target at phi ${phi}`,
          { phi, theta: -70 },
          { geometry: 'box', scale: [size, mirror * size, size], position: [0, -size / 2, 0] },
        ),
      ]),
    ),
  );
}

/** A room with an eye in it, near one of its walls, and boxes and a floor in it. */
export function randomLowEye(seed: number): CoverageScene {
  const dice = new Dice(seed);
  const radius = 10 ** dice.from(-1, 1);
  const room = 10 ** dice.from(0.5, 3) * radius;
  const gap = 10 ** dice.from(-2, 0) * radius;
  const theta = dice.from(-180, 180);
  const phi = dice.pick([90, 89, 91, 60, 100, dice.from(1, 179)]);
  // The eye is `gap` above the floor or beside a wall of the room.
  const back: Vec3 = [
    Math.sin((phi * Math.PI) / 180) * Math.sin((theta * Math.PI) / 180),
    Math.cos((phi * Math.PI) / 180),
    Math.sin((phi * Math.PI) / 180) * Math.cos((theta * Math.PI) / 180),
  ];
  const side = dice.pick([0, 1, 2] as const);
  const eye = dice.vector(-0.3, 0.3).map((x) => x * room) as unknown as [number, number, number];
  eye[side] = gap - room / 2;
  const target: Vec3 = [
    eye[0] - radius * back[0],
    eye[1] - radius * back[1],
    eye[2] - radius * back[2],
  ];
  const mirror = dice.pick([1, -1]);
  const meshes: CoverageMesh[] = [{ geometry: 'box', scale: [mirror * room, room, room] }];
  if (dice.chance(0.5)) {
    meshes.push({ geometry: 'plane', scale: cube(room), position: [0, eye[1] - 2 * gap, 0] });
  }
  if (dice.chance(0.5)) {
    meshes.push({
      geometry: 'box',
      scale: cube(radius),
      position: target,
      rotation: dice.vector(-90, 90),
    });
  }
  return {
    name: `room of seed ${String(seed)}`,
    theta,
    phi,
    radius,
    target,
    fov: dice.from(20, 110),
    meshes,
  };
}
