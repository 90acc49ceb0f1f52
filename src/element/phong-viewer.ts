// <phong-viewer>: the element. It translates: attributes and children into state for the picture, hands into camera
// moves, what happens into events. It computes no light and draws nothing itself.
import { LitElement, type PropertyValues } from 'lit';
import { LightSet } from '../light/light-set.js';
import { FieldStore } from '../fields/field-store.js';
import { Viewport } from '../scene/viewport.js';
import { attributesOf, FieldBinding, defineProperties } from './fields/field-binding.js';
import type { Listen, PhongViewerEventMap } from './events.js';
import { viewerSnapshot, pictureOf } from './viewer/viewer-snapshot.js';
import { EventQueue } from './viewer/event-queue.js';
import type { PanelLoader } from './viewer/panel-api.js';
import type { PhongLight } from './phong-light.js';
import type { PhongMesh } from './phong-mesh.js';
import { styles } from './phong-viewer.styles.js';
import type { PictureOptions } from './viewer/picture-blob.js';
import { Readiness } from './viewer/readiness.js';
import type { FragmentExplanation } from './viewer/shade-at.js';
import { sceneMarkup } from './viewer/to-html.js';
import { type CameraSource, type CameraState, ViewerCamera } from './viewer/camera.js';
import { ViewerChildren } from './viewer/children.js';
import { LOADING_KEYS, VIEWER_FIELDS, type ViewerValues } from './fields/viewer-fields.js';
import { ViewerFailure } from './viewer/failure.js';
import { ViewerLoading } from './viewer/loading.js';
import { ViewerPanel } from './viewer/panel.js';
import type { ViewerStats } from './viewer/stats.js';
import { viewerTemplate } from './viewer/template.js';
import { Visibility } from './page/visibility.js';

export interface PhongViewer extends ViewerValues {
  readonly localName: 'phong-viewer';
  addEventListener: Listen<this, PhongViewerEventMap>;
  removeEventListener: Listen<this, PhongViewerEventMap>;
}

/**
 * Shows a Phong-lit 3D scene. Lights and meshes are its children; properties are those of {@link ViewerValues}, under
 * the attributes' names in camel case; events are those of {@link PhongViewerEventMap}.
 *
 * @slot - `<phong-light>` and `<phong-mesh>` elements; nothing of them is shown as such
 * @slot error - shown instead of the element's own message when something fails
 * @csspart surface - the picture, without the panel
 * @csspart poster - the image shown before the first picture
 * @csspart notice - the element's own message when something fails
 * @csspart panel - the control panel's place
 */
export class PhongViewer extends LitElement {
  static override readonly styles = styles;
  static override readonly shadowRootOptions: ShadowRootInit = { mode: 'open', delegatesFocus: true };
  static override get observedAttributes(): string[] {
    return [...super.observedAttributes, ...attributesOf(VIEWER_FIELDS), 'aria-label'];
  }

  /** Fetches the control panel's code; handed in by the package's entry. */
  static loadPanel: PanelLoader | null = null;

  readonly state = new FieldStore<ViewerValues>(VIEWER_FIELDS);
  readonly declared = new FieldBinding<ViewerValues>(this, this.state, (key) => {
    this.#camera.assigned(key);
    if (key === 'src') this.requestUpdate('src'); // the same address again tries again what has failed
  });

  readonly #holder = document.createElement('div');
  readonly #notices = new EventQueue(this);
  readonly #panel = new ViewerPanel(this);
  readonly #failure = new ViewerFailure(this, this.#notices);
  readonly #readiness = new Readiness(() => this.#settled);
  readonly #lightSet = new LightSet((light) => {
    this.#viewport.invalidate();
    const element = light === null ? null : this.#children.lightOf(light);
    this.#notices.tellLight(element);
    this.#panel.changed(element === null ? 'lights' : 'light');
  });
  readonly #viewport = new Viewport(this.#holder, this.#lightSet, {
    locate: () => this.#visibility.look(),
    beforeFrame: (now) => this.#camera.frame(now),
    drawn: () => {
      this.#reveal();
      this.dispatchEvent(new CustomEvent('render'));
    },
    tried: () => this.#readiness.check(),
    fitted: () => this.#cameraMoved('auto'),
    contextMissing: (error) => {
      this.#failure.contextMissing(error);
    },
    contextLost: () => {
      this.#failure.contextLost();
      this.#readiness.check();
    },
    contextRestored: () => this.#failure.contextRestored(),
  });
  readonly #loading = new ViewerLoading({
    state: this.state,
    viewport: this.#viewport,
    notices: this.#notices,
    elementOf: (mesh) => this.#children.elementOf(mesh),
    childMeshes: () => this.#children.sceneMeshes,
    fail: (mesh, detail) => this.#failure.tell(mesh, detail),
    mended: (mesh) => {
      this.#failure.mended(mesh);
      queueMicrotask(() => {
        this.#readiness.check();
      });
    },
    ended: () => this.#readiness.check(),
  });
  readonly #children: ViewerChildren = new ViewerChildren(
    {
      viewport: this.#viewport,
      meshHost: this.#loading,
      slot: () => this.#part<HTMLSlotElement>('slot:not([name])'),
      meshesChanged: () => this.#panel.changed('meshes'),
    },
    this.#lightSet,
  );
  readonly #camera: ViewerCamera = new ViewerCamera({
    values: this.state.values,
    viewport: this.#viewport,
    size: () => this.#holder.getBoundingClientRect(),
    moved: (source) => this.#cameraMoved(source),
  });
  readonly #visibility = new Visibility(this.#holder, (sight) => {
    if (sight.visible) this.#loading.seen();
    else this.#camera.rest();
    this.#viewport.resize(sight.pixelWidth, sight.pixelHeight);
    this.#viewport.visible = sight.visible;
    if (sight.printing) this.#viewport.redraw();
    this.#camera.resized();
    if (sight.visible && this.#camera.turning) this.#viewport.animate();
    this.#readiness.check();
  });
  #revealed = false;

  constructor() {
    super();
    this.#holder.className = 'holder';
    this.state.listen((key) => this.requestUpdate(key));
    this.addController(this.#camera);
    this.addController(this.#visibility);
  }

  /** The `<phong-light>` children, in order. Frozen; a new list when they change. */
  get lights(): readonly PhongLight[] {
    return this.#children.lights;
  }

  /** The `<phong-mesh>` children, in order. Frozen; a new list when they change. */
  get meshes(): readonly PhongMesh[] {
    return this.#children.meshes;
  }

  /** The camera as it is now, wherever hands, time or `auto` have brought it. */
  get camera(): CameraState {
    this.#bringInStep();
    return this.#camera.state;
  }

  /** All models asked for are there. */
  get loaded(): boolean {
    return this.#loading.loaded;
  }

  /**
   * The three.js scene, for objects of your own; call {@link requestRender} after changing it. The standalone file does
   * not contain the shaders of three.js's own materials: objects need a ShaderMaterial or a RawShaderMaterial there.
   */
  get scene(): Viewport['scene'] {
    return this.#viewport.scene;
  }

  get stats(): ViewerStats {
    return { lightsDeclared: this.lights.length, ...this.#viewport.stats };
  }

  /**
   * Resolves, and never rejects, once all that was asked for is drawn, or loaded and drawable but not visible. Asked
   * for again after a change it is a new promise.
   */
  get ready(): Promise<void> {
    return this.#readiness.promise;
  }

  /** Draws a frame, soon: for changes to {@link scene} that the element cannot see. */
  requestRender(): void {
    this.#viewport.reshaped();
  }

  /** The picture now, at exactly `width` × `height` pixels. Bad sizes reject with `RangeError`. */
  async toBlob(options: PictureOptions = {}): Promise<Blob> {
    this.#bringInStep();
    const picture = pictureOf(this.#viewport, options);
    return (await import('./viewer/picture-blob.js')).pictureBlob(picture, options);
  }

  /**
   * Explains the fragment that the picture shows at `x`, `y`: CSS pixels from the picture's top left corner, inside any
   * border, as `offsetX` and `offsetY` of a pointer event on the viewer. It is the one at the centre of the device pixel
   * there, as the scene is at the call, in float64, with highlights as they are there: unfiltered, whatever `antialias` says.
   * Blended surfaces are explained without what lies behind them, and textures are sampled without mipmaps. Null where
   * nothing is hit, where an object of your own in {@link scene} is nearest (its lines and points are looked through), and
   * while the viewer has no place on the page. Rejects with `TypeError` or `RangeError` where x or y is no finite number.
   */
  async shadeAt(x: number, y: number): Promise<FragmentExplanation | null> {
    this.#bringInStep();
    const moment = viewerSnapshot(this, this.#viewport, this.#children, this.#visibility.size);
    const { shadeAt } = await import('./viewer/shade-at.js');
    return shadeAt(moment, x, y);
  }

  /** The scene as markup, with the camera as it is now: it gives the same picture back. */
  toHTML(): string {
    return sceneMarkup(this);
  }

  /** Back to the last declared camera. */
  resetCamera(): void {
    this.#camera.reset();
  }

  /** Camera properties assigned inside `write` count as moved by `source`: for control panels. */
  moveFrom(source: CameraSource, write: () => void): void {
    this.#camera.from(source, write);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.declared.upgrade();
    // At once rather than at the task's end: children and camera can be asked for right after.
    this.performUpdate();
    this.#children.collect();
    this.#failure.contextRestored(); // or missing once more
    this.#viewport.attach();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#viewport.detach();
    this.#readiness.check();
  }

  override attributeChangedCallback(name: string, old: string | null, text: string | null): void {
    super.attributeChangedCallback(name, old, text);
    if (!this.declared.attributeChanged(name, text)) this.requestUpdate();
  }

  protected override render(): unknown {
    const { alt, poster, orbit } = this.state.values;
    return viewerTemplate({
      label: this.getAttribute('aria-label') ?? alt,
      poster: this.#revealed ? '' : poster,
      fixed: !orbit,
      notice: this.#failure.message,
      holder: this.#holder,
      slotchange: () => this.#children.collect(),
    });
  }

  protected override firstUpdated(): void {
    const surface = this.#part<HTMLElement>('.surface');
    if (surface !== null) this.#camera.listenTo(surface);
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.size > 0) this.#apply(changed as ReadonlyMap<string, unknown>);
  }

  /** Values that were written are acted on. */
  #apply(changed: { has(key: string): boolean }): void {
    const { values } = this.state;
    const viewport = this.#viewport;
    viewport.fov = values.fov;
    viewport.linear = values.colorInterpolation === 'linear';
    if (['shading', 'reflection', 'terms', 'antialias'].some((key) => changed.has(key))) {
      const { shading, reflection, terms, antialias } = values;
      viewport.style = { shading, reflection, terms, antialias };
    }
    if (changed.has('src')) this.#readiness.supersede();
    if (LOADING_KEYS.some((key) => changed.has(key))) this.#loading.update();
    if (changed.has('autoRotate') && this.#camera.turning) viewport.animate();
    if (changed.has('gui')) void this.#panel.toggle(values.gui, PhongViewer.loadPanel, this.#part('.panel'));
    this.#panel.changed('viewer');
  }

  /** Writes of this task that wait for its end are acted on now. */
  #bringInStep(): void {
    if (this.isUpdatePending && this.hasUpdated) this.performUpdate();
    else if (!this.hasUpdated) this.#apply({ has: () => true }); // never connected: there is no shadow tree to bring in step
    if (this.isConnected && !this.#visibility.looked) this.#visibility.look();
    this.#children.flush();
    this.#children.collect();
  }

  get #settled(): boolean {
    this.#bringInStep();
    if (!this.isConnected) return true;
    if (this.#loading.pending || !this.#visibility.known) return false;
    return this.#viewport.upToDate || !this.#viewport.drawable || document.visibilityState === 'hidden';
  }

  /** The first picture of all that was asked for is drawn: the poster has done its work. */
  #reveal(): void {
    if (this.#revealed || this.#loading.pending || this.#failure.message !== null) return;
    this.#revealed = true;
    if (this.state.values.poster !== '') this.requestUpdate();
  }

  /** By looking, not by Lit's refs: those are empty while the element is out of the document. */
  #part<E extends HTMLElement>(selector: string): E | null {
    return this.shadowRoot?.querySelector<E>(selector) ?? null;
  }

  #cameraMoved(source: CameraSource): void {
    // Where a camera begins is not a move.
    if (this.hasUpdated) this.#notices.tell('camera-change', { source });
    this.#panel.changed('camera');
  }
}

defineProperties(PhongViewer.prototype, VIEWER_FIELDS, (viewer) => viewer.declared);

declare global {
  interface HTMLElementTagNameMap {
    'phong-viewer': PhongViewer;
  }
}
