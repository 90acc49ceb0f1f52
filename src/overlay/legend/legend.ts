// Shows a view: what the picture draws in place of the shaded colours, and the legend over it. Follows `view` and `view-light`. Knows
// no shaders.
import type { Extra, ExtraHost } from '../../element/viewer/extras.js';
import { phrase } from '../../element/fields/texts.js';
import { pictureView, scaleEnd } from '../../material/view/picture-view.js';
import { chosenLights, lightsText } from './chosen-lights.js';
import { LegendBox } from './legend-box.js';
import { adoptStyles } from './legend-styles.js';
import { type Bar, barsOf, titleOf } from './view-scale.js';

export const showView = (host: ExtraHost): Extra => new ViewExtra(host);

class ViewExtra implements Extra {
  readonly #host: ExtraHost;
  readonly #legend = new LegendBox();
  readonly #dropStyles: () => void;
  /** The values that the picture was last set to. */
  #shown = '';
  #scale: { readonly key: string; readonly bars: readonly Bar[] } = { key: '', bars: [] };

  constructor(host: ExtraHost) {
    this.#host = host;
    this.#dropStyles = adoptStyles(host.tree.layer.getRootNode() as ShadowRoot);
    host.tree.layer.append(this.#legend.place);
  }

  update(): void {
    const { values, viewport } = this.#host;
    const shown = `${values.view} ${values.viewLight}`;
    if (shown !== this.#shown) {
      this.#shown = shown;
      viewport.lighting.view = pictureView(values.view, () => chosenLights(this.#host));
      viewport.style = { ...viewport.style }; // materials and geometries follow
    }
    this.#updateLegend();
  }

  dispose(): void {
    const { values, viewport } = this.#host;
    this.#legend.place.remove();
    this.#dropStyles();
    // A viewer that has left the page still draws its view, for toBlob.
    if (values.view !== 'shaded' || values.viewLight !== '') return;
    viewport.lighting.view = null;
    viewport.style = { ...viewport.style };
  }

  #updateLegend(): void {
    const host = this.#host;
    const { view, reflection } = host.values;
    const { texts } = host.viewer;
    this.#legend.write({
      label: phrase(texts, 'Legend'),
      title: phrase(texts, titleOf(view, reflection === 'blinn-phong')),
      lights: lightsText(host),
      note: '',
    });
    const most = view === 'light-count' ? scaleEnd(chosenLights(host)) : 1;
    const key = `${view} ${String(most)}`;
    if (this.#scale.key !== key) this.#scale = { key, bars: barsOf(view, most) };
    this.#legend.showScale(this.#scale.bars);
  }
}
