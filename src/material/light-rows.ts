// Packed lights on the GPU. Loops read a float texture, of any number of lights: measured, it is faster than a uniform block
// read by a running index (0.5 of the time in software, 0.9 on a GPU). Programs for exactly these lights read a uniform block at
// literal places (0.5 of a texture's time on a GPU). What did not change, or is not read, is not sent.
import { DynamicDrawUsage, ExternalTexture, Uniform, UniformsGroup, type WebGLRenderer } from 'three';
import { BLOCK_ROWS, LARGE_BLOCK_ROWS, TEXTURE_ROWS_LOG2 } from '../light/light-layout.js';
import type { PackedLights } from '../light/pack-lights.js';

const TEXTURE_WIDTH = 1 << TEXTURE_ROWS_LOG2;

/** Where the block's pieces begin: a change sends the pieces it touches, so four calls at most and 1 KiB for a few lights. */
const PIECES = [0, 64, 256, BLOCK_ROWS, LARGE_BLOCK_ROWS] as const;

/**
 * A piece of the block. three.js sends every typed array of a group in each frame, changed or not, so the group lists
 * only the pieces that wait to be sent; reading the value is how three.js takes it.
 */
class BlockPiece extends Uniform<Float32Array> {
  waiting = true;
  #data: Float32Array;

  constructor(data: Float32Array) {
    super(new Float32Array(0));
    this.#data = data;
    Object.defineProperty(this, 'value', {
      get: () => {
        this.waiting = false;
        return this.#data;
      },
    });
  }

  /** None: the rows end before it. */
  get empty(): boolean {
    return this.#data.length === 0;
  }

  /** The rows have moved into other memory. */
  set data(data: Float32Array) {
    this.#data = data;
  }
}

/** The lights of one list, as materials read them. */
export class LightRows {
  /** The uniform block. */
  readonly group = new UniformsGroup();
  #data = new Float32Array(TEXTURE_WIDTH * 4);
  /** What it stands for is made here: three.js would ask for each texture's anisotropy, and wait for the answer. */
  readonly #texture = new ExternalTexture();
  #gl: WebGL2RenderingContext | null = null;
  /** Rows that the texture on the GPU has not seen: from, and up to but without. */
  #stale = { from: 0, to: 0 };
  readonly #pieces: readonly BlockPiece[];
  #uploads = 0;
  #version = 0;

  constructor() {
    this.#pieces = PIECES.slice(1).map((end, i) => new BlockPiece(this.#rows(PIECES[i] ?? 0, end)));
    this.group.setName('LightRows');
    this.group.setUsage(DynamicDrawUsage);
    this.group.uniforms.push(...this.#filled()); // all of them, when three.js measures the block
  }

  /** How often light data has been handed over for sending. */
  get uploads(): number {
    return this.#uploads;
  }

  /** Goes up whenever a number is other than before. */
  get version(): number {
    return this.#version;
  }

  /** Rows of the block that a program for `rows` rows is to declare. Its buffer may have more, and never less. */
  blockRowsFor(rows: number): number {
    return rows <= BLOCK_ROWS ? BLOCK_ROWS : Math.min(this.#data.length / 4, LARGE_BLOCK_ROWS);
  }

  /** Takes what changed in `packed`. Cheap when nothing did. */
  write({ data, rows }: PackedLights): void {
    if (rows * 4 > this.#data.length) this.#grow(rows);
    const kept = this.#data;
    const end = rows * 4;
    let first = 0;
    while (first < end && kept[first] === data[first]) first += 1;
    if (first === end) return;
    this.#version += 1;
    let last = end - 1;
    while (kept[last] === data[last]) last -= 1;
    for (let i = first; i <= last; i++) kept[i] = data[i] ?? 0;
    this.#changed(first >> 2, (last >> 2) + 1);
  }

  /** Before a draw that reads the texture: sends it what has changed. */
  sendTexture(renderer: WebGLRenderer): ExternalTexture {
    const { from, to } = this.#stale;
    if (from === to) return this.#texture;
    this.#uploads += 1;
    this.#stale = { from: 0, to: 0 };
    const { state } = renderer;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const made = this.#texture.sourceTexture !== null;
    if (!made) this.#texture.sourceTexture = gl.createTexture();
    this.#gl = gl;
    state.bindTexture(gl.TEXTURE_2D, this.#texture.sourceTexture as WebGLTexture);
    if (!made) {
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, TEXTURE_WIDTH, this.#data.length / (TEXTURE_WIDTH * 4));
    }
    state.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    state.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    state.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
    patch(gl, this.#data, from, to);
    return this.#texture;
  }

  /** Before a frame that reads the block: lists what waits to be sent. */
  sendBlock(): void {
    const { uniforms } = this.group;
    uniforms.length = 0;
    for (const piece of this.#filled()) if (piece.waiting) uniforms.push(piece);
    if (uniforms.length > 0) this.#uploads += 1;
  }

  /** Binds the buffer that three.js has made for the block and drawn with. */
  bindBlock(gl: WebGL2RenderingContext): void {
    const { __bindingPointIndex: point = 0 } = this.group as { __bindingPointIndex?: number };
    const buffer = gl.getIndexedParameter(gl.UNIFORM_BUFFER_BINDING, point) as WebGLBuffer | null;
    gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
  }

  /** Sends what the block waits for to its buffer, which is bound. */
  patchBlock(gl: WebGL2RenderingContext): void {
    this.sendBlock();
    this.#pieces.forEach((piece, i) => {
      if (piece.waiting) gl.bufferSubData(gl.UNIFORM_BUFFER, (PIECES[i] ?? 0) * 16, piece.value);
    });
  }

  /** What holds the rows for loops; null before they are sent. */
  get texture(): WebGLTexture | null {
    return this.#texture.sourceTexture;
  }

  /** The GPU has lost everything: send it all again. */
  restore(): void {
    for (const piece of this.#pieces) piece.waiting = true;
    this.group.uniforms.splice(0, Infinity, ...this.#filled());
    this.#texture.sourceTexture = null;
    this.#stale = { from: 0, to: this.#data.length / 4 };
  }

  /** Frees what the GPU holds; drawing again sends it again. */
  dispose(): void {
    this.group.dispose();
    this.#gl?.deleteTexture(this.#texture.sourceTexture);
    this.restore();
  }

  #filled(): readonly BlockPiece[] {
    return this.#pieces.filter(({ empty }) => !empty);
  }

  #rows(from: number, to: number): Float32Array {
    return this.#data.subarray(from * 4, to * 4);
  }

  #changed(from: number, to: number): void {
    const { from: first, to: last } = this.#stale;
    this.#stale = first < last ? { from: Math.min(from, first), to: Math.max(to, last) } : { from, to };
    this.#pieces.forEach((piece, i) => {
      if (from < (PIECES[i + 1] ?? 0) && to > (PIECES[i] ?? 0)) piece.waiting = true;
    });
  }

  /** Room to double, so that lights added one by one do not make a texture and a buffer each. */
  #grow(rows: number): void {
    const height = Math.ceil(Math.max(rows * 4, this.#data.length * 2) / (TEXTURE_WIDTH * 4));
    const grown = new Float32Array(height * TEXTURE_WIDTH * 4);
    grown.set(this.#data);
    this.#data = grown;
    this.#pieces.forEach((piece, i) => {
      piece.data = this.#rows(PIECES[i] ?? 0, PIECES[i + 1] ?? 0);
    });
    this.dispose();
  }
}

/** Sends rows [from, to) to the texture that is bound: a part of one line, or whole lines. */
function patch(gl: WebGL2RenderingContext, data: Float32Array, from: number, to: number): void {
  const line = from >> TEXTURE_ROWS_LOG2;
  const lines = Math.ceil(to / TEXTURE_WIDTH) - line;
  const x = lines === 1 ? from - line * TEXTURE_WIDTH : 0;
  const width = lines === 1 ? to - from : TEXTURE_WIDTH;
  const first = (line * TEXTURE_WIDTH + x) * 4;
  gl.texSubImage2D(gl.TEXTURE_2D, 0, x, line, width, lines, gl.RGBA, gl.FLOAT, data, first);
}
