// Shows a view: what the picture draws in place of the shaded colours, and the legend over it. Follows `view` and
// `view-light`.
import { sameValue } from '../../fields/field-store.js';
import { addStyles, removeStyles } from '../../element/page/style-sheets.js';
import type { Extra, ExtraHost } from '../../element/viewer/extra.js';
import { phrase } from '../../element/fields/texts.js';
import { pictureView } from '../../material/view/picture-view.js';
import { viewEntry } from '../../material/view/view-table.js';
import { chosenLights, chosenLightsText, unknownLightText } from './chosen-lights.js';
import { LegendBox } from './legend-box.js';
import styles from './legend.css?inline';
import { type Bar, barsOf, viewTitle } from './view-scale.js';

export const create = (host: ExtraHost): Extra => new ViewExtra(host);

class ViewExtra implements Extra {
  readonly #host: ExtraHost;
  readonly #legend = new LegendBox();
  readonly #root: ShadowRoot;
  /** The values that the picture was last set to. */
  #shown = '';
  #scale: { readonly key: readonly unknown[]; readonly bars: readonly Bar[] } = { key: [], bars: [] };
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
      viewport.picture.lighting.view = pictureView(values.view, () => chosenLights(this.#host));
      viewport.picture.style = { ...viewport.picture.style }; // materials and geometries follow
      viewport.holder.classList.toggle('outlined', viewEntry(values.view).scale === 'unit');
    }
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

  dispose(): void {
    const { viewport } = this.#host;
    clearTimeout(this.#warning);
    this.#legend.place.remove();
    viewport.holder.classList.remove('outlined');
    removeStyles(this.#root, styles);
    viewport.picture.lighting.view = null;
    viewport.picture.style = { ...viewport.picture.style };
  }

  #updateLegend(): void {
    const host = this.#host;
    const { view, reflection } = host.values;
    const { texts } = host.viewer;
    const key = [view, texts, document.documentElement.lang];
    if (!sameValue(key, this.#scale.key)) this.#scale = { key, bars: barsOf(view, texts) };
    this.#legend.show({
      label: phrase(texts, 'Legend'),
      title: phrase(texts, viewTitle(view, reflection === 'blinn-phong')),
      lights: chosenLightsText(host),
      bars: this.#scale.bars,
    });
  }
}
