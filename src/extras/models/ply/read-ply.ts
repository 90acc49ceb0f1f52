// Reads a PLY file, text or binary: vertices with normals and colours, faces as lists or strips.
// Vertices that the file gives no normals are smoothed, with edges where faces meet at a sharp
// angle. A separate chunk.
import { PLAIN_LOOK } from '../../../phong/material/file-surface.js';
import { type ModelReader, ownedModel } from '../model-reader.js';
import { LeftOut } from '../left-out.js';
import { isOutOfMemory } from '../../../phong/model/limits.js';
import { ModelError } from '../../../phong/model/model.js';
import { Slices } from '../slices.js';
import { type CornerLists } from '../triangles/corner-lists.js';
import { IndexedGeometries } from '../triangles/indexed-geometry.js';
import { smoothNormals } from '../triangles/smooth-normals.js';
import { keepSoundFaces } from '../triangles/sound-faces.js';
import { countOf, readPlyHeader, type PlyElement } from './ply-header.js';
import { readRows } from './ply-rows.js';

export const read: ModelReader = async ({ bytes, signal, budget }) => {
  const slices = new Slices(signal, budget);
  const header = await readPlyHeader(bytes, slices);
  requireFaces(header.elements);
  if (header.encoding === 'text') {
    budget.add({ text: bytes.byteLength });
  }
  let leftOut = new LeftOut();
  let lists: CornerLists;
  try {
    lists = await readRows(bytes, header, true, leftOut, slices);
  } catch (error) {
    const isWrong = error instanceof ModelError || isOutOfMemory(error) || signal.aborted;
    if (header.encoding !== 'text' || isWrong) throw error;
    // Rows need not be lines.
    leftOut = new LeftOut();
    lists = await readRows(bytes, header, false, leftOut, slices);
  }
  if (lists.triangles === 0) throw new Error('it has no triangles');
  if (lists.normals.length > 0) {
    // One normal per vertex: the numbers are the same.
    lists.cornerNormals.array = new Int32Array(lists.corners.array);
    lists.cornerNormals.length = lists.corners.length;
  }
  await keepSoundFaces(lists, leftOut, slices);
  await smoothNormals(lists, slices);
  const ranges = [{ start: 0, end: lists.corners.length }];
  const geometry = await new IndexedGeometries(lists, budget, slices).of(ranges, false);
  lists.free();
  if (geometry === null) throw leftOut.error('it has no triangles');
  if (header.hasTexture) {
    leftOut.feature('TextureFile');
  }
  const look = { ...PLAIN_LOOK, vertexColors: geometry.hasAttribute('color') };
  const { matrix } = lists.places;
  return {
    ...ownedModel([{ name: '', geometry, matrix, look, sides: 'double', surface: {} }]),
    dropped: leftOut.names,
  };
};

function requireFaces(elements: readonly PlyElement[]) {
  const vertices = countOf(elements, 'vertex');
  if (vertices === 0) throw new Error('it has no vertices');
  if (countOf(elements, 'face') + countOf(elements, 'tristrips') > 0) return;
  const fact = `The PLY file is a cloud of ${String(vertices)} points without faces. Only surfaces can be lit.`;
  throw new ModelError('bad-model', fact, { advice: 'Make a mesh of the points, and save that.' });
}
