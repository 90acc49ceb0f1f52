// Which keys and gestures in the panel mean undo, redo, or the end of a step? Does not know what is undone.
import { type History, undoKey } from '../element/viewer/history.js';

const isText = (target: EventTarget | undefined): target is HTMLInputElement | HTMLTextAreaElement =>
  target instanceof HTMLTextAreaElement ||
  (target instanceof HTMLInputElement && (target.type === 'text' || target.type === 'number'));

/** Undo in `panel` by Ctrl or Cmd with Z, Shift + Z, and Y. A text field in which the user is typing keeps its own undo. */
export function listenForUndo(panel: HTMLElement, history: History): void {
  let typedIn: EventTarget | null = null;
  panel.addEventListener('input', ({ target }) => {
    if (isText(target ?? undefined)) typedIn = target;
  });
  panel.addEventListener('focusout', () => {
    typedIn = null;
  });
  // A step ends when the pointer or an arrow key is released, and when a field or picker is left.
  for (const type of ['change', 'pointerup', 'pointercancel'] as const) {
    panel.addEventListener(type, () => {
      if (type === 'change') typedIn = null;
      history.seal();
    });
  }
  const keys = { capture: true }; // lil-gui stops the keys of its rows on their way up
  panel.addEventListener(
    'keyup',
    ({ key }) => {
      if (key.startsWith('Arrow')) history.seal();
    },
    keys,
  );
  panel.addEventListener(
    'keydown',
    (event) => {
      const action = undoKey(event);
      if (action === null || (typedIn !== null && typedIn === event.target)) return;
      event.preventDefault();
      event.stopPropagation();
      history[action]();
    },
    keys,
  );
}
