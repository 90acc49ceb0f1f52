// What does a viewer show and say around its picture: poster, progress bar, message, custom states, description? Brings the shadow
// tree in step with what is loaded and what has failed. Knows neither how anything is loaded nor how it is drawn.
import { checkedTexts, upgradeTexts, type ViewerTexts } from '../fields/texts.js';
import type { PhongLight } from '../phong-light.js';
import type { PhongViewer } from '../phong-viewer.js';
import { ViewerAnnouncements } from './announcements.js';
import type { CameraSource } from './camera.js';
import { type ExtraHost, ViewerExtras } from './extras.js';
import type { ViewerFailure } from './failure.js';
import type { ViewerLoading } from './loading.js';
import { ViewerStates } from './states.js';
import { ViewerTree } from './template.js';

export interface DisplayHost extends Omit<ExtraHost, 'tree'> {
  readonly loading: ViewerLoading;
  readonly failure: ViewerFailure;
}

export class ViewerDisplay {
  readonly #viewer: PhongViewer;
  readonly #host: DisplayHost;
  readonly #states: ViewerStates;
  readonly #announcements: ViewerAnnouncements;
  readonly extras: ViewerExtras;
  /** Null before the element is connected for the first time. */
  #tree: ViewerTree | null = null;
  #texts: ViewerTexts | null = null;
  /** The poster has been replaced by a picture. */
  #revealed = false;
  #empty = false;

  constructor(host: DisplayHost) {
    const { viewer } = host;
    this.#viewer = viewer;
    this.#host = host;
    this.#states = new ViewerStates(viewer);
    this.#announcements = new ViewerAnnouncements(viewer);
    this.extras = new ViewerExtras(host);
    for (const part of [this.#announcements, this.extras]) viewer.addController(part);
  }

  /** `holder` is the element that holds the canvas. Returns the surface: the picture, without the panel. */
  fill(root: Node, holder: HTMLElement): HTMLElement {
    upgradeTexts(this.#viewer);
    this.#tree = new ViewerTree(root, holder, this.#host.loading.retry);
    this.#announcements.connect(this.#tree);
    this.extras.connect(this.#tree);
    return this.#tree.surface;
  }

  /** The control panel's place. */
  get panel(): HTMLElement | null {
    return this.#tree?.panel ?? null;
  }

  get texts(): ViewerTexts | null {
    return this.#texts;
  }

  set texts(texts: ViewerTexts | null | undefined) {
    this.#texts = checkedTexts(texts);
    this.#viewer.requestUpdate('texts');
  }

  update(): void {
    const { poster, orbit } = this.#viewer;
    const { loading, failure } = this.#host;
    this.#tree?.update({
      poster: this.#revealed ? '' : poster,
      fixed: !orbit,
      loading,
      failure,
      texts: this.#texts,
    });
    this.#empty = this.#isEmpty;
    this.#states.set('loading', loading.pending);
    this.#states.set('error', failure.newest !== null);
    this.#states.set('empty', this.#empty);
    this.extras.apply();
  }

  cameraMoved(source: CameraSource, linked: boolean): void {
    this.extras.cameraMoved(source);
    this.#announcements.cameraMoved(source, linked);
  }

  /** Lights were written to, or came, went or changed places. */
  lightsChanged(lights: readonly PhongLight[]): void {
    this.#announcements.lightsChanged(lights);
  }

  /** A frame was drawn. */
  drawn(): void {
    this.checkEmpty();
    this.extras.drawn();
    this.#announcements.describeSoon();
    this.#reveal();
    this.#viewer.dispatchEvent(new CustomEvent('render'));
  }

  /** Removes the poster once everything requested has been drawn for the first time. */
  #reveal(): void {
    const { loading, failure } = this.#host;
    if (this.#revealed || loading.pending || failure.newest !== null) return;
    this.#revealed = true;
    if (this.#viewer.poster !== '') this.#viewer.requestUpdate();
  }

  /** Objects of the scene may have come or gone. Cheap: called for each frame. */
  checkEmpty(): void {
    if (this.#isEmpty !== this.#empty) this.update();
  }

  get #isEmpty(): boolean {
    return !this.#host.loading.wanted && this.#host.viewport.scene.children.length === 0;
  }
}
