// Reads an OBJ file with its MTL libraries. One part per object and material; the material's
// coefficients are those of the equation. Corners without a normal get one by smoothing group. A
// separate chunk.
import {
  ClampToEdgeWrapping,
  LinearFilter,
  LinearMipmapLinearFilter,
  RepeatWrapping,
  type Texture,
} from 'three';
import { type BaseLook, emits, PLAIN_LOOK } from '../../../phong/material/file-surface.js';
import { clip } from '../../../phong/fields/clip.js';
import { type FileBytes, type ModelReader, type ModelSource, ownedModel } from '../model-reader.js';
import { ImageTextures } from '../image.js';
import { LeftOut } from '../left-out.js';
import { type ContentPart, ModelError } from '../../../phong/model/model.js';
import { Slices } from '../slices.js';
import { asUtf8 } from '../encodings.js';
import { IndexedGeometries, type CornerRange } from '../triangles/indexed-geometry.js';
import { smoothNormals } from '../triangles/smooth-normals.js';
import { plainName, type MtlMap, type MtlMaterial, NO_MATERIAL, readMtl } from './mtl.js';
import { readObjText, type ObjRun, type ObjText } from './obj-text.js';

export const read: ModelReader = async (source) => {
  const { bytes, budget } = source;
  const slices = new Slices(source.signal, budget);
  budget.add({ text: bytes.byteLength });
  const leftOut = new LeftOut();
  const text = await readObjText(bytes, leftOut, slices);
  const materials = await readLibraries(text, source, leftOut, slices);
  await smoothNormals(text.lists, slices);
  const textures = new ImageTextures(source);
  const geometries = new IndexedGeometries(text.lists, budget, slices);
  try {
    const parts: ContentPart[] = [];
    for (const { name, material, ranges } of await groupsOf(text.runs, slices)) {
      const definition = materialNamed(materials, material) ?? NO_MATERIAL;
      const { map, keMap, surface } = definition;
      const withUvs = (map !== null || keMap !== null) && text.lists.uvs.length > 0;
      const geometry = await geometries.of(ranges, withUvs);
      if (geometry === null) continue;
      const plain = lookOf(definition, geometry.hasAttribute('color'));
      const textureOf = (named: MtlMap | null) =>
        named && withUvs ? mtlTexture(named, textures, source) : null;
      const look = {
        ...plain,
        map: await textureOf(map),
        emissiveMap: emits(plain) ? await textureOf(keMap) : null,
      };
      const { matrix } = text.lists.places;
      parts.push({ name, geometry, matrix, look, sides: 'double', surface });
      if (slices.took(16)) {
        await slices.pause();
      }
    }
    text.lists.free();
    if (parts.length === 0) throw leftOut.error('it has no faces');
    return { ...ownedModel(parts, () => void textures.close()), dropped: leftOut.names };
  } catch (error) {
    void textures.close();
    throw error;
  }
};

/** Null if its file is missing or broken. */
function mtlTexture(
  { files, scale, offset, clamped }: MtlMap,
  textures: ImageTextures,
  { linked }: ModelSource,
): Promise<Texture | null> {
  const wrap = clamped ? ClampToEdgeWrapping : RepeatWrapping;
  const sampler = {
    magFilter: LinearFilter,
    minFilter: LinearMipmapLinearFilter,
    wrapS: wrap,
    wrapT: wrap,
  } as const;
  const load = async (): Promise<FileBytes> => ({ bytes: await firstOf(files, linked), type: '' });
  // The file's v points up, the geometry's points down: 1 − (v·s + o) = (1 − v)·s + (1 − s − o).
  return textures.of(files[0], files[0], load, sampler, {
    scale,
    offset: [offset[0], 1 - scale[1] - offset[1]],
  });
}

/**
 * The first of these files that is there. OBJ and MTL files name files by paths, not by addresses.
 * @throws what the first one ends with, if none is there.
 */
async function firstOf(
  paths: readonly [string, ...string[]],
  linked: ModelSource['linked'],
): Promise<FileBytes['bytes']> {
  let missing: ModelError | null = null;
  for (const path of paths) {
    try {
      return await linked(path.split('/').map(encodeURIComponent).join('/'));
    } catch (error) {
      if (!(error instanceof ModelError && error.code === 'load-failed')) throw error;
      missing ??= error;
    }
  }
  throw missing!;
}

/** The materials of a model's libraries: by name, as it is written and plain. */
type Materials = ReadonlyMap<string, MtlMaterial>;

const materialNamed = (materials: Materials, name: string) =>
  materials.get(name) ?? materials.get(plainName(name));

/**
 * Names what the materials in use leave out, and those that are in no library. A missing library
 * names itself.
 */
async function readLibraries(
  { libraries, runs }: ObjText,
  { linked, optional, budget }: ModelSource,
  leftOut: LeftOut,
  slices: Slices,
): Promise<Materials> {
  const used = new Set(runs.map(({ material }) => material));
  const usedPlain = new Set(Array.from(used, plainName));
  const pending = libraries.map(async (paths) => {
    const [library] = paths;
    const readAll = async (bytes: FileBytes['bytes']): Promise<Materials> => {
      budget.add({ text: bytes.byteLength });
      const folder = library.slice(0, library.lastIndexOf('/') + 1);
      return readMtl(asUtf8(bytes), folder, slices);
    };
    const found = await optional(library, () => firstOf(paths, linked), readAll);
    return found && [...found].filter(([name]) => usedPlain.has(plainName(name)));
  });
  const found = await Promise.all(pending);
  const entries = found.flatMap((library) => library ?? []);
  const plain = entries.map(([name, material]) => [plainName(name), material] as const);
  const materials = new Map([...plain, ...entries]);
  const unknown = [...used].filter((name) => name !== '' && !materialNamed(materials, name));
  for (const name of used) {
    for (const statement of materialNamed(materials, name)?.leftOut ?? []) {
      leftOut.feature(statement);
    }
  }
  if (unknown.length > 0 && !found.includes(null)) {
    leftOut.add('material', unknown.length);
    leftOut.because('material', () => clip(unknown[0]!, 40));
  }
  return materials;
}

interface Group {
  readonly name: string;
  readonly material: string;
  readonly ranges: CornerRange[];
}

/**
 * Most parts that keep their objects apart. Plans from CAD have an object per screw; drawing each
 * of them alone is slow.
 */
const OBJECT_LIMIT = 1000;

/**
 * Runs by object and material. Past {@link OBJECT_LIMIT} objects of the same material become one
 * part.
 */
async function groupsOf(runs: readonly ObjRun[], slices: Slices): Promise<readonly Group[]> {
  const byObject = await groupedBy(
    runs,
    ({ object, material }) => JSON.stringify([object, material]),
    slices,
  );
  return byObject.length <= OBJECT_LIMIT
    ? byObject
    : groupedBy(runs, ({ material }) => material, slices);
}

async function groupedBy(
  runs: readonly ObjRun[],
  keyOf: (run: ObjRun) => string,
  slices: Slices,
): Promise<readonly Group[]> {
  const groups = new Map<string, Group>();
  for (const run of runs) {
    const key = keyOf(run);
    const group = groups.get(key) ?? {
      name: run.object || run.material,
      material: run.material,
      ranges: [],
    };
    groups.set(key, group);
    group.ranges.push(run);
    if (slices.took(2)) {
      await slices.pause();
    }
  }
  return [...groups.values()];
}

function lookOf({ opacity, ke }: MtlMaterial, vertexColors: boolean): BaseLook {
  return {
    ...PLAIN_LOOK,
    opacity,
    alphaMode: opacity < 1 ? 'blend' : 'opaque',
    emissive: ke,
    vertexColors,
  };
}
