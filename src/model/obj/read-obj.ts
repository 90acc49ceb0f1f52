// Reads an OBJ file with its MTL libraries. One part per object and material; the material's coefficients are those of
// the equation. Corners without a normal get one by smoothing group. A separate chunk.
import { ClampToEdgeWrapping, LinearFilter, LinearMipmapLinearFilter, RepeatWrapping, type Texture } from 'three';
import { type BaseLook, emits, PLAIN_LOOK } from '../../material/file-surface.js';
import type { SurfaceValues } from '../../material/material-values.js';
import { scale } from '../../math/vector.js';
import { clip } from '../../fields/clip.js';
import { type ModelReader, type ModelSource, ownedModel } from '../model-reader.js';
import { type ImageFile, ImageTextures } from '../image.js';
import { LeftOut } from '../left-out.js';
import type { ContentPart } from '../model.js';
import { Slices } from '../slices.js';
import { asUtf8 } from '../encodings.js';
import { IndexedGeometries, type CornerRange } from '../triangles/indexed-geometry.js';
import { smoothNormals } from '../triangles/smooth-normals.js';
import { plainName, type MtlMap, type MtlMaterial, NO_MATERIAL, readMtl } from './mtl.js';
import { readObjText, type ObjRun, type ObjText } from './obj-text.js';

export const readObj: ModelReader = async (source) => {
  const { bytes } = source;
  const slices = new Slices(source.signal, source.budget);
  const { budget } = source;
  budget.add({ text: bytes.byteLength });
  const leftOut = new LeftOut();
  const text = await readObjText(bytes, leftOut, slices);
  const materials = await readLibraries(text, source, slices);
  await smoothNormals(text.lists, slices);
  const textures = new ImageTextures(source);
  const geometries = new IndexedGeometries(text.lists, budget, slices);
  try {
    const parts: ContentPart[] = [];
    for (const { name, material, ranges } of await groupsOf(text.runs, slices)) {
      const definition = materials.named(material);
      const { map, keMap } = definition;
      const withUvs = (map !== null || keMap !== null) && text.lists.uvs.length > 0;
      const geometry = await geometries.of(ranges, withUvs);
      if (geometry === null) continue;
      const look = lookOf(definition, geometry.hasAttribute('color'));
      const maps = withUvs
        ? {
            map: await textureOf(map, textures, source),
            emissiveMap: emits(look) ? await textureOf(keMap, textures, source) : null,
          }
        : {};
      const { matrix } = text.lists.places;
      const surface = surfaceOf(definition);
      parts.push({ name, geometry, matrix, look: { ...look, ...maps }, sides: 'double', surface });
      if (slices.took(16)) await slices.pause();
    }
    text.lists.free();
    if (parts.length === 0) throw await leftOut.error(bytes, slices, 'it has no faces');
    materials.nameLeftOut(leftOut);
    const dropped = await leftOut.names(bytes, slices);
    return { ...ownedModel(parts, () => void textures.close()), dropped };
  } catch (error) {
    void textures.close();
    throw error;
  }
};

/** Null if there is no map, or its file is missing or broken. */
async function textureOf(
  map: MtlMap | null,
  textures: ImageTextures,
  { linked }: ModelSource,
): Promise<Texture | null> {
  if (map === null) return null;
  const { file, scale, offset, clamped } = map;
  const wrap = clamped ? ClampToEdgeWrapping : RepeatWrapping;
  const sampler = { magFilter: LinearFilter, minFilter: LinearMipmapLinearFilter, wrapS: wrap, wrapT: wrap } as const;
  const read = async (): Promise<ImageFile> => ({ bytes: await linked(addressOf(file)), type: '' });
  // The file's v points up, the geometry's points down: 1 − (v·s + o) = (1 − v)·s + (1 − s − o).
  return textures.of(file, file, read, sampler, { scale, offset: [offset[0], 1 - scale[1] - offset[1]] });
}

/** OBJ and MTL files name files by paths, not by addresses. */
const addressOf = (path: string): string => path.split('/').map(encodeURIComponent).join('/');

type Entry = readonly [name: string, material: MtlMaterial];

/** The materials of a model's libraries. */
class Materials {
  readonly #byName: ReadonlyMap<string, MtlMaterial>;
  readonly #byPlainName: ReadonlyMap<string, MtlMaterial>;
  /** Whether every library was read. A missing one is reported by itself. */
  readonly #complete: boolean;
  readonly #used = new Set<MtlMaterial>();
  readonly #unknown = new Set<string>();

  constructor(entries: readonly Entry[], complete: boolean) {
    this.#byName = new Map(entries);
    this.#byPlainName = new Map(entries.map(([name, material]) => [plainName(name), material]));
    this.#complete = complete;
  }

  named(name: string): MtlMaterial {
    const found = this.#byName.get(name) ?? this.#byPlainName.get(plainName(name));
    if (found) this.#used.add(found);
    else if (name !== '') this.#unknown.add(name);
    return found ?? NO_MATERIAL;
  }

  /** What those that were asked for leave out, and those that are in no library. */
  nameLeftOut(leftOut: LeftOut): void {
    for (const material of this.#used) for (const name of material.leftOut) leftOut.feature(name);
    const [first] = this.#unknown;
    if (!this.#complete || first === undefined) return;
    leftOut.add('material', this.#unknown.size);
    leftOut.because('material', clip(first, 40));
  }
}

async function readLibraries(
  { libraries, runs }: ObjText,
  { linked, optional, budget }: ModelSource,
  slices: Slices,
): Promise<Materials> {
  const named = new Set(Array.from(new Set(runs.map(({ material }) => material)), plainName));
  const read = libraries.map(async (library) => {
    const found = await optional(
      library,
      () => linked(addressOf(library)),
      async (bytes) => {
        budget.add({ text: bytes.byteLength });
        return readMtl(await asUtf8(bytes, budget, slices), slices);
      },
    );
    const folder = library.slice(0, library.lastIndexOf('/') + 1);
    if (found === null) return null;
    const placed = await slices.map([...found], (entry) =>
      named.has(plainName(entry[0])) ? [placedIn(folder, entry)] : [],
    );
    return placed.flat();
  });
  const found = await Promise.all(read);
  return new Materials(
    found.flatMap((entries) => entries ?? []),
    !found.includes(null),
  );
}

/** Images are named relative to the library. */
function placedIn(folder: string, [name, material]: Entry): Entry {
  const placed = (map: MtlMaterial['map']): MtlMaterial['map'] => map && { ...map, file: folder + map.file };
  return [name, { ...material, map: placed(material.map), keMap: placed(material.keMap) }];
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
async function groupsOf(runs: readonly ObjRun[], slices: Slices): Promise<readonly Group[]> {
  const byObject = await groupedBy(runs, ({ object, material }) => JSON.stringify([object, material]), slices);
  return byObject.length <= OBJECT_LIMIT ? byObject : groupedBy(runs, ({ material }) => material, slices);
}

async function groupedBy(
  runs: readonly ObjRun[],
  keyOf: (run: ObjRun) => string,
  slices: Slices,
): Promise<readonly Group[]> {
  const groups = new Map<string, Group>();
  for (const run of runs) {
    const key = keyOf(run);
    const group = groups.get(key) ?? { name: run.object || run.material, material: run.material, ranges: [] };
    groups.set(key, group);
    group.ranges.push(run);
    if (slices.took(2)) await slices.pause();
  }
  return [...groups.values()];
}

function lookOf({ opacity, ke }: MtlMaterial, vertexColors: boolean): BaseLook {
  return { ...PLAIN_LOOK, opacity, alphaMode: opacity < 1 ? 'blend' : 'opaque', emissive: ke, vertexColors };
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
