// Are computed tangents those of the surfaces that the texture coordinates describe? Expected
// values come from each surface's own formula. Green points up the image, and glTF's v runs down
// it.
import fc from 'fast-check';
import { BufferAttribute, BufferGeometry, SphereGeometry, Texture } from 'three';
import { describe, expect, it } from 'vitest';
import {
  cross,
  dot,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../../../src/phong/math/vector.js';
import { addTangents } from '../../../src/extras/models/gltf/computed-vectors.js';
import { Slices } from '../../../src/extras/models/slices.js';
import { between } from '../../unit/arbitraries.js';

interface Frame {
  readonly T: Vec3;
  /** N × T · w. */
  readonly up: Vec3;
}

async function framesOf(geometry: BufferGeometry): Promise<readonly Frame[]> {
  await addTangents(geometry, new Texture(), new Slices(new AbortController().signal));
  const { array, count } = geometry.getAttribute('tangent');
  const normals = geometry.getAttribute('normal').array;
  return Array.from({ length: count }, (_, i) => {
    const [x = 0, y = 0, z = 0, w = 0] = array.subarray(4 * i, 4 * i + 4);
    const N: Vec3 = [normals[3 * i]!, normals[3 * i + 1]!, normals[3 * i + 2]!];
    return { T: [x, y, z], up: scale(cross(N, [x, y, z]), w) };
  });
}

const unit = fc
  .tuple(between(0, 6.28), between(-0.99, 0.99))
  .map(([angle, z]) => normalize([Math.cos(angle), Math.sin(angle), z / Math.sqrt(1 - z * z)]));

const CORNERS = [[0, 0], [1, 0], [0, 1], [1, 1]] as const; // oxfmt-ignore

const quad = (N: Vec3, alongU: Vec3, alongV: Vec3) => {
  const geometry = new BufferGeometry().setIndex([0, 1, 2, 2, 1, 3]);
  const set = (name: string, of: (u: number, v: number) => readonly number[]) => {
    const values = CORNERS.flatMap(([u, v]) => of(u, v));
    geometry.setAttribute(name, new BufferAttribute(Float32Array.from(values), values.length / 4));
  };
  set('position', (u, v) => alongU.map((c, i) => u * c + v * alongV[i]!));
  set('normal', () => N);
  set('uv', (u, v) => [u, v]);
  return geometry;
};

describe('computed tangents', () => {
  it('point along u, and their third direction up the image, on a quad of any orientation, mirrored or not', async () => {
    const property = fc.asyncProperty(unit, unit, fc.boolean(), async (N, other, mirrored) => {
      fc.pre(Math.abs(dot(N, other)) < 0.99);
      const right = normalize(cross(N, other));
      const up = scale(cross(N, right), mirrored ? -1 : 1);
      for (const frame of await framesOf(quad(N, right, scale(up, -2)))) {
        expect(Math.hypot(...subtract(frame.T, right))).toBeLessThan(1e-5);
        expect(Math.hypot(...subtract(frame.up, up))).toBeLessThan(1e-5);
      }
    });
    await fc.assert(property);
  });

  it.each([
    ['a sphere', new SphereGeometry(1, 48, 24)],
    ['separate triangles', new SphereGeometry(1, 48, 24).toNonIndexed()],
  ])(
    'follow the parallels of %s, and point to the north where v runs south',
    async (_, geometry) => {
      // three.js counts v from the south.
      const uvs = geometry.getAttribute('uv').array;
      for (let i = 1; i < uvs.length; i += 2) {
        uvs[i] = 1 - uvs[i]!;
      }
      const positions = geometry.getAttribute('position');
      let compared = 0;
      for (const [i, { T, up }] of (await framesOf(geometry)).entries()) {
        const [x, y, z]: Vec3 = [positions.getX(i), positions.getY(i), positions.getZ(i)];
        if (Math.abs(y) > 0.9) continue; // triangles at the poles are long and thin in u
        // x = −cos φ sin θ, z = sin φ sin θ with φ = 2πu.
        expect(dot(T, normalize([z, 0, -x]))).toBeGreaterThan(0.99);
        expect(up[1]).toBeGreaterThan(0);
        compared += 1;
      }
      expect(compared).toBeGreaterThan(500);
    },
  );

  it('are zero where the texture coordinates give no direction', async () => {
    const geometry = new SphereGeometry(1, 20, 10);
    geometry.getAttribute('uv').array.fill(0.5);
    for (const { T } of await framesOf(geometry)) {
      expect(T).toEqual([0, 0, 0]);
    }
    const { array } = geometry.getAttribute('tangent');
    expect(array.every((value, i) => value === (i % 4 === 3 ? 1 : 0))).toBe(true);
  });
});
