// How does the panel's style sheet get into a viewer's shadow root? With the viewer's own, so that it follows the viewer into
// other documents.
import { addStyles, removeStyles } from '../element/page/style-sheets.js';
import access from './access.css?inline';
import controls from './controls.css?inline';
import panel from './panel.css?inline';

/** Adds the sheet to the root. The returned function removes it. */
export function adoptStyles(root: ShadowRoot): () => void {
  const text = panel + controls + access;
  addStyles(root, text);
  return () => {
    removeStyles(root, text);
  };
}
