// How does the user choose a model from the device? With the browser's file dialog; several files are one model, as when they are dropped.
// Knows no formats.
import { modelCode } from '../scene/mesh/content.js';

/** Opens the dialog and calls `chosen` with the model. Nothing is called if the user cancels. */
export function chooseModel(chosen: (model: Blob) => void): void {
  const dialog = document.createElement('input');
  dialog.type = 'file';
  dialog.multiple = true;
  dialog.addEventListener('change', () => {
    const files = [...(dialog.files ?? [])];
    modelCode()
      .then(({ droppedModel }) => droppedModel([], files))
      .then((model) => {
        if (model !== null) chosen(model);
      })
      .catch((error: unknown) => {
        console.warn(`<phong-viewer gui>: ${String(error)}`);
      });
  });
  dialog.click();
}
