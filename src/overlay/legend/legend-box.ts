// Shows a legend: title, lights, scale.
import { html, noChange, nothing, render, type TemplateResult } from 'lit';
import { create } from '../../element/dom.js';
import type { Vec3 } from '../../math/vector.js';
import type { Bar } from './view-scale.js';

interface LegendContent {
  /** Accessible name of the whole. */
  readonly label: string;
  readonly title: string;
  readonly lights: string;
  /** Another list where a bar is different. */
  readonly bars: readonly Bar[];
}

export class LegendBox {
  /** In the free part of the picture, whose size the style sheet asks for. */
  readonly place = create('div', { class: 'view-place' });
  #bars: readonly Bar[] | null = null;

  show({ label, title, lights, bars }: LegendContent): void {
    // A legend is shown after each frame.
    const scale = bars === this.#bars ? noChange : bars.map(barTemplate);
    this.#bars = bars;
    const legend = html`<div class="legend" part="legend" role="group" aria-label=${label}>
      <p class="legend-title" aria-live="polite">${title}</p>
      <p class="legend-lights" dir="auto">${lights}</p>
      <div class="legend-scale">${scale}</div>
    </div>`;
    render(legend, this.place);
  }
}

// Styles as properties: a strict CSP refuses style attributes.
const barTemplate = ({ label, colors, marks }: Bar): TemplateResult => html`
  <div class="legend-bar">
    ${label === '' ? nothing : html`<span class="legend-label">${label}</span>`}
    <div
      class="legend-colors"
      aria-hidden="true"
      dir="ltr"
      .style=${`background-image: linear-gradient(to right, ${colors.map(css).join()})`}
    ></div>
  </div>
  ${
    marks.length === 0
      ? nothing
      : html`<div class=${`legend-marks${label === '' ? '' : ' labelled'}`} dir="ltr">
          ${marks.map(({ at, text }) => html`<span .style=${`left: ${String(100 * at)}%`}>${text}</span> `)}
        </div>`
  }
`;

const css = ([r, g, b]: Vec3): string => `rgb(${String(r)} ${String(g)} ${String(b)})`;
