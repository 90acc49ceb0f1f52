// What `shadeAt` gives: one fragment of a picture, explained. Types only.
import type { Mesh } from 'three';
import type { Vec3 } from '../../phong/math/vector.js';
import type { LightShare } from '../../phong/reference/index.js';
import type { PhongLight, PhongMesh, PhongViewer } from './elements.js';

/** One light's share of a fragment. Frozen. */
export interface LightExplanation extends LightShare {
  /** The light's element; null for the head-light of a viewer without lights. */
  readonly light: PhongLight | null;
  /** Its name as the panel shows it. */
  readonly name: string;
}

export interface ShadeOptions {
  /**
   * Explains the point at `x`, `y` itself, not the one at its pixel's centre: for
   * `antialias="full"`, whose pixels are means. Default false.
   */
  readonly exact?: boolean;
}

/**
 * One fragment by the equation in float64. Frozen; lengths in scene units, vectors in world space.
 */
export interface FragmentExplanation {
  /** The point on the surface. */
  readonly p: Vec3;
  /**
   * Unit normal, interpolated and flipped toward the visible side; zero where the surface has none.
   */
  readonly N: Vec3;
  /** Unit vector toward the eye. */
  readonly V: Vec3;
  /**
   * The element the surface belongs to: a `<phong-mesh>`, or the viewer for its own `src` or
   * `geometry`.
   */
  readonly mesh: PhongMesh | PhongViewer;
  /** Its object in {@link PhongViewer.scene}. */
  readonly object: Mesh;
  /** The object's triangle, counted from 0 in the order of its geometry's index. */
  readonly triangle: number;
  /**
   * Ka, Kd and Ks as the equation uses them: 0–1, with base colour and metalness, decoded if
   * shading is linear.
   */
  readonly ka: Vec3;
  readonly kd: Vec3;
  readonly ks: Vec3;
  /** The specular exponent n. */
  readonly shininess: number;
  /**
   * The factor of ka and kd from a model's own colour, texture and vertex colours. Encoded sRGB,
   * 0–1; 1 1 1 without any.
   */
  readonly baseColor: Vec3;
  /** E, what the surface adds to the sum itself. Encoded sRGB; black for most. */
  readonly emissive: Vec3;
  /** m, 0–1: ka, kd and ks above include it. */
  readonly metalness: number;
  /** The colour is the base colour, whatever the lights; ka, kd and ks are black. */
  readonly unlit: boolean;
  /**
   * The picture averages texels here, because a texture is drawn smaller than it is; this answer
   * reads the texture at the one point `p`. So `color` can be another one than the picture's.
   */
  readonly filtered: boolean;
  /** How much of `color` the picture shows, 0–1; the rest comes from what lies behind. */
  readonly opacity: number;
  /**
   * One for each of {@link PhongViewer.lights}, in their order, null if it is not active; or the
   * head-light alone. The terms of all of them add up to the sum.
   */
  readonly shares: readonly (LightExplanation | null)[];
  /** The sum over the lights before it is clamped; encoded if shading is linear. 1 is full. */
  readonly sum: Vec3;
  /** The colour drawn: the sum clamped to 0–1. */
  readonly color: Vec3;
}
