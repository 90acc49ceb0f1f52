// A divider that the user moves: by pointer, from where it was pressed, and by keys; Escape takes a drag back. Percent
// of the box, along its own axes.
import { html, type TemplateResult } from 'lit';
import type { PictureBox } from '../../camera/gesture.js';
import { followDrag } from '../page/followed-drag.js';
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

export class Divider {
  readonly #host: DividerHost;
  /** A drag in progress, and the place where it began, percent. */
  #drag: { readonly from: number; readonly end: () => void } | null = null;

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
        @keydown=${this.#onKey}
        @dblclick=${this.#onDoubleClick}
      ></div>
      <div class="line" part="line" .style=${at}></div>`;
  }

  readonly #onPress = (event: PointerEvent): void => {
    if (event.button !== 0 || this.#drag !== null) return;
    const handle = event.currentTarget as HTMLElement;
    const { place: from } = this.#host.placeOf(this);
    // Without slop: a press on a divider is never a click for the page.
    const end = followDrag(handle, event, 0, {
      moved: (dx, dy) => {
        const travel = this.#travel(dx, dy);
        if (travel !== null) this.#host.move(this, from + travel);
      },
      ended: () => (this.#drag = null),
    });
    this.#drag = { from, end };
    handle.focus({ preventScroll: true });
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
    if (event.key === 'Escape' && this.#drag !== null) {
      const { from, end } = this.#drag;
      end();
      this.#host.move(this, from);
    } else if (step === 'min') this.#host.move(this, range[0]);
    else if (step === 'max') this.#host.move(this, range[1]);
    else if (step !== undefined) this.#host.move(this, place + step);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
}
