// Keeps a model within the limits. Every format checks a file's claims before it allocates for them; past a limit the
// result is `too-large`. Apart from the limits themselves because no first frame needs it.
import {
  CORNER_LIMIT,
  IMAGE_PIXEL_LIMIT,
  JSON_LIMIT,
  MEMORY_LIMIT,
  NODE_LIMIT,
  PART_LIMIT,
  PIXEL_LIMIT,
  VALUE_LIMIT,
} from './limits.js';
import { ModelError } from './model.js';

/** What a model claims, in the units of the limits. */
export interface ModelClaims {
  readonly corners?: number;
  readonly values?: number;
  readonly parts?: number;
  readonly nodes?: number;
  readonly json?: number;
  readonly pixels?: number;
  /** The part of `pixels` that is transcoded (KTX2). Images are transcoded one after the other: the largest counts. */
  readonly transcoded?: number;
}

/** Adds up what a model claims. One instance per model. */
export class ModelBudget {
  #corners = 0;
  #values = 0;
  #parts = 0;
  #nodes = 0;
  #json = 0;
  #pixels = 0;
  #transcoded = 0;
  readonly #onValues: ((values: number) => void) | undefined;

  /**
   * @param onValues called before values are allocated, with their number; it may throw. For what other models take.
   */
  constructor(onValues?: (values: number) => void) {
    this.#onValues = onValues;
  }

  /** @throws ModelError `too-large` past a limit. Call before allocating. */
  add({
    corners = 0,
    values = 0,
    parts = 0,
    nodes = 0,
    json = 0,
    pixels = 0,
    transcoded = 0,
  }: ModelClaims): void {
    this.#transcoded = Math.max(this.#transcoded, transcoded);
    requireAtMost((this.#json += json), JSON_LIMIT, 'values in its JSON');
    requireAtMost((this.#nodes += nodes), NODE_LIMIT, 'nodes');
    requireAtMost((this.#parts += parts), PART_LIMIT, 'draws');
    requireAtMost((this.#corners += corners), CORNER_LIMIT, 'triangle corners');
    requireAtMost((this.#values += values), VALUE_LIMIT, 'numbers in its vertices');
    requireAtMost((this.#pixels += pixels), PIXEL_LIMIT, 'pixels in its images');
    requireAtMost(this.#memory, MEMORY_LIMIT, 'bytes in memory (vertices and images)');
    if (values > 0) this.#onValues?.(values);
  }

  /**
   * Bytes in the page and the GPU process, measured in Chromium with software GL. Values are there twice. A pixel takes
   * 4 bytes in the page and 5.3 on the GPU, with mipmaps; the image that is being uploaded takes 8 more, one that is
   * transcoded before 10. A draw takes 12 kB, a node 2 kB.
   */
  get #memory(): number {
    const uploading = 8 * Math.min(this.#pixels, IMAGE_PIXEL_LIMIT);
    const transcoding = 10 * this.#transcoded;
    return Math.ceil(
      8 * this.#values +
        9.4 * this.#pixels +
        Math.max(uploading, transcoding) +
        12_000 * this.#parts +
        2_000 * this.#nodes,
    );
  }
}

/** @throws ModelError `too-large` if a model claims more than the limit of something. */
export function requireAtMost(claimed: number, limit: number, what: string): void {
  if (claimed <= limit) return;
  const [count, most] = [claimed, limit].map((value) => value.toLocaleString('en'));
  throw new ModelError(
    'too-large',
    `The model has ${count ?? ''} ${what}; at most ${most ?? ''} can be shown.`,
  );
}
