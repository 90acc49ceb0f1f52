// In which document an element's templates are created.
import type { LitElement } from 'lit';

/**
 * Templates of `element` are created in its own document, which may be that of an iframe, not in
 * the script's.
 */
export function renderWhereShown(element: LitElement): void {
  element.renderOptions.creationScope = {
    importNode: (node, deep) => element.ownerDocument.importNode(node, deep),
  };
}
