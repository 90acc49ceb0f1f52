// Two fingers on different viewers of a comparison are one gesture of the viewer under the first finger, so that a
// pinch across a divider zooms. Otherwise each finger would turn the linked cameras on its own.
import type { PhongViewer } from '../elements.js';

/** Listens to everything in `root`, the comparison's shadow root. */
export function shareTouch(root: ShadowRoot, signal: AbortSignal): void {
  const early = { signal, capture: true, passive: false };
  /** Fingers on pictures, by pointer. */
  const fingers = new Set<number>();
  /** The picture under the first finger. */
  let first: Element | null = null;
  /** A finger on another picture has joined. */
  let joined = false;
  const press = (event: PointerEvent): void => {
    // The event that is dispatched below comes by here, too.
    if (event.pointerType !== 'touch' || !event.isTrusted) return;
    const surface = linkedSurface(event);
    if (surface === null) return;
    if (first?.isConnected !== true) fingers.clear();
    if (fingers.size === 0) first = surface;
    fingers.add(event.pointerId);
    if (surface === first) return;
    joined = true;
    event.stopPropagation();
    // It captures the pointer, whose later events then come to it by themselves.
    first?.dispatchEvent(new PointerEvent('pointerdown', event));
  };
  const lift = (event: Event): void => {
    fingers.delete((event as PointerEvent).pointerId);
    if (fingers.size === 0) joined = false;
  };
  // The pictures prevent scrolling by two fingers themselves, but count only their own.
  const keep = (event: Event): void => {
    if (joined && event.cancelable) event.preventDefault();
  };
  root.addEventListener('pointerdown', (event) => press(event as PointerEvent), early);
  for (const type of ['pointerup', 'pointercancel']) root.addEventListener(type, lift, early);
  for (const type of ['touchstart', 'touchmove']) root.addEventListener(type, keep, early);
}

/** The picture that was pressed, of a viewer whose camera is linked to those of the comparison. */
function linkedSurface(event: Event): Element | null {
  const path = event.composedPath();
  const viewer = path.find((node) => (node as Partial<Element>).localName === 'phong-viewer') as
    PhongViewer | undefined;
  const surface = viewer?.shadowRoot?.querySelector('[part=surface]') ?? null;
  return viewer?.cameraGroup === '' && surface !== null && path.includes(surface) ? surface : null;
}
