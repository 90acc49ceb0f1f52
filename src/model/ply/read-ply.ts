// Reads a PLY file, text or binary: vertices with normals and colours, faces as lists or strips. Vertices that the file
// gives no normals are smoothed, with edges where faces meet at a sharp angle. A separate chunk.
import type { ModelReader } from '../format.js';
import { CORNER_LIMIT } from '../limits.js';
import { PLAIN_LOOK } from '../../material/file-surface.js';
import { ModelError } from '../model.js';
import { ownedModel } from '../owned-model.js';
import { PAUSE_MASK, Slices } from '../slices.js';
import { CornerLists } from '../triangles/corner-lists.js';
import { indexedGeometry } from '../triangles/indexed-geometry.js';
import { smoothNormals } from '../triangles/smooth-normals.js';
import { requirePolygon, Triangulator } from '../triangles/triangulate.js';
import { readPlyHeader, type PlyElement, type PlyProperty, type PlyType } from './ply-header.js';
import { plyValues, type PlyValues } from './ply-values.js';

export const readPly: ModelReader = async ({ bytes, signal, budget }) => {
  const slices = new Slices(signal);
  const header = readPlyHeader(bytes);
  requireFaces(header.elements);
  if (header.encoding === 'text') budget.add({ text: bytes.byteLength });
  const values = plyValues(bytes, header);
  const lists = new CornerLists();
  for (const element of header.elements) {
    if (element.properties.length === 0) continue;
    const row = rowReader(element, values, lists);
    for (let i = 0; i < element.count; i += 1) {
      if ((i & PAUSE_MASK) === 0 && slices.due) await slices.pause();
      row();
    }
  }
  requireVertices(lists);
  if (lists.triangles === 0) throw new Error('it has no triangles');
  if (lists.normals.length > 0) {
    // One normal per vertex: the numbers are the same.
    lists.cornerNormals.array = Int32Array.from(lists.corners.array);
    lists.cornerNormals.length = lists.corners.length;
  } else {
    await smoothNormals(lists, slices);
  }
  const ranges = [{ start: 0, end: lists.corners.length }];
  const geometry = await indexedGeometry(lists, ranges, false, budget, slices);
  const look = { ...PLAIN_LOOK, vertexColors: geometry.hasAttribute('color') };
  const { matrix } = lists.places;
  return ownedModel([{ name: '', geometry, matrix, look, sides: 'double', surface: {} }]);
};

function requireFaces(elements: readonly PlyElement[]): void {
  const countOf = (name: string): number =>
    elements.reduce((sum, element) => sum + (element.name === name ? element.count : 0), 0);
  const vertices = countOf('vertex');
  if (vertices === 0) throw new Error('it has no vertices');
  if (countOf('face') + countOf('tristrips') > 0) return;
  throw new ModelError(
    'bad-model',
    `The PLY file is a cloud of ${String(vertices)} points without faces. Only surfaces can be lit: make a mesh of the points, and save that.`,
  );
}

/** A function that reads one row. */
function rowReader(element: PlyElement, values: PlyValues, lists: CornerLists): () => void {
  if (element.name === 'vertex') return vertexReader(element.properties, values, lists);
  const readers = element.properties.map((property) => {
    const corners =
      element.name === 'face' && /^vertex_ind(ices|ex)$/.test(property.name)
        ? faceReader(lists)
        : element.name === 'tristrips' && property.name === 'vertex_indices'
          ? stripReader(lists)
          : null;
    return propertyReader(property, values, corners);
  });
  return () => {
    for (const read of readers) read();
  };
}

/** What takes the items of a list: each in turn, then its end. */
interface ListTaker {
  item(value: number): void;
  end(): void;
}

function propertyReader(
  { type, countType }: PlyProperty,
  values: PlyValues,
  taker: ListTaker | null,
): () => void {
  if (countType === null) {
    return () => {
      values.next(type);
    };
  }
  return () => {
    const count = values.required(countType);
    if (!(Number.isInteger(count) && count >= 0)) throw new Error('a list has no length');
    for (let i = 0; i < count; i += 1) {
      if (taker === null) values.next(type);
      else taker.item(values.required(type));
    }
    taker?.end();
  };
}

type Slot = 'x' | 'y' | 'z' | 'nx' | 'ny' | 'nz' | 'red' | 'green' | 'blue';

const SLOTS: Readonly<Record<string, Slot>> = {
  x: 'x',
  y: 'y',
  z: 'z',
  nx: 'nx',
  ny: 'ny',
  nz: 'nz',
  red: 'red',
  green: 'green',
  blue: 'blue',
  r: 'red',
  g: 'green',
  b: 'blue',
  diffuse_red: 'red',
  diffuse_green: 'green',
  diffuse_blue: 'blue',
};

function vertexReader(properties: readonly PlyProperty[], values: PlyValues, lists: CornerLists): () => void {
  const row: Record<Slot, number> = { x: 0, y: 0, z: 0, nx: 0, ny: 0, nz: 0, red: 0, green: 0, blue: 0 };
  const found = new Set<Slot>();
  const readers = properties.map((property) => {
    const { name, type, countType } = property;
    const slot = countType === null && Object.hasOwn(SLOTS, name) ? SLOTS[name] : undefined;
    if (slot === undefined) return propertyReader(property, values, null);
    found.add(slot);
    const scale = slot === 'red' || slot === 'green' || slot === 'blue' ? 1 / fullColor(type) : 1;
    const isPlace = slot === 'x' || slot === 'y' || slot === 'z';
    return () => {
      row[slot] = (isPlace ? values.required(type) : values.next(type)) * scale;
    };
  });
  const has = (...slots: readonly Slot[]): boolean => slots.every((slot) => found.has(slot));
  if (!has('x', 'y', 'z')) throw new Error('its vertices have no x, y and z');
  const withNormals = has('nx', 'ny', 'nz');
  const withColors = has('red', 'green', 'blue');
  return () => {
    for (const read of readers) read();
    lists.places.push(row.x, row.y, row.z);
    if (withNormals) lists.pushNormal(row.nx, row.ny, row.nz);
    if (!withColors) return;
    lists.colors.push(clamped(row.red));
    lists.colors.push(clamped(row.green));
    lists.colors.push(clamped(row.blue));
  };
}

/** The number that means full intensity. Whole numbers of any other width are written for bytes. */
function fullColor(type: PlyType): number {
  if (type === 'float32' || type === 'float64') return 1;
  return type === 'uint16' ? 65535 : 255;
}

const clamped = (value: number): number => (value > 0 ? Math.min(value, 1) : 0);

function faceReader(lists: CornerLists): ListTaker {
  const polygon: number[] = [];
  const triangulator = new Triangulator(lists.places);
  const emit = (a: number, b: number, c: number): void => {
    pushTriangle(lists, polygon[a] ?? 0, polygon[b] ?? 0, polygon[c] ?? 0);
  };
  return {
    item: (vertex) => {
      requireIndex(vertex);
      requirePolygon(polygon.length);
      polygon.push(vertex);
    },
    end: () => {
      triangulator.cut(polygon, emit);
      polygon.length = 0;
    },
  };
}

/** Each vertex makes a triangle with the two before it, every second one turned around; -1 begins a new strip. */
function stripReader(lists: CornerLists): ListTaker {
  let length = 0;
  let before = 0;
  let last = 0;
  return {
    item: (vertex) => {
      if (vertex === -1) {
        length = 0;
        return;
      }
      requireIndex(vertex);
      if (length >= 2) {
        if (length % 2 === 0) pushTriangle(lists, before, last, vertex);
        else pushTriangle(lists, last, before, vertex);
      }
      before = last;
      last = vertex;
      length += 1;
    },
    end: () => {
      length = 0;
    },
  };
}

function requireIndex(vertex: number): void {
  if (Number.isInteger(vertex) && vertex >= 0 && vertex < CORNER_LIMIT) return;
  throw new Error(`a face refers to the vertex ${String(vertex)}`);
}

function pushTriangle({ corners }: CornerLists, a: number, b: number, c: number): void {
  if (corners.length >= CORNER_LIMIT) {
    throw new ModelError(
      'too-large',
      `The model has more than ${CORNER_LIMIT.toLocaleString('en')} triangle corners.`,
    );
  }
  corners.push(a);
  corners.push(b);
  corners.push(c);
}

/** Faces may come before the vertices that they refer to. */
function requireVertices({ corners, places }: CornerLists): void {
  const vertex = corners.array.subarray(0, corners.length).find((index) => index >= places.count);
  if (vertex === undefined) return;
  throw new Error(`a face refers to vertex ${String(vertex)} of ${String(places.count)}`);
}
