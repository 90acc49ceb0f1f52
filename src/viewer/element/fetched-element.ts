// What <phong-control>, <phong-probe> and <phong-exercise> are before their code, an extra, is
// there, and what controls of forms are after it.
import { reportMissing } from '../model/provided-code.js';
import { Base } from './child-element.js';

/** What <phong-probe> and <phong-exercise> have as HTML's own controls of forms do. */
export interface FormControl {
  /**
   * What was written: a probe's answers as typed, those of several questions separated by `;`; an
   * exercise's function.
   */
  value: string;
  readonly form: HTMLFormElement | null;
  readonly validity: ValidityState;
  readonly validationMessage: string;
  readonly willValidate: boolean;
  checkValidity(): boolean;
  reportValidity(): boolean;
}

/** The code of an element that is fetched. */
export interface ElementCode {
  /** An element is on the page. */
  readonly follow: (element: HTMLElement) => void;
  /** Of controls of forms. */
  readonly restore?: (element: HTMLElement, state: string) => void;
}

/** Attached at once: a document that an element has moved to may not know its tag. */
export const internalsOf = new WeakMap<HTMLElement, ElementInternals>();

/**
 * The class of an element whose code is fetched with the first one on a page, and gives it its
 * members. The callbacks of forms are for classes that are `formAssociated`.
 */
export const fetchedElement = <E extends HTMLElement>(
  code: () => Promise<ElementCode>,
): new () => E =>
  class extends Base {
    constructor() {
      super();
      internalsOf.set(this, this.attachInternals());
    }

    connectedCallback(): void {
      code().then(({ follow }) => follow(this), reportMissing);
    }

    formDisabledCallback(): void {
      this.connectedCallback();
    }

    formResetCallback(): void {
      this.formStateRestoreCallback('');
    }

    formStateRestoreCallback(state: string): void {
      code().then(({ restore }) => restore?.(this, state), reportMissing);
    }
  } as unknown as new () => E;
