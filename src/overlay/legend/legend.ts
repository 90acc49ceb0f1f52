// Shows a view: what the picture draws in place of the shaded colours, and the legend over it. Follows `view` and
// `view-light`.
import { localNumber } from '../../element/page/local-number.js';
import { addStyles, removeStyles } from '../../element/page/style-sheets.js';
import type { Extra, ExtraHost } from '../../element/viewer/extras.js';
import { phrase } from '../../element/fields/texts.js';
import { pictureView, scaleEnd } from '../../material/view/picture-view.js';
import { viewEntry } from '../../material/view/view-table.js';
import type { View } from '../../material/views.js';
import { lazyCode } from '../../model/lazy-code.js';
import { chosenLights, lightsText, unknownLightText } from './chosen-lights.js';
import type { ErrorView } from '../error/error-view.js';
import { snapshotOf } from '../error/picture-snapshot.js';
import { LegendBox } from './legend-box.js';
import styles from './legend.css?inline';
import { type Bar, barsOf, ERROR_END, titleOf } from './view-scale.js';

/** Their pictures can be all white or all black, as the page behind them can. */
const OUTLINED: readonly View[] = ['n-dot-l', 'attenuation', 'decay'];

const errorCode = lazyCode(() => import('../error/error-view.js'), 'the error view');

export const showView = (host: ExtraHost): Extra => new ViewExtra(host);

class ViewExtra implements Extra {
  readonly #host: ExtraHost;
  readonly #legend = new LegendBox();
  readonly #root: ShadowRoot;
  /** The values that the picture was last set to. */
  #shown = '';
  /** Null before its code has arrived, and for other views. */
  #error: ErrorView | null = null;
  #errorWanted = false;
  /**
   * `done`: the measured share of the error, null while the picture moves. `largest`: the largest error, NaN until all
   * is measured.
   */
  #progress: { readonly done: number | null; readonly largest: number } = { done: null, largest: NaN };
  #scale: { readonly key: string; readonly bars: readonly Bar[] } = { key: '', bars: [] };
  /** Values of `view-light` that were warned of. */
  readonly #warned = new Set<string>();
  #warning: ReturnType<typeof setTimeout> | undefined;

  constructor(host: ExtraHost) {
    this.#host = host;
    this.#root = host.tree.layer.getRootNode() as ShadowRoot;
    addStyles(this.#root, styles);
    host.tree.free.append(this.#legend.place);
  }

  update(): void {
    const { values, viewport } = this.#host;
    const shown = `${values.view} ${values.viewLight}`;
    if (shown !== this.#shown) {
      this.#shown = shown;
      viewport.changing();
      viewport.lighting.view = pictureView(values.view, () => chosenLights(this.#host));
      viewport.style = { ...viewport.style }; // materials and geometries follow
      viewport.holder.classList.toggle('outlined', OUTLINED.includes(values.view));
    }
    if (values.view !== 'error') this.#hideError();
    else if (this.#errorWanted) this.#error?.update();
    else void this.#showError();
    this.#updateLegend();
    if (!this.#warned.has(values.viewLight) && unknownLightText(this.#host) !== null) this.#warnLater();
  }

  /** After the task and its microtasks, in which frameworks add the lights. Once per value. */
  #warnLater(): void {
    this.#warning ??= setTimeout(() => {
      this.#warning = undefined;
      const text = unknownLightText(this.#host);
      if (text === null) return;
      this.#warned.add(this.#host.values.viewLight);
      console.warn(text);
    });
  }

  async repaint(picture: HTMLCanvasElement): Promise<void> {
    const host = this.#host;
    if (host.values.view !== 'error') return;
    const snapshot = snapshotOf(host.viewport, picture, chosenLights(host));
    const { drawError } = await errorCode();
    await drawError(picture, snapshot, ERROR_END);
  }

  dispose(): void {
    const { viewport } = this.#host;
    clearTimeout(this.#warning);
    this.#hideError();
    this.#legend.place.remove();
    viewport.holder.classList.remove('outlined');
    removeStyles(this.#root, styles);
    viewport.changing();
    viewport.lighting.view = null;
    viewport.style = { ...viewport.style };
  }

  async #showError(): Promise<void> {
    const host = this.#host;
    this.#errorWanted = true;
    try {
      const { ErrorView } = await errorCode();
      if (!this.#wantsError) return;
      this.#error = new ErrorView({
        ...host,
        end: ERROR_END,
        lights: () => chosenLights(host),
        progress: (done, largest) => {
          this.#progress = { done, largest };
          this.#updateLegend();
        },
      });
      this.#error.update();
    } catch (error) {
      this.#errorWanted = false; // the next update tries again
      console.warn(`<phong-viewer>: ${(error as Error).message}`);
    }
  }

  /** The code may arrive after the view has changed, and after another request for it. */
  get #wantsError(): boolean {
    return this.#errorWanted && this.#error === null;
  }

  #hideError(): void {
    this.#errorWanted = false;
    this.#error?.dispose();
    this.#error = null;
    this.#progress = { done: null, largest: NaN };
  }

  /** The legend's line about the error. */
  get #note(): string {
    const { done, largest } = this.#progress;
    const { texts } = this.#host.viewer;
    if (this.#host.values.view !== 'error') return '';
    if (done === null) return phrase(texts, 'measured when the picture is still');
    if (Number.isNaN(largest)) return '';
    return phrase(texts, 'largest away from edges: {error}', { error: localNumber(largest.toFixed(2)) });
  }

  #updateLegend(): void {
    const host = this.#host;
    const { view, reflection } = host.values;
    const { texts } = host.viewer;
    const { done } = this.#progress;
    const busy = view === 'error' && done !== null && done < 1;
    const most = viewEntry(view).scale === 'count' ? scaleEnd(chosenLights(host)) : 1;
    const key = `${view} ${String(most)} ${document.documentElement.lang}`;
    if (this.#scale.key !== key) this.#scale = { key, bars: barsOf(view, most) };
    this.#legend.show({
      label: phrase(texts, 'Legend'),
      title: phrase(texts, titleOf(view, reflection === 'blinn-phong')),
      lights: lightsText(host),
      note: this.#note,
      bars: this.#scale.bars,
      progress: busy ? { share: done, label: phrase(texts, 'Measuring the error') } : null,
    });
  }
}
