// The elements of markup that parse5 has read.
import type { DefaultTreeAdapterTypes } from 'parse5';

type Element = DefaultTreeAdapterTypes.Element;

/**
 * Those below a node in document order, however deep. Declarative shadow roots are part of their
 * hosts; what other templates hold is left out.
 */
export function elementsBelow(node: DefaultTreeAdapterTypes.ParentNode): Element[] {
  const found: Element[] = [];
  const waiting = [...node.childNodes].reverse();
  for (let child = waiting.pop(); child !== undefined; child = waiting.pop()) {
    if (!('tagName' in child)) continue;
    found.push(child);
    const isRoot = child.attrs.some(({ name }) => name === 'shadowrootmode');
    const { childNodes } = isRoot && 'content' in child ? child.content : child;
    for (let i = childNodes.length - 1; i >= 0; i--) {
      waiting.push(childNodes[i]!);
    }
  }
  return found;
}
