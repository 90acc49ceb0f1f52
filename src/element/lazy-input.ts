// The hands on a picture before the code that understands them is there: fetches it with the first sign of a pointer or the
// focus, keeps what happens meanwhile, and hands it over in order, so that the first press drags like any other. Knows nothing
// of cameras.
import type { OrbitInput, OrbitInputHost } from '../camera/orbit-input.js';
import { fetched } from './fetched.js';

/** What may be on its way to a press, a turn of the wheel or a key: the code is fetched. */
const SIGNS = ['pointerover', 'focusin', 'pointerdown', 'wheel', 'keydown'] as const;
/** What only counts after one of those. */
const CONSEQUENCES = [
  'pointermove',
  'pointerup',
  'pointercancel',
  'lostpointercapture',
  'contextmenu',
] as const;

/** Keys that may be the camera's: the page must not scroll by them too. */
const CAMERA_KEY = /^(Arrow|Page|Home$|[-+=_]$)/;

export class LazyInput {
  readonly #surface: HTMLElement;
  readonly #host: OrbitInputHost;
  #input: OrbitInput | null = null;
  #listeners: AbortController | null = null;
  #fetching = false;
  #kept: Event[] = [];

  constructor(surface: HTMLElement, host: OrbitInputHost) {
    this.#surface = surface;
    this.#host = host;
  }

  get dragging(): boolean {
    return this.#input?.dragging === true;
  }

  connect(): void {
    this.#input?.connect();
    if (this.#input !== null || this.#listeners !== null) return;
    this.#listeners = new AbortController();
    const options = { signal: this.#listeners.signal, passive: false };
    for (const type of [...SIGNS, ...CONSEQUENCES]) this.#surface.addEventListener(type, this.#keep, options);
  }

  disconnect(): void {
    this.#input?.disconnect();
    this.#stopKeeping();
  }

  renote(): void {
    this.#input?.renote();
  }

  readonly #keep = (event: Event): void => {
    const { type } = event;
    if (event.defaultPrevented) return;
    if ((SIGNS as readonly string[]).includes(type)) void this.#fetch();
    else if (this.#kept.length === 0) return;
    const { orbit, zoom } = this.#host.allows();
    if (event instanceof KeyboardEvent) {
      if (event.ctrlKey || event.altKey || event.metaKey || !(orbit || zoom) || !CAMERA_KEY.test(event.key))
        return;
      event.preventDefault();
    } else if (event instanceof WheelEvent) {
      if (!zoom || !this.#surface.matches(':focus')) return;
      event.preventDefault();
    } else if (type === 'contextmenu') {
      event.preventDefault(); // nobody knows yet whether what was pressed drags
      return;
    } else if (!(event instanceof PointerEvent) || type === 'pointerover') {
      return;
    } else if (type === 'pointerdown') {
      capture(this.#surface, event.pointerId);
    }
    this.#kept.push(event);
  };

  async #fetch(): Promise<void> {
    if (this.#fetching) return;
    this.#fetching = true;
    const code = await fetched(() => import('../camera/orbit-input.js'), 'drags, wheel and keys');
    const kept = this.#kept;
    this.#kept = [];
    // Browsers remember what could not be fetched: it would be in vain to ask again.
    if (code === null) return;
    this.#fetching = false;
    // Taken out of the page meanwhile, it waits for the next sign.
    if (this.#listeners === null) return;
    this.#stopKeeping();
    this.#input = new code.OrbitInput(this.#surface, this.#host);
    this.#input.connect();
    for (const event of kept) this.#input.take(event);
  }

  #stopKeeping(): void {
    this.#listeners?.abort();
    this.#listeners = null;
    this.#kept = [];
  }
}

function capture(surface: HTMLElement, pointerId: number): void {
  try {
    surface.setPointerCapture(pointerId);
  } catch {
    // A pointer that is gone already, or one made by a script.
  }
}
