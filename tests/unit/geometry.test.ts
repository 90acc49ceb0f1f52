// Does every named shape have its documented size, place, normals and winding at every number of segments?
import type { BufferGeometry } from 'three';
import { describe, expect, it, vi } from 'vitest';
import { shapeContent } from '../../src/scene/mesh/content-load.js';
import { CLOSED, createGeometry, GEOMETRIES, type GeometryName } from '../../src/scene/mesh/shapes/shapes.js';
import {
  acquireGeometry as acquire,
  releaseGeometry as release,
  type ShapeKey,
} from '../../src/scene/mesh/shapes/shared-shapes.js';

const keyOf = (name: GeometryName, segments: number | undefined): ShapeKey => ({
  name,
  segments,
  isLevel: false,
});
const acquireGeometry = (name: GeometryName, segments: number | undefined) => acquire(keyOf(name, segments));
const releaseGeometry = (name: GeometryName, segments: number | undefined): void =>
  release(keyOf(name, segments));

type Point = [number, number, number];

const FEW = [1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 16, 31, 33, 64, 100, undefined];

function vertex(geometry: BufferGeometry, name: string, i: number): Point {
  const attribute = geometry.getAttribute(name);
  return [attribute.getX(i), attribute.getY(i), attribute.getZ(i)];
}

function bounds(geometry: BufferGeometry): { low: Point; high: Point } {
  const low: Point = [Infinity, Infinity, Infinity];
  const high: Point = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < geometry.getAttribute('position').count; i += 1) {
    const p = vertex(geometry, 'position', i);
    for (const axis of [0, 1, 2] as const) {
      low[axis] = Math.min(low[axis], p[axis]);
      high[axis] = Math.max(high[axis], p[axis]);
    }
  }
  return { low, high };
}

interface Triangle {
  readonly corners: readonly [Point, Point, Point];
  readonly normals: readonly [Point, Point, Point];
  /** Twice the area, along the side from which the winding is counter-clockwise. */
  readonly cross: Point;
}

function* triangles(geometry: BufferGeometry): Generator<Triangle> {
  const { index } = geometry;
  if (!index) throw new Error('not indexed');
  for (let i = 0; i < index.count; i += 3) {
    const at = [index.getX(i), index.getX(i + 1), index.getX(i + 2)] as const;
    const [a, b, c] = at.map((v) => vertex(geometry, 'position', v)) as [Point, Point, Point];
    const normals = at.map((v) => vertex(geometry, 'normal', v)) as [Point, Point, Point];
    const u: Point = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    const v: Point = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    const cross: Point = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    yield { corners: [a, b, c], normals, cross };
  }
}

const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

describe.each(GEOMETRIES)('the %s', (name) => {
  it('has finite positions, unit normals and texture coordinates at every number of segments', async () => {
    for (const segments of FEW) {
      const geometry = await createGeometry(name, segments);
      const { count } = geometry.getAttribute('position');
      expect(geometry.index, `${String(segments)} segments`).not.toBeNull();
      expect(geometry.getAttribute('uv').count).toBe(count);
      let worst = 0;
      let finite = true;
      for (let i = 0; i < count; i += 1) {
        finite &&= vertex(geometry, 'position', i).every(Number.isFinite);
        worst = Math.max(worst, Math.abs(Math.hypot(...vertex(geometry, 'normal', i)) - 1));
      }
      expect(finite, `${String(segments)} segments`).toBe(true);
      expect(worst, `${String(segments)} segments`).toBeLessThan(2e-7);
    }
  });

  it('winds its triangles counter-clockwise as seen from the side of its normals', async () => {
    for (const segments of FEW) {
      const geometry = await createGeometry(name, segments);
      let wrong = 0;
      for (const { normals, cross } of triangles(geometry)) {
        const size = Math.hypot(...cross);
        if (size < 1e-12) continue;
        const sum = normals.reduce((total, n) => total + dot(n, cross) / size, 0);
        if (!(sum > 0)) wrong += 1;
      }
      expect(wrong, `${String(segments)} segments`).toBe(0);
    }
  });

  it('stays inside the unit box, centred', async () => {
    for (const segments of FEW) {
      const { low, high } = bounds(await createGeometry(name, segments));
      for (const axis of [0, 1, 2] as const) {
        expect(low[axis]).toBeGreaterThanOrEqual(-0.5 - 1e-7);
        expect(high[axis]).toBeLessThanOrEqual(0.5 + 1e-7);
      }
    }
  });
});

describe('sizes', () => {
  const extents: Readonly<Record<GeometryName, Point>> = {
    box: [1, 1, 1],
    sphere: [1, 1, 1],
    cylinder: [1, 1, 1],
    cone: [1, 1, 1],
    pyramid: [Math.SQRT1_2, 1, Math.SQRT1_2],
    torus: [1, 1, 0.3],
    'torus-knot': [NaN, NaN, NaN],
    teapot: [NaN, NaN, NaN],
    plane: [1, 0, 1],
  };

  it.each(GEOMETRIES)('gives the %s its documented extent', async (name) => {
    const { low, high } = bounds(await createGeometry(name, undefined));
    const extent = low.map((value, axis) => (high[axis] ?? NaN) - value);
    extents[name].forEach((expected, axis) => {
      if (!Number.isNaN(expected)) expect(extent[axis]).toBeCloseTo(expected, 6);
      // The round knot and teapot fit: their vertices do not all touch the box.
      expect((low[axis] ?? NaN) + (high[axis] ?? NaN)).toBeCloseTo(0, 3);
    });
    if (name === 'torus-knot' || name === 'teapot') expect(Math.max(...extent)).toBeCloseTo(1, 2);
  });

  it('turns the plane toward +y', async () => {
    const geometry = await createGeometry('plane', 3);
    for (const { normals, cross } of triangles(geometry)) {
      expect(normals[0][1]).toBeCloseTo(1, 12);
      expect(cross[1]).toBeGreaterThan(0);
    }
    expect(geometry.getAttribute('position').count).toBe(16);
  });

  it('puts the corners of the pyramid on a circle of diameter 1, its sides facing the axes', async () => {
    const geometry = await createGeometry('pyramid', undefined);
    const facing = new Set<string>();
    for (let i = 0; i < geometry.getAttribute('position').count; i += 1) {
      const [x, y, z] = vertex(geometry, 'position', i);
      if (y < 0) expect(Math.hypot(x, z)).toBeCloseTo(0.5, 6);
      const [nx, , nz] = vertex(geometry, 'normal', i);
      facing.add(`${String(Math.sign(Math.round(nx * 1e6)))} ${String(Math.sign(Math.round(nz * 1e6)))}`);
    }
    expect(facing).toEqual(new Set(['0 1', '1 0', '0 -1', '-1 0', '0 0']));
  });

  it('divides a side of the pyramid into segments² triangles', async () => {
    expect((await createGeometry('pyramid', 5)).index?.count).toBe(6 * 25 * 3);
  });
});

/** Edges of one triangle only, and edges that other triangles meet than one on each side. Positions are compared exactly. */
function edgesOf(geometry: BufferGeometry): { readonly open: number; readonly odd: number } {
  const edges = new Map<string, number>();
  // Adding 0 makes -0 equal to 0.
  const key = (p: Point): string => p.map((v) => v + 0).join();
  for (const { corners } of triangles(geometry))
    corners.forEach((corner, i) => {
      const edge = `${key(corner)} ${key(corners[(i + 1) % 3]!)}`;
      edges.set(edge, (edges.get(edge) ?? 0) + 1);
    });
  const reverse = (edge: string): number => edges.get(edge.split(' ').reverse().join(' ')) ?? 0;
  const all = [...edges];
  const open = all.filter(([edge]) => reverse(edge) === 0).length;
  return { open, odd: all.filter(([edge, count]) => count !== 1 || reverse(edge) > 1).length };
}

const LEVELS = [16, 24, 40, 64, 80, 112];

describe('closed shapes', () => {
  it.each([...CLOSED])(
    'the %s has exactly two triangles at each edge, one in each direction',
    async (name) => {
      const few = [1, 2, 3, 4, 5, 6, 7, 8, 12, 33, undefined].map((n) => [n, false] as const);
      for (const [segments, isLevel] of [...few, ...LEVELS.map((n) => [n, true] as const)]) {
        const geometry = await createGeometry(name, segments, isLevel);
        let volume = 0;
        for (const { corners, cross } of triangles(geometry)) volume += dot(corners[0], cross) / 6;
        expect(volume).toBeGreaterThan(0.01);
        expect(edgesOf(geometry), `${String(segments)} segments`).toEqual({ open: 0, odd: 0 });
      }
    },
  );

  it('the teapot is open at its own rims alone: of body, lid, spout and handle', async () => {
    for (const [segments, isLevel] of [12, 17, 33, 64].flatMap((n) =>
      [false, true].map((is) => [n, is] as const),
    ))
      expect(edgesOf(await createGeometry('teapot', segments, isLevel)), String(segments)).toEqual({
        open: 16 * Math.round(segments / 4), // sixteen patches have such a side
        odd: 0,
      });
  });

  it('are neither the plane nor the teapot, which show both of their sides', () => {
    expect(GEOMETRIES.filter((name) => !CLOSED.has(name))).toEqual(['teapot', 'plane']);
  });
});

describe('sharing', () => {
  it('gives the same geometry to the same name and segments, and frees it with its last user', async () => {
    const first = await acquireGeometry('sphere', 12);
    const dispose = vi.spyOn(first, 'dispose');
    expect(acquireGeometry('sphere', 12)).toBe(first);
    releaseGeometry('sphere', 12);
    expect(dispose).not.toHaveBeenCalled();
    releaseGeometry('sphere', 12);
    expect(dispose).toHaveBeenCalledTimes(1);
    releaseGeometry('sphere', 12);
    const next = acquireGeometry('sphere', 12);
    expect(next).not.toBe(first);
    releaseGeometry('sphere', 12);
  });

  it('is by the number of segments that the shape uses', () => {
    const byDefault = acquireGeometry('sphere', undefined);
    expect(acquireGeometry('sphere', 64)).toBe(byDefault);
    expect(acquireGeometry('cone', 1)).toBe(acquireGeometry('cone', 3));
    for (const segments of [undefined, 64]) releaseGeometry('sphere', segments);
    for (const segments of [1, 3]) releaseGeometry('cone', segments);
  });

  it('frees a lazy shape that was released before it arrived, and builds it at once when its code is here', async () => {
    vi.resetModules(); // no shape's code is here
    const fresh = await import('../../src/scene/mesh/shapes/shared-shapes.js');
    const key = keyOf('teapot', 8);
    const pending = fresh.acquireGeometry(key);
    expect(pending).toBeInstanceOf(Promise);
    expect(fresh.acquireGeometry(key)).toBe(pending);
    fresh.releaseGeometry(key);
    fresh.releaseGeometry(key);
    const geometry = await pending;
    const next = fresh.acquireGeometry(key);
    expect(next).not.toBeInstanceOf(Promise);
    expect(next).not.toBe(geometry);
    fresh.releaseGeometry(key);
  });

  it('gives a lazy shape at once after it has arrived, and keeps a level for a second: samples have a finer one', async () => {
    vi.resetModules(); // no shape's code is here
    const fresh = await import('../../src/scene/mesh/shapes/shared-shapes.js');
    const key: ShapeKey = { name: 'teapot', segments: 16, isLevel: true };
    const geometry = await fresh.acquireGeometry(key);
    const dispose = vi.spyOn(geometry, 'dispose');
    vi.useFakeTimers();
    for (const ms of [900, 900]) {
      fresh.releaseGeometry(key);
      vi.advanceTimersByTime(ms);
      expect(fresh.acquireGeometry(key)).toBe(geometry);
    }
    fresh.releaseGeometry(key);
    vi.advanceTimersByTime(1000);
    vi.useRealTimers();
    expect(dispose).toHaveBeenCalledTimes(1);
  });
});

describe('the content of a mesh', () => {
  it('says which shapes are closed', async () => {
    for (const name of GEOMETRIES) {
      const content = await shapeContent(keyOf(name, undefined));
      expect(content.parts[0]!.sides, name).toBe(CLOSED.has(name) ? 'closed' : 'double');
      content.dispose();
    }
  });
});
