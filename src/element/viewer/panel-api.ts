// What the element asks of a control panel, which it never imports: index.ts hands it a loader. Types only.
import type { PhongViewer } from '../phong-viewer.js';

/** What has changed, so that a panel brings only that in step. */
export type PanelChange = 'camera' | 'light' | 'lights' | 'mesh' | 'meshes' | 'viewer';

export interface Panel {
  /** Called after changes, several in one task as one call each kind. Never asks for frames. */
  update(change: PanelChange): void;
  dispose(): void;
}

/** Builds the panel inside `place`; styles go to `root`, the viewer's shadow root. */
export type CreatePanel = (viewer: PhongViewer, place: HTMLElement, root: ShadowRoot) => Panel;

export type PanelLoader = () => Promise<{ readonly createPanel: CreatePanel }>;
