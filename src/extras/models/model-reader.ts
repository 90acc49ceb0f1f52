// What the reader of a format gets and gives, and what several readers use to make it.
import { BufferAttribute } from 'three';
import type { BaseLook } from '../../phong/material/file-surface.js';
import { writeFaceNormals } from '../../phong/material/flat-geometry.js';
import { type Content, ModelError } from '../../phong/model/model.js';
import type { ModelBudget } from '../../phong/model/model-budget.js';
import type { Slices } from './slices.js';

export interface FileBytes {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** The media type that came with it; empty if none did. */
  readonly type: string;
}

export interface ModelSource {
  readonly url: URL;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly signal: AbortSignal;
  /** Downloads a file that the model names, if it is allowed to name it. */
  readonly linked: (uri: string) => Promise<Uint8Array<ArrayBuffer>>;
  readonly optional: ReadOptional;
  /** Has the bytes of the files; the reader claims everything else. */
  readonly budget: ModelBudget;
  readonly decodeImage?: DecodeImage | undefined;
  readonly flush?: (() => void) | undefined;
}

/**
 * Decodes an image in place of the browser. Where there is one, nothing is decoded by workers or
 * WebAssembly: neither KTX2 nor Draco nor meshopt.
 */
export type DecodeImage = (file: FileBytes) => Promise<ImageBitmap>;

/** @throws ModelError, which names what it is that would need WebAssembly. */
export function requireDecoders(
  { decodeImage }: Pick<ModelSource, 'decodeImage'>,
  what: string,
): void {
  if (decodeImage === undefined) return;
  throw new ModelError('bad-model', `A still cannot read ${what}: export the model without it.`);
}

/**
 * Reads something that the model can be shown without: an image, or a library of materials. Null if
 * it is missing or broken, which is then reported. Limits, a policy and missing code of the package
 * are errors here too.
 * @param name as the model names it, for reports.
 * @param read gets its bytes, by `linked` or from the model itself.
 * @param use decodes them. A ModelError is not the file's fault.
 */
export type ReadOptional = <Bytes, Result>(
  name: string,
  read: () => Promise<Bytes>,
  use: (bytes: Bytes) => Result | Promise<Result>,
) => Promise<Result | null>;

/**
 * Code of the package that the model needs. @throws ModelError `load-failed` where it cannot be
 * fetched.
 */
export const neededCode = <Code>(code: Promise<Code>, what: string): Promise<Code> =>
  code.catch((cause: unknown) => {
    if (cause instanceof ModelError) throw cause;
    throw new ModelError('load-failed', `${what}, which this model needs, could not be fetched.`, {
      cause,
    });
  });

/**
 * Reads a whole model, or throws and leaks nothing. An error other than ModelError means a broken
 * file.
 */
export type ModelReader = (source: ModelSource) => Promise<Content>;

/**
 * A model without motion that owns its geometries and textures. @param closeImages frees what their
 * images hold.
 */
export function ownedModel(
  parts: Content['parts'],
  closeImages: () => void = () => undefined,
): Content {
  const owned = new Set(parts.flatMap(({ geometry, look }) => [geometry, ...mapsOfLook(look)]));
  let disposed = false;
  return {
    parts,
    motion: null,
    dispose() {
      if (disposed) return;
      disposed = true;
      for (const item of owned) {
        item.dispose();
      }
      closeImages();
    },
  };
}

export const mapsOfLook = ({ map, emissiveMap, metalRoughMap, normalMap }: BaseLook) =>
  [map, emissiveMap, metalRoughMap, normalMap].flatMap((texture) => texture ?? []);

/** Whether the vector at `i` has no direction. */
export const isZero = (values: ArrayLike<number>, i: number) =>
  values[i] === 0 && values[i + 1] === 0 && values[i + 2] === 0;

/**
 * The normal of each triangle, in the space of `positions`. In slices: millions of triangles take
 * seconds.
 */
export async function faceNormals(
  positions: ArrayLike<number>,
  slices: Slices,
): Promise<BufferAttribute> {
  const normals = new Float32Array(positions.length);
  await slices.over(positions.length / 9, (from, to) =>
    writeFaceNormals(positions, normals, from, to),
  );
  return new BufferAttribute(normals, 3);
}
