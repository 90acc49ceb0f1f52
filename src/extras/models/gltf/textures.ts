// Turns a glTF document's images into textures with the file's samplers.
import {
  ClampToEdgeWrapping,
  LinearFilter,
  LinearMipmapLinearFilter,
  LinearMipmapNearestFilter,
  MirroredRepeatWrapping,
  NearestFilter,
  NearestMipmapLinearFilter,
  NearestMipmapNearestFilter,
  RepeatWrapping,
  type MagnificationTextureFilter,
  type MinificationTextureFilter,
  type Texture,
  type Wrapping,
} from 'three';
import { clip } from '../../../phong/fields/clip.js';
import type { ModelSource } from '../model-reader.js';
import type { ImageTextures, Sampler } from '../image.js';
import type { GltfBytes } from './bytes.js';
import type { GltfDocument } from './document.js';
import { type JsonObject, textAt } from './json.js';
import { isDataUri } from '../../../phong/fields/file-names.js';

const MAG: Readonly<Record<number, MagnificationTextureFilter>> = {
  9728: NearestFilter,
  9729: LinearFilter,
};
const MIN: Readonly<Record<number, MinificationTextureFilter>> = {
  9728: NearestFilter,
  9729: LinearFilter,
  9984: NearestMipmapNearestFilter,
  9985: LinearMipmapNearestFilter,
  9986: NearestMipmapLinearFilter,
  9987: LinearMipmapLinearFilter,
};
const WRAP: Readonly<Record<number, Wrapping>> = {
  33071: ClampToEdgeWrapping,
  33648: MirroredRepeatWrapping,
  10497: RepeatWrapping,
};

/** The texture with this index. Null for an image that is missing or broken. */
export function gltfTexture(
  index: number,
  document: GltfDocument,
  bytes: GltfBytes,
  images: ImageTextures,
  { optional }: ModelSource,
): Promise<Texture | null> {
  const { image, needs, sampler = {} } = document.textures[index] ?? {};
  if (image === undefined) {
    const reason = needs === undefined ? 'has no image' : `needs the glTF extension ${clip(needs)}`;
    const read = () => Promise.reject(new Error(reason));
    return optional(`textures[${String(index)}]`, read, () => null);
  }
  // Exporters repeat the definition of an image that several textures use.
  const { uri, bufferView } = document.images[image] ?? {};
  return images.of(
    uri ?? bufferView,
    nameOfImage(document, image),
    () => bytes.image(image),
    samplerOf(sampler),
  );
}

/** For reports: the path of its file, else its name or place in the document. */
function nameOfImage({ images }: GltfDocument, index: number): string {
  const { uri, name } = images[index] ?? {};
  const path = textAt(uri);
  if (path === '' || isDataUri(path)) return textAt(name) || `images[${String(index)}]`;
  try {
    return decodeURIComponent(path);
  } catch {
    return path; // a percent sign of its own
  }
}

function samplerOf(sampler: JsonObject): Sampler {
  return {
    magFilter: MAG[Number(sampler['magFilter'])] ?? LinearFilter,
    minFilter: MIN[Number(sampler['minFilter'])] ?? LinearMipmapLinearFilter,
    wrapS: WRAP[Number(sampler['wrapS'])] ?? RepeatWrapping,
    wrapT: WRAP[Number(sampler['wrapT'])] ?? RepeatWrapping,
  };
}
