// What <phong-control>, <phong-probe> and <phong-exercise> have in common once their code is there:
// values from attributes and properties, a shadow root, the elements and texts around them, and what
// HTML's own controls of forms have. Only their code imports it: the first file does without.
import { type Fields, FieldStore } from '../../phong/fields/field-store.js';
import type { PhongViewer } from './elements.js';
import { internalsOf } from './fetched-element.js';
import { defineProperties, FieldBinding } from './fields/field-binding.js';
import { upgradeProperty, type ViewerTexts } from './fields/texts.js';
import ownText from './page/own-text.css?inline';
import { addStyles } from './page/style-sheets.js';

/** Milliseconds in which a missing element may come with a later script. */
const PATIENCE = 2000;

const warned = new Set<string>();

export abstract class ExtraElement<V extends object> {
  /** Styles of a block in the page's text. */
  static readonly block = ownText;

  /**
   * Gives the elements of a tag the properties of their fields and, where they are controls of
   * forms, what such have. Returns the code of one element, made with the first call.
   */
  static codeOf<Code extends ExtraElement<object>>(
    tag: string,
    fields: object,
    make: new (element: HTMLElement) => Code,
  ): (element: HTMLElement) => Code {
    const codes = new WeakMap<HTMLElement, Code>();
    const type = customElements.get(tag) as CustomElementConstructor & { formAssociated?: true };
    const prototype = type.prototype as HTMLElement;
    const isForm = type.formAssociated === true;
    const own = (element: HTMLElement): Code => {
      let code = codes.get(element);
      if (code === undefined) {
        codes.set(element, (code = new make(element)));
        if (isForm) {
          upgradeProperty(element, 'value');
        }
      }
      return code;
    };
    defineProperties(prototype, fields);
    if (isForm) {
      defineFormMembers(prototype, own as unknown as (of: HTMLElement) => FormCode);
    }
    return own;
  }

  readonly element: HTMLElement;
  readonly internals: ElementInternals;
  protected readonly root: ShadowRoot;
  protected readonly values: Readonly<V>;
  readonly #styles: readonly string[];
  readonly #page = new MutationObserver(() => this.#pageChanged());
  #patience = 0;

  constructor(element: HTMLElement, fields: Fields<V>, styles: readonly string[]) {
    this.element = element;
    this.internals = internalsOf.get(element)!;
    this.root = element.attachShadow({ mode: 'open', delegatesFocus: true });
    this.#styles = styles;
    const binding = new FieldBinding(element, new FieldStore(fields));
    this.values = binding.store.values;
    const read = (name: string): unknown =>
      binding.attributeChanged(name, element.getAttribute(name));
    element.getAttributeNames().forEach(read);
    binding.upgrade();
    binding.store.listen(() => this.#declared());
    // Also while it is not on the page.
    new MutationObserver((records) => {
      for (const { target, attributeName } of records) {
        if (target === element && attributeName !== null) {
          read(attributeName);
        }
      }
      if (records.some(({ type }) => type !== 'attributes')) {
        this.#declared();
      }
    }).observe(element, { childList: true, subtree: true, attributes: true, characterData: true });
  }

  /** Its values or what stands in it may be others. */
  protected abstract declared(): void;

  /** The page's elements, ids or languages may be others. */
  protected abstract found(): void;

  /** It is not on the page any more. */
  protected abstract left(): void;

  /** Says what has not come in time, if anything. */
  protected abstract complain(): void;

  /** It has come to the page, or is disabled. It sees by itself when it leaves. */
  start(): void {
    const { element } = this;
    if (!element.isConnected) return;
    for (const text of this.#styles) {
      addStyles(this.root, text);
    }
    this.#page.disconnect();
    for (const root of new Set([element.getRootNode(), element.ownerDocument])) {
      this.#page.observe(root, { childList: true, subtree: true, attributeFilter: ['id', 'lang'] });
    }
    this.#declared();
  }

  /** In its own tree, else in the document; null while it is on no page. */
  protected byId(id: string): Element | null {
    const { element } = this;
    if (!element.isConnected) return null;
    const tree = element.getRootNode() as Document | ShadowRoot;
    return tree.getElementById(id) ?? element.ownerDocument.getElementById(id);
  }

  /** Null while there is none. */
  protected viewerById(id: string): PhongViewer | null {
    const found = this.byId(id.trim());
    return found?.matches('phong-viewer:defined') === true ? (found as PhongViewer) : null;
  }

  /**
   * The texts of a viewer as they are where this element stands. In a part of the page that has a
   * language of its own, numbers are in that, and in an English part words are the built-in ones.
   */
  protected textsOf(viewer: Pick<PhongViewer, 'texts'> | null): ViewerTexts | null {
    const texts = viewer?.texts ?? null;
    const part = this.element.closest('[lang]:not(:root)');
    const lang = part?.getAttribute('lang') ?? '';
    if (lang === '') return texts;
    const isForeign = texts?.en !== undefined && !/^en\b/.test(texts.en) && /^en\b/.test(lang);
    return { ...(isForeign ? null : texts), en: lang };
  }

  /** Once for each message. */
  protected warn(message: string): void {
    if (!warned.has(message)) {
      console.warn(message);
    }
    warned.add(message);
  }

  #declared() {
    this.declared();
    clearTimeout(this.#patience);
    if (this.element.isConnected) {
      this.#patience = window.setTimeout(() => this.complain(), PATIENCE);
    }
  }

  #pageChanged() {
    if (this.element.isConnected) {
      this.found();
      return;
    }
    this.#page.disconnect();
    clearTimeout(this.#patience);
    this.left();
  }
}

/** The code of a control of forms. */
interface FormCode {
  readonly internals: ElementInternals;
  value: string;
}

function defineFormMembers(prototype: HTMLElement, own: (of: HTMLElement) => FormCode) {
  const define = (key: string, member: PropertyDescriptor & ThisType<HTMLElement>): unknown =>
    Object.defineProperty(prototype, key, { configurable: true, ...member });
  for (const key of ['form', 'validity', 'validationMessage', 'willValidate'] as const) {
    define(key, {
      get() {
        return own(this).internals[key];
      },
    });
  }
  for (const key of ['checkValidity', 'reportValidity'] as const) {
    define(key, {
      value() {
        return own(this).internals[key]();
      },
    });
  }
  define('value', {
    get() {
      return own(this).value;
    },
    set(value: unknown) {
      own(this).value = String(value);
    },
  });
}
