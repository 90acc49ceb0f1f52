// Builds and changes elements by the DOM's own calls, for what follows every frame: strokes, handles
// (decisions/lit.md).

type Attributes = Readonly<Record<string, string | null>>;

export const createElement = <Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
): HTMLElementTagNameMap[Tag] => set(document.createElement(tag), attributes);

export const createSvg = <Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
): SVGElementTagNameMap[Tag] =>
  set(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes);

/**
 * Writes only what changes: every write is a mutation that the browser restyles and that the page
 * may observe. Null removes an attribute.
 */
export function set<E extends Element>(element: E, attributes: Attributes): E {
  for (const [name, value] of Object.entries(attributes)) {
    if (element.getAttribute(name) === value) continue;
    if (value === null) {
      element.removeAttribute(name);
    } else {
      element.setAttribute(name, value);
    }
  }
  return element;
}

/**
 * Writes only what changes, for the same reason as {@link set}. Screen readers may also read again
 * what is written.
 */
export function write(element: Element, text: string): void {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}
