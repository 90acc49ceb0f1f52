// Which fragment does a picture show at a pixel? The nearest point of what is drawn, by a ray in float64 from the orbit's
// own basis. Knows three.js and the Phong material; must not know lights or elements.
import {
  type Intersection,
  type Material,
  type Mesh,
  type Object3D,
  type PerspectiveCamera,
  Raycaster,
  type Vector3,
} from 'three';
import type { ShadingFrame } from '../../material/phong-lighting.js';
import { PhongMaterial } from '../../material/phong-material.js';
import { add, dot, scale, subtract, type Vec3 } from '../../math/vector.js';
import { type BaseColor, baseColorAt } from './base-color.js';
import { forEachHit, type TriangleHit, type ViewRay } from './ray-triangles.js';

/** The point of a Phong-lit surface that is seen through a pixel. */
export interface Hit extends TriangleHit {
  readonly object: Mesh;
  readonly material: PhongMaterial;
  readonly frame: ShadingFrame;
  /** Place relative to the frame's origin. */
  readonly p: Vec3;
  readonly base: BaseColor;
}

/**
 * What is seen of `scene` along `ray` by `camera`, which must look as the ray's frame says. World matrices must be up to
 * date. Null where that is nothing, or a mesh or sprite that is not `own` or has another material than the Phong one;
 * lines and points are looked through. Of blended surfaces the nearest counts, however much shows through it.
 */
export function pick(
  scene: Object3D,
  camera: PerspectiveCamera,
  ray: ViewRay,
  own: (object: Object3D) => boolean,
): Hit | null {
  let nearest: Hit | null = null;
  let depth = Infinity;
  for (const object of drawnObjects(scene, camera)) {
    if (isPhong(object) && own(object)) {
      for (const hit of phongHits(object, ray)) {
        // As the depth test: of two that are equally near the later one stays.
        if (hit.depth <= depth * (1 + COPLANAR)) ({ depth } = nearest = hit);
      }
    } else {
      const foreign = foreignDepth(object, camera, ray);
      if (foreign < depth) [nearest, depth] = [null, foreign];
    }
  }
  return nearest;
}

/** Faces in one plane, such as a flattened box's, differ in depth by roundings of float64: some 1e-15, times a few. */
const COPLANAR = 1e-12;

type PhongMesh = Mesh & { readonly material: PhongMaterial };

const isPhong = (object: Object3D): object is PhongMesh =>
  (object as Partial<Mesh>).isMesh === true && (object as Mesh).material instanceof PhongMaterial;

/** In the order of the tree, with three.js's own rules of what is drawn. */
function drawnObjects(object: Object3D, camera: PerspectiveCamera, into: Object3D[] = []): Object3D[] {
  if (!object.visible) return into;
  const { material } = object as { material?: Material | Material[] };
  const hidden = material !== undefined && !Array.isArray(material) && !material.visible;
  if (!hidden && object.layers.test(camera.layers)) into.push(object);
  for (const child of object.children) drawnObjects(child, camera, into);
  return into;
}

function phongHits(object: PhongMesh, ray: ViewRay): Hit[] {
  const { geometry, material, matrixWorld } = object;
  const { index, drawRange } = geometry;
  const count = (index ?? geometry.getAttribute('position')).count;
  const range = [Math.max(drawRange.start, 0), Math.min(drawRange.start + drawRange.count, count)] as const;
  const hits: Hit[] = [];
  forEachHit(ray, geometry, matrixWorld, range, (hit) => {
    const base = baseColorAt(material.look, geometry, hit, material.linear);
    if (base.discarded) return;
    hits.push({ ...hit, object, material, base, frame: ray.frame, p: placeAt(ray, hit.depth) });
  });
  return hits;
}

const placeAt = ({ frame, slopeX, slopeY }: ViewRay, depth: number): Vec3 =>
  add(frame.eye, scale(direction(frame, slopeX, slopeY), depth));

const direction = ({ right, up, back }: ShadingFrame, slopeX: number, slopeY: number): Vec3 =>
  subtract(add(scale(right, slopeX), scale(up, slopeY)), back);

/** How deep a mesh or sprite of somebody else's lies, by three.js's own means; Infinity where it is not hit. */
function foreignDepth(object: Object3D, camera: PerspectiveCamera, ray: ViewRay): number {
  const { isMesh, isSprite } = object as { isMesh?: boolean; isSprite?: boolean };
  if (isMesh !== true && isSprite !== true) return Infinity;
  const { frame } = ray;
  const caster = new Raycaster();
  caster.camera = camera;
  caster.ray.origin.set(...add(frame.origin, frame.eye));
  caster.ray.direction.set(...direction(frame, ray.slopeX, ray.slopeY)).normalize();
  const hits: Intersection[] = [];
  object.raycast(caster, hits);
  let nearest = Infinity;
  for (const { point } of hits) {
    const depth = depthOf(point, frame);
    if (depth >= ray.near && depth <= ray.far) nearest = Math.min(nearest, depth);
  }
  return nearest;
}

const depthOf = ({ x, y, z }: Vector3, { origin, eye, back }: ShadingFrame): number =>
  -dot(subtract(subtract([x, y, z], origin), eye), back);
