// The fragment at the origin of a floor, as shadeAt explains it.
import type { Vec3 } from '../../src/phong/math/vector.js';
import { Mesh } from 'three';
import type { FragmentExplanation } from '../../src/viewer/element/elements.js';
import type { PhongViewer } from '../../src/viewer/element/phong-viewer.js';
import type { LightValues } from '../../src/phong/light/light-state.js';
import {
  coefficientsOf,
  type ReferenceOptions,
  shade,
  type Surface,
} from '../../src/phong/reference/index.js';
import { light } from './arbitraries.js';

export interface Explained extends ReferenceOptions {
  readonly lights?: readonly Partial<LightValues>[];
  readonly surface?: Partial<Surface>;
  readonly normal?: Vec3;
  readonly eye?: Vec3;
}

/** Lights are named by their numbers. */
export function explained({ lights = [], ...given }: Explained): FragmentExplanation {
  const { normal = [0, 1, 0], eye = [0, 2, 2], ...options } = given;
  const surface: Surface = { ...SURFACE, ...given.surface };
  const values = lights.map((one) => light(one));
  const shaded = shade({ p: [0, 0, 0], normal, eye }, surface, values, options);
  return {
    p: [0, 0, 0],
    mesh: {} as PhongViewer,
    object: new Mesh(),
    triangle: 0,
    opacity: 1,
    baseColor: [1, 1, 1],
    metalness: 0,
    unlit: false,
    filtered: false,
    emissive: [0, 0, 0],
    ...surface,
    ...shaded,
    ...coefficientsOf(surface, options.linear),
    shares: shaded.shares.map(
      (share, i) => share && { ...share, light: null, name: `light ${i + 1}` },
    ),
  };
}

const SURFACE = {
  ka: [255, 255, 255],
  kd: [204, 204, 204],
  ks: [102, 102, 102],
  shininess: 8,
} as const;
