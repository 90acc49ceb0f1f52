// The control panel's life: its code is fetched on first use, it is notified of changes, and
// removed again.
import { reportMissing } from '../../model/provided-code.js';
import { afterPictures } from '../../scene/frame-loop.js';
import type { PhongViewer } from '../elements.js';
import { type Panel, type PanelChange, panelCode } from '../extra-code.js';
import type { ViewerValues } from '../fields/viewer-fields.js';
import { withRows } from '../panel-rows.js';
import { isInClosed } from '../page/closed.js';
import type { ViewerContext } from './viewer-context.js';

export class ViewerPanel {
  readonly #viewer: PhongViewer;
  readonly #values: Readonly<ViewerValues>;
  readonly #changes = new Set<PanelChange>();
  #panel: Panel | null = null;
  #wanted: Wanted = false;

  /** The place of a panel that waits until what is around the viewer is opened. */
  #waiting: HTMLElement | null = null;
  #painted = false;

  constructor({ viewer, signals, store, lightSet }: ViewerContext) {
    this.#viewer = viewer;
    this.#values = store.values;
    signals.viewChanged.listen(({ painted }) => {
      this.#painted ||= painted;
      if (painted && this.#waiting !== null) {
        void this.toggle(this.#wanted, this.#waiting);
      }
    });
    lightSet.changed.listen(() => this.changed('lights'));
    signals.meshesChanged.listen(() => this.changed('meshes'));
    signals.cameraMoved.listen(() => this.changed('camera'));
    signals.fitted.listen(() => this.changed('camera'));
  }

  /**
   * Shows the panel in `place` once its code is there, with other rows if the list has changed, or
   * removes it.
   */
  async toggle(wanted: Wanted, place: HTMLElement | null): Promise<void> {
    if (wanted !== this.#wanted) {
      this.#panel?.dispose();
      this.#panel = null;
      place?.removeAttribute(PANEL_PLACE.open);
    }
    this.#wanted = wanted;
    if (wanted === false || place === null) return;
    if (this.#panel === null) {
      place.setAttribute(PANEL_PLACE.open, PANEL_PLACE.awaited);
    }
    const waits = !this.#painted && this.#values.loading !== 'eager' && isInClosed(this.#viewer);
    this.#waiting = waits ? place : null;
    if (waits) return;
    const code = await withRows(panelCode).catch(reportMissing);
    if (this.#panel === null) {
      place.removeAttribute(PANEL_PLACE.open);
    }
    if (code === undefined) return;
    const root = this.#viewer.shadowRoot;
    if (this.#wanted === false || this.#panel !== null || root === null) return;
    this.#panel = code.createPanel(this.#viewer, place, root);
  }

  /** Updates the panel in one of the next frames. */
  changed(what: PanelChange): void {
    if (this.#panel === null) return;
    this.#changes.add(what);
    afterPictures(this.#viewer, this.#update);
  }

  readonly #update = () => {
    const changes = [...this.#changes];
    this.#changes.clear();
    for (const change of changes) {
      this.#panel?.update(change);
    }
  };
}

type Wanted = boolean | readonly string[];

/** How the panel's place says to style sheets and comparisons whether the panel is open. */
export const PANEL_PLACE = {
  /** Attribute while the panel is open; {@link awaited} while its code is being fetched. */
  open: 'data-open',

  /**
   * The picture leaves room for a panel that will be open: from {@link wide} pixels on, see
   * phong-viewer.css.
   */
  awaited: 'awaited',

  /** CSS pixels. From this width on the panel stands open beside the picture; see panel.css. */
  wide: 640,
} as const;
