// The samples of a picture while it stands still. The code that draws them is fetched with its
// first use.
import { lazyCode, reportMissing } from '../model/lazy-code.js';
import type { Size } from './gpu/atlas.js';
import type {
  ConvergingPicture,
  SampledViewport,
} from '../../extras/samples/converging-picture.js';

const sampling = /* @__PURE__ */ lazyCode(
  () => import('../../extras/samples/converging-picture.js'),
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
   * The mean of so many samples at this size; plain without float targets. RangeError if no canvas
   * can hold it.
   */
  async capture(size: Size, samples: number): Promise<HTMLCanvasElement> {
    const { captureSamples } = await sampling();
    return captureSamples(this.#viewport, size, samples);
  }

  async #fetch(): Promise<void> {
    try {
      const { ConvergingPicture } = await sampling();
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
