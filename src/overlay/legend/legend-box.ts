// Shows a legend: title, lights, scale. Writes only what changes. Knows no views.
import { create, write } from '../../element/viewer/template.js';
import type { Vec3 } from '../../math/vector.js';
import type { Bar } from './view-scale.js';

export interface LegendText {
  /** Accessible name of the whole. */
  readonly label: string;
  readonly title: string;
  readonly lights: string;
  /** A last line; empty for none. */
  readonly note: string;
}

export class LegendBox {
  /** Fills the layer, so that the legend knows how much room there is. */
  readonly place = create('div', { class: 'view-place' });
  readonly #box = create('div', { class: 'legend', part: 'legend', role: 'group' });
  readonly #title = create('p', { class: 'legend-title', 'aria-live': 'polite' });
  readonly #lights = create('p', { class: 'legend-lights', dir: 'auto' });
  readonly #scale = create('div', {});
  readonly #note = create('p', { class: 'legend-note', role: 'status' });
  readonly #progress = create('progress', { class: 'legend-progress', max: '1' });
  #bars: readonly Bar[] = [];

  constructor() {
    this.#box.append(this.#title, this.#lights, this.#scale, this.#note);
    this.place.append(this.#box);
  }

  write({ label, title, lights, note }: LegendText): void {
    if (this.#box.getAttribute('aria-label') !== label) this.#box.setAttribute('aria-label', label);
    write(this.#title, title);
    write(this.#lights, lights);
    write(this.#note, note);
  }

  /** Shows a share from 0 to 1, or nothing for null. */
  showProgress(share: number | null, label: string): void {
    if (share === null) this.#progress.remove();
    else {
      this.#progress.value = share;
      this.#progress.setAttribute('aria-label', label);
      if (this.#progress.parentNode === null) this.#box.append(this.#progress);
    }
  }

  /** `bars`: another list where a bar is different. */
  showScale(bars: readonly Bar[]): void {
    if (bars === this.#bars) return;
    this.#bars = bars;
    this.#scale.replaceChildren(...bars.flatMap(barElements));
  }
}

function barElements({ label, colors, fields, marks }: Bar): Element[] {
  const row = create('div', { class: 'legend-bar' });
  if (label !== '') row.append(text('span', { class: 'legend-label' }, label));
  const bar = create('div', { class: 'legend-colors', 'aria-hidden': 'true', dir: 'ltr' });
  if (fields) bar.append(...colors.map(field));
  else bar.style.backgroundImage = `linear-gradient(to right, ${colors.map(css).join()})`;
  row.append(bar);
  if (marks.length === 0) return [row];
  const line = create('div', {
    class: `legend-marks${label === '' ? '' : ' labelled'}${fields ? '' : ' flush'}`,
    dir: 'ltr',
  });
  for (const mark of marks) {
    const shown = text('span', {}, mark.text);
    shown.style.left = `${String(100 * mark.at)}%`;
    line.append(shown, ' '); // read as numbers of their own
  }
  return [row, line];
}

function field(color: Vec3): Element {
  const element = create('i', {});
  element.style.backgroundColor = css(color);
  return element;
}

function text<Tag extends 'span' | 'p'>(
  tag: Tag,
  attributes: Readonly<Record<string, string>>,
  content: string,
): HTMLElementTagNameMap[Tag] {
  const element = create(tag, attributes);
  element.textContent = content;
  return element;
}

const css = ([r, g, b]: Vec3): string => `rgb(${String(r)} ${String(g)} ${String(b)})`;
