// A divider that the user moves: by pointer, from where it was pressed, and by keys; Escape takes a
// drag back. Places are percent of the box from the start of the line or from the top, ascending.
import { html, type TemplateResult } from 'lit';
import { alongAxes, type PictureBox } from '../../phong/camera/gesture.js';
import { followDrag } from '../../phong/camera/followed-drag.js';
import { clamp } from '../../phong/math/vector.js';

/** The comparison that a divider is part of. */
interface DividedBox {
  readonly vertical: boolean;
  /** Where a divider is, and where it may be, in percent. */
  placeOf(divider: Divider): {
    readonly place: number;
    readonly range: readonly [min: number, max: number];
  };
  /** Moves a divider and those that it pushes. */
  move(divider: Divider, place: number): void;
  /** Back to where the markup says. */
  reset(): void;
  isRtl(): boolean;
  /** Its box on the page. */
  measure(): PictureBox;
}

export class Divider {
  readonly #host: DividedBox;
  /** A drag in progress, and the place where it began, percent. */
  #drag: { readonly from: number; readonly end: () => void } | null = null;

  constructor(host: DividedBox) {
    this.#host = host;
  }

  /** The handle, and the line where the pictures meet. `panes`: ids of those on both sides. */
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
        @dblclick=${() => this.#host.reset()}
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
        if (travel !== null) {
          this.#host.move(this, from + travel);
        }
      },
      ended: () => (this.#drag = null),
    });
    this.#drag = { from, end };
    handle.focus({ preventScroll: true });
  };

  /**
   * Percent of the box that a pointer has moved along it, on transformed pages too. Null while the
   * box is hidden.
   */
  #travel(x: number, y: number): number | null {
    const { vertical } = this.#host;
    const { width, height, axes } = this.#host.measure();
    if (axes === undefined) return null;
    const [right, down] = alongAxes(axes, x, y);
    if (vertical) return (down * 100) / height;
    return ((this.#host.isRtl() ? -right : right) * 100) / width;
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const step = dividerStep(event, this.#host.vertical, this.#host.isRtl());
    if (event.key === 'Escape' && this.#drag !== null) {
      const { from, end } = this.#drag;
      end();
      this.#host.move(this, from);
    } else if (step !== undefined) {
      this.#host.move(this, this.#host.placeOf(this).place + step);
    } else {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  };
}

/**
 * The places of `count` − 1 dividers. Those that `at` leaves out divide the rest evenly; more than
 * there are dividers are ignored.
 */
export function placesOf(at: readonly number[] | 'auto', count: number): readonly number[] {
  const dividers = Math.max(count - 1, 0);
  const given = at === 'auto' ? [] : at.slice(0, dividers);
  const from = given.at(-1) ?? 0;
  const parts = count - given.length;
  const rest = Array.from(
    { length: dividers - given.length },
    (_, i) => from + ((100 - from) * (i + 1)) / parts,
  );
  return [...given, ...rest];
}

export const rangeOf = (
  places: readonly number[],
  index: number,
): readonly [min: number, max: number] => [places[index - 1] ?? 0, places[index + 1] ?? 100];

/** The places with one divider moved as near to `place` as its neighbours let it. */
export function withMoved(
  places: readonly number[],
  index: number,
  place: number,
): readonly number[] {
  const [min, max] = rangeOf(places, index);
  return places.map((each, i) => (i === index ? clamp(place, min, max) : each));
}

/** Percent that a key moves a divider by; infinite: all the way. Undefined for other keys. */
export function dividerStep(
  { key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  vertical: boolean,
  rtl: boolean,
): number | undefined {
  const step = shiftKey ? LARGE_STEP : STEP;
  const right = rtl ? -step : step;
  const arrows = vertical
    ? { ArrowUp: -step, ArrowDown: step }
    : { ArrowLeft: -right, ArrowRight: right };
  const jumps = { PageUp: -LARGE_STEP, PageDown: LARGE_STEP, Home: -Infinity, End: Infinity };
  return new Map(Object.entries({ ...arrows, ...jumps })).get(key);
}

/** Percent. As sliders of browsers and of ARIA's authoring practices step. */
const STEP = 1;
const LARGE_STEP = 10;
