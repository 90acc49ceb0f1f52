// What an optional part over the picture, such as the helpers or the probe, gets of its viewer, and
// what the viewer asks of it. Types, and the list that the table of extras fills.
import type { LightValues } from '../../../phong/light/light-state.js';
import type { Vec3 } from '../../../phong/math/vector.js';
import type { SceneSnapshot } from '../../../phong/geometry/scene-snapshot.js';
import type { Viewport } from '../../scene/viewport.js';
import type {
  CameraSource,
  PhongLight,
  PhongMesh,
  PhongViewer,
  PictureOptions,
} from '../elements.js';
import type { ViewerValues } from '../fields/viewer-fields.js';
import type { BoxSize } from '../page/visibility.js';
import type { ViewerCamera } from './camera.js';
import type { ViewerTree } from './viewer-tree.js';

export interface ExtraHost {
  readonly viewer: PhongViewer;
  readonly values: Readonly<ViewerValues>;
  readonly viewport: Viewport;
  readonly camera: ViewerCamera;
  /** `tree.layer` lies over the picture and lets the pointer through. */
  readonly tree: ViewerTree;
  /** The names that helpers have placed over the picture. The probe's keep clear of them. */
  readonly names: { placed: readonly PlacedName[] };
  /** The point that the user has pinned the probe to, in world space. Null for none. */
  pin: Vec3 | null;
  /** Size of the picture. 0 × 0 while the viewer has no box. */
  size(): BoxSize;
  snapshot(): ViewerSnapshot;
}

/** CSS pixels of the layer, or of the file that is being drawn. */
type PlacedName = Readonly<Record<'left' | 'top' | 'right' | 'bottom', number>>;

export interface Extra {
  /** A frame was drawn, or the viewer's own values have changed. */
  update(): void;
  /** The camera moved. The frame that shows it follows. */
  cameraMoved?(source: CameraSource): void;
  /** Draws what lies over the picture as it is in this task, on a canvas of its size. */
  drawOver?(canvas: HTMLCanvasElement, options: PictureOptions): Promise<void> | void;
  dispose(): void;
}

/** A kind of these parts. */
export interface ExtraKind {
  readonly wanted: (values: Readonly<ViewerValues>, viewer: PhongViewer) => boolean;
  readonly load: () => Promise<{ readonly create: (host: ExtraHost) => Extra }>;
  /** The first picture waits for it: without it another camera would be shown. */
  readonly first?: true;
}

/** Filled by the table of extras, in drawing order. */
export const extraKinds: ExtraKind[] = [];

/**
 * What is explained, copied at the call: this code may have to be fetched, and the scene changes
 * meanwhile.
 */
export interface ViewerSnapshot {
  /** Null while the picture has no box on the page. */
  readonly scene: SceneSnapshot<PhongMesh | PhongViewer> | null;
  /** Size of the picture, in the CSS pixels of pointer events. */
  readonly width: number;
  readonly height: number;
  readonly lights: readonly {
    /** Null for the head-light. */
    readonly light: PhongLight | null;
    readonly name: string;
    readonly values: LightValues;
  }[];
}
