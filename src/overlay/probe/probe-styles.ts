// How does the probe's style sheet get into a viewer's shadow root? With the viewer's own, so that it follows the viewer into other
// documents.
import { addStyles, removeStyles } from '../../element/page/style-sheets.js';
import probe from './probe.css?inline';

/** Adds the sheet to the root. The returned function removes it. */
export function adoptProbeStyles(root: ShadowRoot): () => void {
  addStyles(root, probe);
  return () => {
    removeStyles(root, probe);
  };
}
