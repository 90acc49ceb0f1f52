// The lights that some meshes are drawn with: all that are sent, or those that reach them. Knows neither meshes nor frames.
import { HEADER, ROWS } from '../light/light-layout.js';
import { forEachLight } from '../light/light-reach.js';
import { emptyPack, KINDS, type PackedLights, reserve } from '../light/pack-lights.js';
import { LightRows } from './light-rows.js';

export class LightList {
  readonly rows = new LightRows();
  #packed: PackedLights;
  #shapes = new Uint32Array(0);
  #counts: readonly number[] = [];
  #version = 0;

  constructor(packed = emptyPack()) {
    this.#packed = packed;
  }

  get packed(): Readonly<PackedLights> {
    return this.#packed;
  }

  /** Goes up when how many lights there are of each kind, or what one of them needs of a program, is other than before. */
  get shapeVersion(): number {
    return this.#version;
  }

  /** These are the lights from now on; `packed` may be one that was given before, written anew. */
  take(packed: PackedLights): void {
    this.#packed = packed;
    this.rows.write(packed);
    if (this.#isAsBefore(packed)) return;
    this.#version += 1;
    this.#counts = KINDS.map((kind) => packed.counts[kind]);
    this.#shapes = packed.shapes.slice(0, packed.sent);
  }

  /** Of the lights of `all` those that `mask` has a 1 for. */
  select(all: PackedLights, mask: Uint8Array): void {
    const into = this.#packed;
    reserve(into, all.rows, all.sent);
    into.active = all.active;
    into.sent = 0;
    into.rows = HEADER.rows;
    for (const kind of KINDS) into.counts[kind] = 0;
    forEachLight(all, (light, kind, row) => {
      if (mask[light] !== 1) return;
      const { rows } = ROWS[kind];
      for (let i = 0; i < rows * 4; i++) into.data[into.rows * 4 + i] = all.data[row * 4 + i]!;
      into.shapes[into.sent] = all.shapes[light] ?? 0;
      into.rows += rows;
      into.sent += 1;
      into.counts[kind] += 1;
    });
    into.data.set(all.data.subarray(0, HEADER.rows * 4), 0);
    into.data.set(
      KINDS.map((kind) => into.counts[kind]),
      HEADER.counts * 4,
    );
    this.take(into);
  }

  #isAsBefore({ counts, shapes, sent }: PackedLights): boolean {
    if (this.#version === 0 || sent !== this.#shapes.length) return false;
    for (let i = 0; i < KINDS.length; i++) if (counts[KINDS[i]!] !== this.#counts[i]) return false;
    for (let i = 0; i < sent; i++) if (shapes[i] !== this.#shapes[i]) return false;
    return true;
  }
}
