// A drag of one element by one pointer, from the press to its end, wherever the pointer is by then.
import { keepDrag } from './kept-drag.js';

interface DragListener {
  /** Whole travel since the press, in client coordinates. */
  moved(dx: number, dy: number, event: PointerEvent): void;
  ended(): void;
}

/**
 * Call at the press; the returned function ends the drag. A press that moves less than `slop` CSS
 * pixels by `distance` is a click, which the page gets; 0 is for what is never clicked.
 */
export function followDrag(
  element: HTMLElement,
  { pointerId, clientX, clientY }: PointerEvent,
  slop: number,
  listener: DragListener,
  distance: (dx: number, dy: number) => number = Math.hypot,
): () => void {
  const view = element.ownerDocument.defaultView;
  const release = keepDrag(view);
  const listening = new AbortController();
  const { signal } = listening;
  let dragged = slop === 0;
  const end = () => {
    if (signal.aborted) return;
    listening.abort('ended');
    release(dragged);
    if (element.hasPointerCapture(pointerId)) {
      element.releasePointerCapture(pointerId);
    }
    listener.ended();
  };
  // The button may be released in another window, which no event reports.
  view?.addEventListener('blur', end, { signal });
  const listen = (
    target: EventTarget | null,
    type: string,
    heard: (event: PointerEvent) => void,
  ): void =>
    target?.addEventListener(
      type,
      (event) => {
        if ((event as PointerEvent).pointerId === pointerId) {
          heard(event as PointerEvent);
        }
      },
      { signal, capture: true },
    );
  listen(element, 'pointermove', (event) => {
    // The button was released without an event: over another window, under a menu.
    if ((event.buttons & 1) === 0) {
      end();
      return;
    }
    const [dx, dy] = [event.clientX - clientX, event.clientY - clientY];
    dragged ||= distance(dx, dy) >= slop;
    if (dragged) {
      listener.moved(dx, dy, event);
    }
  });
  // An element that was removed gets none of these.
  for (const type of ['pointerup', 'pointercancel', 'lostpointercapture']) {
    listen(view, type, end);
  }
  try {
    element.setPointerCapture(pointerId);
  } catch {
    // The pointer is gone already or was made by a script: drag without capture.
  }
  return end;
}
