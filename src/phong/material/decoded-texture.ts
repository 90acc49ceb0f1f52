// Textures whose colours the GPU decodes by the sRGB curve before it filters them, for shading in
// linear light.
import { RGBAFormat, SRGBColorSpace, type Texture, UnsignedByteType } from 'three';

/** By the texture with the same image that is read as it is stored. */
const decoded = new WeakMap<Texture, Texture>();

/**
 * Whether the GPU can decode it: WebGL 2 has sRGB for bytes only. Others are decoded in the shader,
 * after they are filtered.
 */
export function isDecodable(texture: Texture): boolean {
  const { isVideoTexture = false, isCompressedTexture = false } = texture as {
    readonly isVideoTexture?: boolean;
    readonly isCompressedTexture?: boolean;
  };
  return (
    texture.format === RGBAFormat &&
    texture.type === UnsignedByteType &&
    !(isVideoTexture || isCompressedTexture || texture.isRenderTargetTexture)
  );
}

/**
 * The same texture, decoded where it can be. Disposed of with it. Call before each draw: it follows
 * the texture's image.
 */
export function decodedTexture(texture: Texture): Texture {
  if (!isDecodable(texture)) return texture;
  let twin = decoded.get(texture);
  if (twin === undefined) {
    const made = (twin = texture.clone());
    made.colorSpace = SRGBColorSpace;
    made.onUpdate = texture.onUpdate;
    decoded.set(texture, made);
    texture.addEventListener('dispose', () => made.dispose());
  }
  twin.version = texture.version;
  return twin;
}
