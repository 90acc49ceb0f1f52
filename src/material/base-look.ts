// What a file says about a surface, without Ka, Kd, Ks and the exponent.
import type { Texture } from 'three';
import type { Vec3 } from '../math/vector.js';
import { type FileSurface, NO_FILE_SURFACE } from './file-surface.js';

/** What a file says about a surface. Its base colour multiplies Ka and Kd. */
export interface BaseLook extends FileSurface {
  /** Encoded sRGB, 0–1. */
  readonly baseColor: Vec3;
  readonly opacity: number;
  readonly alphaMode: 'opaque' | 'mask' | 'blend';
  readonly alphaCutoff: number;
  readonly map: Texture | null;
  readonly vertexColors: boolean;
}

export const PLAIN_LOOK: BaseLook = {
  baseColor: [1, 1, 1],
  opacity: 1,
  alphaMode: 'opaque',
  alphaCutoff: 0.5,
  map: null,
  vertexColors: false,
  ...NO_FILE_SURFACE,
};
