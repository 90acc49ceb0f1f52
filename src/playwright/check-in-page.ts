// Finds mistakes of a test in its page: another element than a viewer, or CSS that changes a picture. Runs inside the
// page.

/** What the element is if it is no `<phong-viewer>`, and where the viewers are; null for a viewer. */
export function otherElement(element: Element): string | null {
  if (element.localName === 'phong-viewer') return null;
  const viewers = element.querySelectorAll('phong-viewer').length;
  const inside = viewers === 0 ? 'with no viewer inside' : `with ${String(viewers)} inside`;
  return `a <${element.localName}> ${inside}`;
}

/** CSS that changes how the picture looks on the page, on the element or around it, with its cure; null for none. */
export function changeByCss(viewer: Element): string | null {
  let node: Element | null = viewer.shadowRoot?.querySelector('[part=surface]') ?? viewer;
  while (node !== null) {
    const { filter, opacity } = getComputedStyle(node);
    const change =
      filter !== 'none' ? `filter: ${filter}` : Number(opacity) < 1 ? `opacity: ${opacity}` : null;
    // Parts in the element's shadow root are the element's own for whoever reads the message.
    const name = node.getRootNode() === viewer.shadowRoot ? viewer.localName : node.localName;
    if (change !== null)
      return `<${name}> has the style "${change}", so the page shows other colours than the picture that is judged`;
    const root: Node = node.getRootNode();
    node = node.assignedSlot ?? node.parentElement ?? (root instanceof ShadowRoot ? root.host : null);
  }
  return null;
}
