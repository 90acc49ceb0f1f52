// Requests the models that the page's markup names before the rest of the first file runs:
// three.js, Lit and the definitions of the elements take 20 to 50 ms. Only what the elements are
// going to request anyway.
import { requestEarly } from '../../model/request-model.js';
import { isInClosed } from './closed.js';

/** Values set before the elements are defined replace the attributes. */
const isSet = (element: Element) =>
  ['src', 'loading', 'crossOrigin'].some((key) => Object.hasOwn(element, key));

if (typeof document !== 'undefined' && customElements.get('phong-viewer') === undefined) {
  for (const element of document.querySelectorAll(
    'phong-viewer[src], phong-viewer phong-mesh[src]',
  )) {
    const viewer = element.closest('phong-viewer')!;
    const src = element.getAttribute('src')!;
    const loading = viewer.getAttribute('loading')?.trim().toLowerCase();
    if (
      src === '' ||
      loading === 'lazy' ||
      (loading !== 'eager' && isInClosed(viewer)) ||
      isSet(element) ||
      isSet(viewer) ||
      !URL.canParse(src, document.baseURI)
    ) {
      continue;
    }
    const sends = viewer.getAttribute('crossorigin')?.trim().toLowerCase() === 'use-credentials';
    requestEarly(new URL(src, document.baseURI), sends ? 'use-credentials' : null);
  }
}
