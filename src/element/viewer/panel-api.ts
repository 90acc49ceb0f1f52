// What the element needs of a control panel. The element does not import it: index.ts provides a loader. Types only.
import type { PhongViewer } from '../elements.js';

/** What has changed, so that a panel updates only that. */
export type PanelChange = 'camera' | 'light' | 'lights' | 'mesh' | 'meshes' | 'viewer';

export interface Panel {
  /** Called after changes, once per kind and task. Requests no frames. */
  update(change: PanelChange): void;
  dispose(): void;
}

/** Builds the panel inside `place`; its styles go to `root`, the viewer's shadow root. */
export type CreatePanel = (viewer: PhongViewer, place: HTMLElement, root: ShadowRoot) => Panel;

export type PanelLoader = () => Promise<{ readonly createPanel: CreatePanel }>;
