// Packed lights on the GPU. Loops read a float texture, of any number of lights: measured, it is faster than a uniform block
// read by a running index (0.5 of the time in software, 0.9 on a GPU). Programs for exactly these lights read a uniform block;
// see light-block. What did not change, or is not read, is not sent.
import { ExternalTexture, type WebGLRenderer } from 'three';
import { TEXTURE_ROWS_LOG2 } from '../light/light-layout.js';
import type { PackedLights } from '../light/pack-lights.js';
import type { LightBlock } from './light-block.js';

const TEXTURE_WIDTH = 1 << TEXTURE_ROWS_LOG2;

/** The lights of one list, as materials read them. */
export class LightRows {
  /** The uniform block, once a program has asked for it. */
  block: LightBlock | null = null;
  #data = new Float32Array(TEXTURE_WIDTH * 4);
  /** What it stands for is made here: three.js would ask for each texture's anisotropy, and wait for the answer. */
  readonly #texture = new ExternalTexture();
  #gl: WebGL2RenderingContext | null = null;
  /** Rows that the texture on the GPU has not seen: from, and up to but without. */
  #stale = { from: 0, to: 0 };
  #uploads = 0;
  #version = 0;

  /** How often light data has been handed over for sending. */
  get uploads(): number {
    return this.#uploads + (this.block?.uploads ?? 0);
  }

  /** Goes up whenever a number is other than before. */
  get version(): number {
    return this.#version;
  }

  /** All rows, as far as there is room; other memory once they outgrow it. */
  get data(): Float32Array {
    return this.#data;
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

  /** What holds the rows for loops; null before they are sent. */
  get texture(): WebGLTexture | null {
    return this.#texture.sourceTexture;
  }

  /** The GPU has lost everything: send it all again. */
  restore(): void {
    this.block?.restore();
    this.#texture.sourceTexture = null;
    this.#stale = { from: 0, to: this.#data.length / 4 };
  }

  /** Frees what the GPU holds; drawing again sends it again. */
  dispose(): void {
    this.block?.dispose();
    this.#gl?.deleteTexture(this.#texture.sourceTexture);
    this.restore();
  }

  #changed(from: number, to: number): void {
    const { from: first, to: last } = this.#stale;
    this.#stale = first < last ? { from: Math.min(from, first), to: Math.max(to, last) } : { from, to };
    this.block?.changed(from, to);
  }

  /** Room to double, so that lights added one by one do not make a texture and a buffer each. */
  #grow(rows: number): void {
    const height = Math.ceil(Math.max(rows * 4, this.#data.length * 2) / (TEXTURE_WIDTH * 4));
    const grown = new Float32Array(height * TEXTURE_WIDTH * 4);
    grown.set(this.#data);
    this.#data = grown;
    this.block?.moved(grown);
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
