// How does a <phong-compare> show its viewers? Each in a pane of its own, clipped by the dividers on both sides of it, or beside the
// others. Knows neither cameras nor pictures.
import type { CompareValues } from '../fields/compare-fields.js';
import { phrase } from '../fields/texts.js';
import { inspect } from '../diagnosis/inspect.js';
import { fieldsOf } from '../internals.js';
import { PictureCorners } from '../page/picture-box.js';
import { addStyles } from '../page/style-sheets.js';
import type { PhongCompare } from '../phong-compare.js';
import type { PhongViewer } from '../phong-viewer.js';
import { create, set, write } from '../viewer/template.js';
import styles from './comparison.css?inline';
import { Divider, type DividerHost } from './divider.js';
import { placesOf, rangeOf, withMoved } from './places.js';
import { SharedTouch } from './shared-touch.js';

interface Pane {
  readonly box: HTMLElement;
  readonly slot: HTMLSlotElement;
  readonly label: HTMLElement;
}

export class Comparison implements DividerHost {
  readonly #element: PhongCompare;
  readonly #values: Readonly<CompareValues>;
  readonly #box = create('div', { class: 'box' });
  readonly #observer = new MutationObserver(() => this.update());
  readonly #listeners = new AbortController();
  readonly corners: PictureCorners;
  #viewers: readonly PhongViewer[] = [];
  #panes: readonly Pane[] = [];
  #dividers: readonly Divider[] = [];
  #places: readonly number[] = [];
  #rtl = false;

  constructor(element: PhongCompare, root: ShadowRoot) {
    this.#element = element;
    this.#values = fieldsOf(element).store.values;
    this.corners = new PictureCorners(this.#box);
    addStyles(root, styles);
    root.replaceChildren(this.#box);
    this.#observe();
    // The direction of the text may have changed, which no event reports.
    for (const type of ['pointerover', 'focusin'] as const)
      root.addEventListener(type, () => this.update(), { signal: this.#listeners.signal });
    new SharedTouch(root, this.#listeners.signal);
    this.update();
    inspect(element);
  }

  get vertical(): boolean {
    return this.#values.direction === 'vertical';
  }

  get rtl(): boolean {
    return this.#rtl;
  }

  dispose(): void {
    this.#observer.disconnect();
    this.#listeners.abort();
    this.#box.remove();
  }

  move(divider: Divider, place: number): void {
    const at = withMoved(this.#places, this.#dividers.indexOf(divider), place);
    if (at.every((each, i) => each === this.#places[i])) return;
    fieldsOf(this.#element).set('at', at);
    const detail = { at: Object.freeze([...at]) };
    this.#element.dispatchEvent(new CustomEvent('divider-change', { detail }));
  }

  reset(): void {
    const { at } = this.#element;
    fieldsOf(this.#element).attributeChanged('at', this.#element.getAttribute('at'));
    if (at === this.#element.at) return;
    const detail = { at: Object.freeze([...this.#places]) };
    this.#element.dispatchEvent(new CustomEvent('divider-change', { detail }));
  }

  /** Children, values or names have changed. */
  update(): void {
    const { layout, at } = this.#values;
    this.#rtl = getComputedStyle(this.#element).direction === 'rtl';
    this.#arrange();
    const split = layout === 'split';
    set(this.#box, 'class', `box ${layout} ${this.#values.direction}`);
    this.#places = placesOf(at, this.#viewers.length);
    const labels = this.#labels;
    this.#panes.forEach(({ box, label }, i) => {
      const [from, to] = split ? [this.#places[i - 1] ?? 0, this.#places[i] ?? 100] : [0, 100];
      const { text = '', isName = false } = labels[i] ?? {};
      box.style.clipPath = split ? this.#clip(from, to) : '';
      this.#leaveRoom(box, from, to, text);
      // A viewer that is clipped away draws nothing.
      box.style.visibility = from === to ? 'hidden' : '';
      write(label, text);
      label.hidden = text === '';
      // A viewer says its own name.
      set(box, 'role', text === '' || isName ? null : 'group');
      set(box, 'aria-label', text === '' || isName ? null : text);
    });
    this.#dividers.forEach((divider, i) => {
      const [first, second] = [labels[i]?.text ?? '', labels[i + 1]?.text ?? ''];
      const { texts } = this.#viewers[i]!;
      divider.update({
        place: this.#places[i]!,
        range: rangeOf(this.#places, i),
        label:
          first === '' || second === ''
            ? phrase(texts, 'Divider')
            : phrase(texts, 'Divider between {first} and {second}', { first, second }),
        panes: `${this.#panes[i]!.box.id} ${this.#panes[i + 1]!.box.id}`,
      });
    });
  }

  /** A pane for each viewer, and a divider between two of them. */
  #arrange(): void {
    const { viewers } = this.#element;
    const dividers = this.#values.layout === 'split' ? Math.max(viewers.length - 1, 0) : 0;
    if (viewers.length !== this.#panes.length || dividers !== this.#dividers.length) {
      this.#panes = viewers.map((_, i) => this.#panes[i] ?? createPane(i));
      this.#dividers = Array.from({ length: dividers }, (_, i) => this.#dividers[i] ?? new Divider(this));
      const parts = this.#panes.flatMap(({ box }, i) => {
        const divider = this.#dividers[i];
        return divider === undefined ? [box] : [box, divider.handle, divider.line];
      });
      const kept = new Set<Element>(parts);
      for (const part of [...this.#box.children])
        if (!kept.has(part) && part.localName !== 'i') part.remove();
      // The corners come first. What is in its place already stays, and keeps the focus.
      let last = this.#box.querySelector('i:last-of-type')!;
      for (const part of parts) {
        if (last.nextElementSibling !== part) last.after(part);
        last = part;
      }
    }
    if (viewers.length === this.#viewers.length && viewers.every((viewer, i) => viewer === this.#viewers[i]))
      return;
    this.#viewers = viewers;
    this.#panes.forEach(({ slot }, i) => slot.assign(viewers[i]!));
    this.#observe();
  }

  #observe(): void {
    this.#observer.disconnect();
    this.#observer.observe(this.#element, { childList: true });
    for (const viewer of this.#viewers) {
      // The surface has the name in whatever way it was given, by attribute or property.
      const surface = viewer.shadowRoot?.querySelector('[part=surface]') ?? viewer;
      this.#observer.observe(surface, { attributeFilter: ['aria-label'] });
    }
  }

  /** What a viewer shows over its picture, such as its panel, keeps to the visible part. */
  #leaveRoom({ style }: HTMLElement, from: number, to: number, label: string): void {
    const [start, end] = this.vertical ? ['top', 'bottom'] : ['start', 'end'];
    const room = { start: '0%', end: '0%', top: '0%', bottom: '0%', label: label === '' ? '0px' : '26px' };
    const kept = { ...room, [start]: `${String(from)}%`, [end]: `${String(100 - to)}%` };
    for (const [side, length] of Object.entries(kept)) style.setProperty(`--phong-${side}`, length);
  }

  #clip(from: number, to: number): string {
    const [before, after] = [`${String(from)}%`, `${String(100 - to)}%`];
    if (this.vertical) return `inset(${before} 0 ${after} 0)`;
    return this.#rtl ? `inset(0 ${before} 0 ${after})` : `inset(0 ${after} 0 ${before})`;
  }

  /** The text over each viewer; `isName`: the viewer itself has it as its name. */
  get #labels(): readonly { readonly text: string; readonly isName: boolean }[] {
    const given = this.#values.labels?.split(',').map((text) => text.trim());
    return this.#viewers.map((viewer, i) => ({
      text: given === undefined ? (viewer.getAttribute('aria-label') ?? '') || viewer.alt : (given[i] ?? ''),
      isName: given === undefined,
    }));
  }
}

function createPane(index: number): Pane {
  const box = create('div', { class: 'pane', id: `pane-${String(index + 1)}` });
  const slot = create('slot', {});
  // Read as the viewer's name, or as that of the group around it.
  const label = create('div', { class: 'label', part: 'label', 'aria-hidden': 'true' });
  box.append(slot, label);
  return { box, slot, label };
}
