// Where does a pixel's ray meet triangles? Places, sides and limits, for every matrix that a mesh
// may have.

import fc from 'fast-check';
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Euler,
  Matrix4,
  PlaneGeometry,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { Orbit } from '../../../src/phong/camera/orbit.js';
import {
  add,
  cross,
  dot,
  length,
  scale,
  subtract,
  type Vec3,
} from '../../../src/phong/math/vector.js';
import {
  searchNear,
  searchTriangles,
  type TriangleHit,
  type ViewRay,
} from '../../../src/extras/explain/ray-triangles.js';
import { answerOf } from './answer-of.js';
import { between } from '../../unit/arbitraries.js';

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
const placeOf = ({ frame, slopeX, slopeY }: ViewRay, depth: number) =>
  add(
    frame.eye,
    scale(subtract(add(scale(frame.right, slopeX), scale(frame.up, slopeY)), frame.back), depth),
  );

function hitsOf(
  ray: ViewRay,
  geometry: BufferGeometry,
  matrix = new Matrix4(),
  range?: [number, number],
) {
  const hits: TriangleHit[] = [];
  const corners = (geometry.index ?? geometry.getAttribute('position')).count;
  const keepNone = (_depth: number, _front: boolean, read: () => TriangleHit) => {
    hits.push(read());
    return false;
  };
  answerOf(searchTriangles(ray, geometry, matrix, range ?? [0, corners], keepNone));
  return hits.sort((a, b) => a.depth - b.depth);
}

const triangles = (values: readonly number[]) =>
  new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(values), 3));

/**
 * Up to this size, 0 included. Numbers below roundings, but not 0, make triangles of lines: these
 * have no side or weights.
 */
const upTo = (most: number) => between(-most, most).map((x) => (Math.abs(x) < 1e-12 ? 0 : x));

const coordinate = upTo(1);
const slope = upTo(0.25);
const angle = upTo(180);

describe('a ray through triangles', () => {
  it('hits one where its barycentric weights and the depth agree, from any side', () => {
    const corners = fc.array(coordinate, { minLength: 9, maxLength: 9 });
    const phi = between(1, 179);
    fc.assert(
      fc.property(corners, slope, slope, angle, phi, (at, x, y, theta, phi) => {
        const ray = rayAt(x, y, { theta, phi });
        const geometry = triangles(at);
        for (const {
          weights,
          depth,
          corners: [a, b, c],
        } of hitsOf(ray, geometry)) {
          expect(weights[0] + weights[1] + weights[2]).toBeCloseTo(1, 12);
          for (const weight of weights) {
            expect(weight).toBeGreaterThanOrEqual(0);
          }
          const position = geometry.getAttribute('position');
          placeOf(ray, depth).forEach((wanted, axis) => {
            const read = (corner: number) => position.getComponent(corner, axis);
            expect(dot(weights, [read(a), read(b), read(c)])).toBeCloseTo(wanted, 6);
          });
        }
      }),
    );
  });

  it('hits the point that it is aimed at, on the side that the winding gives', () => {
    const weight = between(0.01, 1);
    fc.assert(
      fc.property(weight, weight, weight, fc.boolean(), (a, b, c, turned) => {
        const geometry = triangles(
          turned ? [0, 0, 0, 0, 1, 0, 1, 0, 0] : [0, 0, 0, 1, 0, 0, 0, 1, 0],
        );
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
      const [x, y] = [position.getX(i), position.getY(i)];
      if (Math.abs(x) === 1 || Math.abs(y) === 1) continue;
      position.setXYZ(i, x + 0.05 * Math.sin(7 * i), y + 0.05 * Math.cos(5 * i), 0.1 * Math.sin(i));
    }
    const place = (i: number): Vec3 => [position.getX(i), position.getY(i), position.getZ(i)];
    const { index } = grid;
    for (let i = 0; i < index!.count; i++) {
      const a = place(index!.getX(i));
      const b = place(index!.getX(i - (i % 3) + ((i + 1) % 3)));
      for (const t of [0, 0.1, 1 / 3, 0.5, 0.777]) {
        const [x, y, z] = add(scale(a, 1 - t), scale(b, t));
        if (Math.abs(x) === 1 || Math.abs(y) === 1) continue; // the rim
        expect(
          hitsOf(rayAt(x / (3 - z), y / (3 - z)), grid).length,
          `corner ${i}, ${t}`,
        ).toBeGreaterThan(0);
      }
    }
  });

  // The ends of the domain, mirrored, and flattened into a plane.
  it.each([
    [1, 1, 1, 1],
    [-1, 1, 1, 1],
    [-1, -1, -1, 1],
    [2, -0.5, 1, 1],
    [1e12, 1e12, 1e12, 1e12],
    [1e-12, 1e-12, 1e-12, 1e-12],
    [1, 1, 0, 1],
  ])(
    'hits a box scaled by %d %d %d twice, front and back, from a distance of 3 times %d',
    (x, y, z, size) => {
      const { frame, ...rest } = rayAt(0.01, 0.02);
      const eye: Vec3 = [0, 0, 3 * size];
      const ray = { ...rest, frame: { ...frame, eye }, near: 0.1 * size, far: 100 * size };
      const hits = hitsOf(ray, new BoxGeometry(), new Matrix4().makeScale(x, y, z));
      const depths = z === 0 ? [3, 3] : [2.5, 3.5];
      expect(hits.map(({ depth }) => depth / size)).toEqual(
        depths.map((d) => expect.closeTo(d, 12) as unknown),
      );
      const fronts = hits.map(({ front }) => front);
      expect(z === 0 ? fronts.sort().reverse() : fronts).toEqual([true, false]);
    },
  );

  it('misses a mesh that is flattened and seen edge-on, or has no size', () => {
    for (const z of [1, 0]) {
      expect(hitsOf(rayAt(0, 0), new BoxGeometry(), new Matrix4().makeScale(z, 0, z))).toEqual([]);
    }
  });

  it('misses an edge-on triangle that lies below by the smallest of numbers, in any range', () => {
    const edgeOn = triangles([0, 0, 1, 0, 0, 1, 0, 0, 1, 0.02, 0, 0, 0, 0, -1]);
    const ray = rayAt(9.7e-18, 6.4e-323);
    expect(hitsOf(ray, edgeOn, undefined, [2, 5])).toEqual([]);
    expect(hitsOf(ray, triangles([0, 0, 1, 0.02, 0, 0, 0, 0, -1]))).toEqual([]);
  });

  it('hits only what lies between near and far, measured as depth and not along the ray, and before the eye', () => {
    const wall = new PlaneGeometry(100, 100);
    const at = (near: number, far: number) => hitsOf({ ...rayAt(3, 2), near, far }, wall).length;
    expect([at(2.9, 3.1), at(3.1, 100), at(0.1, 2.9)]).toEqual([1, 0, 0]);
    expect(hitsOf(rayAt(0, 0), wall, new Matrix4().makeTranslation(0, 0, 4))).toEqual([]);
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

  it('finds every hit among thousands of triangles, in drawing order, for every range and after a move', () => {
    const soup = fc.array(coordinate, { minLength: 9 * 700, maxLength: 9 * 700 });
    fc.assert(
      fc.property(soup, slope, slope, fc.nat(2100), fc.nat(2100), (at, x, y, start, length) => {
        const ray = rayAt(x, y);
        const geometry = triangles(at);
        const range = [start, Math.min(start + length, 2100)] as [number, number];
        /** Each triangle as a geometry of its own. */
        const oneByOne = (values: ArrayLike<number>) => {
          const found: number[] = [];
          for (let corner = start; corner + 2 < range[1]; corner += 3) {
            const alone = triangles(Array.from({ length: 9 }, (_, i) => values[3 * corner + i]!));
            if (hitsOf(ray, alone).length > 0) {
              found.push(corner / 3);
            }
          }
          return found;
        };
        const met = () => {
          const found: number[] = [];
          const keepAll = (_depth: number, _front: boolean, read: () => TriangleHit) => {
            found.push(read().triangle);
            return true;
          };
          const last = answerOf(searchTriangles(ray, geometry, new Matrix4(), range, keepAll));
          expect(last?.triangle).toBe(found.at(-1));
          return found;
        };
        const position = geometry.getAttribute('position') as BufferAttribute;
        expect(met()).toEqual(oneByOne(position.array));
        for (let i = 0; i < position.count; i++) {
          position.setX(i, position.getX(i) - 1.5 * x);
        }
        position.needsUpdate = true;
        expect(met()).toEqual(oneByOne(position.array));
      }),
      // Shrinking 6,300 numbers would take minutes.
      { numRuns: 10, endOnFailure: true },
    );
  });
});

it('the point that is nearest to a place lies on a triangle, none is nearer, under every matrix', () => {
  const numbers = fc.array(coordinate, { minLength: 27, maxLength: 27 });
  fc.assert(
    fc.property(numbers, (at) => {
      const geometry = triangles(at.slice(0, 18));
      const place: Vec3 = [at[18]!, at[19]!, at[20]!];
      const matrix = new Matrix4()
        .makeRotationFromEuler(new Euler(at[21], at[22], at[23]))
        .scale(new Vector3(at[24], at[25], at[26]));
      const { frame } = rayAt(0, 0);
      const near = answerOf(searchNear(frame, place, geometry, matrix, [0, 6], 1e9, () => true));
      const position = geometry.getAttribute('position');
      const corner = (i: number): Vec3 =>
        new Vector3().fromBufferAttribute(position, i).applyMatrix4(matrix).toArray();
      const mixed = (weights: Vec3, [a, b, c]: Vec3) =>
        add(
          add(scale(corner(a), weights[0]), scale(corner(b), weights[1])),
          scale(corner(c), weights[2]),
        );
      // Triangles of no area are not drawn.
      const seen = [0, 3].filter((i) => {
        const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
        return length(cross(subtract(b, a), subtract(c, a))) > 1e-9;
      });
      if (seen.length === 0) return;
      const found = mixed(near!.weights, near!.corners);
      expect(length(subtract(subtract(found, place), near!.away))).toBeLessThan(1e-12);
      expect(Math.min(...near!.weights)).toBeGreaterThanOrEqual(0);
      for (const first of seen) {
        for (let i = 0; i <= 8; i++) {
          for (let j = 0; i + j <= 8; j++) {
            const other = mixed([i / 8, j / 8, (8 - i - j) / 8], [first, first + 1, first + 2]);
            expect(length(near!.away)).toBeLessThan(length(subtract(other, place)) + 1e-9);
          }
        }
      }
    }),
  );
});
