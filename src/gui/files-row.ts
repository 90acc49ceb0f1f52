// The panel's row of files: opens a model, saves the picture, copies the markup. Works under a strict
// Content-Security-Policy.
import type { GUI } from 'lil-gui';
import type { ViewerText } from '../element/fields/text-list.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { historyOf, valuesOf } from '../element/viewer/history.js';
import { modelCode } from '../model/request-model.js';
import { ButtonRow } from './button-row.js';
import { label } from './label.js';

const LABEL = 'copy HTML';

/** How long the button shows the result, ms. */
const RESULT_MS = 2000;

/** Adds the row. `update`: the viewer's values have changed. */
export function addFiles(gui: GUI, viewer: PhongViewer): { update(): void; dispose(): void } {
  const row = new ButtonRow(gui, 'Files');
  const open = row.add('open model…', () =>
    chooseModel((file) => historyOf(viewer).edit(valuesOf(viewer), () => (viewer.src = file))),
  );
  row.add('save PNG', () => {
    void savePicture(viewer);
  });
  const copy = new CopyButton(row, () => viewer.toHTML());
  return {
    update: () => (open.hidden = !viewer.droppable),
    dispose: () => copy.dispose(),
  };
}

/** Writes the markup to the clipboard, or shows it selected if the clipboard is not available. */
class CopyButton {
  readonly #row: ButtonRow;
  readonly #button: HTMLButtonElement;
  readonly #text = document.createElement('textarea');
  #timer = 0;

  constructor(row: ButtonRow, markup: () => string) {
    this.#row = row;
    this.#button = row.add(LABEL, () => {
      void this.#copy(markup());
    });
    this.#button.setAttribute('aria-live', 'polite');
    this.#text.readOnly = true;
    this.#text.className = 'markup';
    this.#text.rows = 6;
    // As in lil-gui's own fields: keys typed here must not reach the camera.
    this.#text.addEventListener('keydown', (event) => event.stopPropagation());
  }

  dispose(): void {
    clearTimeout(this.#timer);
  }

  async #copy(markup: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(markup);
      this.#text.remove();
      this.#showResult('copied ✓');
    } catch {
      // Refused, or missing: pages without TLS have no clipboard.
      this.#text.value = markup;
      this.#row.domElement.after(this.#text);
      label(this.#text, (say) => this.#text.setAttribute('aria-label', say("The scene's HTML")));
      this.#text.select();
      this.#text.scrollIntoView({ block: 'nearest' });
      this.#showResult('select and copy below');
    }
  }

  #showResult(what: ViewerText): void {
    clearTimeout(this.#timer);
    this.#show(what);
    this.#timer = window.setTimeout(() => this.#show(LABEL), RESULT_MS);
  }

  #show(text: ViewerText): void {
    label(this.#button, (say) => (this.#button.textContent = say(text)));
  }
}

/**
 * Opens the browser's file dialog; several files are one model, as when they are dropped. Calls `chosen` with the
 * model. Nothing is called if the user cancels.
 */
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
      .catch((error: unknown) => console.warn(`<phong-viewer gui>: ${String(error)}`));
  });
  dialog.click();
}

/**
 * How long the file stays in memory for the browser to save it, ms. Browsers read it after the click, some after a
 * dialog.
 */
const KEPT_MS = 40_000;

async function savePicture(viewer: PhongViewer): Promise<void> {
  const address = URL.createObjectURL(await viewer.toBlob());
  const link = document.createElement('a');
  link.href = address;
  link.download = 'phong-viewer.png';
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), KEPT_MS);
}
