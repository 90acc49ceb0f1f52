// Rows of numbers: one number by slider and field, or a vector by a field for each component.
import type { GUI } from 'lil-gui';
import type { ViewerText } from '../../viewer/extra.js';
import { clamp, type Vec3 } from '../../phong/math/vector.js';
import { accepted, bound, type Bound } from './bound.js';
import { label } from './label.js';
import { InputRow, nameInput, type RowInput, TextField } from './input-row.js';
import { tidy } from '../../phong/math/round-number.js';
import { numberText, type SliderScale } from './travel.js';
import { followDrag } from '../../phong/camera/followed-drag.js';

/** A slider over the usual range, and a field that accepts every value that the element accepts. */
export function addNumber(
  folder: GUI,
  bound: Bound<number>,
  name: ViewerText,
  travel: () => SliderScale,
): InputRow {
  const slider = new Slider(bound, travel);
  // The field does everything by keyboard that the slider does, so one tab stop per row is enough.
  slider.input.tabIndex = -1;
  const field = new NumberField(bound, () => slider.scale);
  return new InputRow(folder, bound, 'lil-number', name, [slider, field]);
}

export type Axis = 0 | 1 | 2;

/** Accessible names of x, y and z. `{row}` is the row's name. */
export type ComponentNames = readonly [ViewerText, ViewerText, ViewerText];

const AXES: ComponentNames = ['{row} x', '{row} y', '{row} z'];

export const componentOf = (value: Bound<Vec3>, axis: Axis): Bound<number> =>
  bound(
    () => value.value[axis],
    (number) => {
      const [x, y, z] = value.value;
      value.value = [axis === 0 ? number : x, axis === 1 ? number : y, axis === 2 ? number : z];
    },
  );

export const nameComponent = (
  name: HTMLElement,
  row: ViewerText,
  axis: Axis,
  components: ComponentNames = AXES,
): void => label(name, (say) => (name.textContent = say(components[axis], { row: say(row) })));

/** A field for each component. `travel`: the scale of a component's steps, as it is now. */
export function addVector(
  folder: GUI,
  value: Bound<Vec3>,
  name: ViewerText,
  travel: (axis: Axis) => SliderScale,
  components: ComponentNames = AXES,
): void {
  const fields = ([0, 1, 2] as const).map(
    (axis) => new NumberField(componentOf(value, axis), () => travel(axis)),
  );
  new InputRow(folder, value, 'vector', name, fields);
  fields.forEach(({ input }, axis) =>
    nameInput(input, (say) => say(components[axis]!, { row: say(name) })),
  );
}

/** Its range grows to include the value, but not while it is dragged. */
export class Slider implements RowInput {
  readonly input = document.createElement('input');
  scale: SliderScale;
  readonly #bound: Bound<number>;
  readonly #travel: () => SliderScale;
  #dragging = false;
  /** What was written last. */
  #range = '';

  /** `travel`: the scale while the value lies within it; read again at each update. */
  constructor(bound: Bound<number>, travel: () => SliderScale) {
    this.#bound = bound;
    this.#travel = travel;
    this.scale = travel();
    const { input } = this;
    input.type = 'range';
    input.addEventListener('pointerdown', () => (this.#dragging = true));
    for (const type of [
      'pointerup',
      'pointercancel',
      'lostpointercapture',
      'change',
      'blur',
    ] as const) {
      input.addEventListener(type, () => {
        this.#dragging = false;
        this.update();
      });
    }
    input.addEventListener('input', () => {
      accepted(() => (bound.value = this.scale.value(Number(input.value))));
    });
  }

  update(): void {
    const { value } = this.#bound;
    const { input } = this;
    if (!this.#dragging) {
      const { start, end, step } = (this.scale = this.#travel().reaching(value));
      const range = [start, end, step].join();
      // Each write lays the row out again, even one of the same value.
      if (this.#range !== range) {
        this.#range = range;
        Object.assign(input, { min: start, max: end, step });
      }
      const place = String(this.scale.place(value));
      if (input.value !== place) {
        input.value = place;
      }
    }
    const text = numberText(value, this.scale.end - this.scale.start, this.scale.decimals);
    if (input.getAttribute('aria-valuetext') !== text) {
      input.setAttribute('aria-valuetext', text);
    }
  }
}

/** A press that moves less than this is a click. Pixels. */
const SLACK = 3;

/** Edits by typing, by arrow keys, and by dragging across the field. */
class NumberField implements RowInput {
  readonly input: HTMLInputElement;
  readonly #travel: () => SliderScale;
  readonly #field: TextField;
  readonly #bound: Bound<number>;

  /** `travel` gives the steps and the resolution. */
  constructor(bound: Bound<number>, travel: () => SliderScale) {
    this.#bound = bound;
    this.#travel = travel;
    this.#field = new TextField(
      () => {
        const { start, end, decimals } = travel();
        return numberText(bound.value, end - start, decimals);
      },
      (text) => text.trim() !== '' && this.#set(Number(text.trim().replace(',', '.'))),
    );
    this.input = this.#field.input;
    // `inputmode=decimal` has no minus key on phones; a number field has one.
    if (matchMedia('(pointer: coarse)').matches) {
      this.input.type = 'number';
    }
    this.input.step = 'any';
    this.input.classList.add('number');
    this.#listenToKeys();
    this.#listenToDrags();
  }

  update(): void {
    this.#field.update();
  }

  #set(value: number): boolean {
    const [least, most] = this.#travel().limits ?? [-Infinity, Infinity];
    return (
      Number.isFinite(value) && accepted(() => (this.#bound.value = clamp(value, least, most)))
    );
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
      const { value } = this.#bound;
      const moved = (dx: number, _: number, now: PointerEvent): void =>
        this.#step(value, Math.round(dx) * factorOf(now));
      // A finger that moves up or down scrolls the panel.
      followDrag(input, event, SLACK, { moved, ended: () => undefined }, (dx) => Math.abs(dx));
    });
    // Without this the press would give the field the focus before it is known to be a click.
    input.addEventListener('mousedown', (event) => {
      if (event.button === 0 && !input.matches(':focus')) {
        event.preventDefault();
      }
    });
    // A drag ends without one.
    input.addEventListener('click', () => input.focus());
  }

  #step(from: number, steps: number): void {
    this.#set(tidy(from + steps * this.#travel().stepAt(from)));
    this.#field.settle();
  }
}

function factorOf({ shiftKey, altKey }: KeyboardEvent | PointerEvent): number {
  if (shiftKey) return 10;
  return altKey ? 0.1 : 1;
}
