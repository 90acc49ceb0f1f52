// Drags one of several elements with a pointer. Reports the press and the whole travel since then in the layer's own
// pixels, which CSS transforms may turn. One pointer at a time.
import { PictureCorners } from '../../element/page/picture-box.js';
import { alongAxes, type PictureBox } from '../../camera/gesture.js';
import { keepDrag } from '../../camera/kept-drag.js';

interface DragListener {
  /** The primary button pressed this element. False: it is not for dragging. */
  press(element: HTMLElement): boolean;
  /** Travel since the press, CSS pixels of the layer, right and down. `along`: Shift is down. */
  moved(dx: number, dy: number, along: boolean): void;
  end(): void;
}

interface Press {
  readonly id: number;
  readonly element: HTMLElement;
  readonly x: number;
  readonly y: number;
  /** The layer's axes on the page. */
  readonly axes: PictureBox['axes'];
  readonly release: (moved: boolean) => void;
  dragged: boolean;
}

/** CSS pixels of the page. A press that moves less is a click: fingers are not steady. */
const SLOP = 3;

/** Listens to the children of `list`; travel is along the axes of the picture's `surface`, which the layer covers. */
export function listenToPointers(list: HTMLElement, surface: HTMLElement, listener: DragListener): void {
  const corners = new PictureCorners(surface);
  let press: Press | null = null;
  const release = (): void => {
    if (press === null) return;
    const { id, element, dragged } = press;
    press.release(dragged);
    press = null;
    surface.ownerDocument.defaultView?.removeEventListener('blur', release);
    if (element.hasPointerCapture(id)) element.releasePointerCapture(id);
    listener.end();
  };
  const end = (event: PointerEvent): void => {
    if (press?.id === event.pointerId) release();
  };
  list.addEventListener('pointerdown', (event) => {
    const { target, pointerId: id, clientX: x, clientY: y } = event;
    // An element that was removed gets no event at the end of its drag.
    if (press?.element.isConnected === true && press.id !== id) return;
    if (event.button !== 0 || !(target instanceof HTMLElement)) return;
    event.preventDefault(); // no selection, no focus elsewhere
    if (!listener.press(target)) return;
    const view = surface.ownerDocument.defaultView;
    press = { id, element: target, x, y, axes: corners.box.axes, release: keepDrag(view), dragged: false };
    // The button may be released in another window, which no event reports.
    view?.addEventListener('blur', release);
    try {
      target.setPointerCapture(id);
    } catch {
      // The pointer is gone already or was made by a script: drag without capture.
    }
  });
  list.addEventListener('pointermove', (event) => {
    if (press?.id !== event.pointerId) return;
    // The button was released without an event: over another window, under a menu.
    if ((event.buttons & 1) === 0) {
      end(event);
      return;
    }
    const [dx, dy] = [event.clientX - press.x, event.clientY - press.y];
    press.dragged ||= Math.hypot(dx, dy) >= SLOP;
    if (press.dragged) listener.moved(...alongAxes(press.axes, dx, dy), event.shiftKey);
  });
  for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
    list.addEventListener(type, end);
}
