// How does the panel's style sheet get into a viewer's shadow root? With the viewer's own, so that it follows the viewer into
// other documents.
import { addStyles, removeStyles } from '../element/page/style-sheets.js';
import controls from './controls.css?inline';
import panel from './panel.css?inline';
import targets from './targets.css?inline';

/** Adds the sheet to the root. The returned function removes it. */
export function adoptStyles(root: ShadowRoot): () => void {
  const text = panel + controls + targets;
  addStyles(root, text);
  return () => {
    removeStyles(root, text);
  };
}
