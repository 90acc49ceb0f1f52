// Files that are dropped on a `droppable` viewer become its model. What the browser offers only during
// the event is taken here; the code that reads models decides which of them is the model. Fetched
// with the attribute.
import { modelCode } from '../../model/request-model.js';
import type { Extra, ExtraHost } from './extra-host.js';
import { stepsCode } from './loading.js';

export function create({ viewer }: ExtraHost): Extra {
  let drops = 0;
  /** A page's own handler comes first, and may have taken the files. */
  const takes = (event: DragEvent): DataTransfer | null => {
    const { dataTransfer, defaultPrevented } = event;
    if (!viewer.droppable || defaultPrevented || dataTransfer?.types.includes('Files') !== true) {
      return null;
    }
    event.preventDefault();
    return dataTransfer;
  };
  const onOver = (event: DragEvent) => {
    const transfer = takes(event);
    if (transfer !== null) {
      transfer.dropEffect = 'copy';
    }
  };
  const onDrop = (event: DragEvent) => {
    const transfer = takes(event);
    if (transfer === null) return;
    const entries = Array.from(transfer.items, (item) => item.webkitGetAsEntry()).filter(
      (entry) => entry !== null,
    );
    const files = [...transfer.files];
    const drop = ++drops; // of two in a row, the later one counts
    viewer.focus({ preventScroll: true }); // as after a press: Escape removes a message
    modelCode()
      .then(({ droppedModel }) => droppedModel(entries, files))
      .then(async (model) => {
        const { showDropped } = await stepsCode();
        if (drop === drops && model !== null) {
          showDropped(viewer, model);
        }
      })
      .catch((error: unknown) => console.warn(`<phong-viewer droppable>: ${String(error)}`));
  };
  viewer.addEventListener('dragover', onOver);
  viewer.addEventListener('drop', onDrop);
  return {
    update: () => undefined,
    dispose() {
      viewer.removeEventListener('dragover', onOver);
      viewer.removeEventListener('drop', onDrop);
    },
  };
}
