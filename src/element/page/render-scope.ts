// Lets an element create its tree in its own document, which may be that of an iframe or a popup, and not the script's.
import type { LitElement } from 'lit';

/** From now on templates of `element` are created in the document that it is in. */
export function renderWhereShown(element: LitElement): void {
  element.renderOptions.creationScope = {
    importNode: (node, deep) => element.ownerDocument.importNode(node, deep),
  };
}
