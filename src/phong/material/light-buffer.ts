// The packed lights that some meshes are drawn with, as the GPU reads them: a uniform array while
// they fit, a float texture beyond. Sends only what changed.
import { ExternalTexture, Vector2, type WebGLRenderer } from 'three';
import { TEXTURE_ROWS_LOG2 } from '../light/light-layout.js';
import { emptyPack, type PackedLights } from '../light/pack-lights.js';

const TEXTURE_WIDTH = 1 << TEXTURE_ROWS_LOG2;

/** The last revision that any buffer was given. */
let revisions = 0;

export class LightBuffer {
  /** Written to by the owner, who then calls {@link changed}. */
  readonly packed: PackedLights = emptyPack();
  /** What the GPU is to hold: a copy of the packed rows, in lines of the texture. */
  #data = new Float32Array(TEXTURE_WIDTH * 4);
  #rows = this.#data.subarray(0, 0);
  /**
   * Most rows ever held. Those beyond the last row stay: lights that come back find theirs
   * unchanged.
   */
  #written = 0;
  #revision = 0;
  /**
   * three.js uses it unchanged. A texture of three's own would query the anisotropy limit, which
   * blocks.
   */
  readonly #texture = new ExternalTexture();
  /**
   * Whose texture it is. three.js replaces a renderer's properties when a lost context is restored.
   */
  #owner: { readonly renderer: WebGLRenderer; readonly properties: object } | null = null;
  /** Rows that changed since they were sent to the texture; `to` is exclusive. */
  #stale = { from: 0, to: 0 };

  /** 1 / the texture's width and height. */
  readonly textureScale = new Vector2(1 / TEXTURE_WIDTH, 1);

  /** The last revision that was counted as an upload; kept by MeshLights. */
  counted = -1;

  /**
   * Increases whenever a number changes, and is no other buffer's. What is made from the lights
   * remembers it.
   */
  get revision(): number {
    return this.#revision;
  }

  get rows(): Float32Array {
    return this.#rows;
  }

  /**
   * Call after {@link packed} was written: copies what differs and marks its rows as stale. Cheap
   * where no number differs.
   */
  changed(): void {
    const { data, rows } = this.packed;
    if (rows * 4 > this.#data.length) {
      this.#grow(rows);
    }
    const end = rows * 4;
    const kept = this.#data;
    if (this.#rows.length !== end) {
      this.#rows = kept.subarray(0, end);
    }
    this.#written = Math.max(this.#written, rows);
    let first = 0;
    while (first < end && kept[first] === data[first]) {
      first += 1;
    }
    if (first === end) return;
    let last = end - 1;
    while (kept[last] === data[last]) {
      last -= 1;
    }
    kept.set(data.subarray(first, last + 1), first);
    this.#revision = revisions += 1;
    const [firstRow, endRow] = [first >> 2, (last >> 2) + 1];
    const { from, to } = this.#stale;
    this.#stale = {
      from: from < to ? Math.min(from, firstRow) : firstRow,
      to: Math.max(to, endRow),
    };
  }

  /** Sends changed rows to the texture and returns it. */
  sendTexture(renderer: WebGLRenderer): ExternalTexture {
    const { from, to } = this.#stale;
    const { state, properties } = renderer;
    const isNew = this.#owner?.properties !== properties;
    if (from === to && !isNew) return this.#texture;
    this.#stale = { from: 0, to: 0 };
    const gl = renderer.getContext() as WebGL2RenderingContext;
    if (isNew) {
      this.dispose();
      this.#texture.sourceTexture = gl.createTexture();
      this.#owner = { renderer, properties };
    }
    state.bindTexture(gl.TEXTURE_2D, this.#texture.sourceTexture as WebGLTexture);
    if (isNew) {
      allocateTexture(gl, this.#data.length / (TEXTURE_WIDTH * 4));
    }
    // three.js keeps track of these since r184. Before, it set them for each upload.
    const unpack = 'pixelStorei' in state ? state : gl;
    unpack.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    unpack.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    unpack.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
    sendRows(gl, this.#data, isNew ? 0 : from, isNew ? this.#written : to);
    return this.#texture;
  }

  /**
   * Frees the texture, or forgets one that a lost context took along; the next draw sends it again.
   */
  dispose(): void {
    const owner = this.#owner;
    const isThere = owner !== null && owner.properties === owner.renderer.properties;
    if (isThere) {
      owner.renderer.getContext().deleteTexture(this.#texture.sourceTexture);
    }
    this.#texture.sourceTexture = null;
    this.#owner = null;
  }

  /** Doubles, so that lights added one by one do not make a texture each. */
  #grow(rows: number): void {
    const height = Math.ceil(Math.max(rows * 4, this.#data.length * 2) / (TEXTURE_WIDTH * 4));
    this.textureScale.y = 1 / height;
    const grown = new Float32Array(height * TEXTURE_WIDTH * 4);
    grown.set(this.#data);
    this.#data = grown;
    this.#rows = grown.subarray(0, 0);
    this.dispose();
  }
}

/** For the bound texture, which is read by whole texels. */
function allocateTexture(gl: WebGL2RenderingContext, height: number) {
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  // An H200 takes 1.4 to 1.9 times as long with a texture that repeats, the default.
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, TEXTURE_WIDTH, height);
}

/** Sends rows [from, to) to the bound texture: a part of one line, or whole lines. */
function sendRows(gl: WebGL2RenderingContext, data: Float32Array, from: number, to: number): void {
  const line = from >> TEXTURE_ROWS_LOG2;
  const lines = Math.ceil(to / TEXTURE_WIDTH) - line;
  const x = lines === 1 ? from - line * TEXTURE_WIDTH : 0;
  const width = lines === 1 ? to - from : TEXTURE_WIDTH;
  const first = (line * TEXTURE_WIDTH + x) * 4;
  gl.texSubImage2D(gl.TEXTURE_2D, 0, x, line, width, lines, gl.RGBA, gl.FLOAT, data, first);
}
