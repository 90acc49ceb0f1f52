// How does a legend's style sheet get into a viewer's shadow root? With the viewer's own, as the panel's does.
import { addStyles, removeStyles } from '../../element/page/style-sheets.js';
import legend from './legend.css?inline';

/** Adds the sheet to the root. The returned function removes it. */
export function adoptStyles(root: ShadowRoot): () => void {
  addStyles(root, legend);
  return () => {
    removeStyles(root, legend);
  };
}
