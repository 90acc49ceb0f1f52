// Finds why a test's page shows no picture of a viewer, or not the one that is meant: another element, a file that is
// missing, nothing to show, or CSS that changes the picture. Runs inside the page.
import type { PhongViewer } from '../index.js';

/** What the element is if it is no `<phong-viewer>`, and where the viewers are; null for a viewer. */
export function otherElement(element: Element): string | null {
  if (element.localName === 'phong-viewer') return null;
  const viewers = element.querySelectorAll('phong-viewer').length;
  const inside = viewers === 0 ? 'with no viewer inside' : `with ${String(viewers)} inside`;
  return `a <${element.localName}> ${inside}`;
}

/** Why a settled viewer does not show all that it declares; null if it does. */
export function whyIncomplete({ shadowRoot, scene }: PhongViewer): string | null {
  const notice = shadowRoot?.querySelector<HTMLElement>('[part=notice]');
  if (notice) {
    const { code, url } = notice.dataset;
    const file = url?.startsWith('data:') === false ? `${url.replace(/^.*\//, '')}: ` : '';
    return `${file}${String(code)} (${notice.textContent})`;
  }
  return scene.children.length > 0 ? null : 'the viewer is empty: no src, geometry or <phong-mesh>';
}

/** CSS that changes how the picture looks on the page, on the element or around it, with its cure; null for none. */
export function changeByCss(viewer: Element): string | null {
  let node: Element | null = viewer.shadowRoot?.querySelector('[part=surface]') ?? viewer;
  while (node !== null) {
    const { filter, opacity } = getComputedStyle(node);
    const change = filter !== 'none' ? `filter: ${filter}` : Number(opacity) < 1 ? `opacity: ${opacity}` : null;
    // Parts in the element's shadow root are the element's own for whoever reads the message.
    const name = node.getRootNode() === viewer.shadowRoot ? viewer.localName : node.localName;
    if (change !== null)
      return `<${name}> has the style "${change}", so the page shows other colours than the picture that is judged`;
    const root: Node = node.getRootNode();
    node = node.assignedSlot ?? node.parentElement ?? (root instanceof ShadowRoot ? root.host : null);
  }
  return null;
}
