// What is a loaded model, whatever file it came from? Parts in the model's own space (float64 matrices, file units).
// Must not know how any format is read, nor who shows the result.
import type { BufferGeometry, Matrix4, Texture } from 'three';
import type { Vec3 } from '../../math/vector.js';

export interface Model {
  /** At least one. */
  readonly parts: readonly ModelPart[];
  /** Frees geometries and textures and closes their images. A second call does nothing. */
  dispose(): void;
}

export interface ModelPart {
  /** The file's name for it; empty where it gives none. */
  readonly name: string;
  /**
   * Float `position`, finite; float `normal`, unit length or zero; `uv` where the look has a map; `color` (encoded
   * sRGB, 3 or 4 components, 0 to 1) where the file colours vertices. Indexed or not. Parts may share one, or attributes.
   */
  readonly geometry: BufferGeometry;
  /** Part to model. */
  readonly matrix: Matrix4;
  readonly look: ModelLook;
}

export interface ModelLook {
  /** Multiplies ka and kd. Encoded sRGB, 0 to 1. */
  readonly baseColor: Vec3;
  /** 0 to 1; always 1 where `alphaMode` is `opaque`. */
  readonly opacity: number;
  readonly alphaMode: 'opaque' | 'mask' | 'blend';
  /** `mask` leaves fragments out whose alpha is below this. */
  readonly alphaCutoff: number;
  /**
   * Encoded sRGB, to be read undecoded (`NoColorSpace`), sampled with `uv` through `map.matrix` (up to date), with the
   * file's filters and wrapping. Its first row is the image's top, as glTF has it.
   */
  readonly map: Texture | null;
  /** Both sides of its faces are to be seen. False only where a glTF file says so. */
  readonly doubleSided: boolean;
  /** The file has no normals: `geometry` has one a triangle. */
  readonly flat: boolean;
  /** Phong's own factors, only from formats that carry them. Encoded sRGB, 0 to 1. */
  readonly ka?: Vec3;
  readonly kd?: Vec3;
  readonly ks?: Vec3;
  readonly shininess?: number;
}

export type ModelErrorCode = 'load-failed' | 'bad-model' | 'too-large' | 'csp';

/** Why a model is not shown, in words for the page's author. */
export class ModelError extends Error {
  override readonly name = 'ModelError';
  readonly code: ModelErrorCode;

  constructor(code: ModelErrorCode, message: string, options?: ErrorOptions) {
    super(message, options);
    this.code = code;
  }
}
