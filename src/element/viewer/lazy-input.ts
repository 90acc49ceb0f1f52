// The hands on a picture before the code that understands them is there: fetches it with the first sign of a pointer or the
// focus, keeps what happens meanwhile, and hands it over in order, so that the first press drags like any other. Knows nothing
// of cameras.
import type { OrbitInput, OrbitInputHost } from '../../camera/orbit-input.js';
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
  #failed = false;
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
    if (this.#input !== null || this.#listeners !== null || this.#failed) return;
    this.#listeners = new AbortController();
    const options = { signal: this.#listeners.signal, passive: false };
    for (const type of [...SIGNS, ...CONSEQUENCES]) this.#surface.addEventListener(type, this.#keep, options);
  }

  disconnect(): void {
    this.#input?.disconnect();
    this.#stopKeeping();
  }

  reanchor(): void {
    this.#input?.reanchor();
  }

  readonly #keep = (event: Event): void => {
    const { type } = event;
    if (event.defaultPrevented) return;
    if ((SIGNS as readonly string[]).includes(type)) void this.#fetch();
    else if (this.#kept.length === 0) return;
    if (type === 'pointerdown') capture(this.#surface, (event as PointerEvent).pointerId);
    // What the page would do with a key or the wheel it must not do as well; nor open a menu: what was pressed may drag.
    else if (type === 'contextmenu' || this.#isKey(event) || this.#isWheel(event)) event.preventDefault();
    else if (!/^(lost)?pointer(?!over)/.test(type)) return;
    this.#kept.push(event);
  };

  #isKey(event: Event): boolean {
    if (!(event instanceof KeyboardEvent) || event.ctrlKey || event.altKey || event.metaKey) return false;
    const { orbit, zoom } = this.#host.allows();
    return (orbit || zoom) && CAMERA_KEY.test(event.key);
  }

  #isWheel({ type }: Event): boolean {
    return type === 'wheel' && this.#host.allows().zoom && this.#surface.matches(':focus');
  }

  async #fetch(): Promise<void> {
    if (this.#fetching) return;
    this.#fetching = true;
    const code = await fetched(() => import('../../camera/orbit-input.js'), 'drags, wheel and keys');
    const kept = this.#kept;
    this.#kept = [];
    if (code === null) {
      // Browsers remember what could not be fetched: it would be in vain to ask again.
      this.#failed = true;
      this.#stopKeeping();
      return;
    }
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
