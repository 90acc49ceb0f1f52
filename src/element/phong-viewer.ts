// <phong-viewer>: the element. It translates attributes and children into state for the picture, input into camera moves,
// and what happens into events. It computes no light and draws nothing itself.
import { type PropertyValues, ReactiveElement } from '@lit/reactive-element';
import type { Scene } from 'three';
import { FieldStore } from '../fields/field-store.js';
import { LightSet } from '../light/light-set.js';
import { Viewport } from '../scene/viewport.js';
import type { Listen, PhongViewerEventMap } from './events.js';
import type { ViewerTexts } from './fields/texts.js';
import { attributesOf, defineProperties, FieldBinding } from './fields/field-binding.js';
import type { ViewerProperties } from './fields/properties.js';
import { RETRY_KEYS, VIEWER_FIELDS, type ViewerValues } from './fields/viewer-fields.js';
import { viewerCameras } from './internals.js';
import { addStyles } from './page/style-sheets.js';
import { Visibility } from './page/visibility.js';
import type { PhongLight } from './phong-light.js';
import type { PhongMesh } from './phong-mesh.js';
import styles from './phong-viewer.css?inline';
import { CAMERA_KEYS, type CameraSource, type CameraState, ViewerCamera } from './viewer/camera.js';
import { ViewerChildren } from './viewer/children.js';
import { ViewerDisplay } from './viewer/display.js';
import { EventQueue } from './viewer/event-queue.js';
import { ViewerFailure } from './viewer/failure.js';
import { ViewerLoading } from './viewer/loading.js';
import { ViewerPanel } from './viewer/panel.js';
import type { PictureOptions } from './viewer/picture-blob.js';
import { NAMING } from './viewer/naming.js';
import { applyStyle } from './viewer/picture-style.js';
import { Readiness } from './viewer/readiness.js';
import type { FragmentExplanation } from './viewer/shade-at.js';
import type { ViewerStats } from './viewer/stats.js';
import { sceneMarkup } from './viewer/to-html.js';
import { blobOf, lazy, type ViewerSnapshot, viewerSnapshot } from './viewer/viewer-snapshot.js';

export interface PhongViewer extends ViewerProperties {
  readonly localName: 'phong-viewer';
  addEventListener: Listen<this, PhongViewerEventMap>;
  removeEventListener: Listen<this, PhongViewerEventMap>;
}

/**
 * Shows a Phong-lit 3D scene. Lights and meshes are elements inside it, at any depth. Properties have the attributes'
 * names in camel case. A bad attribute value warns and gives the default; a bad property value throws.
 *
 * @slot - `<phong-light>` and `<phong-mesh>` elements, alone or in wrappers; none of it is displayed
 * @slot progress - shown instead of the element's own progress bar, while something has been loading for more than 300 ms
 * @slot error - shown instead of the element's own message and button when something fails
 * @csspart surface - the picture, without the panel
 * @csspart poster - the image shown before the first picture
 * @csspart progress - the element's own progress bar; its `color` is that of the share that has arrived
 * @csspart notice - the element's own message when something fails
 * @csspart retry - the button under that message, which tries again what failed
 * @csspart panel - the control panel's place
 * @csspart legend - what the colours of `view` mean
 * @csspart probe - the box of `probe`: a point's colour and the table of its sum
 * @cssState loading - something requested has not arrived yet
 * @cssState error - something has failed and still does
 * @cssState empty - nothing to show is declared, and `scene` holds no object
 */
export class PhongViewer extends ReactiveElement {
  static override readonly shadowRootOptions: ShadowRootInit = { mode: 'open', delegatesFocus: true };
  static override get observedAttributes(): string[] {
    return [...super.observedAttributes, ...attributesOf(VIEWER_FIELDS), ...NAMING];
  }

  readonly #store = new FieldStore<ViewerValues>(VIEWER_FIELDS);
  readonly #binding = new FieldBinding<ViewerValues>(this, this.#store, (key) => {
    this.#camera.assigned(key);
    if (RETRY_KEYS.has(key)) this.requestUpdate(key);
  });

  readonly #holder: HTMLElement = Object.assign(document.createElement('div'), { className: 'holder' });
  readonly #events = new EventQueue(this, (lights) => this.#display.lightsChanged(lights));
  readonly #panel = new ViewerPanel(this);
  readonly #failure = new ViewerFailure(this, this.#events);
  readonly #readiness = new Readiness(() => this.#settled);
  readonly #lightSet = new LightSet((light) => {
    this.#viewport.invalidate();
    this.#events.enqueueLight(light);
    this.#panel.changed(light === null ? 'lights' : 'light');
  });
  readonly #viewport = new Viewport(this.#holder, this.#lightSet, {
    needsLayout: () => this.#visibility.look(),
    beforeFrame: (now) => {
      this.#children.sort();
      return this.#camera.frame(now);
    },
    painted: () => this.#loading.drawn(),
    undrawable: (error, draw): boolean => this.#loading.undrawable(error, draw),
    drawn: () => this.#display.drawn(),
    afterFrame: () => this.#readiness.check(),
    fitted: () => this.#camera.fitted(),
    contextMissing: (error) => this.#failure.contextMissing(error),
    contextLost: () => this.#failure.contextLost(),
    contextRestored: () => this.#failure.contextRestored(),
  });
  readonly #loading: ViewerLoading = new ViewerLoading({
    viewer: this,
    store: this.#store,
    viewport: this.#viewport,
    events: this.#events,
    elementOf: (mesh) => this.#children.elementOf(mesh),
    childMeshes: () => this.#children.sceneMeshes,
    failed: (mesh, detail) => this.#failure.report(mesh, detail),
    cleared: (mesh) => {
      this.#failure.cleared(mesh);
      queueMicrotask(() => this.#readiness.check());
    },
    ended: () => this.#readiness.check(),
    updated: () => this.#display.update(),
  });
  readonly #children: ViewerChildren = new ViewerChildren(this, {
    viewport: this.#viewport,
    lightSet: this.#lightSet,
    meshHost: this.#loading,
    meshesChanged: () => {
      this.#panel.changed('meshes');
      this.#display.checkEmpty();
    },
  });
  readonly #camera: ViewerCamera = new ViewerCamera({
    values: this.#store.values,
    viewport: this.#viewport,
    moved: (source, linked) => this.#cameraMoved(source, linked),
  });
  readonly #visibility = new Visibility(this, this.#holder, (view) => {
    if (view.near) this.#loading.neared();
    this.#viewport.resize(view.pixelWidth, view.pixelHeight);
    this.#viewport.near = this.#store.values.loading === 'eager' ? view.painted : view.near;
    if (view.printing) {
      this.#children.sort();
      this.#viewport.redraw();
    }
    this.#camera.resized();
    this.#camera.inView = view.visible;
    this.#readiness.check();
  });
  readonly #display: ViewerDisplay = new ViewerDisplay({
    loading: this.#loading,
    failure: this.#failure,
    viewer: this,
    values: this.#store.values,
    viewport: this.#viewport,
    camera: this.#camera,
    children: this.#children,
    size: () => this.#visibility.size,
    snapshot: () => this.#snapshot(),
    ended: () => this.#readiness.check(),
  });

  constructor() {
    super();
    this.#store.listen((key) => !CAMERA_KEYS.has(key) && this.requestUpdate(key));
    // Visibility first: it brings the holder into the element's document.
    for (const part of [this.#visibility, this.#camera, this.#loading]) this.addController(part);
    viewerCameras.set(this, this.#camera);
  }

  /** The `<phong-light>` elements that belong to this viewer, in document order. Frozen; a new list when they change. */
  get lights(): readonly PhongLight[] {
    return this.#children.lights;
  }

  /** The `<phong-mesh>` elements that belong to this viewer, in document order. Frozen; a new list when they change. */
  get meshes(): readonly PhongMesh[] {
    return this.#children.meshes;
  }

  /** The camera as it is now, wherever the user, `auto-rotate` or `auto` has moved it. */
  get camera(): CameraState {
    this.#update();
    return this.#camera.state;
  }

  /** Everything requested is there, and shapes have been drawn. False while nothing is requested. */
  get loaded(): boolean {
    this.#update();
    return this.#loading.loaded;
  }

  /**
   * Texts in place of the element's own, by the English text: `{ 'Try again': 'Nochmal' }`. Texts that are left out stay English.
   * Null, the default, restores all. Throws TypeError for anything but an object of strings.
   */
  get texts(): ViewerTexts | null {
    return this.#display.texts;
  }

  set texts(texts: ViewerTexts | null | undefined) {
    this.#display.texts = texts;
  }

  /**
   * The three.js scene, for objects of your own. After changing it call {@link requestRender}, or {@link refit} if it has
   * new vertices. The standalone file does not contain the shaders of three.js's own materials: objects need a
   * ShaderMaterial or a RawShaderMaterial there.
   */
  get scene(): Scene {
    return this.#viewport.scene;
  }

  get stats(): ViewerStats {
    return { lightsDeclared: this.lights.length, ...this.#viewport.stats };
  }

  /**
   * Resolves once everything requested has been drawn, or could be drawn if it were visible. Never rejects. After a
   * change it is a new promise.
   */
  get ready(): Promise<void> {
    return this.#readiness.promise;
  }

  /**
   * Draws one frame, for changes to {@link scene} that the element cannot see. Keeps target and radius and measures
   * nothing: geometries are taken to have the bounds they had.
   */
  requestRender(): void {
    this.#viewport.invalidate();
  }

  /**
   * Measures the scene again and draws one frame: for new vertices in a geometry of {@link scene}, and for a new framing
   * where `target` or `radius` is `auto` and the user has not moved the camera.
   */
  refit(): void {
    this.#viewport.refit();
  }

  /** The picture now, at exactly `width` × `height` pixels. Rejects with `RangeError` for invalid sizes. */
  async toBlob(options: PictureOptions = {}): Promise<Blob> {
    this.#update();
    return blobOf(this.#viewport, this.#display.extras, options);
  }

  /**
   * Explains the fragment that the picture shows at `x`, `y`, in float64. `x` and `y` are CSS pixels from the picture's top
   * left corner, inside any border, like `offsetX` and `offsetY` of a pointer event on the viewer. The fragment is the one
   * at the centre of the device pixel there, in the scene as it is at the call. Highlights are those of the equation, not
   * averaged, whatever `antialias` says. Blended surfaces are explained without what lies behind them. Textures are
   * sampled without mipmaps. Null where nothing is hit, where an object of your own in {@link scene} is nearest (its lines
   * and points are ignored), and while the viewer has no box on the page. Rejects with `TypeError` or `RangeError` unless
   * x and y are finite numbers.
   */
  async shadeAt(x: number, y: number): Promise<FragmentExplanation | null> {
    this.#update();
    const snapshot = this.#snapshot();
    return (await lazy.shadeAt()).shadeAt(snapshot, x, y);
  }

  /** The scene as markup with the camera as it is now. Loaded at the same size, it gives the same picture. */
  toHTML(): string {
    return sceneMarkup(this);
  }

  /** Back to the last declared camera. */
  resetCamera(): void {
    this.#camera.reset();
  }

  override connectedCallback(): void {
    if (this.ownerDocument.defaultView === null) return; // a document that no window shows
    super.connectedCallback();
    addStyles(this.renderRoot as ShadowRoot, styles);
    this.#binding.upgrade();
    // At once rather than at the end of the task: scripts may ask for the camera right after.
    this.performUpdate();
    this.#children.connected();
    this.#viewport.attach();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#viewport.detach();
    this.#readiness.check();
  }

  /** After `moveBefore` everything is as it was: the browser would disconnect and connect the element without this. */
  connectedMoveCallback(): void {
    this.#visibility.look();
    this.#display.extras.apply();
  }

  override attributeChangedCallback(name: string, old: string | null, text: string | null): void {
    super.attributeChangedCallback(name, old, text);
    if (!this.#binding.attributeChanged(name, text)) this.requestUpdate();
  }

  protected override createRenderRoot(): HTMLElement | DocumentFragment {
    const root = super.createRenderRoot();
    this.#camera.listenTo(this.#display.fill(root, this.#holder));
    return root;
  }

  protected override update(changed: PropertyValues): void {
    super.update(changed);
    this.#display.update();
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.size > 0) this.#apply(changed as ReadonlyMap<string, unknown>);
  }

  /** Passes changed values on. */
  #apply(changed: { has(key: string): boolean }): void {
    const { values } = this.#store;
    const viewport = this.#viewport;
    applyStyle(viewport, values, changed);
    if (changed.has('src')) this.#readiness.supersede();
    this.#loading.apply(changed);
    if (changed.has('loading')) this.#visibility.shown();
    this.#visibility.maxRatio = values.pixelRatio === 'auto' ? Infinity : values.pixelRatio;
    if (changed.has('autoRotate') && this.#camera.turning) viewport.animate();
    if (changed.has('gui')) void this.#panel.toggle(values.gui, this.#display.panel);
    this.#panel.changed('viewer');
  }

  /** Applies now what was written in this task and would otherwise wait for its end. */
  #update(): void {
    if (this.isUpdatePending && this.hasUpdated) this.performUpdate();
    else if (!this.hasUpdated) this.#apply({ has: () => true }); // never connected: there is no shadow tree to update
    if (this.#visibility.connected && !this.#visibility.looked) this.#visibility.look();
    this.#children.sort();
    this.#children.flush();
  }

  get #settled(): boolean {
    this.#update();
    if (!this.#visibility.connected) return true;
    if (this.#loading.pending || this.#display.extras.pending !== null) return false;
    return this.#viewport.upToDate || !this.#viewport.drawable;
  }

  readonly #snapshot = (): ViewerSnapshot =>
    viewerSnapshot(this, this.#viewport, this.#children, this.#visibility.size);

  #cameraMoved(source: CameraSource, linked: boolean): void {
    // The first framing is not a move.
    if (this.hasUpdated) this.#events.enqueue('camera-change', linked ? { source, linked } : { source });
    this.#display.cameraMoved(source, linked);
    this.#panel.changed('camera');
  }
}

defineProperties(PhongViewer.prototype, VIEWER_FIELDS);
