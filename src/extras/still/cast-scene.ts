// What the ray caster casts: a scene as plain data, so that threads can be sent it. World space
// unless a field says otherwise; colours as in the reference: 255 is full for Ka, Kd, Ks and
// lights.
import type { Quantity } from '../../phong/material/view/view-table.js';
import type { LightValues, ReferenceOptions, Surface, Vec3 } from '../../phong/reference/index.js';

/**
 * A perspective camera. `right`, `up` and `back` are unit vectors; `back` points from the target to
 * the eye.
 */
export interface CastCamera {
  readonly eye: Vec3;
  readonly right: Vec3;
  readonly up: Vec3;
  readonly back: Vec3;
  /** Vertical angle of view in degrees. */
  readonly fov: number;
}

/** An image on a surface. Level 0, bilinear unless `nearest`. The first row is v = 0. */
export interface CastTexture {
  readonly width: number;
  readonly height: number;
  /** r, g, b, a of each texel, 0–255; colours are encoded sRGB. */
  readonly data: ArrayLike<number>;
  /** Default `repeat`. */
  readonly wrapS?: Wrap;
  readonly wrapT?: Wrap;
  readonly nearest?: boolean;
  /** Which of the shape's `uvs` places it. Default 0. */
  readonly uv?: number;
}

export type Wrap = 'repeat' | 'clamp' | 'mirror';

/** See `phong/material/file-surface.ts` for what files say. */
export interface CastMaterial extends Surface {
  readonly shading?: 'phong' | 'gouraud' | 'flat';
  /** Default: the scene's. */
  readonly reflection?: 'phong' | 'blinn-phong';
  /** Back faces are not drawn. Default false: they are shaded with their normal flipped. */
  readonly single?: boolean;
  /** Multiplies the base colour, and the opacity by its alpha. */
  readonly texture?: CastTexture;
  readonly emissiveTexture?: CastTexture;
  /** Green multiplies `roughness`, blue the metalness. */
  readonly metalRoughTexture?: CastTexture;
  /** Gives the exponent where there is such a texture; null: the exponent is the material's own. */
  readonly roughness?: number | null;
  readonly normalTexture?: CastTexture;
  readonly normalScale?: number;
  /** 0–1, default 1. */
  readonly opacity?: number;
  /** `blend`: the opacity counts. `mask`: what has less than `alphaCutoff` is not there. */
  readonly alphaMode?: 'opaque' | 'mask' | 'blend';
  readonly alphaCutoff?: number;
}

/**
 * Triangles as the shader draws them: the corners' unit normals are interpolated, and made unit per
 * sample. The arrays are in the mesh's own space.
 */
export interface CastShape {
  readonly positions: ArrayLike<number>;
  readonly normals: ArrayLike<number>;
  readonly uvs?: readonly ArrayLike<number>[];
  /** Encoded sRGB, r g b a of each vertex, 0–1. */
  readonly colors?: ArrayLike<number>;
  /** They are in linear light, otherwise encoded sRGB. Default false. */
  readonly linearColors?: boolean;
  /** Unit, w ±1. */
  readonly tangents?: ArrayLike<number>;
  /** Default: corners in order. */
  readonly index?: ArrayLike<number>;
}

/** Where surfaces coincide, the last one shows. */
export interface CastObject {
  readonly shape: CastShape;
  /** To world space: 16 numbers by columns, as three.js has them. Default: the identity. */
  readonly matrix?: ArrayLike<number>;
  /**
   * In world space. Blended objects are drawn in the order of its depth, the farthest first. Default:
   * the matrix's origin.
   */
  readonly center?: Vec3;
  readonly material: CastMaterial;
}

export interface CastScene extends Omit<ReferenceOptions, 'camera'> {
  readonly camera: CastCamera;
  readonly lights: readonly Readonly<LightValues>[];
  readonly objects: readonly CastObject[];
  /** What pixels show in place of the equation: of the fragment, or of the one light. */
  readonly quantity?: Quantity;
}

export interface CastOptions {
  readonly width: number;
  readonly height: number;
  /**
   * Most samples of a pixel in which something varies. Default 1,024. See `picture.ts` for the pixels
   * that need fewer.
   */
  readonly samples?: number;
}
