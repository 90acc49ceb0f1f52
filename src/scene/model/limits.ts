// How large may a model be? Every format checks a file's claims against these before it allocates for them; past one of them the
// result is `too-large`. Chosen so that the page's renderer and GPU process together grow by less than 1 GB. Knows no format.
import { ModelError } from './model.js';

/**
 * Most bytes of one model, all its files together, as they arrive after decompression: 256 MiB. The reader holds the bytes and their
 * copies as vertices, and the GPU holds the vertices once more.
 */
export const BYTE_LIMIT = 2 ** 28;

/** Most triangle corners in all draws of a model, repeated meshes counted each time: 5.6 million triangles. */
export const CORNER_LIMIT = 2 ** 24;

/**
 * Most corners, and most vertices, of one Draco mesh: a million triangles. The decoder's heap and what comes out of it take 500 MB for
 * them, and 1.1 GB for two million. A larger model can have several such meshes.
 */
export const DRACO_LIMIT = 3 * 2 ** 20;

/**
 * Most 4-byte values in a model's vertices and indices, each geometry counted once as it is drawn: 400 MB in the page, and as much on the
 * GPU. Enough for 5 million triangles with a position and a normal per corner.
 */
export const VALUE_LIMIT = 100_000_000;

/** Most draws of a model. Each costs 10 to 30 µs of script per frame, so this many leave a few frames per second. */
export const PART_LIMIT = 10_000;

/** Most nodes of a model's tree, with or without meshes. Each takes 2 kB and 20 µs while the model is read. */
export const NODE_LIMIT = 30_000;

/** Most values in a model's JSON, counted by its brackets and commas. A parsed value takes up to 200 bytes while the model is read. */
export const JSON_LIMIT = 2 ** 21;

/** Most pixels in all images of a model, as its files claim: one image of 8192 × 8192, or 64 of 1024 × 1024. */
export const PIXEL_LIMIT = 2 ** 26;

/** Longest side of an image as it is shown; larger ones are scaled down. All but old phones have textures of this size. */
export const IMAGE_SIDE_LIMIT = 8192;

/** Most pixels of an image as it is shown; larger ones are scaled down. While it is uploaded, its memory is needed four times. */
export const IMAGE_PIXEL_LIMIT = 2 ** 25;

/** Most bytes that a model may take in the page and the GPU process together, by the estimate in {@link ModelBudget}. */
export const MEMORY_LIMIT = 950_000_000;

/** What a model claims, in the units of the limits above. */
export interface ModelClaims {
  readonly corners?: number;
  readonly values?: number;
  readonly parts?: number;
  readonly nodes?: number;
  readonly json?: number;
  readonly pixels?: number;
  /** Those of `pixels` that are transcoded (KTX2). Images are transcoded one after the other: the largest counts. */
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
  }

  /**
   * Bytes in the page and the GPU process, measured in Chromium with software GL. Values are there twice. A pixel takes 4 bytes in the
   * page and 5.3 on the GPU, with mipmaps; the image that is being uploaded takes 8 more, one that is
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
