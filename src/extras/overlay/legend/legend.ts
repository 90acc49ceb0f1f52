// Shows a view: what the picture draws in place of the shaded colours, and the legend over it:
// title, lights, scale. Follows `view` and `view-light`.
import { html, noChange, nothing, render, type TemplateResult } from 'lit';
import { sameValue } from '../../../phong/fields/field-store.js';
import {
  addStyles,
  type Extra,
  type ExtraHost,
  lightName,
  localNumber,
  phrase,
  type ViewerText,
  type ViewerTexts,
} from '../../../viewer/extra.js';
import type { LightState } from '../../../phong/light/light-state.js';
import { pictureView } from '../../../phong/material/view/picture-view.js';
import { chosenLights, unknownLightText } from '../../../phong/material/view/view-light.js';
import { VIEW_TABLE, type ViewEntry, viewEntry } from '../../../phong/material/view/view-table.js';
import type { View } from '../../../phong/material/views.js';
import styles from './legend.css?inline';

export const create = (host: ExtraHost): Extra => new ViewExtra(host);

class ViewExtra implements Extra {
  readonly #host: ExtraHost;
  /** Holds the legend, in the free part of the picture, whose size the style sheet asks for. */
  readonly #place = Object.assign(document.createElement('div'), { className: 'view-place' });
  readonly #removeStyles: () => void;
  /** What the picture was last set by. Texts name lights. */
  #shown: readonly unknown[] = [];
  /** What the scale was written for. */
  #scale: readonly unknown[] = [];
  /** Values of `view-light` that were warned of. */
  readonly #warned = new Set<string>();
  #warning: ReturnType<typeof setTimeout> | undefined;

  constructor(host: ExtraHost) {
    this.#host = host;
    this.#removeStyles = addStyles(host.tree.layer.getRootNode() as ShadowRoot, styles);
    host.tree.free.append(this.#place);
  }

  update(): void {
    const { values, viewport, viewer } = this.#host;
    const shown = [values.view, values.viewLight, viewer.texts];
    if (!sameValue(shown, this.#shown)) {
      this.#shown = shown;
      viewport.picture.view = pictureView(values.view, () =>
        chosenIndices(this.#host).map((i) => viewport.picture.lighting.lights.values[i]!),
      );
      viewport.holder.classList.toggle('outlined', viewEntry(values.view).scale === 'unit');
    }
    this.#showLegend();
    if (!this.#warned.has(values.viewLight) && viewLightFault(this.#host) !== null) {
      this.#warnLater();
    }
  }

  /**
   * After the task and its microtasks, in which frameworks add the lights, and after the page's
   * markup. Once per value.
   */
  #warnLater(): void {
    this.#warning ??= setTimeout(() => {
      if (document.readyState !== 'loading') {
        this.#warn();
      } else {
        document.addEventListener('DOMContentLoaded', () => this.#warn(), { once: true });
      }
    });
  }

  #warn(): void {
    this.#warning = undefined;
    const text = this.#place.isConnected ? viewLightFault(this.#host) : null;
    if (text === null) return;
    this.#warned.add(this.#host.values.viewLight);
    console.warn(text);
  }

  dispose(): void {
    const { viewport } = this.#host;
    clearTimeout(this.#warning);
    this.#place.remove();
    viewport.holder.classList.remove('outlined');
    this.#removeStyles();
    viewport.picture.view = null;
  }

  #showLegend(): void {
    const { values, viewer } = this.#host;
    const { view, reflection } = values;
    const { texts } = viewer;
    const key = [view, texts, document.documentElement.lang];
    // A legend is shown after each frame.
    const scale = sameValue(key, this.#scale)
      ? noChange
      : SCALES[viewEntry(view).scale].map((bar) => barTemplate(bar, texts));
    this.#scale = key;
    const title = phrase(texts, viewTitle(view, reflection === 'blinn-phong'));
    const legend = html`<div
      class="legend"
      part="legend"
      role="group"
      aria-label=${phrase(texts, 'Legend')}
    >
      <p class="legend-title" aria-live="polite">${title}</p>
      <p class="legend-lights" dir="auto">${lightsText(this.#host)}</p>
      <div class="legend-scale">${scale}</div>
    </div>`;
    render(legend, this.#place);
  }
}

const lightsOf = ({ viewport }: ExtraHost): readonly LightState[] =>
  viewport.picture.lighting.lights.lights;

/** Indices of the lights that the view is limited to. */
function chosenIndices(host: ExtraHost): number[] {
  const { values, viewer } = host;
  // Lights without a name have an English one, and one by the page's texts.
  return chosenLights(values, lightsOf(host), (state, i) =>
    [null, viewer.texts].some((texts) => lightName(state, i, texts) === values.viewLight),
  );
}

/** The line under a legend's title; empty where no light has a part in the view. */
function lightsText(host: ExtraHost): string {
  const { view, viewLight } = host.values;
  const { texts } = host.viewer;
  const part = viewEntry(view).lights;
  if (part === 'none') return '';
  if (viewLight === '' && part !== 'one') return phrase(texts, 'all lights');
  const [index] = chosenIndices(host);
  if (index === undefined) {
    return viewLight === ''
      ? phrase(texts, 'no light is active')
      : phrase(texts, 'no light has the name {name}', { name: viewLight });
  }
  const state = lightsOf(host)[index]!;
  const light = lightName(state, index, texts);
  return state.values.active ? light : phrase(texts, '{light} (not active)', { light });
}

/** What is wrong with `view-light`, and its cure; null where it names a light or is empty. */
function viewLightFault(host: ExtraHost): string | null {
  const { viewLight } = host.values;
  if (viewLight === '' || chosenIndices(host).length > 0) return null;
  return unknownLightText(
    viewLight,
    lightsOf(host).map((state, i) => lightName(state, i)),
  );
}

/** The title of a view's legend: a key of `texts`. */
function viewTitle(view: View, blinn: boolean): ViewerText {
  const { blinnTitle, title }: { readonly title: ViewerText; readonly blinnTitle?: ViewerText } =
    VIEW_TABLE[view];
  return (blinn ? blinnTitle : undefined) ?? title;
}

/** A bar from black to its colour, with marks at equal distances. */
interface Bar {
  /** Beside the bar; empty for none. */
  readonly label: string;
  readonly color: string;
  readonly marks: readonly string[];
}

const SCALES: Readonly<Record<ViewEntry['scale'], readonly Bar[]>> = {
  none: [],
  unit: [{ label: '', color: '#fff', marks: ['0', '0.5', '1'] }],
  axes: [
    { label: 'x', color: '#f00', marks: [] },
    { label: 'y', color: '#0f0', marks: [] },
    { label: 'z', color: '#00f', marks: ['−1', '0', '1'] },
  ],
};

// Styles as properties: a strict CSP refuses style attributes.
const barTemplate = (
  { label, color, marks }: Bar,
  texts: ViewerTexts | null,
): TemplateResult => html`
  <div class="legend-bar">
    ${label === '' ? nothing : html`<span class="legend-label">${label}</span>`}
    <div
      class="legend-colors"
      aria-hidden="true"
      dir="ltr"
      .style=${`background-image: linear-gradient(to right, #000, ${color})`}
    ></div>
  </div>
  ${
    marks.length === 0
      ? nothing
      : html`<div class=${`legend-marks${label === '' ? '' : ' labelled'}`} dir="ltr">
          ${marks.map((mark, i) => html`<span .style=${`left: ${String(50 * i)}%`}>${localNumber(mark, texts)}</span> `)}
        </div>`
  }
`;
