// Turns a glTF document's images into textures with the file's samplers. What is equal in the file is decoded once, and
// is one texture on the GPU.
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
  Texture,
  type MagnificationTextureFilter,
  type MinificationTextureFilter,
  type Wrapping,
} from 'three';
import { clip } from '../../fields/clip.js';
import type { ModelSource } from '../model-reader.js';
import { countImage, decodeImage } from '../image.js';
import type { ModelBudget } from '../model-budget.js';
import { isDataUri } from '../request-file.js';
import type { GltfBytes } from './bytes.js';
import type { GltfDocument } from './document.js';
import { textAt } from './json.js';
import type { GltfTexture } from './materials.js';

const MAG: Readonly<Record<number, MagnificationTextureFilter>> = { 9728: NearestFilter, 9729: LinearFilter };
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

interface GltfTextures {
  /** Textures of one image and sampler are one object. Null for an image that is missing or broken. */
  texture(index: number): Promise<Texture | null>;
  /** Waits for images that are being decoded, then closes all images. */
  close(): Promise<void>;
}

/** An image that is decoded once, however many textures use it. */
interface Image {
  readonly decoded: Promise<{ readonly pixels: number; readonly bitmap: ImageBitmap } | null>;
  /** By sampler. */
  readonly textures: Map<string, Promise<Texture | null>>;
  source?: Texture<ImageBitmap>['source'];
}

/** @param budget gets the pixels of every image, once for each sampler: three.js uploads it for each. */
export function gltfTextures(
  document: GltfDocument,
  bytes: GltfBytes,
  budget: ModelBudget,
  source: ModelSource,
): GltfTextures {
  const images = new Map<unknown, Image>();

  const decode = (index: number): Image['decoded'] =>
    source.optional(
      nameOfImage(document, index),
      () => bytes.image(index),
      async (file) => {
        const size = countImage(file, budget);
        const pixels = size.width * size.height;
        return { pixels, bitmap: await decodeImage(file, size, source.signal) };
      },
    );

  const imageAt = (index: number): Image => {
    const { bufferView, uri } = document.images[index] ?? {};
    // Exporters repeat the definition of an image that several textures use.
    const origin = uri ?? bufferView;
    const image = images.get(origin) ?? { decoded: decode(index), textures: new Map() };
    images.set(origin, image);
    return image;
  };

  const create = async (image: Image, sampler: Sampler): Promise<Texture | null> => {
    const decoded = await image.decoded;
    if (decoded === null) return null;
    const { bitmap, pixels } = decoded;
    const texture = new Texture(bitmap);
    if (image.source) {
      budget.add({ pixels });
      texture.source = image.source;
    }
    image.source = texture.source;
    Object.assign(texture, sampler);
    texture.flipY = false;
    texture.generateMipmaps = texture.minFilter !== NearestFilter && texture.minFilter !== LinearFilter;
    texture.needsUpdate = true;
    return texture;
  };

  return {
    texture: async (index) => {
      const definition = document.textures[index];
      if (definition?.image === undefined) {
        const name = `textures[${String(index)}]`;
        const needs = definition?.needs;
        const reason = needs === undefined ? 'has no image' : `needs the glTF extension ${clip(needs)}`;
        return source.optional(name, () => Promise.reject(new Error(reason)), NOTHING);
      }
      const image = imageAt(definition.image);
      const sampler = samplerOf(definition);
      const key = Object.values(sampler).join(' ');
      const texture = image.textures.get(key) ?? create(image, sampler);
      image.textures.set(key, texture);
      return texture;
    },
    close: async () => {
      for (const image of await Promise.allSettled(Array.from(images.values(), ({ decoded }) => decoded))) {
        if (image.status === 'fulfilled') image.value?.bitmap.close();
      }
    },
  };
}

const NOTHING = (): null => null;

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

type Sampler = Readonly<Pick<Texture, 'magFilter' | 'minFilter' | 'wrapS' | 'wrapT'>>;

function samplerOf({ sampler }: GltfTexture): Sampler {
  return {
    magFilter: MAG[Number(sampler['magFilter'])] ?? LinearFilter,
    minFilter: MIN[Number(sampler['minFilter'])] ?? LinearMipmapLinearFilter,
    wrapS: WRAP[Number(sampler['wrapS'])] ?? RepeatWrapping,
    wrapT: WRAP[Number(sampler['wrapT'])] ?? RepeatWrapping,
  };
}
