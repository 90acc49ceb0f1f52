// The bench's own parts: a figure is no better than the scene it was measured on and the numbers made of its samples.
import { describe, expect, test } from 'vitest';
import { box, glbOf, type Triangles } from '../bench/glb.mjs';
import { bentPlane, lightsOf } from '../bench/pages/scenes.js';
import { interleaved, pairedRatios, quantile, spread } from '../bench/statistics.mjs';

describe('statistics', () => {
  test('lie between neighbours where no sample stands at the share', () => {
    expect(quantile([4, 1, 3, 2], 0.5)).toBe(2.5);
    expect(quantile([4, 1, 3, 2, 5], 0.25)).toBe(2);
    expect(spread([7])).toEqual({ median: 7, low: 7, high: 7, count: 1 });
  });

  test('pair samples of the same round', () => {
    expect(pairedRatios([1, 20], [2, 10])).toEqual([0.5, 2]);
  });

  test('come from rounds that every other time run backwards', async () => {
    const order: string[] = [];
    const samples = await interleaved(['a', 'b'], 3, (subject) => {
      order.push(subject);
      return Promise.resolve(order.length);
    });
    expect(order.join('')).toBe('abbaab');
    expect(samples).toEqual([
      [1, 4, 5],
      [2, 3, 6],
    ]);
  });
});

describe('scenes', () => {
  const query = { kind: 'mixed', seed: 1 } as const;

  test('have as many active lights as they are asked for, spread over all', () => {
    const active = lightsOf({ ...query, lights: 1000, active: 8 }).flatMap((light, i) =>
      light.active === true ? [i] : [],
    );
    expect(active).toEqual([0, 125, 250, 375, 500, 625, 750, 875]);
  });

  test('light every corner of the plane from every light, inside every cone', () => {
    const { positions, normals } = bentPlane();
    let [lowest, widest] = [Infinity, 0];
    for (const { position, axis, aperture } of lightsOf({ ...query, lights: 256, active: 256 })) {
      for (let i = 0; i < positions.length; i += 3) {
        // What a picture of aspect 4:3 to 16:9 shows at the most.
        if (Math.abs(positions[i]!) > 2.3 || Math.abs(positions[i + 1]!) > 1.3) continue;
        const to = [0, 1, 2].map((k) => position[k]! - (position[3] === 0 ? 0 : positions[i + k]!));
        lowest = Math.min(lowest, dot(to, [...normals.subarray(i, i + 3)]));
        if (axis === undefined || aperture === undefined) continue;
        const c = -dot(to, axis) / Math.hypot(...to) / Math.hypot(...axis);
        widest = Math.max(widest, (Math.acos(c) * 180) / Math.PI / aperture);
      }
    }
    expect(lowest).toBeGreaterThan(0);
    expect(widest).toBeLessThan(1);
    expect(widest).toBeGreaterThan(0);
  });
});

describe('a binary glTF', () => {
  test('says its own length and holds the triangles it was made of', () => {
    const triangles = box();
    const file = glbOf(triangles);
    const view = new DataView(file.buffer);
    expect(new TextDecoder().decode(file.subarray(0, 4))).toBe('glTF');
    expect(view.getUint32(8, true)).toBe(file.length);
    const jsonLength = view.getUint32(12, true);
    const at = 20 + jsonLength + 8;
    expect(new Float32Array(file.slice(at, at + 72 * 4).buffer)).toEqual(triangles.positions);
  });

  test.each([
    ['the box', box()],
    ['the bent plane', bentPlane()],
  ] satisfies [string, Triangles][])('%s turns its triangles to where their normals point', (_, shape) => {
    const { positions, normals, indices } = shape;
    const corner = (k: number): number[] => [...positions.subarray(indices[k]! * 3, indices[k]! * 3 + 3)];
    for (let k = 0; k < indices.length; k += 3) {
      const [a, b, c] = [corner(k), corner(k + 1), corner(k + 2)];
      const [u, v] = [b.map((x, i) => x - a[i]!), c.map((x, i) => x - a[i]!)];
      const cross = [0, 1, 2].map(
        (i) => u[(i + 1) % 3]! * v[(i + 2) % 3]! - u[(i + 2) % 3]! * v[(i + 1) % 3]!,
      );
      const normal = [...normals.subarray(indices[k]! * 3, indices[k]! * 3 + 3)];
      expect(dot(cross, normal)).toBeGreaterThan(0);
    }
  });
});

const dot = (a: readonly number[], b: readonly number[]): number =>
  a.reduce((sum, x, i) => sum + x * b[i]!, 0);
