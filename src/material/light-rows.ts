// Packed lights on the GPU: a uniform block of 16 KiB, or beyond that a float texture; what did not change is not
// sent again. Knows nothing of what the rows mean.
import {
  DataTexture,
  DynamicDrawUsage,
  FloatType,
  NearestFilter,
  RGBAFormat,
  Uniform,
  UniformsGroup,
} from 'three';
import { BLOCK_ROWS, TEXTURE_ROWS_LOG2 } from '../light/light-layout.js';
import type { PackedLights } from '../light/pack-lights.js';
import type { LightStorage } from './variant.js';

/** Rows sent at a time: 1 KiB. A page's usual few lights are one piece, and so is a change to one of many. */
const PIECE_ROWS = 64;
const TEXTURE_WIDTH = 1 << TEXTURE_ROWS_LOG2;

/**
 * A piece of the block. three.js sends every typed array of a group in each frame, changed or not, so the group lists
 * only the pieces that wait to be sent; reading the value is how three.js takes it.
 */
class BlockPiece extends Uniform<Float32Array> {
  readonly data = new Float32Array(PIECE_ROWS * 4);
  waiting = true;

  constructor() {
    super(new Float32Array(0));
    Object.defineProperty(this, 'value', {
      get: () => {
        this.waiting = false;
        return this.data;
      },
    });
  }
}

/** The lights of one picture, as its materials read them. */
export class LightRows {
  /** The uniform block: shared by all materials of the picture. */
  readonly group = new UniformsGroup();
  /** Value of the sampler `uLightTexture`; null while the block holds everything. */
  readonly texture: { value: DataTexture | null } = { value: null };
  readonly #pieces = Array.from({ length: BLOCK_ROWS / PIECE_ROWS }, () => new BlockPiece());
  #storage: LightStorage = 'block';
  #uploads = 0;

  constructor() {
    this.group.setName('LightRows');
    this.group.setUsage(DynamicDrawUsage);
    this.restore();
  }

  get storage(): LightStorage {
    return this.#storage;
  }

  /** How often light data has been handed over for sending. */
  get uploads(): number {
    return this.#uploads;
  }

  /** Takes what changed in `packed`. Cheap when nothing did. */
  write(packed: PackedLights): void {
    const changed = packed.rows <= BLOCK_ROWS ? this.#writeBlock(packed) : this.#writeTexture(packed);
    if (changed) this.#uploads += 1;
  }

  /** Before each frame: lists what waits to be sent. */
  prepare(): void {
    const { uniforms } = this.group;
    uniforms.length = 0;
    for (const piece of this.#pieces) if (piece.waiting) uniforms.push(piece);
  }

  /** The GPU has lost everything: send it all again. */
  restore(): void {
    for (const piece of this.#pieces) piece.waiting = true;
    this.prepare();
    if (this.texture.value !== null) this.texture.value.needsUpdate = true;
  }

  /** Frees what the GPU holds; drawing again sends it again. */
  dispose(): void {
    this.group.dispose();
    this.texture.value?.dispose();
    this.restore();
  }

  #writeBlock({ data, rows }: PackedLights): boolean {
    this.#storage = 'block';
    let changed = false;
    for (let first = 0; first < rows; first += PIECE_ROWS) {
      const piece = this.#pieces[first / PIECE_ROWS];
      const end = Math.min(rows, first + PIECE_ROWS) * 4;
      if (piece !== undefined && copyChanges(data, first * 4, end, piece.data)) {
        piece.waiting = true;
        changed = true;
      }
    }
    return changed;
  }

  #writeTexture({ data, rows }: PackedLights): boolean {
    this.#storage = 'texture';
    const height = Math.ceil(rows / TEXTURE_WIDTH);
    let texture = this.texture.value;
    if (texture === null || texture.image.height < height) {
      texture?.dispose();
      // Room to double, so that lights added one by one do not make a texture each.
      texture = lightTexture(Math.max(height, 2 * (texture?.image.height ?? 0)));
      this.texture.value = texture;
    }
    const changed = copyChanges(data, 0, rows * 4, texture.image.data as Float32Array);
    if (changed) texture.needsUpdate = true;
    return changed;
  }
}

function lightTexture(height: number): DataTexture {
  const data = new Float32Array(TEXTURE_WIDTH * height * 4);
  const texture = new DataTexture(data, TEXTURE_WIDTH, height, RGBAFormat, FloatType);
  texture.minFilter = NearestFilter;
  texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** Copies from[begin, end) to the start of `to`; true where anything differed. */
function copyChanges(from: Float32Array, begin: number, end: number, to: Float32Array): boolean {
  let changed = false;
  for (let i = begin; i < end; i++) {
    const value = from[i] ?? 0;
    if (to[i - begin] !== value) {
      to[i - begin] = value;
      changed = true;
    }
  }
  return changed;
}
