// What a part that most viewers do without sees of its viewer, and what the viewer asks of it.
import type { Viewport } from '../../scene/viewport.js';
import type { CameraSource, PhongViewer } from '../elements.js';
import type { ViewerValues } from '../fields/viewer-fields.js';
import type { ViewerCamera } from './camera.js';
import type { ViewerChildren } from './children.js';
import type { PictureOptions } from './picture-blob.js';
import type { ViewerTree } from './template.js';
import type { ViewerSnapshot } from './viewer-snapshot.js';

/** What an extra sees of its viewer. */
export interface ExtraHost {
  readonly viewer: PhongViewer;
  readonly values: Readonly<ViewerValues>;
  readonly viewport: Viewport;
  readonly camera: ViewerCamera;
  readonly children: ViewerChildren;
  /** `tree.layer` lies over the picture and lets the pointer through. */
  readonly tree: ViewerTree;
  /** The names that helpers have placed over the picture. The probe's keep clear of them. */
  readonly names: { placed: readonly PlacedName[] };
  /** Size of the picture, CSS pixels. 0 × 0 while the viewer has no box. */
  size(): { readonly width: number; readonly height: number };
  snapshot(): ViewerSnapshot;
}

/** CSS pixels of the layer, or of the file that is being drawn. */
export type PlacedName = Readonly<Record<'left' | 'top' | 'right' | 'bottom', number> & { text: string }>;

export interface Extra {
  /** A frame was drawn, or the viewer's own values have changed. */
  update(): void;
  /** The camera moved. The frame that shows it follows. */
  cameraMoved?(source: CameraSource): void;
  /** Draws what lies over the picture as it is in this task, on a canvas of its size. */
  drawOver?(canvas: HTMLCanvasElement, options: PictureOptions): Promise<void> | void;
  dispose(): void;
}
