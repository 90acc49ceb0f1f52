// Do the orbit's state and its basis match the definition eye = target + r(sinφ sinθ, cosφ, sinφ
// cosθ)? At poles and quarter turns too, and at doubles beside them, down to the smallest.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { wrapDegrees } from '../../../src/phong/math/angle.js';
import { basisOf, LARGEST_LENGTH, Orbit } from '../../../src/phong/camera/orbit.js';
import { eightDigits, writtenPose } from '../../../src/phong/camera/written-pose.js';
import { cross, dot, length, map, subtract } from '../../../src/phong/math/vector.js';
import { Dice } from '../../visual/random-scene.js';
import { repeats, SEED } from '../../support/repeats.js';
import { between } from '../arbitraries.js';

/** These angles, and what lies beside them by any power of ten. */
const beside = (...angles: readonly number[]) =>
  fc
    .tuple(fc.constantFrom(...angles), fc.integer({ min: -324, max: 0 }), fc.constantFrom(-1, 1))
    .map(([angle, power, sign]) => angle + sign * 10 ** power);
const anyTheta = fc.oneof(
  between(-720, 720),
  beside(-180, -90, -45, 0, 30, 90, 180, 270, 3600),
  fc.constantFrom(1e15, -1e300),
);
const anyPhi = fc.oneof(
  between(0, 180),
  beside(0, 45, 90, 135, 180).map((phi) => Math.min(Math.max(phi, 0), 180)),
);

describe('the basis', () => {
  it.each([
    [-90, 90, [0, 0, 1], [0, 1, 0], [-1, 0, 0]],
    [0, 0, [1, 0, 0], [0, 0, -1], [0, 1, 0]],
    [180, 0, [-1, 0, 0], [0, 0, 1], [0, 1, 0]],
    [-3600, 180, [1, 0, 0], [0, 0, 1], [0, -1, 0]],
  ])('consists of 0 and ±1, without -0, at θ = %d, φ = %d', (theta, phi, right, up, back) => {
    const basis = new Orbit({ theta, phi }).basis();
    expect(basis).toStrictEqual({ right, up, back });
  });

  it('is orthonormal and right-handed to two roundings, and changes no more than φ does', () => {
    fc.assert(
      fc.property(anyTheta, anyPhi, anyPhi, (theta, phi, other) => {
        const { right, up, back } = basisOf({ theta, phi });
        const there = basisOf({ theta, phi: other });
        const off = [
          dot(right, right) - 1,
          dot(up, up) - 1,
          dot(back, back) - 1,
          dot(back, right),
          length(subtract(cross(back, right), up)),
        ];
        expect(Math.max(...off.map(Math.abs))).toBeLessThanOrEqual(1e-15);
        const travel = [
          subtract(there.right, right),
          subtract(there.up, up),
          subtract(there.back, back),
        ].map(length);
        // Rounding of both.
        const most = (Math.PI / 180) * Math.abs(phi - other) + 4 * Number.EPSILON;
        expect(Math.max(...travel)).toBeLessThanOrEqual(most);
      }),
      { numRuns: repeats(1e5) },
    );
  });

  it('keeps the eye off the axis near a pole, however small the polar angle is', () => {
    for (let phi = 1e-9; phi > 0; phi /= 10) {
      expect(basisOf({ theta: 90, phi }).back.slice(0, 2)).toStrictEqual([
        phi * (Math.PI / 180),
        1,
      ]);
    }
  });
});

describe('the eye', () => {
  it('lies at its definition', () => {
    const theta = between(-360, 360);
    fc.assert(
      fc.property(theta, anyPhi, between(1e-3, 1e3), (theta, phi, radius) => {
        const [t, p] = [(theta * Math.PI) / 180, (phi * Math.PI) / 180];
        const back = [Math.sin(p) * Math.sin(t), Math.cos(p), Math.sin(p) * Math.cos(t)];
        const eye = new Orbit({ theta, phi, radius, target: [1, 2, 3] }).eye();
        const off = back.map((x, i) => Math.abs(eye[i]! - (i + 1 + radius * x)));
        expect(Math.max(...off)).toBeLessThan(1e-14 * (radius + 10));
      }),
    );
  });

  it('keeps its offset from a target far away, where the eye itself is rounded, in the given array', () => {
    const out: [number, number, number] = [9, 9, 9];
    const orbit = new Orbit({ theta: 0, phi: 90, radius: 1e-3, target: [0, 0, 1e15] });
    expect(orbit.eye(out)).toBe(out);
    expect(orbit.offset(out)).toBe(out);
    expect(out).toStrictEqual([0, 0, 1e-3]);
  });
});

describe('setting', () => {
  it('counts changes only', () => {
    const orbit = new Orbit({ theta: 29 });
    orbit.set({});
    orbit.set({ theta: 29, target: [0, -0, 0] });
    expect(orbit.version).toBe(0);
    orbit.set({ target: [0, 0, 1] });
    expect(orbit.version).toBe(1);
    orbit.set({ theta: 32, phi: 10, radius: 3, target: [1, 1, 1] });
    expect(orbit.version).toBe(2);
    const { target } = orbit;
    orbit.set({ target: [1, 1, 1] });
    expect(orbit.target).toBe(target);
  });

  it('does not wrap θ; clamps φ, large radii and coordinates', () => {
    const orbit = new Orbit({ theta: 750, phi: -3, radius: 1e20, target: [1e300, -1e16, 2] });
    const target = [LARGEST_LENGTH, -LARGEST_LENGTH, 2];
    expect(orbit.pose).toStrictEqual({ theta: 750, phi: 0, radius: LARGEST_LENGTH, target });
    orbit.set({ phi: 181 });
    expect(orbit.phi).toBe(180);
    const zero = new Orbit({ theta: -0, phi: -0, radius: 1, target: [-0, 1, -0] });
    expect(zero.pose).toStrictEqual({ theta: 0, phi: 0, radius: 1, target: [0, 1, 0] });
  });

  it.each([
    { theta: NaN },
    { phi: Infinity },
    { radius: 0 },
    { radius: -1 },
    { radius: Infinity },
    { target: [0, NaN, 0] as const },
  ])('refuses %o and changes nothing', (change) => {
    const orbit = new Orbit();
    const before = orbit.pose;
    const refusal = {
      name: 'RangeError',
      message: expect.stringMatching(/^a camera needs .*finite/) as string,
    };
    expect(() => orbit.set({ theta: 1, ...change })).toThrow(expect.objectContaining(refusal));
    expect(orbit.pose).toBe(before);
  });

  it('returns poses that later changes do not affect', () => {
    const orbit = new Orbit();
    const { pose } = orbit;
    expect(orbit.pose).toBe(pose);
    orbit.set({ theta: 1, target: [1, 2, 3] });
    expect(pose.theta).toBe(30);
    expect(Object.isFrozen(pose) && Object.isFrozen(orbit.target)).toBe(true);
  });
});

it(`writes a pose once: what is written is written the same again (seed ${SEED})`, () => {
  const dice = new Dice(SEED);
  for (let i = 0; i < 2000; i++) {
    const scale = 10 ** dice.from(-6, 6);
    const pose = {
      theta: dice.from(-1e3, 1e3) * Math.PI,
      phi: dice.from(0, 180) * (1 - 1e-9 * Math.PI),
      radius: dice.chance(0.2) ? 9.999999999 * scale : dice.from(0.1, 10) * scale * Math.E,
      target: map(dice.vector(-1, 1), (x) => x * scale * Math.E),
    };
    const once = writtenPose(pose);
    expect(writtenPose(once)).toEqual(once);
    expect(once.theta).toBeCloseTo(wrapDegrees(pose.theta), 4);
    expect(Math.abs(once.radius / pose.radius - 1)).toBeLessThan(1e-7);
  }
  expect(writtenPose({ theta: 179.9999999999, phi: 90, radius: 1, target: [0, 0, 0] }).theta).toBe(
    -180,
  );
});

it("a written number has eight digits from its own first one or the radius's, whichever is smaller", () => {
  const x = 1.23456789012;
  expect(eightDigits(x, 4)).toBe(1.2345679);
  expect(eightDigits(x * 1e3, 4)).toBe(1234.5678901);
  expect(eightDigits(x, 4e6)).toBe(1.2345679);
  expect(eightDigits(x * 1e-3, 4e-3)).toBe(0.0012345679);
  expect([0, -0].map((zero) => eightDigits(zero, 1))).toEqual([0, 0]);
});
