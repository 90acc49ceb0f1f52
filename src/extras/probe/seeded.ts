// Another point and other coefficients for each seed. They depend on the text, the scene and the
// camera alone.
import { type PhongViewer, type FragmentExplanation } from '../../viewer/extra.js';
import { type Intersection, Mesh, Ray, type Raycaster, Vector3 } from 'three';
import { dot, map, type Vec3 } from '../../phong/math/vector.js';
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
  const ray = new Ray(new Vector3(...viewer.camera.eye));
  // What a mesh reads of a Raycaster: with that class `shadeAt` would fetch one more file.
  const caster = { ray, near: 0, far: Infinity } as Raycaster;
  let found: FragmentExplanation | null = null;
  for (let i = 0; i < TRIES && meshes.length > 0; i++) {
    const mesh = meshes[Math.floor(random() * meshes.length)]!;
    ray.lookAt(pointIn(mesh, random));
    const hits: Intersection[] = [];
    // On all layers, and by its triangles: lines of a page's own could ask for a camera.
    meshes.forEach((each) => Mesh.prototype.raycast.call(each, caster, hits));
    const [hit] = hits.sort((a, b) => a.distance - b.distance);
    if (hit === undefined) continue;
    const point = hit.point.toArray();
    if (!isSeen(point)) continue;
    const fragment = await viewer.explain(point);
    if (fragment === null) continue;
    found = fragment;
    if (isTelling(fragment, asked)) break;
  }
  return found;
}

/** A random point of the mesh's box, in world space. */
function pointIn({ geometry, matrixWorld }: Mesh, random: () => number): Vector3 {
  if (geometry.boundingBox === null) {
    geometry.computeBoundingBox();
  }
  const { min, max } = geometry.boundingBox!;
  const share = new Vector3(random(), random(), random());
  return max.clone().sub(min).multiply(share).add(min).applyMatrix4(matrixWorld);
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
