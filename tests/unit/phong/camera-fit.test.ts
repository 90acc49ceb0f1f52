// Does the camera fit a scene's bounding sphere? The auto radius, the zoom limits, near and far.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  depthRange,
  fitPose,
  fitRadius,
  zoomLimits,
  nearBefore,
} from '../../../src/phong/camera/fit.js';
import { basisOf, type Pose } from '../../../src/phong/camera/orbit.js';
import { dot } from '../../../src/phong/math/vector.js';
import { between, triple } from '../arbitraries.js';

const fov = between(1, 170);
const aspect = between(0.05, 20);
/** Scene scales from a bacterium in metres to beyond the solar system. */
const scale = between(-12, 15).map((power) => 10 ** power);

describe('the auto radius', () => {
  it('is 1.05 R / sin(half the field), of the horizontal field on a narrow picture', () => {
    fc.assert(
      fc.property(scale, fov, aspect, (sphereRadius, degrees, ratio) => {
        const vertical = (degrees * Math.PI) / 360;
        const half = Math.min(vertical, Math.atan(Math.tan(vertical) * ratio));
        const radius = fitRadius(sphereRadius, degrees, ratio);
        const wanted = Math.min((1.05 * sphereRadius) / Math.sin(half), 1e15);
        expect(Math.abs(radius / wanted - 1)).toBeLessThan(1e-12);
      }),
    );
  });

  it('is 4 for an empty scene, seen at the origin, and 4 for a single point', () => {
    expect(fitPose(null, 45, 1)).toStrictEqual({ target: [0, 0, 0], radius: 4 });
    expect(fitPose({ center: [1, NaN, 3], radius: 1 }, 45, 1)).toStrictEqual({
      target: [0, 0, 0],
      radius: 4,
    });
    expect(fitPose({ center: [1, 2, 3], radius: 0 }, 45, 1)).toStrictEqual({
      target: [1, 2, 3],
      radius: 4,
    });
  });

  it.each([NaN, 0, -1, Infinity])('treats an aspect of %d as square', (ratio) => {
    expect(fitRadius(1, 45, ratio)).toBeCloseTo(1.05 / Math.sin(Math.PI / 8), 13);
  });

  it('is finite, above 0 and within the domain, for any input', () => {
    fc.assert(
      fc.property(fc.double(), fov, fc.double(), (sphereRadius, degrees, ratio) => {
        const radius = fitRadius(sphereRadius, degrees, ratio);
        expect(radius > 0 && radius <= 1e15).toBe(true);
      }),
    );
  });
});

it('limits the zoom to 1e-3 to 1e3 times the radius of the scene, or times 1 for an empty scene', () => {
  expect(zoomLimits({ center: [0, 0, 0], radius: 5 })).toStrictEqual({ min: 5e-3, max: 5e3 });
  expect(zoomLimits(null)).toStrictEqual({ min: 1e-3, max: 1e3 });
  expect(zoomLimits({ center: [0, 0, 0], radius: 0 })).toStrictEqual({ min: 1e-3, max: 1e3 });
  expect(zoomLimits({ center: [0, 0, 0], radius: 1e14 }).max).toBe(1e15);
});

describe('near and far', () => {
  const unit = between(-1, 1);
  /** A sphere about the origin, and the distances of its front and back from the eye. */
  const scenes = fc
    .record({
      size: scale,
      distance: between(-3, 3).map((power) => 10 ** power),
      theta: between(-180, 180),
      phi: between(0, 180),
      aside: triple(unit),
    })
    .map(({ size, distance, theta, phi, aside: [x, y, z] }) => {
      const pose: Pose = {
        theta,
        phi,
        radius: size * distance,
        target: [x * size, y * size, z * size],
      };
      const middle = pose.radius + dot(pose.target, basisOf(pose).back);
      return { pose, size, front: middle - size, back: middle + size };
    });

  it('enclose a sphere in front of the eye, within a ratio of 1000 unless that would clip the target', () => {
    fc.assert(
      fc.property(scenes, ({ pose, size, front, back }) => {
        const { near, far } = depthRange(pose, { center: [0, 0, 0], radius: size });
        expect(far).toBeGreaterThanOrEqual(back);
        expect(near).toBeLessThanOrEqual(Math.max(front, far / 1000));
        expect(far / near).toBeLessThanOrEqual(
          Math.max(1000, (10 * far) / pose.radius) * (1 + 1e-12),
        );
        // The target, unless the whole sphere lies beyond it.
        if (front < pose.radius && back > pose.radius) {
          expect(near).toBeLessThan(pose.radius);
        }
        if (front < 0) {
          expect(near).toBeLessThanOrEqual(pose.radius / 10);
        }
      }),
      { numRuns: 1000 },
    );
  });

  it('are finite, above 0, in order, and normal float32 numbers, for any input', () => {
    const any = fc.double();
    const anyBounds = fc.option(fc.record({ center: triple(any), radius: any }), {
      nil: null,
    });
    const anyRadius = between(Number.MIN_VALUE, 1e15);
    const anyPhi = between(0, 180);
    fc.assert(
      fc.property(anyBounds, anyRadius, anyPhi, (bounds, radius, phi) => {
        const { near, far } = depthRange({ theta: 10, phi, radius, target: [1, 2, 3] }, bounds);
        expect(near).toBeGreaterThan(1.2e-38);
        expect(far).toBeLessThan(Infinity);
        expect(Math.fround(far)).toBeGreaterThan(Math.fround(near));
      }),
      { numRuns: 1000 },
    );
  });

  it('follow the sphere behind or before the target, and say whether it reaches nearer than near', () => {
    const pose = { theta: 0, phi: 90, target: [0, 0, 1] } as const;
    const sphere = { center: [0, 0, -1], radius: 1 } as const;
    const out = { near: 0, far: 0, cuts: true };
    expect(depthRange({ ...pose, radius: 4 }, sphere, out)).toBe(out);
    expect(out).toStrictEqual({ near: 0.99 * 5, far: 1.01 * 7, cuts: false });
    expect(depthRange({ ...pose, radius: 4 }, { center: [0, 0, 4], radius: 1 }).cuts).toBe(true);
    expect(depthRange({ ...pose, radius: 4 }, null).cuts).toBe(false);
  });

  it('leave a tenth before the nearest surface, as long as float32 tells positions apart', () => {
    expect([nearBefore(10, 4), nearBefore(0, 4)]).toStrictEqual([9, 4 * 2 ** -23]);
  });
});
