// <phong-compare>: the declared values, and the box that CSS sizes. A chunk shows the viewers in
// it.
import { html, LitElement, nothing } from 'lit';
import { FieldStore } from '../../phong/fields/field-store.js';
import { reportMissing } from '../model/provided-code.js';
import type {
  ElementClass,
  Listen,
  PhongCompare as PublicCompare,
  PhongCompareEventMap,
  PhongViewer,
} from './elements.js';
import {
  COMPARE_FIELDS,
  type CompareProperties,
  type CompareValues,
} from './fields/compare-fields.js';
import { attributesOf, defineProperties, FieldBinding } from './fields/field-binding.js';
import { renderWhereShown } from './dom.js';
import { type Comparison, comparisonCode } from './extra-code.js';
import { inspect } from './inspect.js';
import { placed } from './internals.js';
import { leaveTexts, useTexts } from './page/page-texts.js';
import { addStyles } from './page/style-sheets.js';
import ownText from './page/own-text.css?inline';
import styles from './phong-compare.css?inline';
import { compareMarkup } from './viewer/to-html.js';

// The accessors come from the table of fields.
interface CompareElement extends CompareProperties {
  readonly localName: 'phong-compare';
  addEventListener: Listen<this, PhongCompareEventMap>;
  removeEventListener: Listen<this, PhongCompareEventMap>;
}

/**
 * Shows the viewers that are its children over each other, with dividers between them, or side by
 * side. CSS gives the size, 300 × 150 pixels if it gives none; the viewers fill it.
 *
 * @slot - `<phong-viewer>` elements; other children are not displayed
 * @csspart label - the label of a viewer
 * @csspart divider - what the user takes to move a divider: the focusable strip around its line
 * @csspart line - the line of a divider
 */
class CompareElement extends LitElement implements PublicCompare {
  // Nothing is assigned to a slot, so nothing is displayed, until it is known where the viewers
  // lie: they would be drawn twice.
  static override readonly shadowRootOptions: ShadowRootInit = {
    mode: 'open',
    slotAssignment: 'manual',
  };
  static override get observedAttributes(): string[] {
    return [...super.observedAttributes, ...attributesOf(COMPARE_FIELDS)];
  }

  readonly #store = new FieldStore<CompareValues>(COMPARE_FIELDS);
  readonly #binding = new FieldBinding<CompareValues>(this, this.#store);
  #comparison: Comparison | null = null;
  /** Its code could not be fetched: the viewers are shown as they are. */
  #failed = false;

  constructor() {
    super();
    this.#store.listen((key) => this.requestUpdate(key));
    renderWhereShown(this);
  }

  get viewers(): readonly PhongViewer[] {
    return Object.freeze(
      Array.from(this.children).filter(
        (child): child is PhongViewer => child.localName === 'phong-viewer',
      ),
    );
  }

  toHTML(): string {
    return compareMarkup(this);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addStyles(this.renderRoot as ShadowRoot, ownText);
    addStyles(this.renderRoot as ShadowRoot, styles);
    this.#binding.upgrade();
    useTexts(this);
    if (this.#comparison === null) {
      void this.#load();
    } else {
      this.requestUpdate();
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    leaveTexts(this);
  }

  override attributeChangedCallback(
    attribute: string,
    old: string | null,
    text: string | null,
  ): void {
    super.attributeChangedCallback(attribute, old, text);
    this.#binding.attributeChanged(attribute, text);
  }

  protected override render(): unknown {
    return this.#comparison?.template() ?? (this.#failed ? html`<slot></slot>` : nothing);
  }

  protected override updated(): void {
    if (this.#comparison !== null) return;
    this.renderRoot.querySelector('slot')?.assign(...this.viewers);
    if (this.#failed) {
      this.viewers.forEach((viewer) => placed(viewer));
    }
  }

  async #load(): Promise<void> {
    try {
      const { Comparison } = await comparisonCode();
      if (!this.isConnected || this.#comparison !== null) return;
      this.#comparison = new Comparison(this);
      inspect(this);
      this.addController(this.#comparison);
    } catch (error) {
      reportMissing(error);
      this.#failed = true;
    }
    this.requestUpdate();
  }
}

defineProperties(CompareElement.prototype, COMPARE_FIELDS);

export type PhongCompare = PublicCompare;
export const PhongCompare: ElementClass<PhongCompare> = CompareElement;
