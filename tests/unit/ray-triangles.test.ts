// Where does a pixel's ray meet triangles? Places, sides and limits, for every matrix that a mesh may have.

import fc from 'fast-check';
import { BoxGeometry, BufferAttribute, BufferGeometry, Matrix4, PlaneGeometry } from 'three';
import { describe, expect, it } from 'vitest';
import { Orbit } from '../../src/camera/orbit.js';
import { add, dot, scale, subtract, type Vec3 } from '../../src/math/vector.js';
import { forEachHit, type TriangleHit, type ViewRay } from '../../src/scene/snapshot/ray-triangles.js';

/** The ray at these slopes of a camera 3 from `target`; by default it looks along −z. */
function rayAt(
  slopeX: number,
  slopeY: number,
  { theta = 0, phi = 90, target = [0, 0, 0] as Vec3 } = {},
): ViewRay {
  const orbit = new Orbit({ theta, phi, radius: 3, target });
  const frame = { origin: orbit.target, eye: orbit.offset(), ...orbit.basis() };
  return { frame, slopeX, slopeY, near: 0.1, far: 100 };
}

/** Where the ray is at a depth, relative to the target. */
const placeOf = ({ frame, slopeX, slopeY }: ViewRay, depth: number): Vec3 =>
  add(
    frame.eye,
    scale(subtract(add(scale(frame.right, slopeX), scale(frame.up, slopeY)), frame.back), depth),
  );

function hitsOf(ray: ViewRay, geometry: BufferGeometry, matrix = new Matrix4(), range?: [number, number]) {
  const hits: TriangleHit[] = [];
  const corners = (geometry.index ?? geometry.getAttribute('position')).count;
  forEachHit(ray, geometry, matrix, range ?? [0, corners], (hit) => hits.push(hit));
  return hits.sort((a, b) => a.depth - b.depth);
}

const triangles = (values: readonly number[]): BufferGeometry =>
  new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(values), 3));

/**
 * Up to this size, 0 included. Numbers below roundings, but not 0, make triangles of lines: these have no side or
 * weights.
 */
const upTo = (most: number) =>
  fc.double({ min: -most, max: most, noNaN: true }).map((x) => (Math.abs(x) < 1e-12 ? 0 : x));

const coordinate = upTo(1);
const slope = upTo(0.25);
const angle = upTo(180);

describe('a ray through triangles', () => {
  it('hits one where its barycentric weights and the depth agree, from any side', () => {
    const corners = fc.array(coordinate, { minLength: 9, maxLength: 9 });
    fc.assert(
      fc.property(
        corners,
        slope,
        slope,
        angle,
        fc.double({ min: 1, max: 179, noNaN: true }),
        (at, x, y, theta, phi) => {
          const ray = rayAt(x, y, { theta, phi });
          const geometry = triangles(at);
          const position = geometry.getAttribute('position');
          for (const { weights, depth, corners: vertices } of hitsOf(ray, geometry)) {
            expect(weights[0] + weights[1] + weights[2]).toBeCloseTo(1, 12);
            for (const weight of weights) expect(weight).toBeGreaterThanOrEqual(0);
            const place = placeOf(ray, depth);
            [
              position.getX.bind(position),
              position.getY.bind(position),
              position.getZ.bind(position),
            ].forEach((read, axis) => {
              const interpolated = dot(weights, [read(vertices[0]), read(vertices[1]), read(vertices[2])]);
              expect(interpolated).toBeCloseTo(place[axis]!, 6);
            });
          }
        },
      ),
    );
  });

  it('hits the point that it is aimed at, on the side that the winding gives', () => {
    const weight = fc.double({ min: 0.01, max: 1, noNaN: true });
    fc.assert(
      fc.property(weight, weight, weight, fc.boolean(), (a, b, c, turned) => {
        const geometry = triangles(turned ? [0, 0, 0, 0, 1, 0, 1, 0, 0] : [0, 0, 0, 1, 0, 0, 0, 1, 0]);
        const [, u, v] = [a, b, c].map((x) => x / (a + b + c)) as [number, number, number];
        const [x, y] = turned ? [v, u] : [u, v];
        const [hit, ...others] = hitsOf(rayAt(x / 3, y / 3), geometry);
        expect(others).toEqual([]);
        expect(hit!.depth).toBeCloseTo(3, 12);
        expect(hit!.front).toBe(!turned);
        expect(hit!.weights[1]).toBeCloseTo(u, 12);
        expect(hit!.weights[2]).toBeCloseTo(v, 12);
      }),
    );
  });

  it('never slips between neighbours, not even at edges and corners', () => {
    const grid = new PlaneGeometry(2, 2, 7, 5);
    const position = grid.getAttribute('position');
    // Corners off any grid, so that edges have no round slopes.
    for (let i = 0; i < position.count; i++) {
      if (Math.abs(position.getX(i)) === 1 || Math.abs(position.getY(i)) === 1) continue;
      position.setXYZ(
        i,
        position.getX(i) + 0.05 * Math.sin(7 * i),
        position.getY(i) + 0.05 * Math.cos(5 * i),
        0.1 * Math.sin(i),
      );
    }
    const place = (i: number): Vec3 => [position.getX(i), position.getY(i), position.getZ(i)];
    const { index } = grid;
    for (let i = 0; i < index!.count; i++) {
      const a = place(index!.getX(i));
      const b = place(index!.getX(i - (i % 3) + ((i + 1) % 3)));
      for (const t of [0, 0.1, 1 / 3, 0.5, 0.777]) {
        const [x, y, z] = add(scale(a, 1 - t), scale(b, t));
        if (Math.abs(x) === 1 || Math.abs(y) === 1) continue; // the rim
        expect(hitsOf(rayAt(x / (3 - z), y / (3 - z)), grid).length, `corner ${i}, ${t}`).toBeGreaterThan(0);
      }
    }
  });

  it('hits a box twice, front and back, mirrored or not', () => {
    for (const [x, y, z] of [
      [1, 1, 1],
      [-1, 1, 1],
      [-1, -1, -1],
      [2, -0.5, 1],
    ] as const) {
      const hits = hitsOf(rayAt(0.01, 0.02), new BoxGeometry(), new Matrix4().makeScale(x, y, z));
      expect(
        hits.map(({ front }) => front),
        `scale ${x} ${y} ${z}`,
      ).toEqual([true, false]);
      expect(hits.map(({ depth }) => depth)).toEqual(
        [2.5, 3.5].map((depth) => expect.closeTo(depth, 12) as unknown),
      );
    }
  });

  it('hits a mesh that is flattened into a plane, but not one seen edge-on', () => {
    const flat = new Matrix4().makeScale(1, 1, 0);
    const hits = hitsOf(rayAt(0.01, 0.02), new BoxGeometry(), flat);
    expect(hits.map(({ depth }) => depth)).toEqual([3, 3]);
    expect(hits.map(({ front }) => front).sort()).toEqual([false, true]);
    expect(hitsOf(rayAt(0, 0), new BoxGeometry(), new Matrix4().makeScale(1, 0, 1))).toEqual([]);
    expect(hitsOf(rayAt(0, 0), new BoxGeometry(), new Matrix4().makeScale(0, 0, 0))).toEqual([]);
  });

  it('misses an edge-on triangle that lies below by the smallest of numbers, in any range', () => {
    const edgeOn = triangles([0, 0, 1, 0, 0, 1, 0, 0, 1, 0.02, 0, 0, 0, 0, -1]);
    const ray = rayAt(9.7e-18, 6.4e-323);
    expect(hitsOf(ray, edgeOn, undefined, [2, 5])).toEqual([]);
    expect(hitsOf(ray, triangles([0, 0, 1, 0.02, 0, 0, 0, 0, -1]))).toEqual([]);
  });

  it('hits only what lies between near and far, measured as depth and not along the ray', () => {
    const wall = new PlaneGeometry(100, 100);
    const at = (near: number, far: number): number => hitsOf({ ...rayAt(3, 2), near, far }, wall).length;
    expect(at(2.9, 3.1)).toBe(1);
    expect(at(3.1, 100)).toBe(0);
    expect(at(0.1, 2.9)).toBe(0);
    // Behind the eye.
    expect(hitsOf(rayAt(0, 0), wall, new Matrix4().makeTranslation(0, 0, 4))).toEqual([]);
  });

  it('hits a floor that passes below the eye, with corners behind it', () => {
    const ray = rayAt(0.1, -0.5);
    const [hit] = hitsOf(
      ray,
      new PlaneGeometry(100, 100).rotateX(-Math.PI / 2),
      new Matrix4().makeTranslation(0, -1, 0),
    );
    expect(hit!.depth).toBeCloseTo(2, 12);
    expect(hit!.front).toBe(true);
  });

  it('numbers triangles in drawing order, within the draw range', () => {
    const square = new PlaneGeometry(2, 2); // two triangles, the second right below
    const lower = hitsOf(rayAt(0.2, -0.2), square);
    expect(lower.map(({ triangle }) => triangle)).toEqual([1]);
    expect(hitsOf(rayAt(0.2, -0.2), square, undefined, [0, 3])).toEqual([]);
    expect(hitsOf(rayAt(0.2, -0.2), square, undefined, [3, 5])).toEqual([]);
    expect(hitsOf(rayAt(0.2, -0.2), square, undefined, [3, 6])).toEqual(lower);
  });

  it('loses nothing far from the world’s origin', () => {
    const target: Vec3 = [1e8, -3e8, 2e8];
    const turned = new Matrix4().makeRotationX(0.3);
    const away = turned.clone().setPosition(...target);
    const view = { theta: 33, phi: 50 };
    const here = hitsOf(rayAt(0.01, 0.02, view), new BoxGeometry(), turned);
    expect(here).toHaveLength(2);
    expect(hitsOf(rayAt(0.01, 0.02, { ...view, target }), new BoxGeometry(), away)).toEqual(here);
  });

  it('is right for the largest and the smallest mesh of the domain', () => {
    for (const size of [1e12, 1e-12]) {
      const scaled = new Matrix4().makeScale(size, size, size);
      const frame = { ...rayAt(0, 0).frame, eye: [0, 0, 3 * size] as Vec3 };
      const ray = { ...rayAt(0.01, 0.02), frame, near: 0.1 * size, far: 100 * size };
      const hits = hitsOf(ray, new BoxGeometry(), scaled);
      expect(hits.map(({ depth }) => depth / size)).toEqual(
        [2.5, 3.5].map((d) => expect.closeTo(d, 12) as unknown),
      );
    }
  });

  it('finds every hit among thousands of triangles, in drawing order, for every range and after a move', () => {
    const soup = fc.array(coordinate, { minLength: 9 * 700, maxLength: 9 * 700 });
    fc.assert(
      fc.property(soup, slope, slope, fc.nat(2100), fc.nat(2100), (at, x, y, start, length) => {
        const ray = rayAt(x, y);
        const geometry = triangles(at);
        const range = [start, Math.min(start + length, 2100)] as [number, number];
        /** Each triangle as a geometry of its own. */
        const oneByOne = (values: ArrayLike<number>): number[] => {
          const found: number[] = [];
          for (let corner = range[0]; corner + 2 < range[1]; corner += 3) {
            const alone = triangles(Array.from(values).slice(3 * corner, 3 * corner + 9));
            if (hitsOf(ray, alone).length > 0) found.push(corner / 3);
          }
          return found;
        };
        const met = (): number[] => {
          const found: number[] = [];
          forEachHit(ray, geometry, new Matrix4(), range, ({ triangle }) => found.push(triangle));
          return found;
        };
        const position = geometry.getAttribute('position') as BufferAttribute;
        expect(met()).toEqual(oneByOne(position.array));
        for (let i = 0; i < position.count; i++) position.setX(i, position.getX(i) - 1.5 * x);
        position.needsUpdate = true;
        expect(met()).toEqual(oneByOne(position.array));
      }),
      // Shrinking 6,300 numbers would take minutes.
      { numRuns: 10, endOnFailure: true },
    );
  });
});
