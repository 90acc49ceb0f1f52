// A pyramid of height 1 on a square base, whose corners lie on a circle of diameter 1 as a cone's do. Centred on the
// origin, apex toward +y, sides facing the axes, as a box's do. Each face has its own vertices and normal.
import { BufferGeometry, Float32BufferAttribute } from 'three';
import { cross, normalize, subtract, type Vec3 } from '../../../math/vector.js';

const CORNER = Math.SQRT1_2 / 2;
const APEX: Vec3 = [0, 0.5, 0];
/** Counter-clockwise seen from above, from the front left. */
const BASE: readonly [Vec3, Vec3, Vec3, Vec3] = [
  [-CORNER, -0.5, CORNER],
  [CORNER, -0.5, CORNER],
  [CORNER, -0.5, -CORNER],
  [-CORNER, -0.5, -CORNER],
];

/** @param segments parts into which every edge is divided, for lighting per vertex; at least 1. */
export function pyramidGeometry(segments: number): BufferGeometry {
  const mesh: Lists = { position: [], normal: [], uv: [], index: [] };
  const [a, b, c, d] = BASE;
  for (const [left, right] of [
    [a, b],
    [b, c],
    [c, d],
    [d, a],
  ] as const)
    addTriangle(mesh, left, right, APEX, segments);
  addTriangle(mesh, a, d, c, segments);
  addTriangle(mesh, c, b, a, segments);
  const geometry = new BufferGeometry();
  geometry.setIndex(mesh.index);
  geometry.setAttribute('position', new Float32BufferAttribute(mesh.position, 3));
  geometry.setAttribute('normal', new Float32BufferAttribute(mesh.normal, 3));
  geometry.setAttribute('uv', new Float32BufferAttribute(mesh.uv, 2));
  return geometry;
}

const normalOf = (a: Vec3, b: Vec3, c: Vec3): Vec3 => normalize(cross(subtract(b, a), subtract(c, a)));

interface Lists {
  readonly position: number[];
  readonly normal: number[];
  readonly uv: number[];
  readonly index: number[];
}

/** The triangle a b c, counter-clockwise from outside, as rows of n, n - 1, … small ones from ab up to c. */
function addTriangle(mesh: Lists, a: Vec3, b: Vec3, c: Vec3, n: number): void {
  const normal = normalOf(a, b, c);
  let row = mesh.position.length / 3;
  for (let j = 0; j <= n; j += 1) {
    const v = j / n;
    const width = n - j;
    for (let i = 0; i <= width; i += 1) {
      const u = i / n;
      const w = (width - i) / n;
      for (const axis of [0, 1, 2] as const) {
        mesh.position.push(w * a[axis] + u * b[axis] + v * c[axis]);
      }
      mesh.normal.push(...normal);
      mesh.uv.push(u + v / 2, v);
      if (i === width) continue;
      const here = row + i;
      const above = here + width + 1;
      mesh.index.push(here, here + 1, above);
      if (i + 1 < width) mesh.index.push(here + 1, above + 1, above);
    }
    row += width + 1;
  }
}
