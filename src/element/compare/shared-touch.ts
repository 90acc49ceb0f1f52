// Two fingers on different viewers of a comparison are one gesture of the viewer under the first finger, so that a
// pinch across a divider zooms. Otherwise each finger would turn the linked cameras on its own.
import type { PhongViewer } from '../elements.js';

export class SharedTouch {
  /** Fingers on pictures, by pointer. */
  readonly #fingers = new Set<number>();
  /** The picture under the first finger. */
  #surface: Element | null = null;
  /** A finger on another picture has joined. */
  #joined = false;

  /** Listens to everything in `root`, the comparison's shadow root. */
  constructor(root: ShadowRoot, signal: AbortSignal) {
    const early = { signal, capture: true, passive: false };
    root.addEventListener('pointerdown', (event) => this.#onPress(event as PointerEvent), early);
    for (const type of ['pointerup', 'pointercancel'] as const)
      root.addEventListener(type, (event) => this.#onLift(event as PointerEvent), early);
    // The pictures prevent scrolling by two fingers themselves, but count only their own.
    for (const type of ['touchstart', 'touchmove'] as const)
      root.addEventListener(
        type,
        (event) => {
          if (this.#joined && event.cancelable) event.preventDefault();
        },
        early,
      );
  }

  #onPress(event: PointerEvent): void {
    // The event that is dispatched below comes by here, too.
    if (event.pointerType !== 'touch' || !event.isTrusted) return;
    const surface = linkedSurface(event);
    if (surface === null) return;
    if (this.#surface?.isConnected !== true) this.#fingers.clear();
    if (this.#fingers.size === 0) this.#surface = surface;
    this.#fingers.add(event.pointerId);
    if (surface === this.#surface) return;
    this.#joined = true;
    event.stopPropagation();
    // It captures the pointer, whose later events then come to it by themselves.
    this.#surface?.dispatchEvent(new PointerEvent('pointerdown', event));
  }

  #onLift({ pointerId }: PointerEvent): void {
    this.#fingers.delete(pointerId);
    if (this.#fingers.size === 0) this.#joined = false;
  }
}

/** The picture that was pressed, of a viewer whose camera is linked to those of the comparison. */
function linkedSurface(event: Event): Element | null {
  const path = event.composedPath();
  const viewer = path.find((node) => (node as Partial<Element>).localName === 'phong-viewer') as
    PhongViewer | undefined;
  const surface = viewer?.shadowRoot?.querySelector('[part=surface]') ?? null;
  return viewer?.cameraGroup === '' && surface !== null && path.includes(surface) ? surface : null;
}
