// <phong-viewer>: turns attributes and children into the picture's state, input into camera moves,
// changes into events.
import { LitElement, type PropertyValues, type TemplateResult } from 'lit';
import type { Scene } from 'three';
import { FieldStore } from '../../phong/fields/field-store.js';
import type {
  CameraState,
  FragmentExplanation,
  LightsByName,
  Listen,
  PhongLight,
  PhongMesh,
  PhongViewer as PublicViewer,
  PhongViewerEventMap,
  PictureOptions,
  ShadeOptions,
  ViewerClass,
} from './elements.js';
import { renderWhereShown } from './dom.js';
import { explanationCode } from './extra-code.js';
import { attributesOf, defineProperties, FieldBinding } from './fields/field-binding.js';
import { upgradeProperty, type ViewerTexts } from './fields/texts.js';
import {
  RETRY_KEYS,
  VIEWER_FIELDS,
  type ViewerProperties,
  type ViewerValues,
} from './fields/viewer-fields.js';
import { viewerHosts } from './internals.js';
import { assignTexts, leaveTexts, pageTexts, useTexts } from './page/page-texts.js';
import { addStyles } from './page/style-sheets.js';
import { Visibility } from './page/visibility.js';
import ownText from './page/own-text.css?inline';
import styles from './phong-viewer.css?inline';
import { CAMERA_KEYS, ViewerCamera } from './viewer/camera.js';
import { ViewerChildren } from './viewer/children.js';
import { ViewerContext } from './viewer/viewer-context.js';
import { ViewerDisplay } from './viewer/display.js';
import { EventQueue } from './viewer/event-queue.js';
import { ViewerExtras } from './viewer/extras.js';
import { ViewerFailure } from './viewer/failure.js';
import { ViewerLoading } from './viewer/loading.js';
import { ViewerPanel } from './viewer/viewer-panel.js';
import { NAMING } from './viewer/description.js';
import { Readiness } from './viewer/readiness.js';
import { setLights } from './viewer/set-lights.js';
import { sceneMarkup } from './viewer/to-html.js';

// The accessors come from the table of fields.
interface ViewerElement extends ViewerProperties {
  readonly localName: 'phong-viewer';
  addEventListener: Listen<this, PhongViewerEventMap>;
  removeEventListener: Listen<this, PhongViewerEventMap>;
}

/** Properties that no attribute has, with those that can only be read. */
const OTHER_PROPERTIES = [
  'texts',
  'maxTriangles',
  'maxMemory',
  'camera',
  'lights',
  'meshes',
  'loaded',
  'scene',
  'stats',
  'ready',
] as const satisfies readonly (keyof PublicViewer)[];

/**
 * Shows a Phong-lit 3D scene. Lights and meshes are elements inside it, at any depth; it needs its
 * end tag. CSS sets its size, 300 × 150 pixels if it sets none. Where nothing is drawn the canvas
 * is transparent. Properties have the attributes' names in camel case. A bad attribute value warns
 * and gives the default; a bad property value throws.
 *
 * @slot - `<phong-light>` and `<phong-mesh>` elements, alone or in wrappers
 * @slot poster - an image in place of `poster`, which is shown without script too
 * @slot progress - in place of the element's own progress bar, once loading takes more than 300 ms
 * @slot error - in place of the element's own message and button when something fails
 * @csspart surface - the picture, without the panel
 * @csspart poster - the image shown before the first picture
 * @csspart progress - the element's own progress bar; `color` is that of what has arrived
 * @csspart notice - the element's own message when something fails
 * @csspart retry - the button under that message: tries again
 * @csspart dismiss - the button beside a message about a file of the user's own: removes it
 * @csspart panel - the control panel's place
 * @csspart legend - what the colours of `view` mean
 * @csspart probe - the box of `probe`: a point's colour and the table of its sum
 * @csspart light-name - the name of a light that `helpers` draws
 * @cssState loading - something requested has not arrived yet
 * @cssState error - something has failed and still does
 * @cssState empty - nothing to show is declared, and `scene` holds no object
 */
class ViewerElement extends LitElement implements PublicViewer {
  static override readonly shadowRootOptions: ShadowRootInit = {
    mode: 'open',
    delegatesFocus: true,
  };
  static override get observedAttributes(): string[] {
    return [...super.observedAttributes, ...attributesOf(VIEWER_FIELDS), ...NAMING];
  }

  static get texts(): ViewerTexts | null {
    return pageTexts();
  }

  static set texts(texts: ViewerTexts | null | undefined) {
    assignTexts(texts);
  }

  readonly #store = new FieldStore<ViewerValues>(VIEWER_FIELDS);
  readonly #binding = new FieldBinding<ViewerValues>(this, this.#store, (key) => {
    this.#camera.assigned(key);
    if (RETRY_KEYS.has(key)) {
      this.requestUpdate(key);
    }
  });

  readonly #holder = Object.assign(document.createElement('div'), { className: 'holder' });
  readonly #context = new ViewerContext(this, this.#store, this.#holder);
  readonly #events = new EventQueue(this, this.#context.signals.lightsReported);
  readonly #panel = new ViewerPanel(this.#context);
  readonly #failure = new ViewerFailure(this.#context, this.#events);
  readonly #readiness = new Readiness(this.#context.signals, () => this.#settled());
  readonly #loading = new ViewerLoading(this.#context, this.#events, this.#failure);
  readonly #children = new ViewerChildren(this.#context, this.#loading);
  readonly #camera: ViewerCamera = new ViewerCamera(this.#context);
  readonly #visibility = new Visibility(this, this.#holder, this.#context.signals.viewChanged, () =>
    this.disconnectedCallback(),
  );
  readonly #extras = new ViewerExtras(this.#context, this.#camera, this.#visibility);
  readonly #display = new ViewerDisplay(this.#context, this.#loading, this.#failure, this.#extras);

  constructor() {
    super();
    const { signals, lightSet } = this.#context;
    this.#store.listen((key) => !CAMERA_KEYS.has(key) && this.requestUpdate(key));
    signals.awaited = () => this.#loading.awaited || this.#extras.awaited;
    signals.layoutNeeded.listen(() => this.#visibility.measureNow());
    lightSet.changed.listen((light) => this.#events.enqueueLight(light));
    signals.cameraMoved.listen(({ source, linked }) => {
      // The first framing is not a move.
      if (this.hasUpdated) {
        this.#events.enqueue('camera-change', linked ? { source, linked } : { source });
      }
    });
    // Visibility first: it brings the holder into the element's document.
    for (const part of [this.#visibility, this.#camera, this.#loading]) {
      this.addController(part);
    }
    viewerHosts.set(this, this.#extras.host);
    renderWhereShown(this);
  }

  get lights(): readonly PhongLight[] {
    return this.#children.lights;
  }

  setLights(lights: LightsByName): void {
    setLights(this, lights);
  }

  get meshes(): readonly PhongMesh[] {
    return this.#children.meshes;
  }

  get camera(): CameraState {
    this.#update();
    return this.#camera.state();
  }

  get loaded(): boolean {
    this.#update();
    return this.#loading.loaded;
  }

  get texts(): ViewerTexts | null {
    return this.#display.texts;
  }

  set texts(texts: ViewerTexts | null | undefined) {
    this.#display.texts = texts;
  }

  get scene(): Scene {
    return this.#context.picture.scene;
  }

  get maxTriangles(): number {
    return this.#context.picture.budget.limit;
  }

  set maxTriangles(triangles: number | null | undefined) {
    this.#context.picture.budget.limit = triangles ?? null;
    this.#limited();
  }

  get maxMemory(): number {
    return this.#context.picture.budget.memory;
  }

  set maxMemory(bytes: number | null | undefined) {
    this.#context.picture.budget.memory = bytes ?? null;
    this.#limited();
  }

  #limited() {
    this.#context.picture.invalidate(); // other levels of detail may fit
    if (this.hasUpdated) {
      this.#loading.retry();
    }
  }

  get stats(): PublicViewer['stats'] {
    return { lightsDeclared: this.lights.length, ...this.#context.viewport.stats };
  }

  get ready(): Promise<void> {
    // Observers report what was just shown only after a frame.
    if (!this.#context.viewport.drawable) {
      this.#visibility.measureNow();
    }
    return this.#readiness.promise;
  }

  requestRender(): void {
    this.#context.picture.invalidate();
  }

  refit(): void {
    this.#context.picture.refit();
  }

  async toBlob(options: PictureOptions = {}): Promise<Blob> {
    this.#update();
    return this.#extras.toBlob(options);
  }

  async shadeAt(x: number, y: number, options?: ShadeOptions): Promise<FragmentExplanation | null> {
    this.#update();
    const snapshot = this.#extras.snapshot();
    return (await explanationCode()).shadeAt(snapshot, x, y, options);
  }

  async explain(point: readonly [number, number, number]): Promise<FragmentExplanation | null> {
    this.#update();
    const snapshot = this.#extras.snapshot();
    return (await explanationCode()).explain(snapshot, point);
  }

  toHTML(): string {
    return sceneMarkup(this);
  }

  resetCamera(): void {
    this.#camera.reset();
  }

  override connectedCallback(): void {
    if (this.ownerDocument.defaultView === null) return; // a document that no window shows
    super.connectedCallback();
    addStyles(this.renderRoot as ShadowRoot, ownText);
    addStyles(this.renderRoot as ShadowRoot, styles);
    useTexts(this);
    this.#binding.upgrade();
    for (const key of OTHER_PROPERTIES) {
      upgradeProperty(this, key);
    }
    // At once rather than at the end of the task: scripts may ask for the camera right after.
    this.performUpdate();
    this.#children.connected();
    this.#context.viewport.attach();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    leaveTexts(this);
    this.#context.viewport.detach();
    this.#readiness.check();
  }

  /**
   * The browser calls it after `moveBefore`; without it, it would disconnect and connect the
   * element. A comparison calls it when it has placed the viewer.
   */
  connectedMoveCallback(): void {
    this.#visibility.measureNow();
    this.#extras.apply();
  }

  override attributeChangedCallback(name: string, old: string | null, text: string | null): void {
    super.attributeChangedCallback(name, old, text);
    if (!this.#binding.attributeChanged(name, text)) {
      this.requestUpdate();
    }
  }

  protected override willUpdate(changed: PropertyValues): void {
    if (changed.size > 0) {
      this.#apply(changed as ReadonlyMap<string, unknown>);
    }
    if (this.hasUpdated) {
      this.#display.keepFocus(this.renderRoot);
    }
  }

  protected override render(): TemplateResult {
    return this.#display.template();
  }

  protected override firstUpdated(): void {
    this.#camera.listenTo(this.#display.connect(this.renderRoot));
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.has('gui')) {
      void this.#panel.toggle(this.#store.values.gui, this.#display.panel);
    }
    if (changed.size > 0) {
      this.#panel.changed('viewer');
    }
    this.#display.updated(changed.size > 0);
  }

  #apply(changed: { has(key: string): boolean }) {
    const { values } = this.#store;
    const { viewport, picture } = this.#context;
    const { shading, reflection, terms } = values;
    picture.fit.fov = values.fov;
    picture.linear = values.colorInterpolation === 'linear';
    viewport.still.wanted = values.antialias === 'full' ? values.samples : 0;
    if (STYLE_KEYS.some((key) => changed.has(key))) {
      picture.style = { shading, reflection, terms };
    }
    if (changed.has('src')) {
      this.#readiness.supersede();
    }
    this.#loading.apply(changed);
    if (changed.has('loading')) {
      this.#visibility.shown();
    }
    viewport.isWhole = values.pixelRatio !== 'auto';
    this.#visibility.maxRatio = values.pixelRatio === 'auto' ? Infinity : values.pixelRatio;
    if (changed.has('autoRotate') && this.#camera.turning) {
      viewport.animate();
    }
  }

  /** Applies now what was written in this task and would otherwise wait for its end. */
  #update() {
    if (this.isUpdatePending && this.hasUpdated) {
      this.performUpdate();
    } else if (!this.hasUpdated) {
      this.#apply({ has: () => true }); // never connected: there is no shadow tree to update
    }
    if (this.#visibility.connected && !this.#visibility.measured) {
      this.#visibility.measureNow();
    }
    this.#children.sort();
    this.#children.flush();
  }

  #settled(): boolean {
    this.#update();
    if (!this.#visibility.connected) return true;
    if (this.#loading.pending || this.#extras.pending !== null || isUnplaced(this)) return false;
    const { viewport } = this.#context;
    const converging = viewport.still.pending && !this.#camera.moving;
    if (!viewport.drawable) return true;
    if (!viewport.upToDate || converging) return false;
    if (viewport.reduced) {
      viewport.finish();
    }
    return true;
  }
}

defineProperties(ViewerElement.prototype, VIEWER_FIELDS);

export type PhongViewer = PublicViewer;
export const PhongViewer: ViewerClass = ViewerElement;

/** In a comparison that has not placed it yet. */
const isUnplaced = ({ parentElement, assignedSlot }: PublicViewer) =>
  parentElement?.localName === 'phong-compare' &&
  parentElement.shadowRoot !== null &&
  assignedSlot === null;

const STYLE_KEYS = ['shading', 'reflection', 'terms'] as const;
