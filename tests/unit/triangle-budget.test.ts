// Does a viewer hold no more triangles than its limit, and do meshes that were refused come back?
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { flatGeometry } from '../../src/material/flat-geometry.js';
import { TRIANGLE_LIMIT, VALUES_PER_TRIANGLE } from '../../src/model/limits.js';
import { createGeometry, GEOMETRIES } from '../../src/scene/mesh/shapes/shapes.js';
import { shapeNeeds } from '../../src/scene/mesh/shapes/shared-shapes.js';
import { type Claimant, flatTriangles, TriangleBudget } from '../../src/scene/mesh/triangle-budget.js';

const mesh = (again = (): void => undefined, wantsFlat = false): Claimant => ({ wantsFlat, again });
const need = (key: object | string, triangles: number, flat = false) => ({ key, triangles, flat });

function budgetOf(limit: number): TriangleBudget {
  const budget = new TriangleBudget();
  budget.limit = limit;
  return budget;
}

describe('the number of triangles that a shape claims', () => {
  it.each(GEOMETRIES)('is that of the %s that is built, or up to a tenth more', async (name) => {
    for (const segments of [1, 2, 3, 7, 12, 33, 64, 100, undefined]) {
      const geometry = await createGeometry(name, segments);
      const corners = geometry.index!.count;
      const [smooth, flat] = shapeNeeds({ name, segments, isLevel: false }, true).map(
        ({ triangles }) => triangles,
      ) as [number, number];
      const what = `${name} ${String(segments)}`;
      expect(smooth, what).toBeGreaterThanOrEqual(corners / 3);
      expect(smooth, what).toBeLessThanOrEqual((1.1 * corners) / 3);
      expect(flat * VALUES_PER_TRIANGLE, what).toBeGreaterThanOrEqual(
        8 * flatGeometry(geometry).getAttribute('position').count,
      );
      expect(flatTriangles(geometry), what).toBeLessThanOrEqual(flat);
    }
  });
});

describe('the budget of triangles', () => {
  it('counts a shared geometry once, for as long as one mesh holds it', () => {
    const budget = budgetOf(10);
    const claims = Array.from({ length: 2000 }, () => budget.claim(mesh()));
    for (const claim of claims) claim.add([need('sphere', 6)]);
    expect(budget.used).toBe(6);
    for (const claim of claims.slice(1)) claim.release();
    expect(budget.used).toBe(6);
    expect(() => budget.claim(mesh()).add([need('box', 5)])).toThrow('at most 10 can be shown');
    claims[0]!.release();
    expect(budget.used).toBe(0);
  });

  it('refuses with too-large what is beyond the limit, and changes nothing then', () => {
    const budget = budgetOf(10);
    const claim = budget.claim(mesh());
    claim.add([need('a', 4)]);
    expect(() => claim.add([need('a', 4), need('b', 7)])).toThrow(
      expect.objectContaining({ code: 'too-large' }) as Error,
    );
    expect(budget.used).toBe(4);
    claim.add([need('b', 6)]);
    expect(budget.used).toBe(10);
  });

  it('lets new content of a mesh take the room of what it replaces, but not that of other meshes', () => {
    const budget = budgetOf(10);
    const owner = mesh();
    const before = budget.claim(owner);
    before.add([need('a', 8)]);
    const next = budget.claim(owner);
    next.add([need('b', 9)]);
    expect(() => budget.claim(mesh()).add([need('c', 1)])).toThrow();
    before.release();
    expect(budget.used).toBe(9);
    budget.claim(mesh()).add([need('c', 1)]);
    expect(() => budget.claim(owner).add([need('d', 10)])).toThrow();
  });

  it('adds up the values that a model claims while it is read', () => {
    const budget = budgetOf(10);
    const claim = budget.claim(mesh());
    for (let i = 0; i < 10; i += 1) claim.addValues(VALUES_PER_TRIANGLE);
    expect(budget.used).toBe(10);
    expect(() => claim.addValues(1)).toThrow();
    claim.release();
    expect(budget.used).toBe(0);
  });

  it('lets refused meshes try again in their order once there is room for them', async () => {
    const budget = budgetOf(10);
    const tried: string[] = [];
    const first = budget.claim(mesh());
    first.add([need('a', 10)]);
    for (const [name, size] of [
      ['big', 11],
      ['b', 6],
      ['c', 6],
      ['d', 4],
    ] as const) {
      const claimant = mesh(() => {
        tried.push(name);
        budget.claim(claimant).add([need(name, size)]);
      });
      expect(() => budget.claim(claimant).add([need(name, size)])).toThrow();
    }
    first.release();
    expect(tried).toEqual([]);
    await Promise.resolve();
    expect(tried).toEqual(['b', 'd']);
    expect(budget.used).toBe(10);
  });

  it('tries again without flat copies where they are no longer wanted', async () => {
    const budget = budgetOf(10);
    const tried: boolean[] = [];
    const state = { wantsFlat: true, again: () => void tried.push(true) };
    expect(() => budget.claim(state).add([need('a', 4), need('flat a', 14, true)])).toThrow();
    budget.review();
    await Promise.resolve();
    expect(tried).toEqual([]);
    state.wantsFlat = false;
    budget.review();
    await Promise.resolve();
    expect(tried).toEqual([true]);
  });

  it('throws for a limit that is none, and keeps the one before', () => {
    const budget = budgetOf(10);
    for (const wrong of [-1, 1.5, NaN, Infinity, TRIANGLE_LIMIT + 1])
      expect(() => (budget.limit = wrong)).toThrow(RangeError);
    expect(() => Reflect.set(budget, 'limit', '5')).toThrow(TypeError);
    expect(budget.limit).toBe(10);
    Reflect.set(budget, 'limit', null);
    expect(budget.limit).toBe(TRIANGLE_LIMIT);
  });

  it('holds the sum of the distinct geometries, and never more than its limit, in any order of claims', () => {
    const step = fc.record({
      mesh: fc.nat(4),
      keys: fc.array(fc.nat(6), { maxLength: 3 }),
      release: fc.boolean(),
    });
    fc.assert(
      fc.property(fc.array(step, { maxLength: 40 }), (steps) => {
        const budget = budgetOf(12);
        const meshes = Array.from({ length: 5 }, () => mesh());
        const held = meshes.map((each) => budget.claim(each));
        for (const { mesh: i, keys, release } of steps) {
          if (release) held[i]!.release();
          try {
            held[i]!.add(keys.map((key) => need(`k${String(key)}`, key + 1)));
          } catch {
            // Refused: the sum below still holds.
          }
          const distinct = new Set(held.flatMap(({ needs }) => [...needs.keys()] as string[]));
          const sum = [...distinct].reduce((total, key) => total + Number(key.slice(1)) + 1, 0);
          expect(budget.used).toBe(sum);
          expect(sum).toBeLessThanOrEqual(12);
        }
      }),
    );
  });
});
