// One viewer's picture: scene, lights, camera and size, drawn on the page's stage when something has changed.
import type { Object3D, Scene, WebGLRenderer } from 'three';
import type { Bounds } from '../camera/fit.js';
import { Orbit } from '../camera/orbit.js';
import type { LightSet } from '../light/light-set.js';
import { Budget } from '../model/budget.js';
import type { PhongLighting } from '../material/lighting.js';
import type { ShadingStyle } from '../material/material-values.js';
import { Animations } from './mesh/animation.js';
import { AutoFit, type Framing } from './auto-fit.js';
import { forgetBounds } from './bounds.js';
import { type Framed, type FrameLoop, frameLoopOf } from './frame-loop.js';
import { drawnObjects, copyFrame, type SceneSnapshot } from './snapshot/scene-snapshot.js';
import { Painter, type ViewportStats } from './painter.js';
import { Levels } from './mesh/levels.js';
import type { SceneMesh } from './mesh/scene-mesh.js';
import { SharedMaterials } from './mesh/shared-materials.js';
import { SceneTree } from './scene-tree.js';
import type { Size } from './gpu/atlas.js';
import { type NoWebGL2Error, stage, type StageClient } from './gpu/stage.js';
import { type PaintPart, StillPicture } from './still-picture.js';
import { ViewCamera } from './view-camera.js';
import type { ViewportSignals } from './viewport-signals.js';

export class Viewport implements StageClient, Framed {
  readonly holder: HTMLElement;
  readonly orbit = new Orbit();
  readonly materials: SharedMaterials;
  readonly animations = new Animations();
  readonly budget = new Budget();
  readonly levels: Levels;
  readonly scene: Scene;
  readonly lighting: PhongLighting;
  readonly meshes: ReadonlySet<SceneMesh>;
  readonly #painter: Painter;
  readonly #tree: SceneTree;
  readonly fit: AutoFit;
  readonly #signals: ViewportSignals;
  readonly #view = new ViewCamera(this.orbit);
  /** Requested size in device pixels. */
  #wanted: Size = { width: 0, height: 0 };
  /** In view, and not only near it. Default false. */
  visible = false;
  /** In view, or close enough to be drawn; undefined until the layout has been read. */
  #near: boolean | undefined = undefined;
  #attached = false;
  /** That of the window in which the picture is attached. */
  #loop: FrameLoop | null = null;
  /** Something has changed since the last frame. */
  #dirty = true;
  #changes = 0;
  /** It has another size since it was drawn. */
  resized = false;
  /** The picture has not changed, but its pixels are gone. */
  #blank = false;
  /** Something moves by itself, as of the last animation frame. */
  #moving = false;
  /** A changed picture was drawn and has not been reported as shown. */
  #unshown = false;
  readonly #still: StillPicture;
  #fov = 45;
  #frames = 0;
  /**
   * Moves what moves by itself to where it is at `now`, the time of an animation frame in ms. True while it keeps
   * moving.
   */
  moveTo: (now: number) => boolean = () => false;
  /** Something that belongs to the first picture, which is not drawn yet, is on its way. */
  awaited: () => boolean = () => false;
  /** Drawing has thrown. True if new content was to blame and is taken back. `draw` tries to draw, and may throw. */
  recover: (error: unknown, draw: () => void) => boolean = () => false;

  /** `holder` is an element that holds nothing but the canvas. */
  constructor(holder: HTMLElement, lights: LightSet, signals: ViewportSignals) {
    this.holder = holder;
    const meshes = (this.meshes = new Set<SceneMesh>());
    this.#painter = new Painter(lights, meshes);
    ({ scene: this.scene, lighting: this.lighting } = this.#painter);
    this.materials = new SharedMaterials(this.#painter.lighting);
    this.levels = new Levels(meshes, this.budget, this.materials);
    this.#tree = new SceneTree(this.#painter.scene, meshes);
    this.fit = new AutoFit(this.#tree, this.orbit);
    this.#signals = signals;
    this.#still = new StillPicture(this, () => signals.frameEnded.emit());
  }

  /** Device pixels, at most what the GPU can draw. */
  get width(): number {
    return Math.floor(this.#wanted.width * stage.shareOf(this.#wanted));
  }

  get height(): number {
    return Math.floor(this.#wanted.height * stage.shareOf(this.#wanted));
  }

  /** Joins the page's stage, in the window that shows the holder. */
  attach(): void {
    const view = this.holder.ownerDocument.defaultView;
    if (view === null) return;
    this.#loop = frameLoopOf(view);
    stage.add(this);
    this.#attached = true;
    this.#signals[stage.lost ? 'contextLost' : 'contextRestored'].emit();
    this.invalidate();
  }

  detach(): void {
    this.#changes += 1; // the context may close under what is being captured
    this.#attached = false;
    this.#near = undefined;
    this.#wake();
    stage.remove(this);
    this.#releaseUnlessAttached();
  }

  get fov(): number {
    return this.#fov;
  }

  set fov(degrees: number) {
    if (degrees === this.#fov) return;
    this.#fov = degrees;
    this.fit.fovChanged();
    this.invalidate();
  }

  get style(): ShadingStyle {
    return this.materials.style;
  }

  set style(style: ShadingStyle) {
    this.materials.style = style;
    for (const mesh of this.#tree.meshes) mesh.restyle();
    this.reshaped();
  }

  set linear(linear: boolean) {
    if (linear !== this.lighting.linear) this.invalidate();
    this.lighting.linear = linear;
  }

  /** Samples per pixel of a picture that stands still. 0, the default: it stays as it was drawn. */
  set samples(samples: number) {
    if (samples === this.#still.wanted) return;
    this.#still.wanted = samples;
    this.invalidate();
  }

  /** While nothing moves, the picture gets more samples. */
  get converging(): boolean {
    return this.#still.pending;
  }

  /** How target and radius are found; null leaves them where the user put them. */
  get framing(): Framing | null {
    return this.fit.framing;
  }

  set framing(framing: Framing | null) {
    this.fit.framing = framing;
    this.invalidate();
  }

  /** Whether the picture is in view or close enough to be drawn. While it is not, changes wait. */
  set near(near: boolean) {
    this.#near = near;
    this.#wake();
  }

  /** In device pixels. A picture of no pixels is not drawn; larger ones than the GPU can draw are reduced. */
  resize(width: number, height: number): void {
    if (width === this.#wanted.width && height === this.#wanted.height) return;
    this.#wanted = { width, height };
    this.resized = true;
    this.fit.resized(width, height);
    this.#changes += 1;
    this.#outdate();
    this.#wake();
  }

  add(mesh: SceneMesh): void {
    this.#tree.add(mesh);
    this.reshaped();
  }

  remove(mesh: SceneMesh): void {
    this.#tree.remove(mesh);
    this.reshaped();
  }

  /** The order in which the scene is drawn: meshes that are not among these, these, the page author's own objects. */
  arrange(meshes: readonly SceneMesh[]): void {
    this.#tree.arrange(meshes);
    this.invalidate();
  }

  /** Meshes were added, removed or moved, or show another geometry: `auto` is fitted again. */
  reshaped(): void {
    this.fit.reshaped();
    this.levels.changed();
    this.invalidate();
  }

  /** Measures the whole scene again, vertices included, and fits `auto` to it. */
  refit(): void {
    forgetBounds(this.scene);
    this.reshaped();
  }

  get attached(): boolean {
    return this.#attached;
  }

  /** Counts the changes of what it shows. */
  get changes(): number {
    return this.#changes;
  }

  /** Frames are drawn when something changes. */
  get drawable(): boolean {
    if (!this.#attached || stage.lost || this.#near === false) return false;
    return this.#near === undefined || (this.width > 0 && this.height > 0);
  }

  /** The canvas shows the scene as it is, if only the plain picture. */
  get upToDate(): boolean {
    return !this.#dirty && !this.#blank;
  }

  /** Something changed: draw a frame, as soon as it is near. */
  invalidate(): void {
    this.#changes += 1;
    this.#outdate();
    this.animate();
  }

  repaint(): void {
    // Out of sight, what the GPU keeps goes with the copy on the page.
    if (this.#still.samples === 0 || !this.drawable) this.#outdate();
    this.#blank = true;
    this.animate();
  }

  /** Requests a frame for motion; {@link moveTo} says whether it goes on. */
  animate(): void {
    // Moving lights come by one by one: the first question is the cheapest.
    if (this.#loop?.latest !== this && this.drawable) this.#loop?.request(this);
  }

  prepare(): void {
    if (this.#near === undefined) this.#signals.layoutNeeded.emit();
  }

  advance(now: number): boolean {
    return (this.#moving = this.drawable && !this.awaited() && this.moveTo(now));
  }

  draw(): void {
    if (!this.drawable) return;
    if (this.awaited())
      stage.draw(this); // opens the context meanwhile
    else if (!this.upToDate) this.redraw();
    else if (this.#moving || !this.#still.step()) return;
    if (this.#moving || this.#still.startable) this.animate();
  }

  redraw(): void {
    const isShown = this.drawable && this.#near !== undefined;
    if (!isShown) this.#outdate();
    if (!isShown) return;
    const changed = this.#dirty;
    // Before drawing: if that throws, the next attempt follows the next change.
    this.#dirty = this.#blank = this.resized = false;
    if (!changed && this.#still.samples > 0) {
      this.show(false);
      this.#signals.frameEnded.emit();
      return;
    }
    try {
      if (this.#paint()) {
        this.#signals.painted.emit();
        // A picture that is drawn again because its pixels were overwritten is not reported again.
        this.#unshown ||= changed;
        this.#frames += 1;
        this.#signals.drawn.emit();
      } else this.#dirty = true; // drawn once there is a context
      this.materials.sweep();
    } catch (error) {
      if (!this.recover(error, this.#paint)) throw error;
      this.#dirty = changed;
      this.redraw();
    } finally {
      this.#signals.frameEnded.emit();
    }
  }

  /** Draws the samples that are missing now, as far as `deadline` allows: a time as of `performance.now()`. */
  converge(deadline: number): void {
    if (this.drawable && this.upToDate && !this.#moving) this.#still.finish(deadline);
  }

  sampler(size: Size = this, begin = false): PaintPart {
    const { width, height } = size;
    this.#bringInStep(size, true); // a picture of another size may have been drawn since
    if (begin) {
      this.#view.aim(this.#fov, this.scene, this.fit.depthBounds(), width, height);
      this.#painter.begin(this.#view);
      this.#releaseUnlessAttached();
    }
    return (renderer, part, samples) => {
      this.#view.aim(this.#fov, this.scene, this.fit.depthBounds(), width, height, part);
      this.#painter.paintAgain(renderer, this.#view, samples);
    };
  }

  show(last: boolean): void {
    this.#blank = !stage.draw(this, (renderer) => this.#still.copy(renderer));
    this.#unshown ||= last;
  }

  /** Fits the camera to the scene if radius or target is `auto` and something has changed. */
  settle(): void {
    // The first fit is not a move.
    if (this.fit.settle(this.#fov) && this.#frames > 0) this.#signals.fitted.emit();
  }

  /** Measures the meshes' bounds, unless nothing has changed since; null where the scene shows nothing. */
  measure(): Bounds | null {
    this.settle();
    return this.fit.bounds;
  }

  /**
   * The picture now, at exactly this size in pixels: the plain one unless `shown`, for what is shown at this size.
   * Throws RangeError if no canvas can hold it.
   */
  capture(width: number, height: number, shown = false): HTMLCanvasElement {
    const isShown = !this.#dirty && width === this.width && height === this.height;
    const isMean = shown && isShown && this.#still.samples > 0;
    if (!isMean) this.#bringInStep({ width, height });
    this.#releaseUnlessAttached();
    return stage.capture({ width, height }, (renderer, part) => {
      if (isMean) this.#still.copy(renderer, part);
      else {
        this.#view.aim(this.#fov, this.scene, this.fit.depthBounds(), width, height, part);
        this.#painter.paint(renderer, this.#view);
      }
    });
  }

  /**
   * The mean of so many samples of each pixel. It begins again when the scene changes. Rejects like {@link capture}.
   * Where the GPU has no float targets it is the plain picture.
   */
  captureSamples(width: number, height: number, samples: number): Promise<HTMLCanvasElement> {
    return this.#still.capture({ width, height }, samples);
  }

  /** Everything that is drawn, as it is now. `ownerOf` names the owner of a mesh. */
  snapshot<Owner>(ownerOf: (mesh: SceneMesh) => Owner): SceneSnapshot<Owner> {
    const { width, height } = this;
    // The triangles of the picture that is shown.
    this.#bringInStep(this, this.#still.samples > 0);
    this.#view.aim(this.#fov, this.scene, this.fit.depthBounds(), width, height);
    const owners = new Map<Object3D, Owner>();
    for (const mesh of this.#tree.meshes) for (const part of mesh.parts) owners.set(part.mesh, ownerOf(mesh));
    const objects = drawnObjects(this.scene, this.#view.camera, (object) => owners.get(object));
    return { width, height, frame: copyFrame(this.#view.frame), camera: this.#view.camera.clone(), objects };
  }

  get stats(): ViewportStats {
    const [{ programs, viewersDrawn }, { samples }] = [stage, this.#still];
    return { ...this.#painter.stats, frames: this.#frames, samples, programs, viewersDrawn };
  }

  shown(): void {
    if (!this.#unshown) return;
    this.#unshown = false;
    this.#signals.shown.emit();
  }

  contextLost(): void {
    this.#changes += 1;
    this.#outdate();
    this.#loop?.cancel(this);
    this.#releaseGpu();
    this.#signals.contextLost.emit();
    this.#signals.frameEnded.emit();
  }

  contextRestored(): void {
    this.#wake();
    this.#signals.contextRestored.emit();
  }

  /** False where there is no context. */
  readonly #paint = (): boolean => {
    this.#bringInStep(this);
    return stage.draw(this, this.#render);
  };

  readonly #render = (renderer: WebGLRenderer): void => {
    this.#view.aim(this.#fov, this.scene, this.fit.depthBounds(), this.width, this.height);
    this.#painter.paint(renderer, this.#view);
  };

  contextMissing(error: NoWebGL2Error): void {
    this.#loop?.cancel(this);
    this.#signals.contextMissing.emit(error);
    this.#signals.frameEnded.emit();
  }

  /** Order, matrices and camera of the scene as they are now, and its shapes as this size shows them. */
  #bringInStep(size: Size, sampled = false): void {
    this.settle();
    this.#tree.update();
    const view = this.#view.look(this.#fov, size.width / size.height);
    this.levels.choose(view, size.height, sampled, this.orbit.version, this.#tree.moves);
  }

  /** An element that only moves is back before the microtask; one that stays away gives its GPU memory back. */
  #releaseUnlessAttached(): void {
    queueMicrotask(() => {
      if (!this.#attached) this.#releaseGpu();
    });
  }

  /** Drawing sends everything to the GPU again. */
  #releaseGpu(): void {
    this.#still.dispose();
    this.materials.sweep();
    this.#painter.release();
  }

  /** After a change of visibility, size or context: requests a frame that was waiting, or takes the request back. */
  #wake(): void {
    if (!this.drawable) {
      this.#loop?.cancel(this);
      this.#still.pause();
    } else if (!this.upToDate || this.converging) this.#loop?.request(this);
  }

  #outdate(): void {
    this.#dirty = true;
    this.#still.reset();
  }
}
