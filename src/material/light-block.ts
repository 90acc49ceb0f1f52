// Packed lights as a uniform block, which programs for exactly these lights read at literal places: 0.5 of a texture's time on
// a GPU. Comes with those programs. What did not change is not sent.
import { DynamicDrawUsage, Uniform, UniformsGroup } from 'three';
import { BLOCK_ROWS, LARGE_BLOCK_ROWS } from '../light/light-layout.js';
import type { LightRows } from './light-rows.js';

/** Where the block's pieces begin: a change sends the pieces it touches, so four calls at most and 1 KiB for a few lights. */
const PIECES = [0, 64, 256, BLOCK_ROWS, LARGE_BLOCK_ROWS] as const;

/**
 * A piece of the block. three.js sends every typed array of a group in each frame, changed or not, so the group lists
 * only the pieces that wait to be sent; reading the value is how three.js takes it.
 */
class BlockPiece extends Uniform<Float32Array> {
  waiting = true;
  #data: Float32Array = new Float32Array(0);

  constructor() {
    super(new Float32Array(0));
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

  /** What it holds. */
  set data(data: Float32Array) {
    this.#data = data;
  }
}

/** The block of these rows: one for all programs that read it. */
export const lightBlockOf = (rows: LightRows): LightBlock => (rows.block ??= new LightBlock(rows.data));

export class LightBlock {
  /** As three.js takes it. */
  readonly group = new UniformsGroup();
  #rows = 0;
  readonly #pieces: readonly BlockPiece[];
  #uploads = 0;

  /** `data`: the memory of the rows, which it goes on to read. */
  constructor(data: Float32Array) {
    this.#pieces = PIECES.slice(1).map(() => new BlockPiece());
    this.group.setName('LightRows');
    this.group.setUsage(DynamicDrawUsage);
    this.moved(data);
    this.restore(); // three.js measures all of it
  }

  /** How often light data has been handed over for sending. */
  get uploads(): number {
    return this.#uploads;
  }

  /** Rows that a program for `rows` rows is to declare. The block's buffer may have more, and never less. */
  rowsFor(rows: number): number {
    return rows <= BLOCK_ROWS ? BLOCK_ROWS : Math.min(this.#rows, LARGE_BLOCK_ROWS);
  }

  /** Before a frame that reads it: lists what waits to be sent. */
  send(): void {
    const { uniforms } = this.group;
    uniforms.length = 0;
    for (const piece of this.#filled()) if (piece.waiting) uniforms.push(piece);
    if (uniforms.length > 0) this.#uploads += 1;
  }

  /** Binds the buffer that three.js has made for it and drawn with. */
  bind(gl: WebGL2RenderingContext): void {
    const { __bindingPointIndex: point = 0 } = this.group as { __bindingPointIndex?: number };
    const buffer = gl.getIndexedParameter(gl.UNIFORM_BUFFER_BINDING, point) as WebGLBuffer | null;
    gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
  }

  /** Sends what waits to its buffer, which is bound. */
  patch(gl: WebGL2RenderingContext): void {
    this.send();
    this.#pieces.forEach((piece, i) => {
      if (piece.waiting) gl.bufferSubData(gl.UNIFORM_BUFFER, (PIECES[i] ?? 0) * 16, piece.value);
    });
  }

  /** Rows [from, to) are others. */
  changed(from: number, to: number): void {
    this.#pieces.forEach((piece, i) => {
      if (from < (PIECES[i + 1] ?? 0) && to > (PIECES[i] ?? 0)) piece.waiting = true;
    });
  }

  /** The rows have moved into other memory. */
  moved(data: Float32Array): void {
    this.#rows = data.length / 4;
    this.#pieces.forEach((piece, i) => {
      piece.data = data.subarray((PIECES[i] ?? 0) * 4, (PIECES[i + 1] ?? 0) * 4);
    });
  }

  /** The GPU has lost everything: send it all again. */
  restore(): void {
    for (const piece of this.#pieces) piece.waiting = true;
    this.group.uniforms.splice(0, Infinity, ...this.#filled());
  }

  /** Frees what the GPU holds. */
  dispose(): void {
    this.group.dispose();
  }

  #filled(): readonly BlockPiece[] {
    return this.#pieces.filter(({ empty }) => !empty);
  }
}
