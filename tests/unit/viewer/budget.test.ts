// Does a viewer hold no more than its limits, whatever claims from its budget?
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { flatGeometry } from '../../../src/phong/material/flat-geometry.js';
import { LIMITS, VALUES_PER_TRIANGLE } from '../../../src/phong/model/limits.js';
import { createGeometry, GEOMETRIES } from '../../../src/phong/model/shapes/shapes.js';
import { shapeNeeds } from '../../../src/viewer/scene/mesh/shared-shapes.js';
import { Budget, type Claims, claimsOf } from '../../../src/phong/model/budget.js';
import { ModelBudget } from '../../../src/phong/model/model-budget.js';

const need = (key: object | string, triangles: number) => ({
  key,
  claims: claimsOf(triangles),
  flat: false,
});
const holds = (claims: Claims, key: object | string = {}) => [{ key, claims, flat: false }];
const tooLarge: unknown = expect.objectContaining({ code: 'too-large' });

function budgetOf(limit: number) {
  const budget = new Budget();
  budget.limit = limit;
  return budget;
}

it.each(GEOMETRIES)(
  'the triangles that a %s claims are those that are built, or up to a tenth more',
  async (name) => {
    for (const segments of [1, 2, 3, 7, 12, 33, 64, 100, undefined]) {
      const geometry = await createGeometry(name, segments);
      const corners = geometry.index!.count;
      const needs = shapeNeeds({ name, segments, isLevel: false }, true);
      const [smooth = 0, flat = 0] = needs.map(({ claims }) => claims.values);
      const what = `${name} ${segments}`;
      expect(smooth / VALUES_PER_TRIANGLE, what).toBeGreaterThanOrEqual(corners / 3);
      expect(smooth / VALUES_PER_TRIANGLE, what).toBeLessThanOrEqual((1.1 * corners) / 3);
      expect(flat, what).toBeGreaterThanOrEqual(
        8 * flatGeometry(geometry).getAttribute('position').count,
      );
    }
  },
);

describe('the budget of memory', () => {
  const quarter = LIMITS.memory / 4;

  it('holds four viewers that have a quarter each to the limits of one, of every kind', () => {
    const kinds: readonly [keyof Claims, number][] = [
      ['bytes', LIMITS.bytes],
      ['text', LIMITS.text],
      ['pixels', LIMITS.pixels],
      ['parts', LIMITS.parts],
      ['nodes', LIMITS.nodes],
    ];
    for (const [kind, most] of kinds) {
      let held = 0;
      for (let i = 0; i < 4; i++) {
        const budget = new Budget();
        budget.memory = quarter;
        // One source after the other, until one is refused.
        for (let k = 0; k < 100; k++) {
          try {
            budget.claim({}).add(holds({ [kind]: most / 50 }));
            held += most / 50;
          } catch (error) {
            expect(error, kind).toEqual(tooLarge);
            break;
          }
        }
      }
      expect(held, kind).toBeLessThanOrEqual(most);
      expect(held, kind).toBeGreaterThan(most / 2);
    }
  });

  it('is a whole number from 0 to the default; null restores the default', () => {
    const budget = new Budget();
    budget.memory = quarter;
    for (const wrong of ['1', Number.NaN, -1, 0.5, LIMITS.memory + 1]) {
      expect(() => (budget.memory = wrong as number)).toThrow(/^maxMemory must be a /);
      expect(budget.memory).toBe(quarter);
    }
    budget.memory = null;
    expect(budget.memory).toBe(LIMITS.memory);
  });
});

describe('the budget of triangles', () => {
  it('refuses with too-large what is beyond the limit, and changes nothing then', () => {
    const budget = budgetOf(10);
    const claim = budget.claim({});
    claim.add([need('a', 4)]);
    expect(() => claim.add([need('a', 4), need('b', 7)])).toThrow(tooLarge);
    expect(budget.used).toBe(4);
    claim.add([need('b', 6)]);
    expect(budget.used).toBe(10);
    expect(() => budget.claim({}).add([need('c', 1)])).toThrow('at most 10 can be shown');
  });

  it('lets new content of a mesh take the room of what it replaces, but not that of other meshes', () => {
    const budget = budgetOf(10);
    const owner = {};
    const before = budget.claim(owner);
    before.add([need('a', 8)]);
    const next = budget.claim(owner);
    next.add([need('b', 9)]);
    expect(() => budget.claim({}).add([need('c', 1)])).toThrow();
    before.release();
    expect(budget.used).toBe(9);
    budget.claim({}).add([need('c', 1)]);
    expect(() => budget.claim(owner).add([need('d', 10)])).toThrow();
  });

  it('counts what grows while it is read', () => {
    const budget = budgetOf(10);
    const claim = budget.claim({});
    const model = new ModelBudget((claims) => claim.add(holds(claims, 'model')));
    for (let i = 0; i < 10; i += 1) {
      model.add({ values: VALUES_PER_TRIANGLE });
    }
    expect(budget.used).toBe(10);
    expect(() => model.add({ values: 1 })).toThrow(tooLarge);
    claim.release();
    expect(budget.used).toBe(0);
  });

  it.each([
    ['bytes', LIMITS.bytes],
    ['text', LIMITS.text],
    ['json', LIMITS.json],
    ['nodes', LIMITS.nodes],
    ['parts', LIMITS.parts],
    ['corners', LIMITS.corners],
    ['pixels', LIMITS.pixels],
    ['work', LIMITS.work],
  ])('has one limit of %s for all files together', (key, limit) => {
    const budget = new Budget();
    budget.claim({}).add(holds({ [key]: limit }));
    const another = budget.claim({});
    expect(() => another.add(holds({ [key]: 1 }))).toThrow(tooLarge);
    expect(() => another.add(holds({ values: 7 }))).not.toThrow();
  });

  it('has one limit of memory for vertices and images', () => {
    const budget = new Budget();
    budget.claim({}).add(holds({ values: 60e6 }));
    expect(() => budget.claim({}).add(holds({ pixels: 40e6 }))).toThrow(/bytes in memory/);
    budget.claim({}).add(holds({ pixels: 20e6 }));
  });

  it('counts the draws of each mesh that shows the same, and everything else once', () => {
    const budget = new Budget();
    const content = { values: 1000, pixels: LIMITS.pixels / 2, parts: LIMITS.parts / 4 };
    const meshes = [1, 2, 3, 4].map(() => budget.claim({}));
    for (const mesh of meshes) {
      mesh.add(holds(content, 'model'));
    }
    expect(() => budget.claim({}).add(holds(content, 'model'))).toThrow(/draws/);
    meshes[0]!.release();
    budget.claim({}).add(holds(content, 'model'));
  });

  it('throws for a limit that is none, and keeps the one before', () => {
    const budget = budgetOf(10);
    for (const wrong of [-1, 1.5, NaN, Infinity, LIMITS.triangles + 1]) {
      expect(() => (budget.limit = wrong)).toThrow(RangeError);
    }
    expect(() => Reflect.set(budget, 'limit', '5')).toThrow(TypeError);
    expect(budget.limit).toBe(10);
    Reflect.set(budget, 'limit', null);
    expect(budget.limit).toBe(LIMITS.triangles);
  });

  it('holds the sum of the distinct geometries, and never more than its limit, in any order of claims', () => {
    const keys = fc.array(fc.nat(6), { maxLength: 3 });
    const step = fc.record({ mesh: fc.nat(4), keys, release: fc.boolean() });
    fc.assert(
      fc.property(fc.array(step, { maxLength: 40 }), (steps) => {
        const budget = budgetOf(12);
        const held = Array.from({ length: 5 }, () => budget.claim({}));
        for (const { mesh: i, keys, release } of steps) {
          if (release) {
            held[i]!.release();
          }
          try {
            held[i]!.add(keys.map((key) => need(`k${key}`, key + 1)));
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
