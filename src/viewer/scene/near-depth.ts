// The depth of the nearest surface in view, along the view: faces are cut by its sides. Float64,
// relative to the eye.
import {
  type BufferAttribute,
  type BufferGeometry,
  type InstancedMesh,
  type LineLoop,
  type LineSegments,
  type Material,
  Matrix4,
  type Mesh,
  type Object3D,
  Sphere,
} from 'three';
import { PhongMaterial } from '../../phong/material/phong-material.js';
import { hasMovingVertices } from '../../phong/geometry/geometry-size.js';
import { boundsOf } from '../../phong/geometry/bounds.js';
import {
  depthOf,
  sphereDepth,
  triangleDepth,
  type Frustum,
  writeModelViewProjection,
} from '../../phong/geometry/frustum-clip.js';
import type { Position } from '../../phong/geometry/triangle-bvh.js';
import type { InViewQuery } from '../../phong/geometry/triangles-in-view.js';
import { fasterCode, lazyCode } from '../../phong/lazy-code.js';

/** Corners of 4,096 triangles. To read fewer in each frame takes a quarter of a millisecond. */
const LARGE = 3 * 4096;

const skippingCode = /* @__PURE__ */ fasterCode(
  /* @__PURE__ */ lazyCode(
    () => import('../../phong/geometry/triangles-in-view.js'),
    'large geometries near the eye',
  ),
);

/**
 * Share of the orbit's radius. Objects with vertices that only the GPU knows are never cut beyond
 * this distance.
 */
const UNKNOWN_NEAREST = 1e-5;

/**
 * The least depth of what is visible below `root` and in view, at most `limit`. Exact for
 * triangles, lines and points. Objects whose vertices only the GPU knows (skinned, displaced, drawn
 * by a shader of the page's own) count by their spheres, down to {@link UNKNOWN_NEAREST}. World
 * matrices must be up to date.
 */
export function nearestDepth(root: Object3D, view: Frustum, limit: number): number {
  search.view = view;
  search.nearest = limit;
  search.below(root);
  return search.nearest;
}

class NearestSearch implements InViewQuery {
  view!: Frustum;
  nearest = 0;
  /** From the present object's own space to clip coordinates. */
  readonly matrix = new Float64Array(12);
  #position!: Position;
  #index: BufferAttribute | null = null;

  below(object: Object3D): void {
    if (!object.visible) return;
    if (boundsOf(object, ball)) {
      this.#object(object as Mesh);
    }
    const { children } = object;
    for (let i = 0; i < children.length; i++) {
      this.below(children[i]!);
    }
  }

  #object(object: Mesh): void {
    const { elements } = object.matrixWorld;
    const least = sphereDepth(this.view, elements, ball, this.nearest);
    if (least >= this.nearest) return;
    writeModelViewProjection(this.view, elements, this.matrix);
    const { isInstancedMesh, isSprite } = object as Partial<InstancedMesh> & { isSprite?: boolean };
    if (isSprite === true) {
      const { x, y, z } = ball.center;
      this.#consider(depthOf(this.matrix, x, y, z)); // it faces the eye
    } else if (!hasKnownVertices(object)) {
      this.#consider(Math.max(least, unknownDepth(this.view)));
    } else if (isInstancedMesh === true) {
      this.#instances(object as InstancedMesh);
    } else {
      this.#geometry(object.geometry, object);
    }
  }

  #instances(object: InstancedMesh): void {
    const { geometry, instanceMatrix, count, matrixWorld } = object;
    if (geometry.boundingSphere === null) {
      geometry.computeBoundingSphere();
    }
    ball.copy(geometry.boundingSphere!);
    for (let i = 0; i < count; i++) {
      const { elements } = instance
        .fromArray(instanceMatrix.array, 16 * i)
        .premultiply(matrixWorld);
      if (sphereDepth(this.view, elements, ball, this.nearest) >= this.nearest) continue;
      writeModelViewProjection(this.view, elements, this.matrix);
      this.#geometry(geometry, object);
    }
  }

  /** Triangles, or the segments of lines, or points. */
  #geometry(geometry: BufferGeometry, object: Object3D): void {
    this.#index = geometry.index;
    this.#position = geometry.getAttribute('position');
    const { count } = this.#index ?? this.#position;
    const { isMesh, isLine, isLineSegments, isLineLoop } = object as Partial<
      Mesh & LineLoop & LineSegments
    >;
    if (isMesh !== true) {
      const [step, size] = isLineSegments === true ? [2, 1] : [1, isLine === true ? 1 : 0];
      for (let i = 0; i + size < count; i += step) {
        this.#triangle(i, i, i + size);
      }
      if (isLineLoop === true) {
        this.#triangle(0, 0, count - 1);
      }
      return;
    }
    const skipping = count > LARGE && !hasMovingVertices(geometry) ? skippingCode() : null;
    if (skipping === null) {
      this.visit(0, count);
    } else {
      skipping.visitInView(geometry, this);
    }
  }

  visit(first: number, end: number): boolean {
    for (let i = first; i + 2 < end; i += 3) {
      this.#triangle(i, i + 1, i + 2);
    }
    return false;
  }

  #triangle(a: number, b: number, c: number): void {
    const index = this.#index;
    const i = index === null ? a : index.getX(a);
    const j = index === null ? b : index.getX(b);
    const k = index === null ? c : index.getX(c);
    this.nearest = triangleDepth(this.matrix, this.view, this.#position, i, j, k, this.nearest);
  }

  /** NaN is ignored. */
  #consider(depth: number): void {
    if (depth >= 0 && depth < this.nearest) {
      this.nearest = depth;
    }
  }
}

/** Used within one call: nothing is allocated in a frame. */
const ball = /* @__PURE__ */ new Sphere();
const instance = /* @__PURE__ */ new Matrix4();
const search = /* @__PURE__ */ new NearestSearch();

/** {@link UNKNOWN_NEAREST} in the corners of the view. */
const unknownDepth = ({ radius, slopeX, slopeY }: Frustum): number =>
  (UNKNOWN_NEAREST * radius) / Math.hypot(1, slopeX, slopeY);

function hasKnownVertices(object: Mesh): boolean {
  const { isSkinnedMesh, isBatchedMesh } = object as {
    isSkinnedMesh?: boolean;
    isBatchedMesh?: boolean;
  };
  const { isInstancedBufferGeometry } = object.geometry as { isInstancedBufferGeometry?: boolean };
  if (isSkinnedMesh === true || isBatchedMesh === true || isInstancedBufferGeometry === true) {
    return false;
  }
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
