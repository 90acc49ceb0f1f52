// The panel's row of files: opens a model, saves the picture, copies the markup. Works under a
// strict Content-Security-Policy.
import type { GUI } from 'lil-gui';
import {
  copyText,
  historyOf,
  modelCode,
  type PhongViewer,
  type ViewerText,
} from '../../viewer/extra.js';
import { ButtonRow } from './button-row.js';
import { label } from './label.js';

const LABEL = 'copy HTML';

/** Adds the row. The returned function is called when the viewer's values have changed. */
export function addFiles(gui: GUI, viewer: PhongViewer): () => void {
  const row = new ButtonRow(gui, 'Files');
  const open = row.add('open model…', () =>
    chooseModel(viewer, (file) => historyOf(viewer).edit(viewer, () => (viewer.src = file), file)),
  );
  row.add('save PNG', () => {
    savePicture(viewer).catch(warnOf);
  });
  addCopyButton(row, () => viewer.toHTML());
  return () => void (open.hidden = !viewer.droppable);
}

const warnOf = (error: unknown): void => console.warn(`<phong-viewer gui>: ${String(error)}`);

/** Copies the markup, or shows it below the row. */
function addCopyButton(row: ButtonRow, markup: () => string): void {
  const text = document.createElement('textarea');
  Object.assign(text, { readOnly: true, hidden: true, className: 'markup', rows: 6 });
  // As in lil-gui's own fields: keys typed here must not reach the camera.
  text.addEventListener('keydown', (event) => event.stopPropagation());
  row.domElement.after(text);
  label(text, (say) => text.setAttribute('aria-label', say("The scene's HTML")));
  const show = (what: ViewerText): void => label(button, (say) => (button.textContent = say(what)));
  const button = row.add(LABEL, () => void copyText(markup(), text, LABEL, show));
  button.setAttribute('aria-live', 'polite');
}

/**
 * Opens the browser's file dialog; several files are one model, as when they are dropped. Calls
 * `chosen` with the model, or opens the scene of a picture. Nothing happens if the user cancels.
 */
export function chooseModel(viewer: PhongViewer, chosen: (model: Blob) => void): void {
  const dialog = document.createElement('input');
  dialog.type = 'file';
  dialog.multiple = true;
  dialog.addEventListener('change', () => {
    const files = [...(dialog.files ?? [])];
    modelCode()
      .then(({ droppedModel }) => droppedModel([], files))
      .then((model) => {
        if (model instanceof Blob) {
          chosen(model);
        } else {
          model?.(viewer);
        }
      })
      .catch(warnOf);
  });
  dialog.click();
}

/** How long the file stays in memory, ms. Browsers read it after the click, some after a dialog. */
const KEPT_MS = 40_000;

async function savePicture(viewer: PhongViewer): Promise<void> {
  const address = URL.createObjectURL(await viewer.toBlob({ markup: true }));
  const link = document.createElement('a');
  link.href = address;
  link.download = 'phong-viewer.png';
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), KEPT_MS);
}
