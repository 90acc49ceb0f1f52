// Reads an OBJ file with its MTL libraries. One part per object and material; the material's coefficients are those of
// the equation. Corners without a normal get one by smoothing group. A separate chunk.
import type { ModelReader, ModelSource } from '../format.js';
import { type BaseLook, PLAIN_LOOK } from '../../material/file-surface.js';
import type { SurfaceValues } from '../../material/material-values.js';
import { scale } from '../../math/vector.js';
import type { ContentPart } from '../model.js';
import { ownedModel } from '../owned-model.js';
import { Slices } from '../slices.js';
import { asUtf8 } from '../text/utf-16.js';
import { indexedGeometry, type CornerRange } from '../triangles/indexed-geometry.js';
import { smoothNormals } from '../triangles/smooth-normals.js';
import { addressOf, MapTextures } from './map-textures.js';
import { readMtl, type MtlMaterial } from './mtl.js';
import { readObjText, type ObjRun, type ObjText } from './obj-text.js';

export const readObj: ModelReader = async (source) => {
  const slices = new Slices(source.signal);
  const { budget } = source;
  budget.add({ text: source.bytes.byteLength });
  const text = await readObjText(source.bytes, slices);
  if (text.runs.length === 0) throw new Error('it has no faces');
  const materials = await readLibraries(text, source, slices);
  await smoothNormals(text.lists, slices);
  const textures = new MapTextures(source, budget);
  try {
    const parts: ContentPart[] = [];
    for (const { name, material, ranges } of groupsOf(text.runs)) {
      const definition = materials.get(material) ?? NO_MATERIAL;
      const withUvs = definition.map !== null && text.lists.uvs.length > 0;
      const geometry = await indexedGeometry(text.lists, ranges, withUvs, budget, slices);
      const map = withUvs ? await textures.of(definition.map) : null;
      const look = lookOf(definition, map, geometry.hasAttribute('color'));
      const { matrix } = text.lists.places;
      parts.push({ name, geometry, matrix, look, sides: 'double', surface: surfaceOf(definition) });
    }
    return ownedModel(parts, () => {
      textures.close();
    });
  } catch (error) {
    textures.close();
    throw error;
  }
};

const NO_MATERIAL: MtlMaterial = { opacity: 1, map: null };

async function readLibraries(
  { libraries }: ObjText,
  { linked, optional, budget }: ModelSource,
  slices: Slices,
): Promise<ReadonlyMap<string, MtlMaterial>> {
  const read = libraries.map(async (library) => {
    const found = await optional(
      library,
      () => linked(addressOf(library)),
      async (bytes) => {
        budget.add({ text: bytes.byteLength });
        return readMtl(await asUtf8(bytes, budget, slices));
      },
    );
    const folder = library.slice(0, library.lastIndexOf('/') + 1);
    return Array.from(found ?? [], (entry) => placedIn(folder, entry));
  });
  return new Map((await Promise.all(read)).flat());
}

/** Images are named relative to the library. */
function placedIn(
  folder: string,
  [name, material]: readonly [string, MtlMaterial],
): readonly [string, MtlMaterial] {
  const { map } = material;
  return [name, map === null ? material : { ...material, map: { ...map, file: folder + map.file } }];
}

interface Group {
  readonly name: string;
  readonly material: string;
  readonly ranges: CornerRange[];
}

/**
 * Most parts that keep their objects apart. Plans from CAD have an object per screw; drawing each of them alone is
 * slow.
 */
const OBJECT_LIMIT = 1000;

/** Runs by object and material. Past {@link OBJECT_LIMIT} objects of the same material become one part. */
function groupsOf(runs: readonly ObjRun[]): Iterable<Group> {
  const byObject = groupedBy(runs, ({ object, material }) => JSON.stringify([object, material]));
  return byObject.length <= OBJECT_LIMIT ? byObject : groupedBy(runs, ({ material }) => material);
}

function groupedBy(runs: readonly ObjRun[], keyOf: (run: ObjRun) => string): readonly Group[] {
  const groups = new Map<string, Group>();
  for (const run of runs) {
    const key = keyOf(run);
    const group = groups.get(key) ?? { name: run.object || run.material, material: run.material, ranges: [] };
    groups.set(key, group);
    group.ranges.push(run);
  }
  return [...groups.values()];
}

function lookOf({ opacity }: MtlMaterial, map: BaseLook['map'], vertexColors: boolean): BaseLook {
  return { ...PLAIN_LOOK, opacity, alphaMode: opacity < 1 ? 'blend' : 'opaque', map, vertexColors };
}

/** Colours from 0 to 255, as in HTML. What the file leaves out is left out. */
function surfaceOf(material: MtlMaterial): Partial<SurfaceValues> {
  const surface: Partial<SurfaceValues> = {};
  for (const key of ['ka', 'kd', 'ks'] as const) {
    const color = material[key];
    if (color !== undefined) surface[key] = scale(color, 255);
  }
  if (material.shininess !== undefined) surface.shininess = material.shininess;
  return surface;
}
