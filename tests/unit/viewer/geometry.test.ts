// Does every named shape have its documented size, place, normals and winding at every number of
// segments?
import { Box3, type BufferAttribute, type BufferGeometry, Vector3 } from 'three';
import { describe, expect, it, vi } from 'vitest';
import { Dice } from '../../visual/random-scene.js';
import { cross, dot, length, subtract, type Vec3 } from '../../../src/phong/math/vector.js';
import {
  CLOSED,
  createGeometry,
  GEOMETRIES,
  type GeometryName,
  roundOf,
} from '../../../src/phong/model/shapes/shapes.js';
import {
  type Cut,
  cutGeometry,
  keyOfCut,
  MOST_CUT_TRIANGLES,
} from '../../../src/phong/model/shapes/cut-faces.js';
import {
  acquireShape,
  FIXED,
  levelKey,
  shapeKey,
} from '../../../src/viewer/scene/mesh/shared-shapes.js';
import { SEED } from '../../support/repeats.js';

const FEW = [1, 2, 3, 4, 5, 8, 33, undefined];

function vertex(geometry: BufferGeometry, name: string, i: number): Vec3 {
  const attribute = geometry.getAttribute(name);
  return [attribute.getX(i), attribute.getY(i), attribute.getZ(i)];
}

interface Triangle {
  readonly corners: readonly [Vec3, Vec3, Vec3];
  readonly normals: readonly [Vec3, Vec3, Vec3];
  /** Twice the area, along the side from which the winding is counter-clockwise. */
  readonly area: Vec3;
}

function* triangles(geometry: BufferGeometry): Generator<Triangle> {
  const { index } = geometry;
  if (!index) throw new Error('not indexed');
  for (let i = 0; i < index.count; i += 3) {
    const at = [index.getX(i), index.getX(i + 1), index.getX(i + 2)] as const;
    const [a, b, c] = at.map((v) => vertex(geometry, 'position', v)) as [Vec3, Vec3, Vec3];
    const normals = at.map((v) => vertex(geometry, 'normal', v)) as [Vec3, Vec3, Vec3];
    yield { corners: [a, b, c], normals, area: cross(subtract(b, a), subtract(c, a)) };
  }
}

it.each(GEOMETRIES)(
  'the %s is finite, with unit normals on the side of its winding, in the unit box at any number of segments',
  async (name) => {
    for (const segments of FEW) {
      const geometry = await createGeometry(name, segments);
      const text = `${segments} segments`;
      const { position, normal, uv } = geometry.attributes;
      const isInside = position!.array.every((x) => Math.abs(x) <= 0.5 + 1e-7);
      expect(isInside, text).toBe(true);
      expect([normal!.count, uv!.count], text).toEqual([position!.count, position!.count]);
      let [worst, wrong] = [0, 0];
      for (let i = 0; i < normal!.count; i += 1) {
        worst = Math.max(worst, Math.abs(length(vertex(geometry, 'normal', i)) - 1));
      }
      expect(worst, text).toBeLessThan(2e-7);
      for (const { normals, area } of triangles(geometry)) {
        const size = length(area);
        if (size < 1e-12) continue;
        const sum = normals.reduce((total, N) => total + dot(N, area) / size, 0);
        if (!(sum > 0)) {
          wrong += 1;
        }
      }
      expect(wrong, text).toBe(0);
    }
  },
);

describe('sizes', () => {
  it.each<[GeometryName, Vec3, digits: number]>([
    ['box', [1, 1, 1], 6],
    ['sphere', [1, 1, 1], 6],
    ['cylinder', [1, 1, 1], 6],
    ['cone', [1, 1, 1], 6],
    ['pyramid', [Math.SQRT1_2, 1, Math.SQRT1_2], 6],
    ['torus', [1, 1, 0.3], 6],
    ['plane', [1, 0, 1], 6],
    // Their vertices do not touch the round shape's box.
    ['torus-knot', [0.96, 1, 0.496], 2],
    ['teapot', [1, 0.49, 0.62], 2],
  ])('gives the %s its documented extent, centred', async (name, extent, digits) => {
    const { position } = (await createGeometry(name, undefined)).attributes;
    const box = new Box3().setFromBufferAttribute(position as BufferAttribute);
    const [size, center] = [box.getSize(new Vector3()), box.getCenter(new Vector3())];
    extent.forEach((expected, k) => expect(size.getComponent(k)).toBeCloseTo(expected, digits));
    expect(center.length()).toBeLessThan(5e-4);
  });

  it('turns the plane toward +y, and divides it into segments² squares', async () => {
    const geometry = await createGeometry('plane', 3);
    expect(geometry.getAttribute('position').count).toBe(16);
    for (const { normals } of triangles(geometry)) {
      expect(normals[0][1]).toBeCloseTo(1, 12);
    }
  });

  it('puts the pyramid’s corners on a circle of diameter 1, its sides of segments² triangles facing the axes', async () => {
    const geometry = await createGeometry('pyramid', 5);
    expect(geometry.index!.count).toBe(6 * 25 * 3);
    const facing = new Set<string>();
    for (const { corners, normals } of triangles(await createGeometry('pyramid', undefined))) {
      corners.forEach(([x, y, z], i) => {
        if (y < 0) {
          expect(Math.hypot(x, z)).toBeCloseTo(0.5, 6);
        }
        const [nx, , nz] = normals[i]!;
        facing.add([nx, nz].map((n) => Math.sign(Math.round(n * 1e6)) + 0).join(' '));
      });
    }
    expect(facing).toEqual(new Set(['0 1', '1 0', '0 -1', '-1 0', '0 0']));
  });
});

/**
 * Edges of one triangle only, and edges that other triangles meet than one on each side. Positions
 * are compared exactly.
 */
function edgesOf(geometry: BufferGeometry) {
  const edges = new Map<string, number>();
  // Adding 0 makes -0 equal to 0.
  const key = (p: Vec3) => p.map((v) => v + 0).join();
  for (const { corners } of triangles(geometry)) {
    corners.forEach((corner, i) => {
      const edge = `${key(corner)} ${key(corners[(i + 1) % 3]!)}`;
      edges.set(edge, (edges.get(edge) ?? 0) + 1);
    });
  }
  const reverse = (edge: string) => edges.get(edge.split(' ').reverse().join(' ')) ?? 0;
  const all = [...edges];
  const open = all.filter(([edge]) => reverse(edge) === 0).length;
  return { open, odd: all.filter(([edge, count]) => count !== 1 || reverse(edge) > 1).length };
}

const LEVELS = [16, 24, 80];

describe('a cut shape', () => {
  it(`has the sides of the whole one, few triangles, and two at each edge of a box (seed ${SEED})`, () => {
    const dice = new Dice(SEED);
    for (let i = 0; i < 200; i++) {
      // Round numbers too: cubes that end exactly in a face or in an edge.
      const round = dice.chance(0.5);
      const place = () => (round ? dice.pick([-1, -0.5, -0.25, 0, 0.5, 1]) : dice.from(-1, 1));
      const size = 2 ** -dice.pick([1, 2, 5, 10, 16]);
      const cut: Cut = {
        center: [place(), place(), place()],
        half: [size, round ? size : size * dice.from(0.5, 2), 3 * size],
      };
      for (const name of ['box', 'plane'] as const) {
        const geometry = cutGeometry(name, cut);
        let area = 0;
        for (const { normals, area: across } of triangles(geometry)) {
          area += Math.min(...normals.map((N) => dot(N, across))) / 2;
        }
        expect(area, keyOfCut(cut)).toBeCloseTo(name === 'box' ? 6 : 1, 6);
        expect(geometry.index!.count / 3).toBeLessThanOrEqual(MOST_CUT_TRIANGLES);
        const solid = edgesOf(geometry);
        expect(solid.odd, keyOfCut(cut)).toBe(0);
        if (name === 'box') {
          expect(solid.open, keyOfCut(cut)).toBe(0);
        }
      }
    }
  });

  it.each(['box', 'plane'] as const)(
    'has the texture coordinates of the whole %s',
    async (name) => {
      const at = (geometry: BufferGeometry) =>
        Array.from({ length: geometry.getAttribute('position').count }, (_, i) =>
          [
            ...vertex(geometry, 'position', i),
            ...vertex(geometry, 'normal', i),
            geometry.getAttribute('uv').getX(i),
            geometry.getAttribute('uv').getY(i),
          ]
            .map((x) => Math.round(x * 1e6) / 1e6 + 0)
            .join(' '),
        );
      const cut = cutGeometry(name, { center: [0.1, 0.6, 0.2], half: [0.2, 0.2, 0.2] });
      expect(at(cut)).toEqual(expect.arrayContaining(at(await createGeometry(name, 1))));
    },
  );
});

describe('closed shapes', () => {
  it.each([...CLOSED])(
    'the %s has exactly two triangles at each edge, one in each direction',
    async (name) => {
      const few = FEW.map((n) => [n, false] as const);
      const levels = roundOf(name) === undefined ? [] : LEVELS.map((n) => [n, true] as const);
      for (const [segments, isLevel] of [...few, ...levels]) {
        const geometry = await createGeometry(name, segments, isLevel);
        let volume = 0;
        for (const { corners, area } of triangles(geometry)) {
          volume += dot(corners[0], area) / 6;
        }
        expect(volume).toBeGreaterThan(0.01);
        expect(edgesOf(geometry), `${segments} segments`).toEqual({ open: 0, odd: 0 });
      }
    },
  );

  it('the teapot is open at its own rims alone: of body, lid, spout and handle', async () => {
    for (const [segments, isLevel] of [12, 17, 33].flatMap((n) =>
      [false, true].map((is) => [n, is] as const),
    )) {
      expect(edgesOf(await createGeometry('teapot', segments, isLevel)), String(segments)).toEqual({
        open: 16 * Math.round(segments / 4), // sixteen patches have such a side
        odd: 0,
      });
    }
  });

  it('are all but the plane and the teapot, whose meshes show both sides', async () => {
    for (const name of GEOMETRIES) {
      const content = await acquireShape(levelKey(name, FIXED));
      const isOpen = name === 'plane' || name === 'teapot';
      expect(content.parts[0]!.sides, name).toBe(isOpen ? 'double' : 'closed');
      content.dispose();
    }
  });
});

describe('sharing', () => {
  it('gives the same geometry to the same name and segments, and frees it with its last user', async () => {
    const key = shapeKey('sphere', 12);
    const first = await acquireShape(key);
    const dispose = vi.spyOn(first.parts[0]!.geometry, 'dispose');
    expect(acquireShape(key)).toBe(first);
    first.dispose();
    expect(dispose).not.toHaveBeenCalled();
    first.dispose();
    expect(dispose).toHaveBeenCalledTimes(1);
    const next = await acquireShape(key);
    expect(next.parts[0]!.geometry).not.toBe(first.parts[0]!.geometry);
    next.dispose();
  });

  it('is by the number of segments that the shape uses', async () => {
    for (const [asked, used] of [
      [levelKey('sphere', FIXED), shapeKey('sphere', 64)],
      [shapeKey('cone', 1), shapeKey('cone', 3)],
    ] as const) {
      const contents = [await acquireShape(asked), await acquireShape(used)] as const;
      expect(contents[0]).toBe(contents[1]);
      for (const content of contents) {
        content.dispose();
      }
    }
  });

  /** Where no shape's code has arrived. */
  async function freshShapes() {
    vi.resetModules();
    return import('../../../src/viewer/scene/mesh/shared-shapes.js');
  }

  it('frees a lazy shape with its last user, and builds it at once when its code is here', async () => {
    const fresh = await freshShapes();
    const key = shapeKey('teapot', 8);
    const pending = fresh.acquireShape(key);
    expect(pending).toBeInstanceOf(Promise);
    expect(fresh.acquireShape(key)).toBe(pending);
    const content = await pending;
    for (let i = 0; i < 2; i += 1) {
      content.dispose();
    }
    const next = fresh.acquireShape(key);
    expect(next).not.toBeInstanceOf(Promise);
    expect(next).not.toBe(content);
    (await next).dispose();
  });

  it('gives a lazy shape at once after it has arrived, and keeps a level for a second: samples have a finer one', async () => {
    const fresh = await freshShapes();
    const key = levelKey('teapot', 16);
    const content = await fresh.acquireShape(key);
    const dispose = vi.spyOn(content.parts[0]!.geometry, 'dispose');
    vi.useFakeTimers();
    for (const ms of [900, 900]) {
      content.dispose();
      vi.advanceTimersByTime(ms);
      expect(fresh.acquireShape(key)).toBe(content);
    }
    content.dispose();
    vi.advanceTimersByTime(1000);
    vi.useRealTimers();
    expect(dispose).toHaveBeenCalledTimes(1);
  });
});
