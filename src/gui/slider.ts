// How does a slider show and set a number? Its range grows to include the value, but not while it is dragged. Knows no
// light, mesh or camera.
import type { Bound } from './bound.js';
import { accepted } from './text-field.js';
import { numberText, type Travel } from './travel.js';

export class Slider {
  readonly input = document.createElement('input');
  /** The scale while the value lies within it. */
  travel: Travel;
  readonly #bound: Bound<number>;
  /** The scale in use. */
  #present: Travel;
  #dragging = false;

  constructor(bound: Bound<number>, travel: Travel) {
    this.#bound = bound;
    this.travel = travel;
    this.#present = travel;
    const { input } = this;
    input.type = 'range';
    input.addEventListener('pointerdown', () => {
      this.#dragging = true;
    });
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture', 'change', 'blur'] as const) {
      input.addEventListener(type, () => {
        this.#dragging = false;
        this.update();
      });
    }
    input.addEventListener('input', () => {
      const place = Number(input.value);
      accepted(() => (bound.value = this.#present.value(place)));
      this.#fill(place);
    });
  }

  /** Shows the value. Returns the scale in use. */
  update(): Travel {
    const { value } = this.#bound;
    const { input } = this;
    if (!this.#dragging) {
      const { start, end, step } = (this.#present = this.travel.reaching(value));
      const place = this.#present.place(value);
      Object.assign(input, {
        min: String(start),
        max: String(end),
        step: String(step),
        value: String(place),
      });
      this.#fill(place);
    }
    const text = numberText(value, this.#present.end - this.#present.start);
    if (input.getAttribute('aria-valuetext') !== text) input.setAttribute('aria-valuetext', text);
    return this.#present;
  }

  #fill(place: number): void {
    const { start, end } = this.#present;
    const share = Math.min(Math.max((place - start) / (end - start), 0), 1);
    this.input.style.setProperty('--share', share.toFixed(4));
  }
}
