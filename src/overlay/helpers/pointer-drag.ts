// Drags one of several elements with a pointer. Reports the press and the whole travel since then in the layer's own
// pixels, which CSS transforms may turn. One pointer at a time.
import { followDrag } from '../../element/page/followed-drag.js';
import { pictureBox } from '../../element/page/picture-box.js';
import { alongAxes } from '../../camera/gesture.js';

interface DragListener {
  /** The primary button pressed this element. False: it is not for dragging. */
  press(element: HTMLElement): boolean;
  /** Travel since the press, CSS pixels of the layer, right and down. `along`: Shift is down. */
  moved(dx: number, dy: number, along: boolean): void;
  end(): void;
}

/** CSS pixels of the page. A press that moves less is a click. Less than the camera's, so that lights move a little. */
const SLOP = 3;

/** Listens to the children of `list`; travel is along the axes of the picture's `surface`, which the layer covers. */
export function listenToPointers(list: HTMLElement, surface: HTMLElement, listener: DragListener): void {
  let drag: { readonly id: number; readonly element: HTMLElement; readonly end: () => void } | null = null;
  list.addEventListener('pointerdown', (event) => {
    const { target, pointerId: id } = event;
    // An element that was removed gets no event at the end of its drag.
    if (drag?.element.isConnected === true && drag.id !== id) return;
    if (event.button !== 0 || !(target instanceof HTMLElement)) return;
    event.preventDefault(); // no selection, no focus elsewhere
    drag?.end();
    if (!listener.press(target)) return;
    const { axes } = pictureBox(surface);
    const end = followDrag(target, event, SLOP, {
      moved: (dx, dy, { shiftKey }) => listener.moved(...alongAxes(axes, dx, dy), shiftKey),
      ended() {
        drag = null;
        listener.end();
      },
    });
    drag = { id, element: target, end };
  });
}
