// Does a light follow a drag in any view, keep its other values, and return when the drag does?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { LightState, type LightValues } from '../../../src/phong/light/light-state.js';
import type { Vec3 } from '../../../src/phong/math/vector.js';
import { Projection } from '../../../src/extras/overlay/drawing/projection.js';
import {
  lightMarks,
  placedLight,
  type HandlePart,
} from '../../../src/extras/overlay/helpers/light-marks.js';
import { moved, type Anchor } from '../../../src/extras/overlay/helpers/light-move.js';
import { between, triple } from '../../unit/arbitraries.js';

const scene = { center: [0, 0, 0], radius: 1 } as const;
const sight = {
  pose: { theta: 0, phi: 90, radius: 4, target: [0, 0, 0] },
  fov: 45,
  width: 400,
  height: 300,
} as const;
const values = (given: Partial<LightValues>): LightValues => new LightState(given).values;

function anchorOf(light: LightValues, view: Projection, part: HandlePart = 'place'): Anchor {
  const { placed, handles } = lightMarks(light, view, scene, false, Infinity);
  return {
    values: light,
    placed,
    handle: handles.find((each) => each.part === part)!,
    view,
    scene,
  };
}

const angle = between(-180, 180);
const pixel = fc.integer({ min: -300, max: 300 });
const coordinate = between(-3, 3);
const anywhere = fc.oneof(coordinate, fc.constantFrom(0, 4, -4, 1e15, -1e15, 1e-300));
const view = fc
  .tuple(angle, angle)
  .map(
    ([theta, phi]) =>
      new Projection({ ...sight, pose: { ...sight.pose, theta, phi: Math.abs(phi) } }),
  );
const move = fc.record({ dx: pixel, dy: pixel, along: fc.boolean(), byKeys: fc.boolean() });
const lengthOf = (v: readonly number[]) => Math.hypot(v[0]!, v[1]!, v[2]!);

describe('a light that is moved', () => {
  it('stays under the pointer at its depth, in both spaces and every view', () => {
    const place = triple(coordinate);
    const space = fc.constantFrom('camera', 'world');
    fc.assert(
      fc.property(view, place, space, pixel, pixel, (from, [x, y, z], space, dx, dy) => {
        const light = values({ position: [x, y, z, 1], space });
        const anchor = anchorOf(light, from);
        if (anchor.handle.outside) return;
        const { position } = moved(anchor, from, { dx, dy, along: false, byKeys: false });
        const after = placedLight({ ...light, position: position! }, from, scene).place;
        const depth = from.depthOf(anchor.handle.place);
        expect(from.depthOf(after)).toBeCloseTo(depth, 3);
        const shown = from.point(after);
        // Rounded to a ten-thousandth of the scene.
        const tolerance = 2e-4 * from.pixelsPerUnit(depth);
        expect(Math.abs(shown!.x - anchor.handle.at.x - dx)).toBeLessThan(tolerance);
        expect(Math.abs(shown!.y - anchor.handle.at.y - dy)).toBeLessThan(tolerance);
      }),
    );
  });

  it('keeps the length of a directional vector and of an axis, and changes nothing else', () => {
    const vector = triple(coordinate).filter((v) => lengthOf(v) > 0.01);
    fc.assert(
      fc.property(view, vector, move, (from, v, by) => {
        const turned = moved(anchorOf(values({ position: [...v, 0] }), from), from, by);
        expect(Object.keys(turned)).toEqual(['position']);
        expect(lengthOf(turned.position!) / lengthOf(v)).toBeCloseTo(1, 12);
        expect(turned.position![3]).toBe(0);
        const spot = values({ position: [1, 1, 1, 1], axis: v, aperture: 20 });
        const { axis, ...others } = moved(anchorOf(spot, from, 'axis'), from, by);
        expect(others).toEqual({});
        expect(lengthOf(axis!) / lengthOf(v)).toBeCloseTo(1, 12);
      }),
    );
  });

  it('is finite and within the domain for lights anywhere, the eye and 1e15 included', () => {
    const position = fc.tuple(anywhere, anywhere, anywhere, fc.constantFrom(0, 1));
    fc.assert(
      fc.property(view, position, move, (from, position, by) => {
        const light = values({ position, axis: [0, -1, 0], aperture: 30 });
        for (const part of ['place', 'axis', 'aperture'] as const) {
          expect(() => values(moved(anchorOf(light, from, part), from, by))).not.toThrow();
        }
      }),
    );
  });
});

const from = new Projection(sight);
const edgeOf = (aperture: number) => {
  const light = values({ position: [0.2, 2, 0.1, 1], axis: [0, -1, 0], aperture });
  const { handles } = lightMarks(light, from, scene, false, 2.5);
  return handles.find(({ part }) => part === 'aperture')!.place;
};
const radiusOf = ([x, , z]: Vec3) => Math.hypot(x - 0.2, z - 0.1);

it('a spot’s helper has a ring of at most twice the scene’s radius, without a jump at any aperture', () => {
  let before = radiusOf(edgeOf(1));
  for (let aperture = 1.5; aperture < 180; aperture += 0.5) {
    const radius = radiusOf(edgeOf(aperture));
    expect(radius).toBeLessThanOrEqual(2 * scene.radius + 1e-9);
    expect(Math.abs(radius - before)).toBeLessThan(0.1);
    before = radius;
  }
});

it('a light’s helper is inside the layer for every light, in layers of every size', () => {
  const position = fc.tuple(anywhere, anywhere, anywhere, fc.constantFrom(0, 1));
  fc.assert(
    fc.property(view, position, fc.integer({ min: 1, max: 500 }), ({ pose }, position, width) => {
      const small = new Projection({ ...sight, pose, width });
      const light = values({ position, aperture: 20 });
      for (const { at } of lightMarks(light, small, scene, false, Infinity).handles) {
        expect(at.x >= 0 && at.x <= width, `${at.x}`).toBe(true);
        expect(at.y >= 0 && at.y <= 300, `${at.y}`).toBe(true);
      }
    }),
  );
});
