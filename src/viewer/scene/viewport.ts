// When one viewer's picture is drawn, and where: on the page's stage when something has changed,
// while it is near.
import type { WebGLRenderer } from 'three';
import { Signal } from '../../phong/fields/signal.js';
import type { LightSet } from '../../phong/light/light-set.js';
import { type FrameLoop, frameLoopOf } from './frame-loop.js';
import type { Size } from '../../phong/math/region.js';
import { pace } from './gpu/pace.js';
import { stage } from './gpu/stage.js';
import { Picture } from './picture.js';
import type { ViewportStats } from './viewport-stats.js';
import { StillPicture } from './still-picture.js';

const NONE = -1; // no version of a picture

/**
 * A picture with fewer pixels gets all of them after this time and this many animation frames
 * without a change: a slow drag has frames in which nothing moves, and slow frames are rare.
 */
const STILL_MS = 200;
const STILL_FRAMES = 3;

/** Frames that wait for a program at most: then drawing waits, whatever the browser says. */
const MOST_HELD = 120;

/** What a viewport reports to the parts around it, and what it asks them. */
export class ViewportSignals {
  /**
   * Before the first frame: size and visibility of the picture are not known yet. Set `near` and
   * call `resize`.
   */
  readonly layoutNeeded = new Signal();
  /** A frame was drawn, and may still have to be copied to the picture's canvas. */
  readonly drawn = new Signal();
  /**
   * A changed picture is on its canvas, whose pixels can be read until the task ends. Once a frame.
   */
  readonly shown = new Signal();
  /**
   * After {@link drawn}, where drawing threw, and where there is no context: no more frames come by
   * themselves.
   */
  readonly frameEnded = new Signal();
  /** `auto` found another target or radius. True before the first frame: that is no move. */
  readonly fitted = new Signal<boolean>();
  /** There is no WebGL 2. {@link contextRestored} follows if a later attempt succeeds. */
  readonly contextMissing = new Signal<Error>();
  readonly contextLost = new Signal();
  readonly contextRestored = new Signal();
  /** Moves what moves by itself to its place at `now`, in ms. True while it keeps moving. */
  moveTo: (now: number) => boolean = () => false;
  /** Something that belongs to the first picture, which is not drawn yet, is on its way. */
  awaited: () => boolean = () => false;
  /** It shows content for the first time that the GPU may have no memory for. */
  unproven: () => boolean = () => false;
  /**
   * Drawing has thrown. True if new content was to blame and is taken back. `draw` tries to draw,
   * and may throw.
   */
  recover: (error: unknown, draw: () => void) => boolean = () => false;
}

/** One viewer's picture on the page; sizes are in device pixels. */
export class Viewport {
  /** Holds the picture's canvas, and nothing else. */
  readonly holder: HTMLElement;
  readonly picture: Picture;
  /** Its samples while it stands still. */
  readonly still: StillPicture;
  readonly #signals: ViewportSignals;
  #wanted: Size = { width: 0, height: 0 };
  /** In view, and not only near it. Default false. */
  visible = false;
  /** In view, or close enough to be drawn; undefined until the layout has been read. */
  #near: boolean | undefined = undefined;
  /** The frame loop of the window in which the picture is attached. */
  #loop: FrameLoop | null = null;
  /** The picture's version that the canvas shows, or whose drawing has thrown. */
  #painted = NONE;
  /** The version that was last reported as shown. */
  #reported = NONE;
  /** Something moves by itself, as of the last animation frame. */
  #moving = false;
  /** Share of the pixels a side, while something moves: see {@link pace}. */
  #share = 1;
  /** It always has all pixels. Default false. */
  isWhole = false;
  /** The first animation frame after the last change, and how many there were since then. */
  #changed = -Infinity;
  #unchanged = STILL_FRAMES;
  /** Drawing is slow, so its animation frames have to tell whether a motion goes on. */
  #settles = false;
  /** The canvas no longer shows the picture, so no frame may wait. */
  #isBlank = false;
  /** Frames in a row without a picture, as programs are compiled. */
  #held = 0;
  #frames = 0;
  #reducedFrames = 0;

  constructor(holder: HTMLElement, lights: LightSet, signals: ViewportSignals) {
    this.holder = holder;
    this.#signals = signals;
    this.still = new StillPicture(this, () => signals.frameEnded.emit());
    const changed = (): void => {
      this.still.converging?.reset();
      this.animate();
    };
    this.picture = new Picture(lights, changed, () => signals.fitted.emit(this.#frames === 0));
  }

  /** Device pixels of the canvas: fewer than those of {@link whole} while it is reduced. */
  get width(): number {
    return Math.ceil(this.#side('width') * this.#share);
  }

  get height(): number {
    return Math.ceil(this.#side('height') * this.#share);
  }

  /** Device pixels of the picture with all of them, at most what the GPU can draw. */
  get whole(): Size {
    return { width: this.#side('width'), height: this.#side('height') };
  }

  /** Without an object: frames ask for the size many times. */
  #side(side: keyof Size): number {
    return Math.floor(this.#wanted[side] * stage.shareOf(this.#wanted));
  }

  /** It has fewer pixels than that, as it moves and drawing is slow. */
  get reduced(): boolean {
    return this.#share < 1;
  }

  /** Joins the page's stage, in the window that shows the holder. */
  attach(): void {
    const view = this.holder.ownerDocument.defaultView;
    if (view === null) return;
    this.#loop = frameLoopOf(view);
    stage.add(this);
    this.#signals[stage.lost ? 'contextLost' : 'contextRestored'].emit();
    this.picture.invalidate();
  }

  detach(): void {
    this.picture.invalidate(); // the context may close under what is being captured
    this.#loop?.cancel(this);
    this.#loop = null;
    this.#near = undefined;
    this.#share = 1;
    stage.remove(this);
    this.releaseUnlessAttached();
  }

  get attached(): boolean {
    return this.#loop !== null;
  }

  /** Whether the picture is in view or close enough to be drawn. While it is not, changes wait. */
  set near(near: boolean) {
    this.#near = near;
    this.#wake();
  }

  /**
   * In device pixels. A picture of no pixels is not drawn; larger ones than the GPU can draw are
   * reduced.
   */
  resize(size: Size): void {
    if (size.width === this.#wanted.width && size.height === this.#wanted.height) return;
    this.#wanted = size;
    this.picture.fit.resized(size);
    this.#wake();
  }

  /** It has another size since it was drawn. */
  get resized(): boolean {
    const { frame } = this.picture;
    return frame.width !== this.#side('width') || frame.height !== this.#side('height');
  }

  /** Frames are drawn when something changes. */
  get drawable(): boolean {
    if (this.#loop === null || stage.lost || this.#near === false) return false;
    return this.#near === undefined || (this.width > 0 && this.height > 0);
  }

  /** The canvas shows the scene as it is, if only the plain picture. */
  get upToDate(): boolean {
    return this.#painted === this.picture.version;
  }

  /** The canvas no longer shows the picture: draws it again once it is visible. */
  repaint(): void {
    // Out of sight, what the GPU keeps goes with the copy on the page.
    if (this.still.samples === 0 || !this.drawable) {
      this.still.converging?.reset();
    }
    this.#painted = NONE;
    this.#isBlank = true;
    this.animate();
  }

  /** Requests a frame for motion; {@link ViewportSignals.moveTo} says whether it goes on. */
  animate(): void {
    if (this.drawable) {
      this.#loop?.request(this);
    }
  }

  /**
   * First phase of a frame: reads the page's layout. Nothing writes to the page before all pictures
   * have read.
   */
  prepare(): void {
    if (this.#near === undefined) {
      this.#signals.layoutNeeded.emit();
    }
  }

  /**
   * Second phase: advances motion such as a turning camera; true requests another frame. `now` is
   * the animation frame's time in milliseconds. Pictures that move must all be out of date before
   * the first one draws: only those share an atlas.
   */
  advance(now: number): boolean {
    this.#moving = this.drawable && !this.#signals.awaited() && this.#signals.moveTo(now);
    this.#choosePixels(now);
    return this.#moving;
  }

  /** Before any picture of the frame is drawn, as they share the atlas. */
  #choosePixels(now: number): void {
    this.#unchanged += 1;
    if (this.#unchanged === 1) {
      this.#changed = now; // the browser may have waited for the picture, which is no rest
    }
    const isStill =
      !this.#moving && this.#unchanged > STILL_FRAMES && now - this.#changed > STILL_MS;
    const draws = !this.upToDate || (this.reduced && isStill);
    if (draws) {
      this.#share = isStill || this.isWhole ? 1 : pace.share;
      this.#painted = NONE;
    }
    if (draws || this.#moving) {
      this.#unchanged = 0;
    }
    this.#settles = this.reduced || (pace.share < 1 && (draws || !isStill));
  }

  draw(): void {
    if (!this.drawable) return;
    if (this.#signals.awaited()) {
      stage.draw(this); // opens the context meanwhile
    } else if (!this.upToDate) {
      if (
        !this.#isBlank &&
        (this.#compiles() || (!this.isWhole && !this.resized && pace.holds()))
      ) {
        this.animate();
        return;
      }
      this.redraw();
    } else if (this.#moving || !(this.#settles || this.still.step())) return;
    if (this.#moving || this.#settles || this.still.converging?.pending === true) {
      this.animate();
    }
  }

  /** The canvas keeps the picture before while another program is compiled, so no frame waits. */
  #compiles(): boolean {
    const { picture } = this;
    const before = this.#held;
    if (this.#frames > 0 && picture.needsPrograms() && before < MOST_HELD) {
      stage.drawAside((renderer) => {
        this.#held += Number(picture.compiles(renderer));
      });
    }
    if (this.#held > before) return true;
    this.#held = 0;
    return false;
  }

  /** Draws it now, with all pixels. */
  finish(): void {
    this.#share = 1;
    this.redraw();
  }

  redraw(): void {
    if (!this.drawable || this.#near === undefined) {
      this.still.converging?.reset();
      this.#painted = NONE;
      return;
    }
    if (this.still.samples > 0) {
      this.show(false);
      this.#signals.frameEnded.emit();
      return;
    }
    const { version, materials } = this.picture;
    // Before drawing: if that throws, the next attempt follows the next change.
    this.#painted = version;
    this.#isBlank = false;
    try {
      if (stage.draw(this, this.#render)) {
        if (this.#signals.unproven() && stage.outOfMemory()) {
          throw new RangeError('the GPU has no memory for it');
        }
        this.#frames += 1;
        this.#reducedFrames += Number(this.reduced);
        this.#signals.drawn.emit();
      } else {
        this.#painted = NONE; // drawn once there is a context
      }
      materials.sweep();
    } catch (error) {
      if (!this.#signals.recover(error, () => stage.draw(this, this.#render))) {
        this.#reported = version;
        throw error;
      }
      this.#painted = NONE;
      this.redraw();
    } finally {
      this.#signals.frameEnded.emit();
    }
  }

  readonly #render = (renderer: WebGLRenderer): void => {
    const { picture } = this;
    if (stage.programs === 0) {
      // The driver compiles the page's first programs while the first frame is computed. They
      // depend on how many rows the lights have.
      picture.lighting.updateFrame(picture.frame.shading);
      picture.compiles(renderer);
      stage.flush(); // else they wait in the browser's queue
    }
    if (!this.isWhole) {
      pace.draws(renderer, this.#share);
    }
    picture.make(this.whole, 1, this.#share);
    picture.draw(renderer);
  };

  /**
   * Draws the samples that are missing now, as far as `deadline` allows: a time as of
   * `performance.now()`.
   */
  converge(deadline: number): void {
    if (this.drawable && this.upToDate && !this.#moving) {
      this.still.finish(deadline);
    }
  }

  /** Shows the kept mean. `last`: it has all samples. */
  show(last: boolean): void {
    const isShown = stage.draw(this, (renderer) => this.still.converging?.copy(renderer));
    this.#painted = isShown ? this.picture.version : NONE;
    if (last) {
      this.#reported = NONE;
    }
  }

  /**
   * The picture now: the shown mean if it has this size, else plain. RangeError if no canvas can
   * hold it.
   */
  capture(size: Size): HTMLCanvasElement {
    const { picture, still } = this;
    const { width, height } = this.whole;
    const isMean = still.samples > 0 && size.width === width && size.height === height;
    if (!isMean) {
      picture.make(size, 1);
    }
    this.releaseUnlessAttached();
    return stage.capture(size, (renderer, part) => {
      if (isMean) {
        still.converging?.copy(renderer, part);
      } else {
        picture.draw(renderer, part);
      }
    });
  }

  /** Pictures drawn. The same in {@link stats}, which counts lights mesh by mesh. */
  get frames(): number {
    return this.#frames;
  }

  get stats(): ViewportStats {
    return {
      ...this.picture.stats,
      frames: this.#frames,
      reducedFrames: this.#reducedFrames,
      samples: this.still.samples,
      programs: stage.programs,
      viewersDrawn: stage.viewersDrawn,
    };
  }

  /** What has been drawn is on the pictures' canvases. */
  shown(): void {
    if (this.#painted === NONE || this.#painted === this.#reported) return;
    this.#reported = this.#painted;
    this.#signals.shown.emit();
  }

  contextLost(): void {
    this.picture.invalidate();
    this.#loop?.cancel(this);
    this.still.converging?.dispose();
    this.picture.release();
    this.#signals.contextLost.emit();
    this.#signals.frameEnded.emit();
  }

  contextRestored(): void {
    this.#wake();
    this.#signals.contextRestored.emit();
  }

  contextMissing(error: Error): void {
    this.#loop?.cancel(this);
    this.#signals.contextMissing.emit(error);
    this.#signals.frameEnded.emit();
  }

  /**
   * An element that only moves is back before the microtask; one that stays away gives its GPU
   * memory back.
   */
  releaseUnlessAttached(): void {
    queueMicrotask(() => {
      if (this.attached) return;
      this.still.converging?.dispose();
      this.picture.release();
    });
  }

  /**
   * After a change of visibility, size or context: requests a frame that was waiting, or takes the
   * request back.
   */
  #wake(): void {
    if (!this.drawable) {
      this.#loop?.cancel(this);
      this.still.converging?.pause();
    } else if (!this.upToDate || this.reduced || this.still.pending) {
      this.#loop?.request(this);
    }
  }
}
