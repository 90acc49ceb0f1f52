// How does the user edit a number without a slider? By typing, by arrow keys, and by dragging across the field. Listens to nothing
// outside the field. Knows no light, mesh or camera.
import type { Bound } from './bound.js';
import { accepted, TextField } from './text-field.js';
import { numberText, tidy, type Travel } from './travel.js';

/** A press that moves less than this is a click. Pixels. */
const SLACK = 3;

export class NumberField {
  readonly input: HTMLInputElement;
  /** Gives the steps and the resolution. */
  travel: Travel;
  readonly #field: TextField;
  readonly #bound: Bound<number>;
  #drag: { readonly x: number; readonly value: number; moved: boolean } | null = null;

  constructor(bound: Bound<number>, travel: Travel) {
    this.#bound = bound;
    this.travel = travel;
    this.#field = new TextField({
      read: () => numberText(bound.value, this.travel.end - this.travel.start),
      write: (text) => text.trim() !== '' && this.set(Number(text.trim().replace(',', '.'))),
    });
    this.input = this.#field.input;
    // `inputmode=decimal` has no minus key on phones; a number field has one.
    if (matchMedia('(pointer: coarse)').matches) this.input.type = 'number';
    this.input.step = 'any';
    this.input.classList.add('number');
    this.#listenToKeys();
    this.#listenToDrags();
  }

  update(): void {
    this.#field.update();
  }

  /** False if the element refuses the value. */
  set(value: number): boolean {
    return Number.isFinite(value) && accepted(() => (this.#bound.value = value));
  }

  #listenToKeys(): void {
    this.input.addEventListener('keydown', (event) => {
      if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
      event.preventDefault();
      this.#step(this.#bound.value, (event.key === 'ArrowUp' ? 1 : -1) * factorOf(event));
    });
  }

  /** A field that has the focus keeps the browser's own drag, which selects text. */
  #listenToDrags(): void {
    const { input } = this;
    input.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || input.matches(':focus')) return;
      this.#drag = { x: event.clientX, value: this.#bound.value, moved: false };
    });
    // Without this the press would give the field the focus before it is known to be a click.
    input.addEventListener('mousedown', (event) => {
      if (this.#drag !== null) event.preventDefault();
    });
    input.addEventListener('pointermove', (event) => {
      const drag = this.#drag;
      if (drag === null) return;
      const travelled = event.clientX - drag.x;
      if (!drag.moved && Math.abs(travelled) < SLACK) return;
      if (!drag.moved) input.setPointerCapture(event.pointerId);
      drag.moved = true;
      this.#step(drag.value, Math.round(travelled) * factorOf(event));
    });
    for (const type of ['pointerup', 'pointercancel'] as const) {
      input.addEventListener(type, () => {
        const drag = this.#drag;
        this.#drag = null;
        if (type === 'pointerup' && drag?.moved === false) input.focus();
      });
    }
  }

  #step(from: number, steps: number): void {
    this.set(tidy(from + steps * this.travel.stepAt(from)));
    this.#field.settle();
  }
}

const factorOf = ({ shiftKey, altKey }: KeyboardEvent | PointerEvent): number =>
  shiftKey ? 10 : altKey ? 0.1 : 1;
