// Draws shapes whose triangles are so large for their distance from the eye that rasterisers lose them: in a frame
// their triangles are replaced by what the view leaves of them, cut in float64.
import {
  Box3,
  type BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Float32BufferAttribute,
  type InterleavedBufferAttribute,
  Matrix4,
  type Mesh,
  Sphere,
  Vector3,
} from 'three';
import { PLAIN_LOOK } from '../material/file-surface.js';
import { declareFaces, facesOf } from '../material/flat-faces.js';
import { boundsOf, hasMovingVertices, newBall, stretch } from './bounds.js';
import type { SceneMesh } from './mesh/scene-mesh.js';
import type { Part } from './mesh/parts.js';
import { type BoxList, forEachRun } from './triangle-boxes.js';
import {
  cutTriangle,
  isInView,
  leastDepth,
  polygon,
  setCorner,
  setObject,
  setView,
  STRIDE,
  type View,
} from './view-cut.js';

/**
 * A square's radius over the depth at which it may begin. Measured in SwiftShader: a floor seen from its back vanishes
 * while its vertices lie within a fraction of a pixel of the horizon. In a picture of 30 rows all of it is lost at a
 * ratio of 5,800, and some pixels at 1,750. Of n triangles each is about sqrt(n / 2) times smaller.
 */
const LARGE = 2 ** 7;

/**
 * The same for shapes of any number of triangles. A vertex so far away is off by 2^-7 of that depth at most, less
 * than the share by which the near plane lies before it. GPUs draw all that is less, so what depends on the vertices
 * themselves is kept till then.
 */
const HUGE = 2 ** 16;

/** How much wider than the picture the cut is: its edges stay outside, whatever rounding does to them. */
const WIDER = 1.05;

/** Stands in for a mesh while a frame is drawn. */
interface Stand {
  /** What {@link geometry} is cut from. */
  readonly source: BufferGeometry;
  readonly geometry: BufferGeometry;
  readonly matrixWorld: Matrix4;
}

interface Lent {
  readonly mesh: Mesh;
  readonly geometry: BufferGeometry;
  readonly matrixWorld: Matrix4;
}

export class HugeShapes {
  readonly #stands = new Map<Mesh, Stand>();
  readonly #lent: Lent[] = [];

  /**
   * Replaces what needs it until {@link restore}. `near` and `far` are those of the view. `separate`: the picture
   * shows the triangles themselves.
   */
  replace(meshes: Iterable<SceneMesh>, view: View, near: number, far: number, separate: boolean): void {
    if (far > LARGE * near) {
      setView({ ...view, slopeX: WIDER * view.slopeX, slopeY: WIDER * view.slopeY });
      for (const { parts } of meshes)
        for (const part of parts) if (isHuge(part, near, separate)) this.#replace(part.mesh, view);
    }
    if (this.#stands.size > this.#lent.length) this.#free(new Set(this.#lent.map(({ mesh }) => mesh)));
  }

  restore(): void {
    for (const { mesh, geometry, matrixWorld } of this.#lent) {
      mesh.geometry = geometry;
      mesh.matrixWorld = matrixWorld;
    }
    this.#lent.length = 0;
  }

  dispose(): void {
    this.#free(new Set());
  }

  #replace(mesh: Mesh, view: View): void {
    const { geometry, matrixWorld } = mesh;
    const stand = this.#standOf(mesh);
    centerAt(stand.matrixWorld.copy(matrixWorld), view.frame.origin);
    setObject(matrixWorld.elements);
    writeCut(stand.geometry, geometry);
    writeBounds(stand.geometry, geometry);
    this.#lent.push({ mesh, geometry, matrixWorld });
    mesh.geometry = stand.geometry;
    mesh.matrixWorld = stand.matrixWorld;
  }

  #standOf(mesh: Mesh): Stand {
    const present = this.#stands.get(mesh);
    if (present?.source === mesh.geometry) return present;
    present?.geometry.dispose();
    const stand = { source: mesh.geometry, geometry: new BufferGeometry(), matrixWorld: new Matrix4() };
    this.#stands.set(mesh, stand);
    return stand;
  }

  #free(kept: ReadonlySet<Mesh>): void {
    for (const [mesh, { geometry }] of this.#stands) {
      if (kept.has(mesh)) continue;
      geometry.dispose();
      this.#stands.delete(mesh);
    }
  }
}

const ball = newBall();

/** Whether it is of a built-in shape, or of a model with places and normals alone. */
function isHuge({ mesh, look, material }: Readonly<Part>, near: number, separate: boolean): boolean {
  const { geometry } = mesh;
  if (look !== PLAIN_LOOK || !mesh.visible || hasMovingVertices(geometry)) return false;
  if (!geometry.hasAttribute('normal') || !boundsOf(mesh, ball)) return false;
  const triangles = (geometry.index ?? geometry.getAttribute('position')).count / 3;
  const showsVertices = separate || material.style.shading === 'gouraud';
  const limit = showsVertices ? HUGE : Math.min(HUGE, LARGE * Math.sqrt(triangles / 2));
  const { elements } = mesh.matrixWorld;
  const radius = ball.radius * stretch(elements);
  if (!(radius > limit * near)) return false;
  setObject(elements);
  return radius > limit * leastDepth(ball.x, ball.y, ball.z, radius);
}

/** The point of the object's own space that a stand has at its origin. */
const center = /* @__PURE__ */ new Vector3();

/**
 * Finds {@link center}, and moves the matrix there: near `target`, so that a float32 can tell vertices in view from
 * each other. It is the target itself where the matrix neither shears nor flattens.
 */
function centerAt({ elements: m }: Matrix4, target: readonly number[]): void {
  const x = target[0]! - m[12];
  const y = target[1]! - m[13];
  const z = target[2]! - m[14];
  for (let axis = 0; axis < 3; axis++) {
    const e = m[4 * axis]!;
    const f = m[4 * axis + 1]!;
    const g = m[4 * axis + 2]!;
    const squared = e * e + f * f + g * g;
    center.setComponent(axis, squared > 0 ? (x * e + y * f + z * g) / squared : 0);
  }
  for (let row = 0; row < 3; row++)
    m[12 + row]! += m[row]! * center.x + m[4 + row]! * center.y + m[8 + row]! * center.z;
}

/** Place and normal of each corner of the cut's triangles. */
const places: number[] = [];
const normals: number[] = [];
let position: BufferAttribute | InterleavedBufferAttribute;
let normal: BufferAttribute | InterleavedBufferAttribute;
let index: BufferAttribute | null = null;

/** Writes what the view leaves of a geometry, relative to {@link center}. */
function writeCut(into: BufferGeometry, from: BufferGeometry): void {
  ({ index } = from);
  position = from.getAttribute('position');
  normal = from.getAttribute('normal');
  places.length = 0;
  normals.length = 0;
  forEachRun(from, meetsView, cutRun);
  write(into, 'position', places);
  write(into, 'normal', normals);
  into.setDrawRange(0, places.length / 3);
}

/** The bounds of the whole, so that culling is the same, and its flat faces. */
function writeBounds(into: BufferGeometry, from: BufferGeometry): void {
  if (from.boundingBox === null) from.computeBoundingBox();
  if (from.boundingSphere === null) from.computeBoundingSphere();
  box.copy(from.boundingBox!);
  box.min.sub(center);
  box.max.sub(center);
  // A new object when it has changed: light culling caches by identity.
  if (into.boundingBox?.equals(box) === true) return;
  into.boundingBox = box.clone();
  into.boundingSphere = new Sphere().copy(from.boundingSphere!);
  into.boundingSphere.center.sub(center);
  const { x, y, z } = center;
  const faces = facesOf(from);
  if (faces !== undefined)
    declareFaces(
      into,
      faces.map(({ point: [px, py, pz], normal }) => ({ point: [px - x, py - y, pz - z], normal })),
    );
}

const box = /* @__PURE__ */ new Box3();

const meetsView = (boxes: BoxList, at: number): boolean => isInView(boxes, at, Infinity);

function cutRun(first: number, end: number): void {
  for (let i = first; i + 2 < end; i += 3) {
    for (let k = 0; k < 3; k++) setVertex(k, index === null ? i + k : index.getX(i + k));
    const corners = cutTriangle();
    for (let k = 2; k < corners; k++) {
      add(0);
      add(k - 1);
      add(k);
    }
  }
}

function setVertex(k: number, vertex: number): void {
  setCorner(k, position, vertex);
  const at = STRIDE * k + 3;
  polygon[at] = position.getX(vertex) - center.x;
  polygon[at + 1] = position.getY(vertex) - center.y;
  polygon[at + 2] = position.getZ(vertex) - center.z;
  polygon[at + 3] = normal.getX(vertex);
  polygon[at + 4] = normal.getY(vertex);
  polygon[at + 5] = normal.getZ(vertex);
}

function add(corner: number): void {
  const at = STRIDE * corner + 3;
  places.push(polygon[at]!, polygon[at + 1]!, polygon[at + 2]!);
  normals.push(polygon[at + 3]!, polygon[at + 4]!, polygon[at + 5]!);
}

function write(geometry: BufferGeometry, name: string, values: readonly number[]): void {
  let attribute = geometry.attributes[name] as BufferAttribute | undefined;
  if (attribute === undefined || attribute.array.length < values.length) {
    geometry.dispose(); // the GPU's buffer of the shorter list
    attribute = new Float32BufferAttribute(new Float32Array(2 * values.length), 3).setUsage(DynamicDrawUsage);
    geometry.setAttribute(name, attribute);
  }
  attribute.array.set(values);
  attribute.needsUpdate = true;
}
