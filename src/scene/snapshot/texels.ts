// The bytes that a texture's image has on the GPU.
import type { Texture } from 'three';
import { NoWebGL2Error } from '../gpu/stage.js';

export interface Texels {
  readonly width: number;
  readonly height: number;
  /** r, g, b, a of each texel with straight alpha, rows as in the image. */
  readonly data: Uint8Array;
}

type Image = TexImageSource & { readonly width: number; readonly height: number };

/** Each image is read once, because fragments are usually explained one after another. */
const read = new WeakMap<object, Texels>();

/** Throws if the image cannot be read. */
export function texelsOf(map: Texture): Texels {
  if ((map as { isCompressedTexture?: boolean }).isCompressedTexture === true)
    throw new Error('compressed textures cannot be read');
  const image = map.image as Image;
  const known = read.get(image) ?? readTexels(image);
  read.set(image, known);
  return known;
}

/**
 * Uses a short-lived WebGL context of its own. A 2D canvas would premultiply alpha, and transparent texels would lose
 * the colour that filtering mixes into their neighbours.
 */
function readTexels(image: Image): Texels {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (gl === null) throw new NoWebGL2Error('this browser gives no WebGL 2 context to read a texture with');
  try {
    return readThrough(gl, image);
  } finally {
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
}

function readThrough(gl: WebGL2RenderingContext, image: Image): Texels {
  const { width, height } = image;
  const data = new Uint8Array(4 * width * height);
  const texture = gl.createTexture();
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, image);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  if (gl.getError() !== gl.NO_ERROR)
    throw new Error(`a texture of ${String(width)} × ${String(height)} texels cannot be read`);
  return { width, height, data };
}
