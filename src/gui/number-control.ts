// How does the user edit a number? With a slider over the usual range, which grows to include other values, and a field that accepts
// every value that the element accepts. Listens to nothing outside the control. Knows no light, mesh or camera.
import { Controller, type GUI } from 'lil-gui';
import type { Bound } from './bound.js';
import { numberText, tidy, type Travel } from './travel.js';

export class NumberControl extends Controller {
  readonly #slider = document.createElement('input');
  readonly #field = document.createElement('input');
  #usual: Travel;
  #travel: Travel;
  #dragging = false;

  constructor(folder: GUI, bound: Bound<number>, label: string, travel: Travel) {
    super(folder, bound, 'value', 'lil-number');
    this.name(label);
    this.#usual = travel;
    this.#travel = travel;
    this.domElement.classList.add('lil-has-slider');
    this.$disable = this.#field;
    this.#addSlider();
    this.#addField();
    this.updateDisplay();
  }

  /** The slider's scale, while the value lies within it. */
  set travel(travel: Travel) {
    this.#usual = travel;
  }

  override updateDisplay(): this {
    const value = this.#value;
    if (!this.#dragging) this.#place(value);
    if (!this.#field.matches(':focus')) this.#write(value);
    return this;
  }

  get #value(): number {
    return this.getValue() as number;
  }

  #addSlider(): void {
    const slider = this.#slider;
    slider.type = 'range';
    // The field does everything by keyboard that the slider does, so one tab stop per row is enough.
    slider.tabIndex = -1;
    slider.setAttribute('aria-labelledby', this.$name.id);
    slider.addEventListener('pointerdown', () => {
      this.#dragging = true;
    });
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture', 'change', 'blur'] as const) {
      slider.addEventListener(type, () => {
        this.#dragging = false;
        this.updateDisplay();
      });
    }
    slider.addEventListener('input', () => {
      this.#try(this.#travel.value(Number(slider.value)));
      this.#fill(Number(slider.value));
    });
    this.$widget.append(slider);
  }

  #addField(): void {
    const field = this.#field;
    // `inputmode=decimal` has no minus key on phones; a number field has one.
    field.type = matchMedia('(pointer: coarse)').matches ? 'number' : 'text';
    field.setAttribute('aria-labelledby', this.$name.id);
    field.setAttribute('step', 'any');
    field.autocomplete = 'off';
    field.spellcheck = false;
    field.addEventListener('focus', () => {
      field.select();
    });
    field.addEventListener('input', () => {
      const number = Number(field.value.trim().replace(',', '.'));
      this.#valid = field.value.trim() !== '' && this.#try(number);
    });
    field.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') field.blur();
      if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
      event.preventDefault();
      const factor = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
      this.#stepBy((event.key === 'ArrowUp' ? 1 : -1) * factor);
    });
    field.addEventListener('blur', () => {
      this.#valid = true;
      this.#write(this.#value);
    });
    this.$widget.append(field);
  }

  /** Returns false if the element refuses the value. */
  #try(value: number): boolean {
    if (!Number.isFinite(value)) return false;
    try {
      this.setValue(value);
      return true;
    } catch (error) {
      if (error instanceof RangeError) return false;
      throw error;
    }
  }

  #stepBy(steps: number): void {
    const value = this.#value;
    this.#try(tidy(value + steps * this.#travel.stepAt(value)));
    this.#valid = true;
    this.#write(this.#value);
  }

  set #valid(valid: boolean) {
    if (valid) this.#field.removeAttribute('aria-invalid');
    else this.#field.setAttribute('aria-invalid', 'true');
  }

  #write(value: number): void {
    const text = numberText(value, this.#travel.end - this.#travel.start);
    if (this.#field.value !== text) this.#field.value = text;
    if (this.#slider.getAttribute('aria-valuetext') !== text)
      this.#slider.setAttribute('aria-valuetext', text);
  }

  #place(value: number): void {
    const travel = this.#usual.reaching(value);
    const { start, end, step } = (this.#travel = travel);
    const slider = this.#slider;
    slider.min = String(start);
    slider.max = String(end);
    slider.step = String(step);
    slider.value = String(travel.place(value));
    this.#fill(travel.place(value));
  }

  #fill(place: number): void {
    const { start, end } = this.#travel;
    const share = Math.min(Math.max((place - start) / (end - start), 0), 1);
    this.#slider.style.setProperty('--share', share.toFixed(4));
  }
}
