// How does the user move a divider? By pointer, from where it was pressed, and by keys; Escape takes a drag back. Percent of the box,
// along its own axes. Knows no viewers.
import { set, create } from '../viewer/template.js';
import type { PictureCorners } from '../page/picture-box.js';
import { keyStep } from './places.js';

export interface DividerHost {
  readonly corners: PictureCorners;
  readonly vertical: boolean;
  /** The start of the line is on the right. */
  readonly rtl: boolean;
  /** The user moves this divider there. */
  move(divider: Divider, place: number): void;
  /** The user wants it where it was declared. */
  reset(): void;
}

export interface DividerState {
  readonly place: number;
  readonly range: readonly [min: number, max: number];
  readonly label: string;
  /** Ids of the panes on both sides. */
  readonly panes: string;
}

/** From where a drag is measured: client coordinates, percent. */
interface Press {
  readonly pointerId: number;
  readonly x: number;
  readonly y: number;
  readonly place: number;
}

export class Divider {
  /** What the user takes, and its line, which lies exactly where the pictures meet. */
  readonly handle = create('div', { class: 'divider', part: 'divider', role: 'separator', tabindex: '0' });
  readonly line = create('div', { class: 'line', part: 'line' });
  readonly #host: DividerHost;
  #place = 0;
  #range: DividerState['range'] = [0, 100];
  #press: Press | null = null;

  constructor(host: DividerHost) {
    this.#host = host;
    const { handle } = this;
    handle.addEventListener('pointerdown', (event) => this.#onPress(event));
    handle.addEventListener('pointermove', (event) => this.#onMove(event));
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      handle.addEventListener(type, ({ pointerId }) => {
        if (pointerId === this.#press?.pointerId) this.#press = null;
      });
    handle.addEventListener('keydown', (event) => this.#onKey(event));
    handle.addEventListener('dblclick', () => host.reset());
  }

  update({ place, range, label, panes }: DividerState): void {
    this.#place = place;
    this.#range = range;
    const { handle, line } = this;
    for (const { style } of [handle, line]) style.setProperty('--at', `${String(place)}%`);
    const values = { now: place, min: range[0], max: range[1] };
    for (const [name, value] of Object.entries(values)) set(handle, `aria-value${name}`, value.toFixed());
    set(handle, 'aria-orientation', this.#host.vertical ? 'horizontal' : 'vertical');
    set(handle, 'aria-label', label);
    set(handle, 'aria-controls', panes);
  }

  #onPress({ button, pointerId, clientX: x, clientY: y }: PointerEvent): void {
    if (button !== 0 || this.#press !== null) return;
    this.#press = { pointerId, x, y, place: this.#place };
    this.handle.focus({ preventScroll: true });
    try {
      this.handle.setPointerCapture(pointerId);
    } catch {
      // The pointer was made by a script: moves over the handle still count.
    }
  }

  #onMove({ pointerId, clientX, clientY, buttons }: PointerEvent): void {
    const press = this.#press;
    if (pointerId !== press?.pointerId) return;
    // The button was released without an event, over another window or under a menu.
    if ((buttons & 1) === 0) this.#press = null;
    else this.#host.move(this, press.place + this.#travel(clientX - press.x, clientY - press.y));
  }

  /** Percent of the box that a pointer has moved along it, whatever turns or scales the page. */
  #travel(x: number, y: number): number {
    const { corners, vertical, rtl } = this.#host;
    const { width, height, axes = [1, 0, 0, 1] } = corners.box;
    const [rightX, rightY, downX, downY] = axes;
    const [alongX, alongY] = vertical ? [downX, downY] : [rightX, rightY];
    const squared = alongX ** 2 + alongY ** 2;
    const pixels = squared === 0 ? 0 : (x * alongX + y * alongY) / squared;
    return ((rtl && !vertical ? -pixels : pixels) * 100) / Math.max(vertical ? height : width, 1);
  }

  #onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const { vertical, rtl } = this.#host;
    const step = keyStep(event, vertical, rtl);
    const [min, max] = this.#range;
    if (event.key === 'Escape' && this.#press !== null) {
      const { place } = this.#press;
      this.#press = null;
      this.#host.move(this, place);
    } else if (step === 'min') this.#host.move(this, min);
    else if (step === 'max') this.#host.move(this, max);
    else if (step !== undefined) this.#host.move(this, this.#place + step);
    else return;
    event.preventDefault();
  }
}
