// Do drag, shift, pinch, wheel and keys give the right poses, and a whole drag from press to
// release exactly these? Examples by hand, and properties over every input a pointer can send.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  keyPose,
  keyStep,
  pinch,
  shift,
  turn,
  wheelZoom,
  worldPerPixel,
  zoomBy,
} from '../../../src/phong/camera/drag.js';
import { type PictureAxes, PointerGesture } from '../../../src/phong/camera/gesture.js';
import { basisOf, Orbit, type Pose } from '../../../src/phong/camera/orbit.js';
import { type Vec3, dot, subtract } from '../../../src/phong/math/vector.js';
import { between, triple } from '../arbitraries.js';

const view = { width: 600, height: 400, fov: 45 };
const limits = { min: 1e-3, max: 1e3 };
const start: Pose = { theta: 30, phi: 70, radius: 4, target: [0, 0, 0] };

const length = between(-1e3, 1e3);
const anyPose = fc.record({
  theta: between(-1e4, 1e4),
  phi: between(0, 180),
  radius: between(1e-3, 1e3),
  target: triple(length),
});
const travel = between(-2000, 2000);

describe('turning', () => {
  it.each([
    [60, 40, -6, 52],
    [-60, -40, 66, 88],
    [600, 0, -330, 70],
    [0, 1000, 30, 0],
    [0, -1000, 30, 180],
  ])('takes a travel of %d, %d px to θ = %d, φ = %d', (dx, dy, theta, phi) => {
    expect(turn(start, dx, dy, view)).toStrictEqual({ ...start, theta, phi });
  });

  it('returns the start pose itself for zero travel', () => {
    fc.assert(
      fc.property(
        anyPose,
        (pose) => turn(pose, 0, 0, view) === pose && shift(pose, 0, 0, view) === pose,
      ),
    );
  });

  it('turns a camera declared at an enormous θ, and keeps a θ beyond a turn for a travel up or down', () => {
    expect(turn({ ...start, theta: 360e15 }, 60, 0, view).theta).toBe(-36);
    expect(turn({ ...start, theta: 370 }, 0, 40, view)).toStrictEqual({
      ...start,
      theta: 370,
      phi: 52,
    });
  });
});

describe('shifting', () => {
  /** Position of a world point in the picture, CSS pixels from its middle, right and down. */
  function project(pose: Pose, point: Vec3) {
    const { right, up, back } = basisOf(pose);
    const p = subtract(point, pose.target);
    const depth = pose.radius - dot(p, back);
    const focal = view.height / 2 / Math.tan((view.fov * Math.PI) / 360);
    return { x: (focal * dot(p, right)) / depth, y: (-focal * dot(p, up)) / depth };
  }

  it('keeps the point under the pointer under the pointer', () => {
    fc.assert(
      fc.property(anyPose, travel, travel, travel, travel, (pose, x, y, dx, dy) => {
        const near = { ...pose, target: [0, 0, 0] as const };
        const { right, up } = basisOf(near);
        const step = worldPerPixel(near.radius, view);
        const at = (i: 0 | 1 | 2) => step * (x * right[i] - y * up[i]);
        const moved = project(shift(near, dx, dy, view), [at(0), at(1), at(2)]);
        expect(Math.abs(moved.x - (x + dx))).toBeLessThan(1e-12 * 4000);
        expect(Math.abs(moved.y - (y + dy))).toBeLessThan(1e-12 * 4000);
      }),
      { numRuns: 500 },
    );
  });
});

describe('zooming', () => {
  it.each([
    [100, 200, 2],
    [100, 50, 8],
    [100, 100, 4],
    [0, 50, 4],
    [100, 0, 1e3],
    [1, 1e300, 1e-3],
  ])('takes fingers from %d to %d px apart to a radius of %d', (from, to, radius) => {
    expect(pinch(start, from, to, limits).radius).toBe(radius);
  });

  it('lets a radius outside its limits come back but not move farther out', () => {
    const far = { ...start, radius: 1e6 };
    expect(zoomBy(far, 2, limits).radius).toBe(1e6);
    expect(zoomBy(far, 0.5, limits).radius).toBe(5e5);
    expect(zoomBy({ ...start, radius: 1e-6 }, 0.5, limits).radius).toBe(1e-6);
  });

  it.each([
    [{ deltaY: 100, deltaMode: 0 }, 4 * Math.exp(0.1)],
    [{ deltaY: -100, deltaMode: 0 }, 4 * Math.exp(-0.1)],
    [{ deltaY: 3, deltaMode: 1 }, 4 * Math.exp(0.001 * 48)],
    [{ deltaY: 1, deltaMode: 2 }, 4 * Math.exp(0.4)],
    [{ deltaY: 1e300, deltaMode: 0 }, 1e3],
    [{ deltaY: -1e300, deltaMode: 0 }, 1e-3],
    [{ deltaY: NaN, deltaMode: 0 }, 4],
    // A trackpad's pinch.
    [{ deltaY: 10, deltaMode: 0, ctrlKey: true }, 4 * Math.exp(0.1)],
    [{ deltaY: -25, deltaMode: 0, ctrlKey: true }, 4 * Math.exp(-0.25)],
    [{ deltaY: 1, deltaMode: 1, ctrlKey: true }, 4 * Math.exp(0.16)],
  ])('takes the wheel turn %o to a radius of %d', (wheel, radius) => {
    expect(wheelZoom(start, { ctrlKey: false, ...wheel }, 400, limits).radius).toBeCloseTo(
      radius,
      12,
    );
  });
});

describe('keys', () => {
  it.each([
    ['ArrowRight', false, { theta: 25 }],
    ['ArrowLeft', false, { theta: 35 }],
    ['ArrowUp', false, { phi: 75 }],
    ['ArrowDown', false, { phi: 65 }],
    ['ArrowRight', true, { theta: 29 }],
    ['ArrowDown', true, { phi: 69 }],
    ['+', true, { radius: 4 / 1.1 }],
    ['=', false, { radius: 4 / 1.1 }],
    ['PageUp', false, { radius: 4 / 1.1 }],
    ['-', false, { radius: 4 * 1.1 }],
    ['_', true, { radius: 4 * 1.1 }],
    ['PageDown', false, { radius: 4 * 1.1 }],
  ])('%s (Shift %s) leads to %o', (key, shiftKey, change) => {
    const step = keyStep(key, shiftKey);
    if (step === undefined || step.kind === 'reset') throw new Error('expected a turn or a zoom');
    const pose = keyPose(start, step, limits);
    const expected = { ...start, ...change };
    expect(pose.radius).toBeCloseTo(expected.radius, 14);
    expect({ ...pose, radius: 0 }).toStrictEqual({ ...expected, radius: 0 });
  });
});

it('gives a pose that an orbit accepts, for any input', () => {
  const any = fc.double();
  const anyView = fc.record({
    width: any,
    height: any,
    fov: between(1, 170),
  });
  const anyLimits = fc.record({ min: any, max: any });
  fc.assert(
    fc.property(anyPose, any, any, anyView, anyLimits, (pose, a, b, anySize, bounds) => {
      const orbit = new Orbit(pose);
      orbit.set(turn(pose, a, b, anySize));
      orbit.set(shift(pose, a, b, anySize));
      orbit.set(pinch(pose, a, b, bounds));
      orbit.set(wheelZoom(pose, { deltaY: a, deltaMode: 2, ctrlKey: b > 200 }, b, bounds));
      for (const x of [...orbit.eye(), orbit.theta, orbit.radius]) {
        expect(Number.isFinite(x)).toBe(true);
      }
    }),
    { numRuns: 1000 },
  );
});

it.each([
  [0, 400],
  [600, 0],
  [0, 0],
  [NaN, 400],
])('moves nothing on a picture of %d × %d', (width, height) => {
  const nowhere = { width, height, fov: 45 };
  expect(turn(start, 10, 10, nowhere)).toBe(start);
  expect(turn(start, 0, 10, nowhere)).toBe(start);
  if (!(height > 0)) {
    expect(shift(start, 10, 10, nowhere)).toBe(start);
  }
});

function setUp(axes: PictureAxes = [1, 0, 0, 1]) {
  const orbit = new Orbit();
  const world = { width: 600, height: 400, fov: 45, orbit: true, zoom: true, axes };
  const gesture = new PointerGesture({
    orbit,
    size: () => ({ width: world.width, height: world.height, axes: world.axes }),
    fov: () => world.fov,
    radiusLimits: () => ({ min: 1e-3, max: 1e3 }),
    allows: () => ({ orbit: world.orbit, zoom: world.zoom }),
  });
  return { orbit, gesture, world };
}

describe('a drag', () => {
  it.each([{ height: 800 }, { fov: 20 }])(
    'goes on like a new one after a change to %o',
    (change) => {
      const [{ orbit, gesture, world }, other] = [setUp(), setUp()];
      gesture.press(1, 0, 0, 'shift');
      gesture.move(1, 60, 0);
      Object.assign(world, change);
      Object.assign(other.world, change);
      other.orbit.set(orbit.pose);
      other.gesture.press(1, 60, 0, 'shift');
      for (const each of [gesture, other.gesture]) {
        each.move(1, 60, 90);
      }
      expect(orbit.pose).toEqual(other.orbit.pose);
      expect(orbit.pose.target[1]).toBeGreaterThan(0);
    },
  );

  it('continues from a property write or a resize during the drag', () => {
    const { orbit, gesture, world } = setUp();
    gesture.press(1, 0, 0, 'turn');
    gesture.move(1, 60, 0);
    orbit.set({ theta: 100 });
    gesture.move(1, 120, 0);
    expect(orbit.theta).toBe(64);
    world.width = 1200;
    gesture.move(1, 240, 0);
    expect(orbit.theta).toBe(28);
    gesture.reanchor();
    gesture.move(1, 180, 0);
    expect(orbit.theta).toBe(46);
  });

  it.each([
    ['while orbit is off', { orbit: false }, { orbit: true }],
    ['on a picture without size', { width: 0, height: 0 }, { width: 600, height: 400 }],
    ['on a picture that is seen edge-on', { axes: [1, 0, 2, 0] }, { axes: [1, 0, 0, 1] }],
  ] as const)('moves nothing %s, and does not jump afterwards', (_, before, after) => {
    const { orbit, gesture, world } = setUp();
    Object.assign(world, before);
    gesture.press(1, 0, 0, 'turn');
    expect(gesture.move(1, 300, 40)).toBe(false);
    Object.assign(world, after);
    gesture.move(1, 360, 40);
    expect([orbit.theta, orbit.phi]).toStrictEqual([-6, 70]);
  });

  it('ignores coordinates that are not finite, and pointers that are not pressed', () => {
    const { orbit, gesture } = setUp();
    expect(gesture.press(1, NaN, 0, 'turn')).toBe(false);
    expect(gesture.press(1, 0, 0, 'turn')).toBe(true);
    for (const bad of [NaN, Infinity, -Infinity]) {
      expect(gesture.move(1, bad, 0)).toBe(false);
    }
    expect(gesture.move(7, 100, 0)).toBe(false);
    gesture.lift(7);
    expect(gesture.active).toBe(true);
    expect(orbit.version).toBe(0);
  });
});

describe('a picture that is rotated, skewed or mirrored', () => {
  const axis = between(-2, 2);
  const anyAxes = fc
    .tuple(axis, axis, axis, axis)
    .filter(([a, b, c, d]) => Math.abs(a * d - b * c) > 0.01);
  const pixels = fc.integer({ min: -300, max: 300 });

  it.each(['turn', 'shift'] as const)('follows a %s along its own axes', (kind) => {
    fc.assert(
      fc.property(anyAxes, pixels, pixels, (axes, x, y) => {
        const [upright, turned] = [setUp(), setUp(axes)];
        const [rightX, rightY, downX, downY] = axes;
        upright.gesture.press(1, 0, 0, kind);
        turned.gesture.press(1, 0, 0, kind);
        upright.gesture.move(1, x, y);
        turned.gesture.move(1, x * rightX + y * downX, x * rightY + y * downY);
        expect(turned.orbit.theta).toBeCloseTo(upright.orbit.theta, 8);
        expect(turned.orbit.phi).toBeCloseTo(upright.orbit.phi, 8);
        for (const i of [0, 1, 2] as const) {
          expect(turned.orbit.target[i]).toBeCloseTo(upright.orbit.target[i], 8);
        }
      }),
    );
  });

  it('gets a new anchor when its axes change, but not when they change by a rounding', () => {
    const { orbit, gesture, world } = setUp();
    gesture.press(1, 0, 0, 'turn');
    gesture.move(1, 60, 0);
    world.axes = [1 + 1e-7, 0, 0, 1];
    gesture.move(1, 0, 0);
    expect(orbit.theta).toBe(30);
    gesture.move(1, 60, 0);
    world.axes = [0, 1, -1, 0];
    gesture.move(1, 60, 60);
    expect(orbit.theta).toBe(-42);
  });
});

describe('two fingers', () => {
  it('zoom from where they are when zoom is allowed again', () => {
    const { orbit, gesture, world } = setUp();
    world.zoom = false;
    gesture.press(1, 0, 0, 'turn');
    gesture.press(2, 100, 0, 'turn');
    gesture.move(2, 200, 0);
    world.zoom = true;
    gesture.move(2, 400, 0);
    expect(orbit.radius).toBeCloseTo(2);
  });

  it('zoom by the ratio of their distances and shift by the travel of their middle', () => {
    const { orbit, gesture } = setUp();
    orbit.set({ theta: 0, phi: 90 });
    gesture.press(1, 100, 100, 'turn');
    gesture.press(2, 200, 100, 'turn');
    gesture.move(1, 50, 100);
    gesture.move(2, 250, 100);
    expect(orbit.radius).toBe(2);
    expect(orbit.target).toStrictEqual([0, 0, 0]);
    gesture.move(1, 60, 100);
    gesture.move(2, 260, 100);
    expect(orbit.radius).toBe(2);
    expect(orbit.target[0]).toBeCloseTo((-10 * 2 * 2 * Math.tan(Math.PI / 8)) / 400, 8);
    expect(orbit.theta).toBe(0);
    gesture.move(1, 60, 110);
    gesture.move(2, 260, 110);
    expect(orbit.target[1]).toBeCloseTo((10 * 2 * 2 * Math.tan(Math.PI / 8)) / 400, 8);
  });

  it('only shift without zoom, and only zoom without orbit', () => {
    for (const what of ['zoom', 'orbit'] as const) {
      const { orbit, gesture, world } = setUp();
      world[what] = false;
      gesture.press(1, 100, 100, 'turn');
      gesture.press(2, 200, 100, 'turn');
      gesture.move(2, 300, 100);
      expect(orbit.radius === 4).toBe(what === 'zoom');
      expect(orbit.target[0] === 0).toBe(what === 'orbit');
    }
  });

  it('are all that count: a third is ignored', () => {
    const { gesture } = setUp();
    gesture.press(1, 0, 0, 'turn');
    gesture.press(2, 1, 1, 'turn');
    expect(gesture.press(3, 2, 2, 'turn')).toBe(false);
    expect(gesture.pointers).toStrictEqual([1, 2]);
  });
});
