// A loaded model, whatever its file format. Parts in the model's own space (float64 matrices, file units).
import type { BufferGeometry, Matrix4, Texture } from 'three';
import type { FileSurface } from '../material/file-surface.js';
import type { Vec3 } from '../math/vector.js';

export interface Model {
  /** At least one. */
  readonly parts: readonly ModelPart[];
  /** What the file says and the equation has no place for, by the file's own names. */
  readonly dropped?: ReadonlySet<string>;
  /**
   * What the model is shown without because it is missing or broken, by the names in the model: images and libraries of
   * materials.
   */
  readonly missing?: readonly string[];
  /** Null or absent if nothing in it moves. */
  readonly motion?: ModelMotion | null;
  /** Frees geometries and textures and closes their images. A second call does nothing. */
  dispose(): void;
}

/** The animations of a model. */
export interface ModelMotion {
  /** At least one, in the file's order. Names can be empty or repeat; durations are in seconds. */
  readonly clips: readonly { readonly name: string; readonly duration: number }[];
  /**
   * Writes a pose into the parts' matrices and geometries, bounds of the latter included. Null for the file's own pose.
   * Times outside a clip give its first or last one. Never throws.
   */
  pose(clip: number | null, seconds: number): void;
}

export interface ModelPart {
  /** Its name in the file; may be empty. */
  readonly name: string;
  /**
   * Attributes: `position` (float, finite); `normal` (float, unit length or zero); for each map of the look the texture
   * coordinates of its channel (`uv`, `uv1`, …); `tangent` (unit, w ±1) for a normal map; `color` (encoded sRGB, 3 or 4
   * components, 0 to 1) if the file has vertex colours. Indexed or not. Parts can share geometries or attributes.
   * Vertices that {@link ModelMotion} changes have `DynamicDrawUsage`.
   */
  readonly geometry: BufferGeometry;
  /** Part to model. {@link ModelMotion} changes it. */
  readonly matrix: Matrix4;
  readonly look: ModelLook;
}

/** Without what {@link FileSurface} names, a file says nothing about it. */
export interface ModelLook extends Partial<FileSurface> {
  /** Multiplies ka and kd. Encoded sRGB, 0 to 1. */
  readonly baseColor: Vec3;
  /** 0 to 1; always 1 if `alphaMode` is `opaque`. */
  readonly opacity: number;
  readonly alphaMode: 'opaque' | 'mask' | 'blend';
  /** With `mask`, fragments with a lower alpha are discarded. */
  readonly alphaCutoff: number;
  /**
   * Encoded sRGB, read without decoding (`NoColorSpace`). Sampled with `uv` transformed by `map.matrix` (up to date),
   * with the file's filters and wrapping. The first row is the top of the image, as in glTF.
   */
  readonly map: Texture | null;
  /** Whether both sides of its faces can be seen. False only if a glTF file says so. */
  readonly doubleSided: boolean;
  /** The file has no normals: `geometry` has one per triangle. */
  readonly flat: boolean;
  /** Phong coefficients, from formats that have them. Encoded sRGB, 0 to 1. */
  readonly ka?: Vec3;
  readonly kd?: Vec3;
  readonly ks?: Vec3;
  readonly shininess?: number;
}

/** All textures of a look. */
export const mapsOfLook = ({ map, emissiveMap, metalRoughMap, normalMap }: ModelLook): Texture[] =>
  [map, emissiveMap, metalRoughMap, normalMap].flatMap((texture) => texture ?? []);

export type ModelErrorCode = 'load-failed' | 'bad-model' | 'too-large' | 'csp';

/** Why a model cannot be shown, in words for the page's author. */
export class ModelError extends Error {
  override readonly name = 'ModelError';
  readonly code: ModelErrorCode;

  constructor(code: ModelErrorCode, message: string, options?: ErrorOptions) {
    super(message, options);
    this.code = code;
  }
}
