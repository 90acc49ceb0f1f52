// The samples of a picture while it stands still. The code that draws them is fetched with its
// first use.
import type { WebGLRenderer } from 'three';
import { extraCode, reportMissing } from '../model/provided-code.js';
import type { Region, Size } from '../../phong/math/region.js';
import type { Picture } from './picture.js';

/** Whose picture is sampled; its size is in device pixels. */
export interface SampledViewport extends Size {
  readonly picture: Picture;
  /** In view, and not only near it. */
  readonly visible: boolean;
  readonly attached: boolean;
  /** Requests a frame. */
  animate(): void;
  /** Shows the kept mean. `last`: it has all samples. */
  show(last: boolean): void;
  /** The picture now, of this size, without samples of its own. */
  capture(size: Size): HTMLCanvasElement;
  /** Gives the GPU's memory back if it is not on the page. */
  releaseUnlessAttached(): void;
}

/** The picture of a viewport that gets more samples while nothing changes. */
export interface ConvergingPicture {
  /** Samples of the picture that is shown; 0: the plain one. */
  readonly samples: number;
  /** More samples are to come, as long as nothing changes. */
  readonly pending: boolean;
  /** Call in an animation frame without a change. True: call again in the next one. */
  step(): boolean;
  /**
   * While it is pending: draws what is missing now, without turns and frames, up to a time of
   * `performance.now()`.
   */
  finish(deadline: number): void;
  /** Something has changed. */
  reset(): void;
  /** Stops for as long as nobody can see the picture. What is shown stays. */
  pause(): void;
  /** Fills the renderer's present viewport with the kept picture, or with a part of it. */
  copy(renderer: WebGLRenderer, part?: Region): void;
  dispose(): void;
}

interface SamplingCode {
  readonly ConvergingPicture: new (viewport: SampledViewport, wanted: number) => ConvergingPicture;
  readonly captureSamples: (
    viewport: SampledViewport,
    size: Size,
    samples: number,
  ) => Promise<HTMLCanvasElement>;
}

export const samplingCode = /* @__PURE__ */ extraCode<SamplingCode>(
  'antialias="full" and toBlob({ samples })',
);

export class StillPicture {
  readonly #viewport: SampledViewport;
  readonly #settled: () => void;
  #wanted = 0;
  #converging: ConvergingPicture | null = null;

  /** `settled`: no more samples are to come, because all are there or cannot be drawn. */
  constructor(viewport: SampledViewport, settled: () => void) {
    this.#viewport = viewport;
    this.#settled = settled;
  }

  /** Null while no samples are wanted or the code is being fetched. */
  get converging(): ConvergingPicture | null {
    return this.#converging;
  }

  /** Samples per pixel. 0, the default: the picture stays as it was drawn. */
  get wanted(): number {
    return this.#wanted;
  }

  set wanted(samples: number) {
    if (samples === this.#wanted) return;
    this.#wanted = samples;
    this.#converging?.dispose();
    this.#converging = null;
    if (samples > 0) {
      void this.#fetch();
    }
    this.#viewport.picture.invalidate();
  }

  /** Samples of the picture that is shown; 0: it is as it was drawn. */
  get samples(): number {
    return this.#converging?.samples ?? 0;
  }

  /** Samples are to come while nothing changes. */
  get pending(): boolean {
    return this.#wanted > 0 && (this.#converging?.pending ?? true);
  }

  /** Call in an animation frame in which nothing moves. True: call again in the next one. */
  step(): boolean {
    try {
      return this.#converging?.step() === true;
    } finally {
      if (!this.pending) {
        this.#settled();
      }
    }
  }

  finish(deadline: number): void {
    if (this.pending) {
      this.#converging?.finish(deadline);
    }
    if (!this.pending) {
      this.#settled();
    }
  }

  /**
   * The mean of `samples` samples at this size; plain without float targets. RangeError if no
   * canvas can hold it.
   */
  async capture(size: Size, samples: number): Promise<HTMLCanvasElement> {
    const { captureSamples } = await samplingCode();
    return captureSamples(this.#viewport, size, samples);
  }

  async #fetch(): Promise<void> {
    try {
      const { ConvergingPicture } = await samplingCode();
      if (this.#wanted === 0 || this.#converging !== null) return;
      this.#converging = new ConvergingPicture(this.#viewport, this.#wanted);
      this.#viewport.animate();
    } catch (error) {
      reportMissing(error);
      this.#wanted = 0;
      this.#settled();
    }
  }
}
