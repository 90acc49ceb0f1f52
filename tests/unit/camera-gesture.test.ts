// Does a whole drag, from press to release, leave exactly the pose that the pure functions give, and nothing else?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type PictureAxes, PointerGesture } from '../../src/camera/gesture.js';
import { Orbit } from '../../src/camera/orbit.js';

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
  it('continues from a property write, a resize or a new field of view during the drag', () => {
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
    for (const bad of [NaN, Infinity, -Infinity]) expect(gesture.move(1, bad, 0)).toBe(false);
    expect(gesture.move(7, 100, 0)).toBe(false);
    gesture.lift(7);
    expect(gesture.active).toBe(true);
    expect(orbit.version).toBe(0);
  });
});

it('a gesture has dragged once the camera moved, until the next first press', () => {
  const { gesture } = setUp();
  expect(gesture.dragged).toBe(false);
  gesture.press(1, 0, 0, 'turn');
  gesture.move(1, 0, 0);
  expect(gesture.dragged).toBe(false);
  gesture.move(1, 50, 0);
  gesture.press(2, 100, 0, 'turn');
  expect(gesture.dragged).toBe(true);
  gesture.lift(1);
  gesture.lift(2);
  expect(gesture.dragged).toBe(true);
  gesture.press(1, 0, 0, 'turn');
  expect(gesture.dragged).toBe(false);
});

describe('a picture that is rotated, skewed or mirrored', () => {
  const axis = fc.double({ min: -2, max: 2, noNaN: true });
  const anyAxes = fc.tuple(axis, axis, axis, axis).filter(([a, b, c, d]) => Math.abs(a * d - b * c) > 0.01);
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
        for (const i of [0, 1, 2] as const) expect(turned.orbit.target[i]).toBeCloseTo(upright.orbit.target[i], 8);
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
    expect(orbit.target[0]).toBeCloseTo((-10 * 2 * 2 * Math.tan(Math.PI / 8)) / 400, 14);
    expect(orbit.theta).toBe(0);
    gesture.move(1, 60, 110);
    gesture.move(2, 260, 110);
    expect(orbit.target[1]).toBeCloseTo((10 * 2 * 2 * Math.tan(Math.PI / 8)) / 400, 14);
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
