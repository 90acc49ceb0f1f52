// Pointer and keys on a picture, as its probe takes them. A mouse hovers, a click or tap without a drag pins, arrow
// keys move the cross-hair. The camera takes the same events: a drag turns the picture and is no click. Places are CSS
// pixels of the layer.
import { SLOP } from '../../camera/kept-drag.js';
import { zoomOf } from '../../element/dom.js';
import { ARROWS } from '../arrow-keys.js';
import type { Point } from '../drawing/projection.js';

export interface ProbeInputHost {
  /** Where the mouse is; null once it has left, or drags. */
  look(at: Point | null): void;
  pin(at: Point): void;
  /** Removes the pin. False if there is none. */
  release(): boolean;
  /** Moves the cross-hair. */
  step(across: number, down: number): void;
  /** Pins what the cross-hair shows. */
  pinHere(): void;
  /** The cross-hair got the focus. */
  focused(): void;
  /** Neither cross-hair nor table has the focus any more. */
  blurred(): void;
}

/** CSS pixels per press of an arrow key, and with Shift. */
const STEP = { fine: 1, coarse: 10 } as const;

interface Elements {
  readonly surface: HTMLElement;
  readonly cursor: HTMLElement;
  /** They hold the cross-hair and the table. */
  readonly boxes: readonly HTMLElement[];
}

/** Listens until `signal` is aborted. */
export function listen({ surface, cursor, boxes }: Elements, host: ProbeInputHost, signal: AbortSignal): void {
  let pressed: Point = { x: 0, y: 0 };
  let steady = false;
  const on = <K extends keyof HTMLElementEventMap>(
    target: HTMLElement,
    type: K,
    listener: (event: HTMLElementEventMap[K]) => void,
  ): void => target.addEventListener(type, listener, { signal });
  const placeOf = ({ offsetX, offsetY }: MouseEvent): Point => {
    // Inside CSS zoom, pointer events use the page's pixels.
    const zoom = zoomOf(surface);
    return { x: offsetX / zoom, y: offsetY / zoom };
  };

  on(surface, 'pointerdown', ({ clientX, clientY, isPrimary }) => {
    pressed = { x: clientX, y: clientY };
    steady = isPrimary; // a second finger pinches
  });
  on(surface, 'pointermove', (event) => {
    const { clientX, clientY, buttons, pointerType } = event;
    if (buttons === 0) {
      if (pointerType !== 'touch') host.look(placeOf(event));
      return;
    }
    const slop = pointerType === 'touch' ? SLOP.touch : SLOP.mouse;
    steady &&= Math.hypot(clientX - pressed.x, clientY - pressed.y) <= slop;
    if (!steady) host.look(null);
  });
  on(surface, 'pointerleave', () => host.look(null));
  on(surface, 'click', (event) => {
    if (steady) host.pin(placeOf(event));
    steady = false;
  });

  on(cursor, 'focus', () => host.focused());
  for (const box of boxes)
    on(box, 'focusout', ({ relatedTarget }) => {
      if (!boxes.some((each) => each.contains(relatedTarget as Node | null))) host.blurred();
    });
  on(cursor, 'keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const arrow = ARROWS[event.key];
    const pixels = event.shiftKey ? STEP.coarse : STEP.fine;
    if (arrow !== undefined) host.step(arrow[0] * pixels, arrow[1] * pixels);
    else if (event.key === 'Enter') host.pinHere();
    else return;
    event.preventDefault();
  });
  // Escape that removes a pin must do nothing else, such as closing a dialog around the viewer.
  for (const target of [surface, ...boxes])
    on(target, 'keydown', (event) => {
      if (event.key === 'Escape' && host.release()) event.preventDefault();
    });
}
