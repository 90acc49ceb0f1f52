// Turns an MTL file's images into textures. Decoded without colour conversion; each image once. One that is missing or
// broken is left out.
import {
  ClampToEdgeWrapping,
  LinearFilter,
  LinearMipmapLinearFilter,
  NoColorSpace,
  RepeatWrapping,
  Texture,
} from 'three';
import type { ModelSource } from '../model-reader.js';
import { countImage, decodeImage, type ImageFile } from '../image.js';
import type { ModelBudget } from '../model-budget.js';
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

  /** Null if there is no map, or its file is missing or broken. */
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
    const { linked, optional } = this.#source;
    const read = (): Promise<Uint8Array<ArrayBuffer>> => linked(addressOf(file));
    const image = await optional(file, read, (bytes) => this.#decoded({ bytes, type: '' }));
    this.#images.set(file, image);
    this.#source.signal.throwIfAborted();
    return image;
  }

  async #decoded(file: ImageFile): Promise<MapImage> {
    const size = countImage(file, this.#budget);
    const pixels = size.width * size.height;
    return { pixels, bitmap: await decodeImage(file, size, this.#source.signal), sources: new Map() };
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
