// Undo and redo in a viewer with a panel: two buttons, and the keys and gestures that take back or
// end a step.
import type { GUI } from 'lil-gui';
import { historyOf, type PhongViewer } from '../../viewer/extra.js';
import { ButtonRow } from './button-row.js';

/** The returned function stops following the history. */
export function addUndo(gui: GUI, viewer: PhongViewer): () => void {
  const history = historyOf(viewer);
  const row = new ButtonRow(gui, 'Undo');
  const undo = row.add('undo', () => history.undo());
  const redo = row.add('redo', () => history.redo());
  undo.setAttribute('aria-keyshortcuts', 'Control+Z Meta+Z');
  redo.setAttribute('aria-keyshortcuts', 'Control+Shift+Z Meta+Shift+Z Control+Y');
  const update = (): void => {
    undo.setAttribute('aria-disabled', String(!history.canUndo));
    redo.setAttribute('aria-disabled', String(!history.canRedo));
  };
  update();
  const stops = [listenForUndo(viewer, gui.domElement, history), history.listen(update)];
  return () => {
    for (const stop of stops) {
      stop();
    }
  };
}

/** Inputs that hold no text that is typed, so that they have no undo of their own. */
const TEXTLESS: ReadonlySet<string> = new Set(
  'button checkbox color file image radio range reset submit'.split(' '),
);

/** Has undo by keys itself. */
const isEditor = (target: EventTarget | null | undefined): boolean =>
  target instanceof HTMLInputElement
    ? !TEXTLESS.has(target.type)
    : target instanceof HTMLTextAreaElement ||
      (target instanceof HTMLElement && target.isContentEditable);

/**
 * Undo by Ctrl or Cmd with Z, Shift + Z, and Y, wherever in `viewer` the focus is. A text field in
 * which the user is typing keeps its own undo. The returned function stops listening outside the
 * panel.
 */
export function listenForUndo(
  viewer: HTMLElement,
  panel: HTMLElement,
  history: ReturnType<typeof historyOf>,
): () => void {
  let typedIn: EventTarget | null = null;
  panel.addEventListener('input', ({ target }) => {
    if (isEditor(target)) {
      typedIn = target;
    }
  });
  panel.addEventListener('focusout', ({ target }) => {
    typedIn = null;
    if (isEditor(target)) {
      history.seal();
    }
  });
  // A step ends when the pointer is released, and when a field or picker is left; outside of fields
  // with each arrow key, too.
  for (const type of ['change', 'pointerup', 'pointercancel'] as const) {
    panel.addEventListener(type, () => {
      if (type === 'change') {
        typedIn = null;
      }
      history.seal();
    });
  }
  // In the capture phase: lil-gui stops the keys of its rows on their way up.
  const onKey = (type: 'keyup' | 'keydown', heard: (event: KeyboardEvent) => void): void =>
    panel.addEventListener(type, heard, { capture: true });
  onKey('keyup', ({ key, target }) => {
    if (key.startsWith('Arrow') && !isEditor(target)) {
      history.seal();
    }
  });
  const act = (event: KeyboardEvent): void => {
    const action = history.actionOf(event);
    if (action === null) return;
    event.preventDefault();
    event.stopPropagation();
    history[action]();
  };
  onKey('keydown', (event) => {
    if (typedIn === null || typedIn !== event.target) {
      act(event);
    }
  });
  const outside = new AbortController();
  viewer.addEventListener(
    'keydown',
    (event) => {
      // Handles of lights undo by themselves, without a panel too.
      if (!event.defaultPrevented && !isEditor(event.composedPath()[0])) {
        act(event);
      }
    },
    { signal: outside.signal },
  );
  return () => outside.abort('closed');
}
