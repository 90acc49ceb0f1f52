// What a screen reader finds beside the picture, and what is announced: a description of keys,
// camera and lights, and a live region. Follows drawn frames, at most once a second; announces only
// what the user changed.
import { html, nothing, type ReactiveController, type TemplateResult } from 'lit';
import type { ViewerTexts } from '../fields/texts.js';
import { fieldsOf } from '../internals.js';
import type { PhongLight, PhongViewer } from '../elements.js';
import { lightName } from '../phong-light.js';
import type { CameraMove, ViewerContext } from './viewer-context.js';
import {
  cameraText,
  keysText,
  lightCountText,
  lightNameText,
  lightsText,
  lightText,
  NAMED,
} from './description.js';
import type { ViewerTree } from './viewer-tree.js';

/**
 * Milliseconds. After this long without a change the user has stopped, so announcements are at
 * least this far apart. Also the time between two updates of the description while the picture
 * moves.
 */
const PAUSE = 1000;

/** Most lights in one announcement. */
const ANNOUNCED = 3;

/** Events in which the panel, and what lies over the picture, write to lights. */
const PANEL_EVENTS = ['input', 'change', 'click', 'keydown', 'pointermove'] as const;

export class ViewerAnnouncements implements ReactiveController {
  readonly #viewer: PhongViewer;
  /** The live region's text; null before its first use. */
  #spoken: string | null = null;
  #timer = 0;
  /** Camera and lights in words; null before the first picture. */
  #scene: string | null = null;
  #language: ViewerTexts | null = null;
  #cameraMoved = false;
  /** Lights were added, removed or moved. */
  #counted = false;
  readonly #lights = new Set<PhongLight>();
  #panelEvent: Event | null = null;

  constructor({ viewer, signals }: ViewerContext) {
    this.#viewer = viewer;
    signals.drawn.listen(() => this.#describeSoon());
    signals.cameraMoved.listen((move) => this.#follow(move));
    signals.lightsReported.listen((lights) => this.#lightsChanged(lights));
  }

  connect({ layer, panel }: ViewerTree): void {
    for (const part of [panel, layer]) {
      for (const type of PANEL_EVENTS) {
        part.addEventListener(type, (event) => (this.#panelEvent = event), {
          capture: true,
          passive: true,
        });
      }
    }
  }

  template(): TemplateResult | typeof nothing {
    return this.#spoken === null ? nothing : html`<p aria-live="polite">${this.#spoken}</p>`;
  }

  get description(): string {
    return `${keysText(this.#viewer, this.#texts)} ${this.#scene ?? ''}`.trim();
  }

  hostDisconnected(): void {
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#forget();
  }

  hostUpdated(): void {
    if (this.#scene !== null && this.#language !== this.#texts) {
      this.#describeSoon();
    }
  }

  #describeSoon() {
    if (this.#timer === 0) {
      this.#wait(this.#scene === null ? 0 : PAUSE);
    }
  }

  /** The viewer that the user moves speaks for those linked to it. */
  #follow({ source, linked }: CameraMove) {
    if (source === 'script' || source === 'auto' || linked) return;
    this.#cameraMoved = true;
    this.#userActed();
  }

  /**
   * Lights were written to; none: they came, went or changed places. Call when `light-change` is
   * dispatched.
   */
  #lightsChanged(lights: readonly PhongLight[]) {
    // These write while an event of the user is dispatched to them. All other writes are a
    // script's.
    if ((this.#panelEvent?.eventPhase ?? Event.NONE) === Event.NONE) return;
    if (lights.length === 0) {
      this.#counted = true;
    }
    for (const light of lights) {
      this.#lights.add(light);
    }
    this.#userActed();
  }

  #userActed() {
    // Screen readers announce only changes of a region that is there already.
    if (this.#spoken === null) {
      this.#spoken = '';
      this.#viewer.requestUpdate();
    }
    // A new timer instead of a longer one: once the user has stopped, only the announcement itself
    // is left to do.
    clearTimeout(this.#timer);
    this.#wait(PAUSE);
  }

  #wait(ms: number) {
    this.#timer = window.setTimeout(() => {
      this.#timer = 0;
      const [spoken, scene] = [this.#spoken, this.#scene];
      this.#announce();
      this.#describe();
      if (this.#spoken !== spoken || this.#scene !== scene) {
        this.#viewer.requestUpdate();
      }
    }, ms);
  }

  #announce() {
    const { camera, lights } = this.#viewer;
    const texts = this.#cameraMoved ? [cameraText(this.#texts, camera)] : [];
    if (this.#counted) {
      texts.push(lightCountText(this.#texts, lights.length));
    }
    const changed = [...this.#lights].filter((light) => lights.includes(light)).slice(-ANNOUNCED);
    for (const light of changed) {
      const { store } = fieldsOf(light);
      const name = lightName(store, lights.indexOf(light), this.#texts);
      texts.push(`${lightText(this.#texts, name, store.values)}.`);
    }
    this.#forget();
    if (texts.length > 0) {
      this.#spoken = texts.join(' ');
    }
  }

  #forget() {
    this.#cameraMoved = false;
    this.#counted = false;
    this.#lights.clear();
  }

  #describe() {
    const texts = (this.#language = this.#texts);
    const { camera, lights } = this.#viewer;
    const names = lights.slice(0, NAMED + 1).map((light, i) => {
      const name = lightName(fieldsOf(light).store, i, texts);
      return lightNameText(texts, name, light);
    });
    this.#scene = `${cameraText(texts, camera)} ${lightsText(texts, names)}`;
  }

  get #texts(): ViewerTexts | null {
    return this.#viewer.texts;
  }
}
