// The elements' events, for `addEventListener`, JSX and the editors' data: names, details, when
// they come. Types only.
import type { CameraSource, PhongLight } from './elements.js';
import type { FragmentExplanation } from './explanation.js';
import type { ViewerErrorCode } from './fields/texts.js';

export interface ViewerErrorDetail {
  readonly code: ViewerErrorCode;
  /** For the page's author. */
  readonly message: string;
  /** The address that could not be loaded; null if the error is about something else. */
  readonly url: string | null;
}

/** What was loaded. */
export interface LoadDetail {
  readonly url: string;
  /**
   * Images and material libraries that are missing or broken, by the names in the model; empty if
   * all are there.
   */
  readonly missing: readonly string[];
}

/** Events of `<phong-mesh>`. None bubbles. */
export interface PhongMeshEventMap {
  /**
   * Its `src` is shown; `detail.url` is where it came from, `detail.missing` what it is shown
   * without.
   */
  load: CustomEvent<LoadDetail>;
  /** Its `src` cannot be shown; `detail.code` and `detail.message` say why. */
  error: CustomEvent<ViewerErrorDetail>;
}

/** What the probe shows. */
export interface ProbeDetail {
  /** As by `shadeAt`; null where none is explained. */
  readonly fragment: FragmentExplanation | null;
  /** Where it is, as `shadeAt` takes it. Null outside the picture, and while nothing is shown. */
  readonly x: number | null;
  readonly y: number | null;
  /** It stays there when the mouse moves. */
  readonly pinned: boolean;
}

/** An answer to a question of `probe="ask"`. */
export interface AnswerDetail {
  readonly term: 'ambient' | 'diffuse' | 'specular' | 'sum';
  /** Null for the sum and the head-light. */
  readonly light: PhongLight | null;
  /** Null where all channels are equal. */
  readonly channel: 'red' | 'green' | 'blue' | null;
  /** As typed, and as a number; null if it is none. */
  readonly text: string;
  readonly value: number | null;
  readonly expected: number;
  readonly correct: boolean;
  /** The likeliest one that gives this value. Null for right answers and unusual ones. */
  readonly mistake:
    | 'digits'
    | 'left-out'
    | 'unclamped'
    | 'angle'
    | 'radians'
    | 'sine'
    | 'exponent'
    | 'times-exponent'
    | 'other-value'
    | 'attenuation'
    | 'aperture'
    | 'cone'
    | 'behind'
    | 'scale'
    | null;
}

/**
 * Events of `<phong-viewer>`. None bubbles. `progress`, `camera-change` and `light-change` come
 * once for a task, however many there were.
 */
export interface PhongViewerEventMap {
  /**
   * A `src` is shown, the viewer's own or a child's; `detail.url` is where it came from,
   * `detail.missing` what it is shown without.
   */
  load: CustomEvent<LoadDetail>;
  /** Bytes of models have arrived; `detail.totalProgress` is from 0 to 1. */
  progress: CustomEvent<{ readonly totalProgress: number }>;
  /**
   * Something failed; `detail.code` and `detail.message` say what, `detail.url` which address, if
   * any.
   */
  error: CustomEvent<ViewerErrorDetail>;
  /**
   * The camera moved; `detail.source` says what moved it. `detail.linked`: it followed another
   * viewer of its `camera-group`.
   */
  'camera-change': CustomEvent<{ readonly source: CameraSource; readonly linked?: true }>;
  /**
   * Lights were written to (`detail.lights`, in that order), added, removed or reordered (then it
   * may be empty).
   */
  'light-change': CustomEvent<{ readonly lights: readonly PhongLight[] }>;
  /**
   * The probe shows another point, or the point has changed: `detail.fragment` at `detail.x` and
   * `detail.y`.
   */
  'probe-change': CustomEvent<ProbeDetail>;
  /** The user answered a question of `probe="ask"`. */
  answer: CustomEvent<AnswerDetail>;
  /** A changed picture is on the canvas. Its pixels can be read in the listener, but not later. */
  render: CustomEvent<null>;
}

/** Events of `<phong-compare>`. None bubbles. */
export interface PhongCompareEventMap {
  /** The user moved a divider; `detail.at` are the places of all, in percent. */
  'divider-change': CustomEvent<{ readonly at: readonly number[] }>;
}

/** All events by name, including those of every element. */
type HeardEvents<Own> = Omit<HTMLElementEventMap, keyof Own> & Own;

/** `addEventListener` and `removeEventListener` of an element with its own events. */
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
