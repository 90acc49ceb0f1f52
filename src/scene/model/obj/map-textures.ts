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
import { countImage, decodeImage, type ImageFile } from '../image.js';
import type { ModelBudget } from '../model-budget.js';
import { ModelError } from '../model.js';
import type { MtlMap } from './mtl.js';

export class MapTextures {
  readonly #source: ModelSource;
  readonly #budget: ModelBudget;
  readonly #images = new Map<string, MapImage | null>();
  readonly #textures = new Map<string, Texture>();

  /** @param budget gets the pixels of each image, once for each way of wrapping it: three.js uploads it for each. */
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
    const present = this.#images.get(map.file);
    const image = present === undefined ? await this.#decode(map.file) : present;
    if (image === null) return null;
    const texture = textureOf(image.bitmap, map);
    const source = image.sources.get(map.clamped);
    if (source) texture.source = source;
    else if (image.sources.size > 0) this.#budget.add({ pixels: image.pixels });
    image.sources.set(map.clamped, texture.source);
    this.#textures.set(key, texture);
    return texture;
  }

  close(): void {
    for (const image of this.#images.values()) image?.bitmap.close();
    this.#images.clear();
  }

  async #decode(file: string): Promise<MapImage | null> {
    const bytes = await this.#source.optional(addressOf(file));
    const image = bytes === null ? null : await this.#decoded({ bytes, type: '' }, file);
    this.#images.set(file, image);
    this.#source.signal.throwIfAborted();
    return image;
  }

  async #decoded(imageFile: ImageFile, name: string): Promise<MapImage> {
    try {
      const size = countImage(imageFile, this.#budget);
      const pixels = size.width * size.height;
      return { pixels, bitmap: await decodeImage(imageFile, size, this.#source.signal), sources: new Map() };
    } catch (cause) {
      if (cause instanceof ModelError) throw cause;
      throw new Error(`the image ${name} ${(cause as Error).message}`, { cause });
    }
  }
}

interface MapImage {
  readonly pixels: number;
  readonly bitmap: ImageBitmap;
  /** By whether it is clamped. */
  readonly sources: Map<boolean, Texture['source']>;
}

/** OBJ and MTL files name files by paths, not by addresses. */
export const addressOf = (path: string): string => path.split('/').map(encodeURIComponent).join('/');

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
