// How do an MTL file's images become textures? Decoded without colour conversion; each image once. One that is missing is left out.
import {
  ClampToEdgeWrapping,
  LinearFilter,
  LinearMipmapLinearFilter,
  NoColorSpace,
  RepeatWrapping,
  Texture,
} from 'three';
import type { ModelSource } from '../format.js';
import type { ModelBudget } from '../limits.js';
import type { MtlMap } from './mtl.js';

export class MapTextures {
  readonly #source: ModelSource;
  readonly #budget: ModelBudget;
  readonly #images = new Map<string, ImageBitmap | null>();
  readonly #textures = new Map<string, Texture>();

  constructor(source: ModelSource, budget: ModelBudget) {
    this.#source = source;
    this.#budget = budget;
  }

  /** Null if there is no map, or its file is missing. @throws Error if the browser cannot decode it. */
  async of(map: MtlMap | null): Promise<Texture | null> {
    if (map === null) return null;
    const key = JSON.stringify(map);
    const known = this.#textures.get(key);
    if (known) return known;
    const image = this.#images.get(map.file);
    const decoded = image === undefined ? await this.#decode(map.file) : image;
    if (decoded === null) return null;
    const texture = textureOf(decoded, map);
    this.#textures.set(key, texture);
    return texture;
  }

  close(): void {
    for (const image of this.#images.values()) image?.close();
    this.#images.clear();
  }

  async #decode(file: string): Promise<ImageBitmap | null> {
    const bytes = await this.#source.optional(addressOf(file));
    const image = bytes === null ? null : await decoded(bytes, file);
    this.#images.set(file, image);
    if (image !== null) this.#budget.add({ pixels: image.width * image.height });
    this.#source.signal.throwIfAborted();
    return image;
  }
}

/** OBJ and MTL files name files by paths, not by addresses. */
export const addressOf = (path: string): string => path.split('/').map(encodeURIComponent).join('/');

async function decoded(bytes: Uint8Array<ArrayBuffer>, file: string): Promise<ImageBitmap> {
  try {
    return await createImageBitmap(new Blob([bytes]), {
      premultiplyAlpha: 'none',
      colorSpaceConversion: 'none',
    });
  } catch (cause) {
    throw new Error(`the image ${file} cannot be decoded by this browser`, { cause });
  }
}

function textureOf(image: ImageBitmap, { scale, offset, clamped }: MtlMap): Texture {
  const texture = new Texture(image);
  texture.colorSpace = NoColorSpace;
  texture.flipY = false;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.wrapS = texture.wrapT = clamped ? ClampToEdgeWrapping : RepeatWrapping;
  // The file's v points up, the geometry's points down: 1 − (v·s + o) = (1 − v)·s + (1 − s − o).
  texture.repeat.set(scale[0], scale[1]);
  texture.offset.set(offset[0], 1 - scale[1] - offset[1]);
  texture.updateMatrix();
  texture.needsUpdate = true;
  return texture;
}
