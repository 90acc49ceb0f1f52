// What the ray caster casts: a scene as plain data, so that a page can send it to Node, and Node to
// its threads. World space unless a field says otherwise; colours as in the reference: 255 is full
// for Ka, Kd, Ks and lights.
import type {
  LightValues,
  ReferenceOptions,
  Surface,
  Vec3,
} from '../../../src/phong/reference/index.js';

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

/** Base colour; encoded sRGB, read undecoded. Level 0, bilinear. The first row is v = 0. */
export interface CastTexture {
  readonly width: number;
  readonly height: number;
  /** r, g, b, a of each texel, 0–255. Alpha is not read. */
  readonly data: ArrayLike<number>;
  /** Default `repeat`. */
  readonly wrapS?: Wrap;
  readonly wrapT?: Wrap;
}

export type Wrap = 'repeat' | 'clamp' | 'mirror';

/** An opaque surface. */
export interface CastMaterial extends Surface {
  readonly texture?: CastTexture;
}

/**
 * Triangles as the shader draws them: the corners' unit normals are interpolated, and made unit per
 * sample. The arrays are in the mesh's own space.
 */
export interface TrianglesShape {
  readonly kind: 'triangles';
  readonly positions: ArrayLike<number>;
  readonly normals: ArrayLike<number>;
  readonly uvs?: ArrayLike<number>;
  /** Default: corners in order. */
  readonly index?: ArrayLike<number>;
}

/**
 * The true shapes of `geometry`, in their own space. `sphere`: radius 1/2. `cylinder` and `cone`:
 * radius 1/2, y from −1/2 to 1/2, with their flat ends. `torus`: a tube of radius 0.15 around a
 * circle of radius 0.35 in the plane of x and y.
 */
export interface TrueShape {
  readonly kind: 'sphere' | 'cylinder' | 'cone' | 'torus';
}

export type CastShape = TrianglesShape | TrueShape;

/** Back faces are shaded with their normal flipped. */
export interface CastObject {
  readonly shape: CastShape;
  /**
   * To world space: 16 numbers by columns, as three.js has them, not singular. Default: the
   * identity.
   */
  readonly matrix?: ArrayLike<number>;
  readonly material: CastMaterial;
}

export interface CastScene extends Omit<ReferenceOptions, 'camera'> {
  readonly camera: CastCamera;
  readonly lights: readonly Readonly<LightValues>[];
  readonly objects: readonly CastObject[];
}

export interface CastOptions {
  readonly width: number;
  readonly height: number;
  /**
   * Samples of a pixel in which something varies: the square of a whole number. Default 1,024. See
   * `picture.ts` for the pixels that need fewer.
   */
  readonly samples?: number;
}
