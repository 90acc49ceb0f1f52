// What the elements tell by events: names, details and when. The one list from which `addEventListener`, JSX and the
// editors' data take their types and words. Types only.
import type { PhongLight } from './phong-light.js';
import type { CameraSource } from './viewer/camera.js';
import type { ViewerErrorDetail } from './viewer/loading.js';

/** Events of `<phong-mesh>`. None bubbles. */
export interface PhongMeshEventMap {
  /** Its `src` is shown; `detail.url` is where it came from. */
  load: CustomEvent<{ readonly url: string }>;
  /** Its `src` cannot be shown; `detail.code` and `detail.message` say why. */
  error: CustomEvent<ViewerErrorDetail>;
}

/** Events of `<phong-viewer>`. None bubbles; several of one kind in a task become one. */
export interface PhongViewerEventMap {
  /** A `src` is shown, the viewer's own or a child's; `detail.url` is where it came from. */
  load: CustomEvent<{ readonly url: string }>;
  /** Bytes of models have come; `detail.totalProgress` from 0 to 1. */
  progress: CustomEvent<{ readonly totalProgress: number }>;
  /** Something failed; `detail.code` and `detail.message` say what, `detail.url` where it is about a load. */
  error: CustomEvent<ViewerErrorDetail>;
  /** The camera moved; `detail.source` says by what. */
  'camera-change': CustomEvent<{ readonly source: CameraSource }>;
  /** Lights were written to (`detail.lights`, in the order of the writing), or came, went or changed places (then it may be empty). */
  'light-change': CustomEvent<{ readonly lights: readonly PhongLight[] }>;
  /** A frame was drawn. */
  render: CustomEvent<null>;
}

/** All events by name, the ones every element has too. */
export type HeardEvents<Own> = Omit<HTMLElementEventMap, keyof Own> & Own;

/** `addEventListener` and `removeEventListener` of an element with events of its own. */
export interface Listen<E, Own> {
  <K extends keyof HeardEvents<Own>>(
    type: K,
    listener: (this: E, event: HeardEvents<Own>[K]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  (
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
}
