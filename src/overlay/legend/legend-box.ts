// Shows a legend: title, lights, scale.
import { html, noChange, nothing, render, type TemplateResult } from 'lit';
import { create } from '../../element/dom.js';
import type { Vec3 } from '../../math/vector.js';
import type { Bar } from './view-scale.js';

export interface LegendContent {
  /** Accessible name of the whole. */
  readonly label: string;
  readonly title: string;
  readonly lights: string;
  /** A last line; empty for none. */
  readonly note: string;
  /** Another list where a bar is different. */
  readonly bars: readonly Bar[];
  /** A share from 0 to 1, and what it is of; null for no progress bar. */
  readonly progress: { readonly share: number; readonly label: string } | null;
}

export class LegendBox {
  /** In the free part of the picture, whose size the style sheet asks for. */
  readonly place = create('div', { class: 'view-place' });
  #bars: readonly Bar[] | null = null;

  show({ label, title, lights, note, bars, progress }: LegendContent): void {
    // A scale has up to 48 colours, and a legend is shown after each frame.
    const scale = bars === this.#bars ? noChange : bars.map(barTemplate);
    this.#bars = bars;
    const legend = html`<div class="legend" part="legend" role="group" aria-label=${label}>
      <p class="legend-title" aria-live="polite">${title}</p>
      <p class="legend-lights" dir="auto">${lights}</p>
      <div class="legend-scale">${scale}</div>
      <p class="legend-note" role="status">${note}</p>
      ${progress === null ? nothing : progressTemplate(progress)}
    </div>`;
    render(legend, this.place);
  }
}

const progressTemplate = ({ share, label }: NonNullable<LegendContent['progress']>): TemplateResult =>
  html`<progress class="legend-progress" max="1" value=${share} aria-label=${label}></progress>`;

// Styles as properties: a strict CSP refuses style attributes.
const barTemplate = ({ label, colors, fields, marks }: Bar): TemplateResult => html`
  <div class="legend-bar">
    ${label === '' ? nothing : html`<span class="legend-label">${label}</span>`}
    ${
      fields
        ? html`<div class="legend-colors" aria-hidden="true" dir="ltr">
            ${colors.map((color) => html`<i .style=${`background-color: ${css(color)}`}></i>`)}
          </div>`
        : html`<div
            class="legend-colors"
            aria-hidden="true"
            dir="ltr"
            .style=${`background-image: linear-gradient(to right, ${colors.map(css).join()})`}
          ></div>`
    }
  </div>
  ${
    marks.length === 0
      ? nothing
      : html`<div
          class=${`legend-marks${label === '' ? '' : ' labelled'}${fields ? '' : ' flush'}`}
          dir="ltr"
        >
          ${marks.map(({ at, text }) => html`<span .style=${`left: ${String(100 * at)}%`}>${text}</span> `)}
        </div>`
  }
`;

const css = ([r, g, b]: Vec3): string => `rgb(${String(r)} ${String(g)} ${String(b)})`;
