// The depth of the nearest surface in view: faces are cut by the sides of the view, so that nothing outside it
// counts. World space and float64, relative to the eye; depth is measured along the view.
import {
  type BufferAttribute,
  type BufferGeometry,
  type InstancedMesh,
  type InterleavedBufferAttribute,
  type Material,
  Matrix4,
  type Mesh,
  type Object3D,
} from 'three';
import { PhongMaterial } from '../material/phong-material.js';
import { boundsOf, hasMovingVertices, newBall, stretch } from './bounds.js';
import { type BoxList, forEachRun } from './triangle-boxes.js';
import {
  along,
  cutTriangle,
  DEPTH,
  isInView,
  leastDepth,
  polygon,
  setCorner,
  setObject,
  setView,
  STRIDE,
  type View,
} from './view-cut.js';

/** Share of the orbit's radius. Objects with vertices that only the GPU knows are never cut beyond this distance. */
const UNKNOWN_NEAREST = 1e-5;

/** The least depth found so far. */
let nearest = 0;
/** {@link UNKNOWN_NEAREST} in the corners of the view. */
let unknownDepth = 0;

/**
 * The least depth of what is visible below `root` and in view, or `limit` where nothing is nearer. Exact for
 * triangles, lines and points as they are stored. Objects whose vertices only the GPU knows (skinned, displaced,
 * drawn by a shader of the page's own) count by their spheres, but never as nearer than 1e-5 of the orbit's radius.
 * World matrices must be up to date.
 */
export function nearestDepth(root: Object3D, view: View, limit: number): number {
  setView(view);
  nearest = limit;
  unknownDepth = (UNKNOWN_NEAREST * view.radius) / Math.hypot(1, view.slopeX, view.slopeY);
  searchBelow(root);
  return nearest;
}

function searchBelow(object: Object3D): void {
  if (!object.visible) return;
  if (boundsOf(object, ball)) search(object as Mesh);
  const { children } = object;
  for (let i = 0; i < children.length; i++) searchBelow(children[i]!);
}

const ball = newBall();

function search(object: Mesh): void {
  const { elements } = object.matrixWorld;
  setObject(elements);
  const least = leastDepth(ball.x, ball.y, ball.z, ball.radius * stretch(elements));
  if (least >= nearest) return;
  const { isInstancedMesh, isSprite } = object as Partial<InstancedMesh> & { isSprite?: boolean };
  if (isSprite === true)
    consider(along(DEPTH, ball.x, ball.y, ball.z)); // it faces the eye
  else if (!hasKnownVertices(object)) consider(Math.max(least, unknownDepth));
  else if (isInstancedMesh === true) searchInstances(object as InstancedMesh);
  else searchGeometry(object.geometry, object);
}

const instance = /* @__PURE__ */ new Matrix4();

function searchInstances(object: InstancedMesh): void {
  const { geometry, instanceMatrix, count, matrixWorld } = object;
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
  const { center, radius } = geometry.boundingSphere!;
  for (let i = 0; i < count; i++) {
    instance.fromArray(instanceMatrix.array, 16 * i).premultiply(matrixWorld);
    setObject(instance.elements);
    if (leastDepth(center.x, center.y, center.z, radius * stretch(instance.elements)) < nearest)
      searchGeometry(geometry, object);
  }
}

/** The vertices are drawn as they are stored. */
function hasKnownVertices(object: Mesh): boolean {
  const { isSkinnedMesh, isBatchedMesh } = object as { isSkinnedMesh?: boolean; isBatchedMesh?: boolean };
  const { isInstancedBufferGeometry } = object.geometry as { isInstancedBufferGeometry?: boolean };
  if (isSkinnedMesh === true || isBatchedMesh === true || isInstancedBufferGeometry === true) return false;
  if (object.morphTargetInfluences !== undefined) return false;
  const material = object.material as Material | Material[] | undefined;
  if (Array.isArray(material)) return material.every(keepsVertices);
  return material === undefined || keepsVertices(material);
}

function keepsVertices(material: Material): boolean {
  if (material instanceof PhongMaterial) return true;
  const { isShaderMaterial, displacementMap } = material as {
    isShaderMaterial?: boolean;
    displacementMap?: unknown;
  };
  if (isShaderMaterial === true || (displacementMap ?? null) !== null) return false;
  return !Object.hasOwn(material, 'onBeforeCompile');
}

/** NaN, of a broken vertex, is ignored: it is not drawn either. */
function consider(depth: number): void {
  if (depth >= 0 && depth < nearest) nearest = depth;
}

let position: BufferAttribute | InterleavedBufferAttribute;
let index: BufferAttribute | null = null;

/** Triangles, or the segments of lines, or points. */
function searchGeometry(geometry: BufferGeometry, object: Object3D): void {
  ({ index } = geometry);
  position = geometry.getAttribute('position');
  const { count } = index ?? position;
  const { isMesh, isLineSegments, isLine } = object as Partial<Mesh> & {
    isLineSegments?: boolean;
    isLine?: boolean;
  };
  if (isMesh !== true) {
    const [step, size] = isLineSegments === true ? [2, 1] : [1, isLine === true ? 1 : 0];
    for (let i = 0; i + size < count; i += step) searchTriangle(i, i, i + size);
    if ((object as { isLineLoop?: boolean }).isLineLoop === true) searchTriangle(0, 0, count - 1);
  } else if (hasMovingVertices(geometry)) searchRun(0, count);
  else forEachRun(geometry, meetsView, searchRun);
}

const meetsView = (boxes: BoxList, at: number): boolean => isInView(boxes, at, nearest);

function searchRun(first: number, end: number): void {
  for (let i = first; i + 2 < end; i += 3) searchTriangle(i, i + 1, i + 2);
}

function searchTriangle(a: number, b: number, c: number): void {
  setCorner(0, position, index === null ? a : index.getX(a));
  setCorner(1, position, index === null ? b : index.getX(b));
  setCorner(2, position, index === null ? c : index.getX(c));
  const p = polygon;
  if (p[2]! >= nearest && p[STRIDE + 2]! >= nearest && p[2 * STRIDE + 2]! >= nearest) return;
  const corners = cutTriangle();
  for (let i = 0; i < corners; i++) consider(p[STRIDE * i + 2]!);
}
