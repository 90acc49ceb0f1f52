// Keeps a drag from the page around it, which may be a link, a draggable card, a label or a
// summary.

/**
 * CSS pixels of the page. A press that moves less is a click: hands are not steady, and fingers
 * less so.
 */
export const SLOP = { mouse: 4, touch: 10 } as const;

/**
 * Milliseconds in which the click that ends a drag arrives. After a mouse it is there at once,
 * after a touch later.
 */
const CLICK_DELAY = 300;

/** Before the page's own listeners. */
const CAPTURE = { capture: true };

/**
 * Call at the press: from then on nothing around the picture is dragged. The returned function ends
 * that; if the press has `moved` something, the click that follows is kept from the page, too.
 */
export function keepDrag(view: EventTarget | null): (moved: boolean) => void {
  const keep = (event: Event) => {
    event.preventDefault();
    event.stopPropagation();
  };
  const keepClick = (event: Event) => {
    if (!event.isTrusted) return; // a script's own
    keep(event);
    forget();
  };
  const forget = () => {
    view?.removeEventListener('click', keepClick, CAPTURE);
    view?.removeEventListener('pointerdown', forget, CAPTURE);
  };
  view?.addEventListener('dragstart', keep, CAPTURE);
  return (moved) => {
    view?.removeEventListener('dragstart', keep, CAPTURE);
    if (!moved) return;
    view?.addEventListener('click', keepClick, CAPTURE);
    view?.addEventListener('pointerdown', forget, CAPTURE);
    setTimeout(forget, CLICK_DELAY);
  };
}
