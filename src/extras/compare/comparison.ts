// Lays out the viewers of a <phong-compare>: in panes clipped by the dividers beside them, or
// beside each other.
import { html, nothing, type ReactiveController, type TemplateResult } from 'lit';
import { sameValue } from '../../phong/fields/field-store.js';
import type { PictureBox } from '../../phong/camera/gesture.js';
import {
  addStyles,
  CORNER_MARKS,
  fieldsOf,
  PANEL_PLACE,
  type PhongCompare,
  type PhongViewer,
  phrase,
  pictureBox,
} from '../../viewer/extra.js';
import styles from './comparison.css?inline';
import { Divider, placesOf, rangeOf, withMoved } from './divider.js';

interface Placed {
  connectedMoveCallback?(): void;
}

const valuesOf = (element: PhongCompare) => fieldsOf(element).store.values;

/** Height of a label with the space above it; see comparison.css. */
const LABEL = 'calc(1.6em + 8px)';

export class Comparison implements ReactiveController {
  readonly #element: PhongCompare;
  readonly #values: ReturnType<typeof valuesOf>;
  readonly #observer = new MutationObserver(() => this.#element.requestUpdate());
  #listeners = new AbortController();
  #viewers: readonly PhongViewer[] = [];
  #dividers: readonly Divider[] = [];

  constructor(element: PhongCompare) {
    this.#element = element;
    this.#values = valuesOf(element);
  }

  hostConnected(): void {
    const root = this.#element.shadowRoot!;
    addStyles(root, styles);
    this.#observe();
    const { signal } = (this.#listeners = new AbortController());
    // The direction of the text may have changed, which no event reports.
    for (const type of ['pointerover', 'focusin'] as const) {
      root.addEventListener(type, () => this.#element.requestUpdate(), { signal });
    }
    shareTouch(root, signal);
  }

  hostDisconnected(): void {
    this.#observer.disconnect();
    this.#listeners.abort('disconnected');
  }

  /** The panes are there: assigns the viewers to them, unless they have them already. */
  hostUpdated(): void {
    const { viewers } = this.#element;
    if (sameValue(viewers, this.#viewers)) return;
    this.#viewers = viewers;
    const slots = this.#element.shadowRoot!.querySelectorAll<HTMLSlotElement>('.pane > slot');
    viewers.forEach((viewer, i) => slots[i]?.assign(viewer));
    // Observers report their new place only after a frame.
    viewers.forEach((viewer: PhongViewer & Placed) => viewer.connectedMoveCallback?.());
    this.#observe();
  }

  measure(): PictureBox {
    return pictureBox(this.#element.shadowRoot!.querySelector('.box')!);
  }

  get vertical(): boolean {
    return this.#values.direction === 'vertical';
  }

  isRtl(): boolean {
    return getComputedStyle(this.#element).direction === 'rtl';
  }

  placeOf(divider: Divider): {
    readonly place: number;
    readonly range: readonly [min: number, max: number];
  } {
    const index = this.#dividers.indexOf(divider);
    const places = this.#places;
    return { place: places[index]!, range: rangeOf(places, index) };
  }

  move(divider: Divider, place: number): void {
    const places = this.#places;
    const at = withMoved(places, this.#dividers.indexOf(divider), place);
    if (sameValue(at, places)) return;
    fieldsOf(this.#element).set('at', at);
    this.#reportMove();
  }

  reset(): void {
    const { at } = this.#element;
    fieldsOf(this.#element).attributeChanged('at', this.#element.getAttribute('at'));
    if (at !== this.#element.at) {
      this.#reportMove();
    }
  }

  #reportMove(): void {
    const detail = { at: Object.freeze([...this.#places]) };
    this.#element.dispatchEvent(new CustomEvent('divider-change', { detail }));
  }

  template(): TemplateResult {
    const { layout, direction } = this.#values;
    const { viewers } = this.#element;
    const split = layout === 'split';
    const places = this.#places;
    const labels = this.#labelsOf(viewers);
    const rtl = this.isRtl();
    const dividers = split ? Math.max(viewers.length - 1, 0) : 0;
    this.#dividers = Array.from(
      { length: dividers },
      (_, i) => this.#dividers[i] ?? new Divider(this),
    );
    const open = split ? this.#withPanels(viewers) : [];
    const kinds = `${open.length > 0 ? ' docked' : ''}${rtl ? ' rtl' : ''}`;
    return html`<div class=${`box ${layout} ${direction}${kinds}`}>
      ${CORNER_MARKS}
      ${viewers.map((viewer, i) => {
        const divider = this.#dividers[i];
        const range = split ? ([places[i - 1] ?? 0, places[i] ?? 100] as const) : null;
        return [
          this.#paneTemplate(i, labels[i] ?? '', range, rtl, [open.indexOf(viewer), open.length]),
          divider?.template(
            dividerLabel(viewer, labels[i], labels[i + 1]),
            `${paneId(i)} ${paneId(i + 1)}`,
          ),
        ];
      })}
    </div>`;
  }

  /**
   * `range`: what the dividers leave, percent; null for all. `panel`: its index among the open
   * ones; -1: not open.
   */
  #paneTemplate(
    index: number,
    label: string,
    range: readonly [from: number, to: number] | null,
    rtl: boolean,
    [panel, panels]: readonly [index: number, count: number],
  ): TemplateResult {
    const isOpen = panel >= 0;
    const clip = range === null ? '' : this.#clip(...range, rtl, isOpen);
    const share = isOpen
      ? `--index: ${String(panel)}; --count: ${String(panels)}; --phong-name: ${cssString(label)}; `
      : '';
    // A viewer says its own name.
    const name = label === '' || this.#values.labels === null ? nothing : label;
    // Styles as properties: a strict CSP refuses style attributes.
    return html`<div
      class=${isOpen ? 'pane open' : 'pane'}
      id=${paneId(index)}
      role=${name === nothing ? nothing : 'group'}
      aria-label=${name}
      .style=${`${this.#room(...(range ?? [0, 100]), label)}; ${share}${clip}`}
    >
      <slot></slot>
      <div
        class="label"
        part="label"
        aria-hidden="true"
        ?hidden=${label === ''}
        .textContent=${label}
      ></div>
    </div>`;
  }

  /** Viewers whose panels are open; while none is, those whose panels are about to be. */
  #withPanels(viewers: readonly PhongViewer[]): readonly PhongViewer[] {
    const place = (viewer: PhongViewer): string | null =>
      panelPlace(viewer)?.getAttribute(PANEL_PLACE.open) ?? null;
    const awaited = viewers.filter((viewer) => place(viewer) === PANEL_PLACE.awaited);
    const open = viewers.filter((viewer) => place(viewer) === '');
    const waits =
      awaited.length > 0 && open.length === 0 && this.#element.clientWidth >= PANEL_PLACE.wide;
    return waits ? awaited : open;
  }

  get #places(): readonly number[] {
    return placesOf(this.#values.at, this.#element.viewers.length);
  }

  #observe(): void {
    this.#observer.disconnect();
    this.#observer.observe(this.#element, { childList: true });
    for (const viewer of this.#viewers) {
      // The surface carries the name, whether it was given by attribute or property.
      const surface = viewer.shadowRoot?.querySelector('[part=surface]') ?? viewer;
      this.#observer.observe(surface, { attributeFilter: ['aria-label'] });
      const panel = panelPlace(viewer);
      if (panel !== null) {
        this.#observer.observe(panel, { attributeFilter: [PANEL_PLACE.open] });
      }
    }
  }

  /** What a viewer shows over its picture, such as its panel, keeps to the visible part. */
  #room(from: number, to: number, label: string): string {
    const [start, end] = this.vertical ? ['top', 'bottom'] : ['start', 'end'];
    const room = {
      start: '0%',
      end: '0%',
      top: '0%',
      bottom: '0%',
      label: label === '' ? '0px' : LABEL,
    };
    const kept = { ...room, [start]: `${String(from)}%`, [end]: `${String(100 - to)}%` };
    return Object.entries(kept)
      .map(([side, length]) => `--phong-${side}: ${length}`)
      .join('; ');
  }

  /** `more`: also what the style sheet leaves beside the picture, for the panel. */
  #clip(from: number, to: number, rtl: boolean, more: boolean): string {
    const [before, after] = [`${String(from)}%`, `${String(100 - to)}%`];
    const across = rtl ? [0, before, 0, after] : [0, after, 0, before];
    const sides = this.vertical ? [before, 0, after, 0] : across;
    // A viewer that is clipped away draws nothing.
    const rest = from === to ? '; visibility: hidden' : '';
    if (!more) return `clip-path: inset(${sides.join(' ')})${rest}`;
    const [top, right, bottom, left] = sides.map((side, i) =>
      i % 3 === 0 ? length(side) : `calc(100% - ${length(side)})`,
    );
    const own = corners(left!, top!, right!, bottom!);
    const panel = corners('var(--x0)', 'var(--y0)', 'var(--x1)', 'var(--y1)');
    return `clip-path: polygon(${own}, ${panel})`;
  }

  /**
   * The texts over the viewers. Without `labels` they are the viewers' own names.
   */
  #labelsOf(viewers: readonly PhongViewer[]): readonly string[] {
    const given = this.#values.labels?.split(',').map((text) => text.trim());
    return viewers.map((viewer, i) =>
      given === undefined
        ? (viewer.getAttribute('aria-label') ?? '') || viewer.alt
        : (given[i] ?? ''),
    );
  }
}

const panelPlace = (viewer: PhongViewer): Element | null =>
  viewer.shadowRoot?.querySelector('[part=panel]') ?? null;

const corners = (left: string, top: string, right: string, bottom: string): string =>
  `${left} ${top}, ${right} ${top}, ${right} ${bottom}, ${left} ${bottom}, ${left} ${top}`;

const length = (side: string | number): string => (side === 0 ? '0px' : String(side));

/** As a string in a style sheet, in one line. */
const cssString = (text: string): string => JSON.stringify(text.replace(/\s+/g, ' '));

const paneId = (index: number): string => `pane-${String(index + 1)}`;

/** `viewer`: the one before the divider, whose texts it is in. */
function dividerLabel({ texts }: PhongViewer, first = '', second = ''): string {
  return first === '' || second === ''
    ? phrase(texts, 'Divider')
    : phrase(texts, 'Divider between {first} and {second}', { first, second });
}

/**
 * Fingers on several viewers are one gesture of the viewer under the first finger, so that a pinch
 * across a divider zooms. Otherwise each finger would turn the linked cameras on its own. Listens
 * to everything in the shadow root.
 */
function shareTouch(root: ShadowRoot, signal: AbortSignal): void {
  const early = { signal, capture: true, passive: false };
  const fingers = new Set<number>();
  let first: Element | null = null; // the picture under the first finger
  let joined = false; // a finger on another picture has joined
  const press = (event: PointerEvent): void => {
    // The event that is dispatched below comes by here, too.
    if (event.pointerType !== 'touch' || !event.isTrusted) return;
    const surface = linkedSurface(event);
    if (surface === null) return;
    if (first?.isConnected !== true) {
      fingers.clear();
    }
    if (fingers.size === 0) {
      first = surface;
    }
    fingers.add(event.pointerId);
    if (surface === first) return;
    joined = true;
    event.stopPropagation();
    // It captures the pointer, whose later events then come to it by themselves.
    first?.dispatchEvent(new PointerEvent('pointerdown', event));
  };
  const lift = (event: Event): void => {
    fingers.delete((event as PointerEvent).pointerId);
    if (fingers.size === 0) {
      joined = false;
    }
  };
  // The pictures prevent scrolling by two fingers themselves, but count only their own.
  const keep = (event: Event): void => {
    if (joined && event.cancelable) {
      event.preventDefault();
    }
  };
  root.addEventListener('pointerdown', (event) => press(event as PointerEvent), early);
  for (const type of ['pointerup', 'pointercancel']) {
    root.addEventListener(type, lift, early);
  }
  for (const type of ['touchstart', 'touchmove']) {
    root.addEventListener(type, keep, early);
  }
}

/** The picture that was pressed, of a viewer whose camera is linked to those of the comparison. */
function linkedSurface(event: Event): Element | null {
  const path = event.composedPath();
  const viewer = path.find(
    (node): node is PhongViewer => (node as Partial<Element>).localName === 'phong-viewer',
  );
  const surface = viewer?.shadowRoot?.querySelector('[part=surface]') ?? null;
  return viewer?.cameraGroup === '' && surface !== null && path.includes(surface) ? surface : null;
}
