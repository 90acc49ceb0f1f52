// The control panel's life: fetched when first wanted, told what changed, taken away. Knows nothing of its controls.
import { fetched } from './fetched.js';
import type { Panel, PanelChange, PanelLoader } from './panel-api.js';
import type { PhongViewer } from '../phong-viewer.js';

export class ViewerPanel {
  readonly #viewer: PhongViewer;
  readonly #changes = new Set<PanelChange>();
  #panel: Panel | null = null;
  #wanted = false;

  constructor(viewer: PhongViewer) {
    this.#viewer = viewer;
  }

  /** Shows it in `place`, as soon as its code is there, or takes it away. */
  async toggle(wanted: boolean, loader: PanelLoader | null, place: HTMLElement | null): Promise<void> {
    this.#wanted = wanted;
    if (!wanted) {
      this.#panel?.dispose();
      this.#panel = null;
      return;
    }
    if (loader === null || place === null) return;
    const door = await fetched(loader, 'the control panel');
    const root = place.getRootNode();
    if (door === null || !this.#wanted || this.#panel !== null || !(root instanceof ShadowRoot)) return;
    this.#panel = door.createPanel(this.#viewer, place, root);
  }

  /** Brings the panel in step at the task's end. */
  changed(what: PanelChange): void {
    if (this.#panel === null) return;
    if (this.#changes.size === 0) queueMicrotask(this.#update);
    this.#changes.add(what);
  }

  readonly #update = (): void => {
    const changes = [...this.#changes];
    this.#changes.clear();
    for (const change of changes) this.#panel?.update(change);
  };
}
