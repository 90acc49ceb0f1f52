// How do an image's bytes become a texture with the file's sampler? The browser decodes them without colour conversion and without
// premultiplication, first row on top. No blob: address is fetched, as a strict CSP requires.
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
import type { GltfBytes } from './bytes.js';
import { unsupported, type GltfDocument } from './document.js';

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

export interface GltfTextures {
  texture(index: number): Promise<Texture>;
  /** Waits for images that are being decoded, then closes all images. */
  close(): Promise<void>;
}

export function gltfTextures(document: GltfDocument, bytes: GltfBytes): GltfTextures {
  const images = new Map<number, Promise<ImageBitmap>>();

  const decode = async (index: number): Promise<ImageBitmap> => {
    const { bytes: file, type } = await bytes.image(index);
    try {
      return await createImageBitmap(new Blob([file], { type }), {
        premultiplyAlpha: 'none',
        colorSpaceConversion: 'none',
      });
    } catch (cause) {
      throw new Error(`images[${String(index)}] cannot be decoded by this browser`, { cause });
    }
  };

  return {
    texture: async (index) => {
      const definition = document.textures[index];
      if (definition?.image === undefined) {
        if (definition?.needs !== undefined) throw unsupported(definition.needs);
        throw new Error(`textures[${String(index)}] has no image`);
      }
      const image = images.get(definition.image) ?? decode(definition.image);
      images.set(definition.image, image);
      const texture = new Texture(await image);
      const { sampler } = definition;
      texture.flipY = false;
      texture.magFilter = MAG[Number(sampler['magFilter'])] ?? LinearFilter;
      texture.minFilter = MIN[Number(sampler['minFilter'])] ?? LinearMipmapLinearFilter;
      texture.wrapS = WRAP[Number(sampler['wrapS'])] ?? RepeatWrapping;
      texture.wrapT = WRAP[Number(sampler['wrapT'])] ?? RepeatWrapping;
      texture.generateMipmaps = texture.minFilter !== NearestFilter && texture.minFilter !== LinearFilter;
      texture.needsUpdate = true;
      return texture;
    },
    close: async () => {
      for (const image of await Promise.allSettled(images.values())) {
        if (image.status === 'fulfilled') image.value.close();
      }
    },
  };
}
