// The vertices of a geometry that decide how large it is, wherever it is placed. Reads all vertices once and keeps
// those that lie farthest along some hundred directions, in the geometry's own space.
import {
  Box3,
  BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  Sphere,
  Vector3,
} from 'three';
import type { Vec3 } from '../math/vector.js';
import type { Slices } from './slices.js';

/**
 * The size of a geometry. Its points are found when they are first needed: most meshes are not turned, and need none.
 */
export class ExtremePoints {
  /** The box around all vertices. */
  readonly box: Readonly<Box>;
  /** Centre of the box. */
  readonly center: Vec3;
  /** Reaches the vertex farthest from `center`. */
  readonly radius: number;
  /** The vertices, or a function that returns them. Null once the points are found. */
  #vertices: Vertices | (() => Vertices) | null;
  #points: Float64Array = new Float64Array(0);

  constructor(vertices: Vertices | (() => Vertices), box: Readonly<Box>, center: Vec3, radius: number) {
    this.#vertices = vertices;
    this.box = box;
    this.center = center;
    this.radius = radius;
  }

  /** x, y, z of each point, one after the other. */
  get points(): Float64Array {
    finished(this.search());
    return this.#points;
  }

  /** Finds the points, unless they are known. */
  *search(): Search<undefined> {
    if (this.#vertices === null) return;
    const vertices = typeof this.#vertices === 'function' ? this.#vertices() : this.#vertices;
    const count = vertices.length / 3;
    const chosen =
      count <= FEW ? Array.from({ length: count }, (_, i) => 3 * i) : yield* supports(vertices, this.box);
    this.#points = distinct(vertices, chosen);
    this.#vertices = null;
  }
}

/** Geometries with fewer vertices keep all of them. */
const FEW = 192;
/** Directions come in pairs, d and −d. 96 pairs find the framing within 1 %; 64 nearly do. */
const PAIRS = 96;
/** Vertices that are skipped together where their box lies behind all points found so far. */
const BLOCK = 64;
/**
 * Blocks far apart are read first: points found early let more of the later blocks be skipped (500,000 vertices: 55
 * ms).
 */
const STRIDE = 61;

/** Numbers of vertices between two steps. */
const PIECE = 3 * 2 ** 18;

const known = new WeakMap<BufferGeometry, ExtremePoints | null>();

/** Null where the geometry has no vertex. Measured with the first call, and kept until {@link forgetExtremePoints}. */
export const extremePointsOf = (geometry: BufferGeometry): ExtremePoints | null =>
  finished(measuring(geometry));

function* measuring(geometry: BufferGeometry): Search<ExtremePoints | null> {
  let found = known.get(geometry);
  if (found === undefined) known.set(geometry, (found = declaredOf(geometry) ?? (yield* measured(geometry))));
  return found;
}

interface Declared {
  readonly points: ExtremePoints;
  /** The version of the vertices that the points were found in. */
  readonly version: number;
}

const declared = new WeakMap<BufferGeometry, Declared>();

/** Replaces the measured size of a geometry, until its vertices are written to. */
export function declareExtremePoints(geometry: BufferGeometry, points: ExtremePoints): void {
  declared.set(geometry, { points, version: versionOf(geometry) });
}

function declaredOf(geometry: BufferGeometry): ExtremePoints | undefined {
  const found = declared.get(geometry);
  return found?.version === versionOf(geometry) ? found.points : undefined;
}

const versionOf = (geometry: BufferGeometry): number =>
  (geometry.getAttribute('position') as Partial<BufferAttribute>).version ?? 0;

/** Measures the geometry and finds the points too, in slices. */
export async function findExtremePoints(geometry: BufferGeometry, slices: Slices): Promise<void> {
  const search = (function* (): Search<void> {
    const size = yield* measuring(geometry);
    if (size !== null) yield* size.search();
  })();
  while (search.next().done === false) if (slices.due) await slices.pause();
}

/** `copy` has the vertices of `geometry`: it is not read for itself. */
export function shareExtremePoints(geometry: BufferGeometry, copy: BufferGeometry): void {
  known.set(copy, extremePointsOf(geometry));
  const points = declaredOf(geometry);
  if (points !== undefined) declareExtremePoints(copy, points);
}

/** The vertices may have changed. Whether they have not, because the declared size still holds. */
export function forgetExtremePoints(geometry: BufferGeometry): boolean {
  known.delete(geometry);
  return declaredOf(geometry) !== undefined;
}

/** A computation in steps of about a millisecond for 300,000 vertices. */
type Search<T> = Generator<undefined, T, undefined>;

function finished<T>(search: Search<T>): T {
  for (;;) {
    const { done, value } = search.next();
    if (done === true) return value;
  }
}

function* measured(geometry: BufferGeometry): Search<ExtremePoints | null> {
  const position = geometry.getAttribute('position');
  const plain =
    position instanceof BufferAttribute && position.itemSize === 3 && position.array instanceof Float32Array;
  // Most geometries have only finite numbers, and are read without a copy.
  const found = plain ? yield* extremesOf(position.array as Float32Array) : null;
  if (found === null || !Number.isFinite(found.radius)) return yield* extremesOf(finiteVertices(position));
  // three.js would find the same numbers for its own culling, in a pass over all vertices for each.
  if (geometry.morphAttributes['position'] === undefined) {
    const [minX, minY, minZ, maxX, maxY, maxZ] = found.box;
    geometry.boundingBox ??= new Box3(new Vector3(minX, minY, minZ), new Vector3(maxX, maxY, maxZ));
    geometry.boundingSphere ??= new Sphere(new Vector3(...found.center), found.radius);
  }
  return found;
}

function* extremesOf(vertices: Vertices): Search<ExtremePoints | null> {
  const box = emptyBox();
  for (let first = 0; first < vertices.length; first += PIECE) {
    extend(box, vertices, first, Math.min(first + PIECE, vertices.length));
    yield;
  }
  const [minX, minY, minZ, maxX, maxY, maxZ] = box;
  if (!(minX <= maxX)) return null;
  const center: Vec3 = [minX + (maxX - minX) / 2, minY + (maxY - minY) / 2, minZ + (maxZ - minZ) / 2];
  let farthest = 0;
  for (let i = 0; i < vertices.length; i += 3) {
    if (i % PIECE === 0) yield;
    const dx = vertices[i]! - center[0];
    const dy = vertices[i + 1]! - center[1];
    const dz = vertices[i + 2]! - center[2];
    farthest = Math.max(farthest, dx * dx + dy * dy + dz * dz);
  }
  return new ExtremePoints(vertices, box, center, Math.sqrt(farthest));
}

/** x, y, z of each vertex, one after the other. */
type Vertices = Float32Array | Float64Array;

/** The vertices that are numbers. */
function finiteVertices(position: BufferAttribute | InterleavedBufferAttribute): Vertices {
  const vertices = new Float64Array(3 * position.count);
  let end = 0;
  for (let i = 0; i < position.count; i++) {
    const [x, y, z] = [position.getX(i), position.getY(i), position.getZ(i)];
    if (!Number.isFinite(x + y + z)) continue;
    vertices[end++] = x;
    vertices[end++] = y;
    vertices[end++] = z;
  }
  return vertices.subarray(0, end);
}

type Box = [minX: number, minY: number, minZ: number, maxX: number, maxY: number, maxZ: number];

const emptyBox = (): Box => [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];

function extend(box: Box, vertices: Vertices, first: number, end: number): void {
  let [minX, minY, minZ, maxX, maxY, maxZ] = box;
  for (let i = first; i < end; i += 3) {
    const [x, y, z] = [vertices[i]!, vertices[i + 1]!, vertices[i + 2]!];
    if (x < minX) minX = x;
    if (x > maxX) maxX = x;
    if (y < minY) minY = y;
    if (y > maxY) maxY = y;
    if (z < minZ) minZ = z;
    if (z > maxZ) maxZ = z;
  }
  box[0] = minX;
  box[1] = minY;
  box[2] = minZ;
  box[3] = maxX;
  box[4] = maxY;
  box[5] = maxZ;
}

/** Where in `vertices` the farthest along each direction and against it begin. */
function* supports(vertices: Vertices, box: Readonly<Box>): Search<Set<number>> {
  const directions = directionsFor(box);
  const least = new Float64Array(PAIRS).fill(Infinity);
  const most = new Float64Array(PAIRS).fill(-Infinity);
  const leastAt = new Uint32Array(PAIRS);
  const mostAt = new Uint32Array(PAIRS);
  const take = (first: number): void => {
    const end = Math.min(first + 3 * BLOCK, vertices.length);
    const [minX, minY, minZ, maxX, maxY, maxZ] = blockBox(vertices, first, end);
    for (let k = 0; k < PAIRS; k++) {
      const [x, y, z] = [directions[3 * k]!, directions[3 * k + 1]!, directions[3 * k + 2]!];
      const high = x * (x > 0 ? maxX : minX) + y * (y > 0 ? maxY : minY) + z * (z > 0 ? maxZ : minZ);
      const low = x * (x > 0 ? minX : maxX) + y * (y > 0 ? minY : maxY) + z * (z > 0 ? minZ : maxZ);
      if (high <= most[k]! && low >= least[k]!) continue;
      for (let i = first; i < end; i += 3) {
        const along = x * vertices[i]! + y * vertices[i + 1]! + z * vertices[i + 2]!;
        if (along < least[k]!) {
          least[k] = along;
          leastAt[k] = i;
        }
        if (along > most[k]!) {
          most[k] = along;
          mostAt[k] = i;
        }
      }
    }
  };
  for (let lane = 0; lane < STRIDE; lane++) {
    for (let block = lane; 3 * BLOCK * block < vertices.length; block += STRIDE) take(3 * BLOCK * block);
    yield;
  }
  return new Set([...leastAt, ...mostAt]);
}

function blockBox(vertices: Vertices, first: number, end: number): Box {
  const box = emptyBox();
  extend(box, vertices, first, end);
  return box;
}

/**
 * The axes, and a Fibonacci spiral over a half sphere. Each is stretched as if the box were a cube: thin geometries
 * would otherwise have all their points along their rim.
 */
function directionsFor([minX, minY, minZ, maxX, maxY, maxZ]: Readonly<Box>): Float64Array {
  const scale = [maxX - minX, maxY - minY, maxZ - minZ].map((extent) => (extent > 0 ? 1 / extent : 0));
  const directions = Float64Array.from([1, 0, 0, 0, 1, 0, 0, 0, 1, ...spiral(PAIRS - 3)]);
  return directions.map((component, i) => component * scale[i % 3]!);
}

const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

function* spiral(count: number): Iterable<number> {
  for (let i = 0; i < count; i++) {
    const y = 1 - (i + 0.5) / count;
    const around = Math.sqrt(1 - y * y);
    yield around * Math.cos(i * GOLDEN_ANGLE);
    yield y;
    yield around * Math.sin(i * GOLDEN_ANGLE);
  }
}

/**
 * The places of the chosen vertices, each once: faces of their own normals repeat their corners. They are few, so
 * comparing each with each is faster than texts as keys: 7 times with 192 places.
 */
function distinct(vertices: Vertices, chosen: Iterable<number>): Float64Array {
  const places: number[] = [];
  for (const i of chosen) {
    const [x, y, z] = [vertices[i]!, vertices[i + 1]!, vertices[i + 2]!];
    let at = 0;
    while (at < places.length && (places[at] !== x || places[at + 1] !== y || places[at + 2] !== z)) at += 3;
    if (at === places.length) places.push(x, y, z);
  }
  return Float64Array.from(places);
}
