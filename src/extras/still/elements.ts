// The elements of markup that parse5 has read.
import type { DefaultTreeAdapterTypes } from 'parse5';

type Element = DefaultTreeAdapterTypes.Element;

/** Those below a node in document order, without what templates hold, however deep. */
export function elementsBelow(node: DefaultTreeAdapterTypes.ParentNode): Element[] {
  const found: Element[] = [];
  const waiting = [...node.childNodes].reverse();
  for (let child = waiting.pop(); child !== undefined; child = waiting.pop()) {
    if (!('tagName' in child)) continue;
    found.push(child);
    for (let i = child.childNodes.length - 1; i >= 0; i--) {
      waiting.push(child.childNodes[i]!);
    }
  }
  return found;
}
