// The elements in a page of happy-dom, which has neither layout nor pictures: viewers are 0 × 0, so
// they draw nothing, and colours are numbers, as no canvas converts others.

import '../../../src/viewer/index.js';
import type { PhongViewer } from '../../../src/viewer/index.js';

/** The first viewer of a page with this markup alone, ready. */
export async function onPage(markup: string): Promise<PhongViewer> {
  document.body.innerHTML = markup;
  const viewer = document.querySelector('phong-viewer')!;
  await viewer.ready;
  return viewer;
}

/** The part of a viewer's shadow tree; null if there is none. */
export const partOf = (viewer: PhongViewer, selector: string): HTMLElement | null =>
  viewer.shadowRoot!.querySelector(selector);
