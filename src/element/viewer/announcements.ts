// What does a screen reader find beside the picture, and what is announced? A description of camera and lights, a list of
// lights and meshes by name, and a live region. The list is a sibling of the picture: screen readers do not browse inside
// an application or an image, and ids of the children cannot be owned from inside a shadow tree.
// Follows drawn frames, at most once a second; announces only what the user changed. Knows nothing of drawing.
import { html, nothing, render, type ReactiveController } from 'lit';
import { fieldsOf } from '../internals.js';
import { numberedName, type PhongLight } from '../phong-light.js';
import type { PhongViewer } from '../phong-viewer.js';
import type { CameraSource } from './camera.js';
import {
  cameraText,
  lightCountText,
  lightName,
  lightsText,
  lightText,
  meshText,
  PHRASES,
} from './description.js';

/**
 * Milliseconds. The user has stopped after such a time without a change, so announcements are at least this far apart. Also
 * the time between two updates of the description while the picture moves.
 */
const PAUSE = 1000;

/** Lights in one announcement. */
const ANNOUNCED = 3;

/** Events in which the panel writes to lights. */
const PANEL_EVENTS = ['input', 'change', 'click', 'keydown', 'pointermove'] as const;

export class ViewerAnnouncements implements ReactiveController {
  /** Visually hidden. Belongs into the shadow tree, beside the picture. */
  readonly node = document.createElement('div');
  readonly #viewer: PhongViewer;
  #timer = 0;
  #described = false;
  /** The last announcement; null: there was none. */
  #message: string | null = null;
  #cameraMoved = false;
  /** Lights were added, removed or moved. */
  #counted = false;
  readonly #lights = new Set<PhongLight>();
  /** The last event in the panel. */
  #panelEvent: Event | null = null;

  constructor(viewer: PhongViewer) {
    this.#viewer = viewer;
    this.node.className = 'reader';
    viewer.addController(this);
    viewer.addEventListener('render', () => this.#drawn());
    viewer.addEventListener('camera-change', ({ detail }) => this.#onCamera(detail.source));
    viewer.addEventListener('light-change', ({ detail }) => this.#onLights(detail.lights));
  }

  hostConnected(): void {
    for (const type of PANEL_EVENTS)
      this.#viewer.shadowRoot?.addEventListener(type, this.#onPanel, { capture: true, passive: true });
  }

  hostDisconnected(): void {
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#forget();
  }

  #drawn(): void {
    if (this.#timer === 0) this.#wait(this.#described ? PAUSE : 0);
  }

  #onCamera(source: CameraSource): void {
    if (source === 'script' || source === 'auto') return;
    this.#cameraMoved = true;
    this.#userActed();
  }

  #onLights(lights: readonly PhongLight[]): void {
    // The panel writes while an event of the user is dispatched to it. All other writes are a script's.
    if ((this.#panelEvent?.eventPhase ?? Event.NONE) === Event.NONE) return;
    if (lights.length === 0) this.#counted = true;
    for (const light of lights) this.#lights.add(light);
    this.#userActed();
  }

  readonly #onPanel = (event: Event): void => {
    if (event.target instanceof Element && event.target.closest('.panel') !== null) this.#panelEvent = event;
  };

  #userActed(): void {
    // Screen readers announce only changes of a region that is there already.
    if (this.#message === null) {
      this.#message = '';
      this.#describe();
    }
    // A new timer instead of a longer one: once the user has stopped, only the announcement itself is left to do.
    clearTimeout(this.#timer);
    this.#wait(PAUSE);
  }

  #wait(ms: number): void {
    this.#timer = window.setTimeout(this.#update, ms);
  }

  readonly #update = (): void => {
    this.#timer = 0;
    const changes = this.#changes();
    if (changes !== '') this.#message = changes;
    this.#describe();
  };

  /** What the user changed since the last announcement, in words; empty if nothing. */
  #changes(): string {
    const { camera, lights } = this.#viewer;
    const texts = this.#cameraMoved ? [cameraText(camera)] : [];
    if (this.#counted) texts.push(lightCountText(lights.length));
    const changed = [...this.#lights].filter((light) => lights.includes(light)).slice(-ANNOUNCED);
    for (const light of changed) texts.push(`${textOf(light, lights.indexOf(light))}.`);
    this.#forget();
    return texts.join(' ');
  }

  #forget(): void {
    this.#cameraMoved = false;
    this.#counted = false;
    this.#lights.clear();
  }

  #describe(): void {
    const viewer = this.#viewer;
    this.#described = true;
    const { lights, meshes } = viewer;
    const names = lights.map((light, i) => lightName(nameOf(light, i), light));
    const items = [...lights.map(textOf), ...meshes.map((mesh, i) => meshText(mesh, i))];
    render(
      html`<p id="scene" hidden>${cameraText(viewer.camera)} ${lightsText(names)}</p>
        <ul role="list" aria-label=${PHRASES.contents} ?hidden=${items.length === 0}>
          ${items.map((item) => html`<li>${item}</li>`)}
        </ul>
        ${this.#message === null ? nothing : html`<p aria-live="polite">${this.#message}</p>`}`,
      this.node,
    );
  }
}

/** Not the element's `name`: its default takes a search through all lights. */
const nameOf = (light: PhongLight, index: number): string =>
  fieldsOf(light).store.values.name || numberedName(index);

const textOf = (light: PhongLight, index: number): string =>
  lightText(nameOf(light, index), fieldsOf(light).store.values);
