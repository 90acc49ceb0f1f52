// The panel's row of files: opens a model, saves the picture, copies the markup. Works under a
// strict Content-Security-Policy.
import type { GUI } from 'lil-gui';
import { historyOf, modelCode, type PhongViewer, type ViewerText } from '../../viewer/extra.js';
import { ButtonRow } from './button-row.js';
import { label } from './label.js';

const LABEL = 'copy HTML';

/** How long the button shows the result, ms. */
const RESULT_MS = 2000;

/** Adds the row. Returns a function to call when the viewer's values have changed. */
export function addFiles(gui: GUI, viewer: PhongViewer): () => void {
  const row = new ButtonRow(gui, 'Files');
  const open = row.add('open model…', () =>
    chooseModel(viewer, (file) => historyOf(viewer).edit(viewer, () => (viewer.src = file), file)),
  );
  row.add('save PNG', () => {
    savePicture(viewer).catch(warnOf);
  });
  addCopyButton(row, () => viewer.toHTML());
  return () => (open.hidden = !viewer.droppable);
}

const warnOf = (error: unknown): void => console.warn(`<phong-viewer gui>: ${String(error)}`);

/** Writes the markup to the clipboard, or shows it selected if the clipboard is not available. */
function addCopyButton(row: ButtonRow, markup: () => string): void {
  const button = row.add(LABEL, () => {
    void copy();
  });
  button.setAttribute('aria-live', 'polite');
  const text = document.createElement('textarea');
  text.readOnly = true;
  text.className = 'markup';
  text.rows = 6;
  // As in lil-gui's own fields: keys typed here must not reach the camera.
  text.addEventListener('keydown', (event) => event.stopPropagation());
  const show = (what: ViewerText): void => label(button, (say) => (button.textContent = say(what)));
  let timer = 0;
  const showResult = (what: ViewerText): void => {
    clearTimeout(timer);
    show(what);
    timer = window.setTimeout(() => show(LABEL), RESULT_MS);
  };
  const copy = async (): Promise<void> => {
    const html = markup();
    try {
      await navigator.clipboard.writeText(html);
      text.remove();
      showResult('copied ✓');
    } catch {
      // Refused, or missing: pages without TLS have no clipboard.
      text.value = html;
      row.domElement.after(text);
      label(text, (say) => text.setAttribute('aria-label', say("The scene's HTML")));
      text.select();
      text.scrollIntoView({ block: 'nearest' });
      showResult('select and copy below');
    }
  };
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
