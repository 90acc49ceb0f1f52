// <phong-compare>: viewers over each other with dividers, or side by side. Holds the declared values and the box that CSS gives a size;
// what shows the viewers in it is a chunk. Their cameras are linked by viewer/camera-group.ts. Knows no pictures.
import { FieldStore } from '../fields/field-store.js';
import { lazyCode } from '../scene/lazy-code.js';
import type { Comparison } from './compare/comparison.js';
import type { Listen, PhongCompareEventMap } from './events.js';
import { COMPARE_FIELDS, type CompareValues } from './fields/compare-fields.js';
import { attributesOf, defineProperties, FieldBinding } from './fields/field-binding.js';
import type { CompareProperties } from './fields/properties.js';
import { addStyles } from './page/style-sheets.js';
import styles from './phong-compare.css?inline';
import type { PhongViewer } from './phong-viewer.js';
import { compareMarkup } from './viewer/to-html.js';

const load = lazyCode(() => import('./compare/comparison.js'), '<phong-compare>');

/** Importing this file where there is no DOM does nothing. */
const Base = typeof HTMLElement === 'undefined' ? (class {} as typeof HTMLElement) : HTMLElement;

export interface PhongCompare extends CompareProperties {
  readonly localName: 'phong-compare';
  addEventListener: Listen<this, PhongCompareEventMap>;
  removeEventListener: Listen<this, PhongCompareEventMap>;
}

/**
 * Shows the viewers that are its children over each other, with dividers between them, or side by side. Their cameras move together,
 * except those of viewers with a `camera-group` of their own. CSS gives the size, 300 × 150 pixels if it gives none; the viewers fill it.
 *
 * @slot - `<phong-viewer>` elements; other children are not displayed
 * @csspart label - the label of a viewer
 * @csspart divider - what the user takes to move a divider: the focusable strip around its line
 * @csspart line - the line of a divider
 */
export class PhongCompare extends Base {
  static readonly observedAttributes: readonly string[] = attributesOf(COMPARE_FIELDS);

  readonly #store = new FieldStore<CompareValues>(COMPARE_FIELDS);
  readonly #binding = new FieldBinding<CompareValues>(this, this.#store);
  #comparison: Comparison | null = null;

  constructor() {
    super();
    this.#store.listen(() => this.#comparison?.update());
  }

  /** The viewers that are compared, in document order. */
  get viewers(): readonly PhongViewer[] {
    return Object.freeze(
      Array.from(this.children).filter((child): child is PhongViewer => child.localName === 'phong-viewer'),
    );
  }

  /** The comparison as markup, with the cameras and dividers as they are now. */
  toHTML(): string {
    return compareMarkup(this);
  }

  connectedCallback(): void {
    this.#binding.upgrade();
    // Nothing is assigned to a slot, so nothing is displayed, until it is known where the viewers lie: they would be drawn twice.
    const root = this.shadowRoot ?? this.attachShadow({ mode: 'open', slotAssignment: 'manual' });
    addStyles(root, styles);
    void this.#show(root);
  }

  disconnectedCallback(): void {
    this.#comparison?.dispose();
    this.#comparison = null;
  }

  attributeChangedCallback(attribute: string, _old: string | null, text: string | null): void {
    this.#binding.attributeChanged(attribute, text);
  }

  async #show(root: ShadowRoot): Promise<void> {
    try {
      const { Comparison } = await load();
      if (this.isConnected) this.#comparison ??= new Comparison(this, root);
    } catch (error) {
      console.warn(`<phong-compare>: ${(error as Error).message}`);
      const slot = document.createElement('slot');
      root.replaceChildren(slot);
      slot.assign(...this.viewers);
    }
  }
}

defineProperties(PhongCompare.prototype, COMPARE_FIELDS);

declare global {
  interface HTMLElementTagNameMap {
    'phong-compare': PhongCompare;
  }
}
