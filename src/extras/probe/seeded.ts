// Another point and other coefficients for each seed. They depend on the text, the scene and the
// camera alone.
import { type PhongViewer, type FragmentExplanation } from '../../viewer/extra.js';
import type { Mesh } from 'three';
import {
  add,
  cross,
  dot,
  map,
  scale,
  subtract,
  transformed,
  type Vec3,
} from '../../phong/math/vector.js';
import { withCoefficients } from './equations.js';
import { type Asked, isAsked } from './probe-fields.js';

/** Numbers from 0 to 1, the same for the same text: FNV-1a, then mulberry32. */
function randomBy(seed: string): () => number {
  let state = 0x811c9dc5;
  for (const char of seed) {
    state = Math.imul(state ^ char.codePointAt(0)!, 0x01000193);
  }
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let x = Math.imul(state ^ (state >>> 15), 1 | state);
    x = (x + Math.imul(x ^ (x >>> 7), 61 | x)) ^ x;
    return ((x ^ (x >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Points tried before the last one stays: on a sphere about every fourth is lit. */
const TRIES = 100;

/**
 * A point that is seen from the eye and that what is asked adds light to; null where no surface is.
 * It does not depend on how shapes are cut into triangles, but by how far these are off.
 */
export async function seededFragment(
  viewer: PhongViewer,
  seed: string,
  asked: Asked | null,
  isSeen: (point: Vec3) => boolean,
): Promise<FragmentExplanation | null> {
  const meshes: Mesh[] = [];
  viewer.scene.updateMatrixWorld();
  viewer.scene.traverseVisible((object) => {
    if ('isMesh' in object && (object as Mesh).geometry.hasAttribute('position')) {
      meshes.push(object as Mesh);
    }
  });
  const random = randomBy(seed);
  const { eye } = viewer.camera;
  let found: FragmentExplanation | null = null;
  for (let i = 0; i < TRIES && meshes.length > 0; i++) {
    const mesh = meshes[Math.floor(random() * meshes.length)]!;
    const toward = subtract(pointIn(mesh, random), eye);
    const away = Math.min(...meshes.map((each) => distanceTo(each, eye, toward)));
    const point = add(eye, scale(toward, away));
    if (away === Infinity || !isSeen(point)) continue;
    const fragment = await viewer.explain(point);
    if (fragment === null) continue;
    found = fragment;
    if (isTelling(fragment, asked)) break;
  }
  return found;
}

/** A random point of the mesh's box, in world space. */
function pointIn({ geometry, matrixWorld }: Mesh, random: () => number): Vec3 {
  if (geometry.boundingBox === null) {
    geometry.computeBoundingBox();
  }
  const { min, max } = geometry.boundingBox!;
  const [x, y, z] = (['x', 'y', 'z'] as const).map(
    (axis) => min[axis] + random() * (max[axis] - min[axis]),
  ) as [number, number, number];
  return transformed(matrixWorld.elements, x, y, z);
}

/** In lengths of `toward`; Infinity where the ray meets no triangle. World space. */
function distanceTo({ geometry, matrixWorld }: Mesh, eye: Vec3, toward: Vec3): number {
  const toLocal = matrixWorld.clone().invert().elements;
  const from = transformed(toLocal, ...eye);
  const along = transformed(toLocal, ...toward, 0);
  const { index } = geometry;
  const places = geometry.getAttribute('position');
  const corner = (i: number): Vec3 => {
    const at = index?.getX(i) ?? i;
    return [places.getX(at), places.getY(at), places.getZ(at)];
  };
  let nearest = Infinity;
  for (let i = 0; i + 2 < (index ?? places).count; i += 3) {
    const a = corner(i);
    const [ab, ac] = [subtract(corner(i + 1), a), subtract(corner(i + 2), a)];
    // By Cramer's rule (Möller and Trumbore 1997).
    const across = cross(along, ac);
    const away = subtract(from, a);
    const over = cross(away, ab);
    const volume = dot(ab, across);
    const [u, v, t] = [dot(away, across), dot(along, over), dot(ac, over)].map((x) => x / volume);
    if (u! >= 0 && v! >= 0 && u! + v! <= 1 && t! > 0) {
      nearest = Math.min(nearest, t!);
    }
  }
  return nearest;
}

/** Not at the edge of what is seen, and at least five codes of light. */
function isTelling({ N, V, shares }: FragmentExplanation, asked: Asked | null): boolean {
  const term = asked === null || asked.term === 'sum' ? 'diffuse' : asked.term;
  return (
    dot(N, V) > 0.25 &&
    shares.some(
      (share) =>
        share !== null &&
        (asked === null || isAsked(asked, share)) &&
        Math.max(...share[term]) > 0.02,
    )
  );
}

/** Coefficients from 0.6 of the scene's on, in hundredths. */
export function seededNumbers(
  fragment: FragmentExplanation,
  seed: string,
  linear: boolean,
): FragmentExplanation {
  const random = randomBy(`${seed} `);
  return withCoefficients(fragment, linear, (k) => {
    const factor = 0.6 + 0.4 * random();
    return map(k, (x) => (x === 0 ? 0 : Math.max(Math.round(100 * x * factor), 1) / 100));
  });
}
