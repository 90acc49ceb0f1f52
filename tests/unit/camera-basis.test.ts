// Is the camera's basis orthonormal wherever the eye can be? Random angles, a million in a release run, and the quarter
// turns with the doubles that lie beside them, down to the smallest. How it is defined is tested with the orbit.

import { describe, expect, it } from 'vitest';
import { type Basis, basisOf, newBasis } from '../../src/camera/orbit.js';
import { cross, dot } from '../../src/math/vector.js';
import { repeats } from '../support/repeats.js';
import { seeded } from '../visual/random-scene.js';

const SEED = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

/** How far the basis is from being orthonormal and right-handed: the largest entry of what should be zero. */
function defect({ right, up, back }: Basis): number {
  let worst = Math.max(Math.abs(dot(right, up)), Math.abs(dot(up, back)), Math.abs(dot(back, right)));
  for (const axis of [right, up, back]) worst = Math.max(worst, Math.abs(dot(axis, axis) - 1));
  const [x, y, z] = cross(back, right);
  return Math.max(worst, Math.abs(x - up[0]), Math.abs(y - up[1]), Math.abs(z - up[2]));
}

/** `where` completes the message of a failure. */
function expectOrthonormal(angles: Iterable<{ theta: number; phi: number }>, where = ''): void {
  const basis = newBasis();
  const worst = { defect: 0, theta: 0, phi: 0 };
  for (const { theta, phi } of angles) {
    const d = defect(basisOf({ theta, phi }, basis));
    if (d > worst.defect) Object.assign(worst, { defect: d, theta, phi });
  }
  // Measured: 4.4e-16, two roundings of 1.
  expect(worst.defect, `θ = ${worst.theta}, φ = ${worst.phi}${where}`).toBeLessThanOrEqual(1e-15);
}

/** The smallest double, the smallest normal one, and every power of ten between them and 1. */
const TINY = [5e-324, 2 ** -1022, ...Array.from({ length: 308 }, (_, i) => 10 ** -(i + 1))];

/** The angle itself and doubles on both sides of it, from the nearest one on. */
function around(angle: number): number[] {
  const ulp = 2 ** (Math.floor(Math.log2(Math.max(Math.abs(angle), 1))) - 52);
  const beside = [...TINY, ulp, 2 * ulp].flatMap((step) => [angle - step, angle + step]);
  return [...new Set([angle, ...beside])];
}

const RADIANS = Math.PI / 180;
const POLAR = [0, 45, 90, 135, 180].flatMap(around).filter((phi) => phi >= 0 && phi <= 180);
const AZIMUTHS = [...[-180, -90, -45, 0, 30, 90, 180, 270].flatMap(around), 3600, 1e15, -1e300];

describe('the basis', () => {
  const angles = repeats(1e6);
  it(`is orthonormal and right-handed to 1e-15 at ${angles} random angles (seed ${SEED})`, () => {
    const coarse = seeded(SEED);
    const next = (): number => coarse() + coarse() * 2 ** -32; // all the bits of a double
    function* randomAngles() {
      for (let i = 0; i < angles; i++) {
        const theta = 720 * (next() - 0.5);
        // One in four lies within a millionth of a degree of a pole, on a logarithmic scale.
        const fromPole = 10 ** (-6 - 14 * next());
        yield { theta, phi: i % 4 > 0 ? 180 * next() : i % 8 > 0 ? fromPole : 180 - fromPole };
      }
    }
    expectOrthonormal(randomAngles(), `, seed ${SEED}`);
  });

  it('is orthonormal at the poles, at quarter turns, and at angles off them by each power of ten', () => {
    expect(POLAR.length).toBeGreaterThan(300);
    expectOrthonormal(POLAR.flatMap((phi) => AZIMUTHS.map((theta) => ({ theta, phi }))));
  });

  it('changes no more than its angles do, even at a pole and across a quarter turn', () => {
    for (const theta of [0, 30, 90, -180]) {
      for (const middle of [0, 45, 90, 135, 180]) {
        const here = basisOf({ theta, phi: middle });
        for (const phi of around(middle).filter((p) => p >= 0 && p <= 180)) {
          const there = basisOf({ theta, phi });
          for (const axis of ['right', 'up', 'back'] as const) {
            const travel = Math.hypot(...there[axis].map((x, i) => x - here[axis][i]!));
            // Rounding of both.
            expect(travel).toBeLessThanOrEqual(RADIANS * Math.abs(phi - middle) + 4 * Number.EPSILON);
          }
        }
      }
    }
  });

  it('keeps the eye off the axis near a pole, however small the polar angle is', () => {
    for (const phi of TINY.filter((p) => p < 1e-8)) {
      const { back } = basisOf({ theta: 90, phi });
      expect(back[1]).toBe(1);
      expect(back[0]).toBe(phi * RADIANS);
    }
  });
});
