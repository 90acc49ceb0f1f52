// Files dropped on a viewer become its model. What the browser offers only during the event is taken here; which of
// them is the model is decided by the code that reads models.
import { modelCode } from '../../model/request-model.js';
import type { PhongViewer } from '../elements.js';

/** From now on the viewer takes files while it is `droppable`. */
export function takeDrops(viewer: PhongViewer): void {
  let drops = 0;
  /** A page's own handler comes first, and may have taken the files. */
  const takes = (event: DragEvent): DataTransfer | null => {
    const { dataTransfer, defaultPrevented } = event;
    if (!viewer.droppable || defaultPrevented || dataTransfer?.types.includes('Files') !== true) return null;
    event.preventDefault();
    return dataTransfer;
  };
  viewer.addEventListener('dragover', (event) => {
    const transfer = takes(event);
    if (transfer !== null) transfer.dropEffect = 'copy';
  });
  viewer.addEventListener('drop', (event) => {
    const transfer = takes(event);
    if (transfer === null) return;
    const entries = Array.from(transfer.items, (item) => item.webkitGetAsEntry()).filter((entry) => entry !== null);
    const files = [...transfer.files];
    const drop = ++drops; // of two in a row, the later one counts
    viewer.focus({ preventScroll: true }); // as after a press: Escape removes a message
    modelCode()
      .then(({ droppedModel }) => droppedModel(entries, files))
      .then((model) => {
        if (drop === drops && model !== null) viewer.src = model;
      })
      .catch((error: unknown) => console.warn(`<phong-viewer droppable>: ${String(error)}`));
  });
}
