// One viewer's picture: its scene, lights, camera and size, drawn on the page's stage when something has changed.
// Knows neither Lit nor attributes nor where input comes from.
import type { Object3D, Scene } from 'three';
import { zoomLimits } from '../camera/fit.js';
import type { RadiusLimits } from '../camera/drag.js';
import { Orbit } from '../camera/orbit.js';
import type { LightSet } from '../light/light-set.js';
import type { PhongLighting } from '../material/lighting.js';
import { DEFAULT_STYLE, type ShadingStyle } from '../material/phong-material.js';
import { AutoFit, type Framing } from './auto-fit.js';
import { type Framed, frameLoop } from './frame-loop.js';
import { drawnObjects, frameNow, type SceneSnapshot } from './snapshot/scene-snapshot.js';
import { Painter } from './painter.js';
import type { SceneMesh } from './mesh/scene-mesh.js';
import type { Size } from './gpu/atlas.js';
import { NoWebGL2Error, stage, type StageClient } from './gpu/stage.js';
import { ViewCamera } from './view-camera.js';
import type { ViewportEvents } from './viewport-events.js';
import type { ViewportStats } from './viewport-stats.js';

export class Viewport implements StageClient, Framed {
  readonly holder: HTMLElement;
  readonly orbit = new Orbit();
  readonly #painter: Painter;
  readonly #fit: AutoFit;
  readonly #events: ViewportEvents;
  readonly #view = new ViewCamera(this.orbit);
  readonly #meshes = new Set<SceneMesh>();
  /** Device pixels, as many as were asked for. */
  #wanted: Size = { width: 0, height: 0 };
  /** On screen; undefined until somebody has looked. */
  #visible: boolean | undefined = undefined;
  #attached = false;
  #dirty = true;
  #fov = 45;
  #style: ShadingStyle = DEFAULT_STYLE;
  #frames = 0;

  /** `holder` is an element for the canvas alone. */
  constructor(holder: HTMLElement, lights: LightSet, events: ViewportEvents) {
    this.holder = holder;
    this.#painter = new Painter(lights, this.#meshes);
    this.#fit = new AutoFit(this.#painter.scene, this.orbit);
    this.#events = events;
  }

  /** Device pixels, no more than the GPU draws. */
  get width(): number {
    return Math.floor(this.#wanted.width * stage.shareOf(this.#wanted));
  }

  get height(): number {
    return Math.floor(this.#wanted.height * stage.shareOf(this.#wanted));
  }

  get scene(): Scene {
    return this.#painter.scene;
  }

  get lighting(): PhongLighting {
    return this.#painter.lighting;
  }

  /** Joins the page's stage. */
  attach(): void {
    stage.add(this);
    this.#attached = true;
    this.invalidate();
  }

  detach(): void {
    this.#attached = false;
    this.#visible = undefined;
    frameLoop.cancel(this);
    stage.remove(this);
    // An element that only moves is back before the microtask; one that stays away gives its GPU memory back.
    queueMicrotask(() => {
      if (!this.#attached) this.#painter.release();
    });
  }

  get fov(): number {
    return this.#fov;
  }

  set fov(degrees: number) {
    if (degrees === this.#fov) return;
    this.#fov = degrees;
    this.#fit.refit();
    this.invalidate();
  }

  get style(): ShadingStyle {
    return this.#style;
  }

  set style(style: ShadingStyle) {
    this.#style = style;
    for (const mesh of this.#meshes) mesh.restyle();
  }

  set linear(linear: boolean) {
    if (linear !== this.lighting.linear) this.invalidate();
    this.lighting.linear = linear;
  }

  /** How target and radius are found; null leaves them where the user has put them. */
  get framing(): Framing | null {
    return this.#fit.framing;
  }

  set framing(framing: Framing | null) {
    this.#fit.framing = framing;
    this.invalidate();
  }

  /** Whether the picture can be seen. Until it can, nothing is drawn; what has changed is drawn when it can. */
  set visible(visible: boolean) {
    this.#visible = visible;
    this.#wake();
  }

  /** In device pixels, fewer where the GPU draws no more; a picture without any is not drawn. */
  resize(width: number, height: number): void {
    if (width === this.#wanted.width && height === this.#wanted.height) return;
    this.#wanted = { width, height };
    this.#fit.resized(width, height);
    this.#dirty = true;
    this.#wake();
  }

  add(mesh: SceneMesh): void {
    this.#meshes.add(mesh);
    this.scene.add(mesh.root);
    this.reshaped();
  }

  remove(mesh: SceneMesh): void {
    this.#meshes.delete(mesh);
    mesh.dispose();
    this.reshaped();
  }

  /** The scene's order, in which it is drawn: a mesh that is not among `meshes`, these, and objects of one's own. */
  arrange(meshes: readonly SceneMesh[]): void {
    const ranks = new Map<Object3D, number>();
    for (const mesh of this.#meshes) ranks.set(mesh.root, meshes.indexOf(mesh));
    const rank = (object: Object3D): number => ranks.get(object) ?? meshes.length;
    this.scene.children.sort((a, b) => rank(a) - rank(b));
    this.invalidate();
  }

  /** Meshes came, went, moved or changed their triangles. */
  reshaped(): void {
    this.#fit.reshaped();
    this.invalidate();
  }

  /** A frame is coming, or would be if anything changed. */
  get drawable(): boolean {
    if (!this.#attached || stage.lost || this.#visible === false) return false;
    return this.#visible === undefined || (this.width > 0 && this.height > 0);
  }

  /** What was drawn last is what would be drawn now. */
  get upToDate(): boolean {
    return !this.#dirty;
  }

  /** Something changed: draw once more, as soon as that can be seen. */
  invalidate(): void {
    this.#dirty = true;
    if (this.drawable) frameLoop.request(this);
  }

  /** Motion begins that `beforeFrame` carries on. */
  animate(): void {
    if (this.drawable) frameLoop.request(this);
  }

  prepare(): void {
    if (this.#visible === undefined) this.#events.locate();
  }

  advance(now: number): boolean {
    return this.drawable && this.#events.beforeFrame(now);
  }

  draw(): void {
    if (this.#dirty && this.drawable) this.redraw();
  }

  redraw(): void {
    if (!this.drawable || this.#visible === undefined) {
      this.#dirty = true;
      return;
    }
    // Before drawing: what cannot be drawn is not tried again until something changes.
    this.#dirty = false;
    try {
      this.settle();
      stage.draw(this, (renderer) => {
        this.#view.aim(this.#fov, this.#fit.bounds, this.width, this.height);
        this.#painter.paint(renderer, this.#view);
      });
      this.#frames += 1;
      this.#events.drawn();
    } catch (error) {
      if (!(error instanceof NoWebGL2Error)) throw error;
      this.#attached = false; // until somebody attaches it again
      this.#events.contextMissing(error);
    } finally {
      this.#events.tried();
    }
  }

  /** Brings the camera in step with the scene: `auto` is found anew where it has to be. */
  settle(): void {
    // Where a camera begins is not a move.
    if (this.#fit.settle(this.#fov) && this.#frames > 0) this.#events.fitted();
  }

  /** How near and how far zooming may go. */
  get zoomLimits(): RadiusLimits {
    this.settle();
    return zoomLimits(this.#fit.bounds);
  }

  /** The picture now, at exactly this many pixels. Throws RangeError where no canvas can hold them. */
  capture(width: number, height: number): HTMLCanvasElement {
    this.settle();
    return stage.capture({ width, height }, (renderer, part) => {
      this.#view.aim(this.#fov, this.#fit.bounds, width, height, part);
      this.#painter.paint(renderer, this.#view);
    });
  }

  /** All that is drawn, as it is now; `ownerOf` says whose a mesh is. */
  glimpse<Owner>(ownerOf: (mesh: SceneMesh) => Owner): SceneSnapshot<Owner> {
    const { width, height } = this;
    this.settle();
    this.scene.updateMatrixWorld();
    this.#view.aim(this.#fov, this.#fit.bounds, width, height);
    const { camera, frame } = this.#view;
    const objects = drawnObjects(this.scene, camera, (object) => {
      const mesh = [...this.#meshes].find((one) => one.shows(object));
      return mesh && ownerOf(mesh);
    });
    return { width, height, frame: frameNow(frame), camera: camera.clone(), objects };
  }

  get stats(): ViewportStats {
    return {
      ...this.#painter.stats,
      frames: this.#frames,
      programs: stage.programs,
      viewersDrawn: stage.viewersDrawn,
    };
  }

  contextLost(): void {
    frameLoop.cancel(this);
    this.#painter.release();
    this.#events.contextLost();
  }

  contextRestored(): void {
    this.invalidate();
    this.#events.contextRestored();
  }

  /** Visibility, size or context changed: what waited for them is asked for, what cannot be shown is not. */
  #wake(): void {
    if (!this.drawable) frameLoop.cancel(this);
    else if (this.#dirty) frameLoop.request(this);
  }
}
