// What a mesh shows, whether it is a built-in shape or a loaded model.
import type { BufferGeometry, Matrix4 } from 'three';
import type { Sides } from '../material/back-faces.js';
import type { BaseLook } from '../material/file-surface.js';
import type { Model } from './model.js';
import type { SurfaceValues } from '../material/material-values.js';

/** A geometry and how it looks, as far as its file or shape says. */
export interface ContentPart {
  readonly name: string;
  readonly geometry: BufferGeometry;
  /** Part to mesh. {@link Motion} changes it. */
  readonly matrix: Matrix4;
  readonly look: BaseLook;
  /** `closed` for opaque closed shapes, `single` or `double` as a file says. */
  readonly sides: Sides;
  /** Surface values from the file; HTML's units. */
  readonly surface: Partial<SurfaceValues>;
}

/** The animations of a content. */
export interface Motion {
  /** As in the file. */
  readonly names: readonly string[];
  /** Length in seconds of the animation with this name; of the first one if the name is empty or unknown. */
  durationOf(name: string): number;
  /**
   * Writes a pose into the parts' matrices and geometries. After its end an animation begins again. Null: the pose
   * without animation.
   */
  pose(name: string | null, seconds: number): void;
}

export interface Content {
  readonly parts: readonly ContentPart[];
  /** Null if nothing in it moves. */
  readonly motion: Motion | null;
  readonly missing?: Model['missing'];
  /** Frees it. Call once for each mesh that shows it. */
  dispose(): void;
}

export const NOTHING: Content = { parts: [], motion: null, dispose: () => undefined };
