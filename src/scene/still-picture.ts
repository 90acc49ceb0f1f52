// The samples of a picture while it stands still. The code that draws them is fetched with its first use.
import type { WebGLRenderer } from 'three';
import { lazyCode, reportMissing } from '../model/lazy-code.js';
import type { Region, Size } from './gpu/atlas.js';
import type { ConvergingPicture } from './samples/converging-picture.js';
import type { Viewport } from './viewport.js';

const sampling = /* @__PURE__ */ lazyCode(
  () => import('./samples/converging-picture.js'),
  'antialias="full" and toBlob({ samples })',
);

export class StillPicture {
  readonly #subject: Viewport;
  readonly #settled: () => void;
  #wanted = 0;
  /** Null while no samples are wanted or the code is being fetched. */
  #converging: ConvergingPicture | null = null;

  /** `settled`: no more samples are to come, because all are there or cannot be drawn. */
  constructor(subject: Viewport, settled: () => void) {
    this.#subject = subject;
    this.#settled = settled;
  }

  /** Samples per pixel. 0, the default: the picture stays as it was drawn. */
  get wanted(): number {
    return this.#wanted;
  }

  set wanted(samples: number) {
    if (samples === this.#wanted) return;
    this.#wanted = samples;
    this.dispose();
    this.#converging = null;
    if (samples > 0) void this.#fetch();
    this.#subject.picture.invalidate();
  }

  /** Samples of the picture that is shown; 0: it is as it was drawn. */
  get samples(): number {
    return this.#converging?.samples ?? 0;
  }

  /** Samples are to come while nothing changes. */
  get pending(): boolean {
    return this.#wanted > 0 && (this.#converging?.pending ?? true);
  }

  /** The code is there, so that an animation frame brings samples. */
  get startable(): boolean {
    return this.#converging?.pending === true;
  }

  /** Call in an animation frame in which nothing moves. True: call again in the next one. */
  step(): boolean {
    try {
      return this.#converging?.step() === true;
    } finally {
      if (!this.pending) this.#settled();
    }
  }

  /** Draws the missing samples now, as far as `deadline` allows: a time as of `performance.now()`. */
  finish(deadline: number): void {
    if (this.startable) this.#converging?.finish(deadline);
    if (!this.pending) this.#settled();
  }

  /** Draws the mean of {@link samples} in place of the scene, or the part of it that `part` is. */
  copy(renderer: WebGLRenderer, part?: Region): void {
    this.#converging?.copy(renderer, part);
  }

  /**
   * The mean of so many samples of each pixel, at exactly this size in pixels. It begins again when the scene changes.
   * Rejects with RangeError if no canvas can hold it. Where the GPU has no float targets it is the plain picture.
   */
  async capture(size: Size, samples: number): Promise<HTMLCanvasElement> {
    const { captureSamples } = await sampling();
    return captureSamples(this.#subject, size, samples);
  }

  /** Something has changed. */
  reset(): void {
    this.#converging?.reset();
  }

  /** Nobody can see the picture. */
  pause(): void {
    this.#converging?.pause();
  }

  /** Gives back what the GPU holds. */
  dispose(): void {
    this.#converging?.dispose();
  }

  async #fetch(): Promise<void> {
    try {
      const { ConvergingPicture } = await sampling();
      if (this.#wanted === 0 || this.#converging !== null) return;
      this.#converging = new ConvergingPicture(this.#subject, this.#wanted);
      this.#subject.animate();
    } catch (error) {
      reportMissing(error);
      this.#wanted = 0;
      this.#settled();
    }
  }
}
