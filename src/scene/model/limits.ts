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
 * Most 4-byte values in a model's vertices and indices, each geometry counted once as it is drawn: 448 MiB in the page, and as much
 * on the GPU. Enough for 5 million triangles with a position and a normal per corner.
 */
export const VALUE_LIMIT = 7 * 2 ** 24;

/** Most draws of a model. Each costs 10 to 30 µs of script per frame, so this many leave a few frames per second. */
export const PART_LIMIT = 10_000;

/** Most nodes of a model's tree, with or without meshes. Each takes about 2 kB while the model is read. */
export const NODE_LIMIT = 50_000;

/** Most pixels in all images of a model: one image of 8192 × 8192. A pixel takes 4 bytes in the page and 5.3 on the GPU, with mipmaps. */
export const PIXEL_LIMIT = 2 ** 26;

/** Longest side of an image as it is shown; larger ones are scaled down. All but old phones have textures of this size. */
export const IMAGE_SIDE_LIMIT = 8192;

/** What a model claims, in the units of the limits above. */
export interface ModelClaims {
  readonly corners?: number;
  readonly values?: number;
  readonly parts?: number;
  readonly nodes?: number;
  readonly pixels?: number;
}

/** Adds up what a model claims. One instance per model. */
export class ModelBudget {
  #corners = 0;
  #values = 0;
  #parts = 0;
  #nodes = 0;
  #pixels = 0;

  /** @throws ModelError `too-large` past a limit. Call before allocating. */
  add({ corners = 0, values = 0, parts = 0, nodes = 0, pixels = 0 }: ModelClaims): void {
    require((this.#parts += parts), PART_LIMIT, 'draws');
    require((this.#nodes += nodes), NODE_LIMIT, 'nodes');
    require((this.#corners += corners), CORNER_LIMIT, 'triangle corners');
    require((this.#values += values), VALUE_LIMIT, 'numbers in its vertices');
    require((this.#pixels += pixels), PIXEL_LIMIT, 'pixels in its images');
  }
}

function require(claimed: number, limit: number, what: string): void {
  if (claimed <= limit) return;
  const [count, most] = [claimed, limit].map((value) => value.toLocaleString('en'));
  throw new ModelError(
    'too-large',
    `The model has ${count ?? ''} ${what}; at most ${most ?? ''} can be shown.`,
  );
}
