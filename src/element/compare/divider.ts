// A divider that the user moves: by pointer, from where it was pressed, and by keys; Escape takes a drag back. Percent
// of the box, along its own axes.
import { html, type TemplateResult } from 'lit';
import type { PictureBox } from '../../camera/gesture.js';
import { keepDrag } from '../../camera/kept-drag.js';
import { dividerStep } from './divider-positions.js';

export interface DividerHost {
  readonly vertical: boolean;
  /** The start of the line is on the right. */
  isRtl(): boolean;
  /** The box of the comparison as it is now. */
  measure(): PictureBox;
  /** Where this divider is, and how far it can go. */
  placeOf(divider: Divider): { readonly place: number; readonly range: readonly [min: number, max: number] };
  /** The user moves this divider there. */
  move(divider: Divider, place: number): void;
  /** The user wants it where it was declared. */
  reset(): void;
}

/** From where a drag is measured: client coordinates, percent. */
interface Press {
  readonly pointerId: number;
  readonly x: number;
  readonly y: number;
  readonly place: number;
  readonly release: (moved: boolean) => void;
}

export class Divider {
  readonly #host: DividerHost;
  /** What was pressed, and is moved. */
  #handle: HTMLElement | null = null;
  #press: Press | null = null;

  constructor(host: DividerHost) {
    this.#host = host;
  }

  /**
   * What the user takes, and its line, which lies exactly where the pictures meet. `panes`: ids of those on both sides.
   */
  template(label: string, panes: string): TemplateResult {
    const { place, range } = this.#host.placeOf(this);
    // As a property: a strict CSP refuses style attributes.
    const at = `--at: ${String(place)}%`;
    return html`<div
        class="divider"
        part="divider"
        role="separator"
        tabindex="0"
        aria-valuenow=${place.toFixed()}
        aria-valuemin=${range[0].toFixed()}
        aria-valuemax=${range[1].toFixed()}
        aria-orientation=${this.#host.vertical ? 'horizontal' : 'vertical'}
        aria-label=${label}
        aria-controls=${panes}
        .style=${at}
        @pointerdown=${this.#onPress}
        @pointermove=${this.#onMove}
        @pointerup=${this.#onLift}
        @pointercancel=${this.#onLift}
        @lostpointercapture=${this.#onLift}
        @keydown=${this.#onKey}
        @dblclick=${this.#onDoubleClick}
      ></div>
      <div class="line" part="line" .style=${at}></div>`;
  }

  readonly #onPress = (event: PointerEvent): void => {
    const { button, pointerId, clientX: x, clientY: y } = event;
    if (button !== 0 || this.#press !== null) return;
    const handle = (this.#handle = event.currentTarget as HTMLElement);
    // The button may be released in another window, which no event reports.
    const view = handle.ownerDocument.defaultView;
    view?.addEventListener('blur', this.#end);
    this.#press = { pointerId, x, y, place: this.#host.placeOf(this).place, release: keepDrag(view) };
    handle.focus({ preventScroll: true });
    try {
      handle.setPointerCapture(pointerId);
    } catch {
      // The pointer was made by a script: moves over the handle still count.
    }
  };

  readonly #onMove = ({ pointerId, clientX, clientY, buttons }: PointerEvent): void => {
    const press = this.#press;
    if (pointerId !== press?.pointerId) return;
    // The button was released without an event, over another window or under a menu.
    if ((buttons & 1) === 0) this.#end();
    else {
      const travel = this.#travel(clientX - press.x, clientY - press.y);
      if (travel !== null) this.#host.move(this, press.place + travel);
    }
  };

  readonly #onLift = ({ pointerId }: PointerEvent): void => {
    if (pointerId === this.#press?.pointerId) this.#end();
  };

  /** Ends a drag. */
  readonly #end = (): void => {
    const handle = this.#handle;
    const press = this.#press;
    const id = press?.pointerId;
    // A press on a divider is never a click for the page.
    press?.release(true);
    this.#press = null;
    handle?.ownerDocument.defaultView?.removeEventListener('blur', this.#end);
    if (id !== undefined && handle?.hasPointerCapture(id) === true) handle.releasePointerCapture(id);
  };

  readonly #onDoubleClick = (): void => this.#host.reset();

  /**
   * Percent of the box that a pointer has moved along it, also on a rotated or scaled page. Null while the box is
   * hidden.
   */
  #travel(x: number, y: number): number | null {
    const { vertical } = this.#host;
    const { width, height, axes } = this.#host.measure();
    if (axes === undefined) return null;
    const [rightX, rightY, downX, downY] = axes;
    const [alongX, alongY] = vertical ? [downX, downY] : [rightX, rightY];
    const squared = alongX ** 2 + alongY ** 2;
    const pixels = squared === 0 ? 0 : (x * alongX + y * alongY) / squared;
    return ((!vertical && this.#host.isRtl() ? -pixels : pixels) * 100) / (vertical ? height : width);
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const step = dividerStep(event, this.#host.vertical, this.#host.isRtl());
    const { place, range } = this.#host.placeOf(this);
    if (event.key === 'Escape' && this.#press !== null) {
      const { place: start } = this.#press;
      this.#end();
      this.#host.move(this, start);
    } else if (step === 'min') this.#host.move(this, range[0]);
    else if (step === 'max') this.#host.move(this, range[1]);
    else if (step !== undefined) this.#host.move(this, place + step);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
}
