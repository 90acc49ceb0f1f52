// What a text file's model is shown without, for the one warning: things that are counted, each
// with its first reason, and features by name.
import type { Slices } from './slices.js';
import { lineOf } from './text/text-scanner.js';

const NAMES = {
  vertex: ['vertex', 'vertices'],
  face: ['face', 'faces'],
  triangle: ['triangle', 'triangles'],
  uv: ["face's texture coordinates", "faces' texture coordinates"],
  normal: ["face's normals", "faces' normals"],
  corner: ['end of a corner of a face', 'ends of corners of faces'],
  line: ['line', 'lines'],
  point: ['point', 'points'],
  curve: ['curve or surface', 'curves and surfaces'],
  surplus: [
    'line with more values than its header names',
    'lines with more values than its header names',
  ],
  material: ['material that no library has', 'materials that no library has'],
} satisfies Readonly<Record<string, readonly [one: string, many: string]>>;

export type LeftOutKind = keyof typeof NAMES;

export class LeftOut {
  readonly #counts = new Map<LeftOutKind, number>();
  /** The first of each kind, with the position in the file where its line helps. */
  readonly #reasons = new Map<
    LeftOutKind,
    { readonly text: string; readonly at: number | undefined }
  >();
  readonly #features = new Set<string>();

  add(kind: LeftOutKind, count = 1): void {
    if (count > 0) {
      this.#counts.set(kind, (this.#counts.get(kind) ?? 0) + count);
    }
  }

  /** Keeps the first reason of a kind, whether or not the thing will be left out. */
  because(kind: LeftOutKind, reason: () => string, at?: number): void {
    if (!this.#reasons.has(kind)) {
      this.#reasons.set(kind, { text: reason(), at });
    }
  }

  /** A feature that the equation has no place for, by the file's own name. */
  feature(name: string): void {
    this.#features.add(name);
  }

  /** The phrases of the warning. */
  async names(bytes: Uint8Array, slices: Slices): Promise<ReadonlySet<string>> {
    const names = new Set<string>();
    for (const [kind, count] of this.#counts) {
      const reason = await this.#reason(kind, bytes, slices);
      const what = `${count.toLocaleString('en')} ${NAMES[kind][count === 1 ? 0 : 1]}`;
      names.add(reason === '' ? what : `${what} (${reason})`);
    }
    for (const feature of this.#features) {
      names.add(feature);
    }
    return names;
  }

  /** Why nothing is left of a model: the first reason known, or `otherwise`. */
  async error(bytes: Uint8Array, slices: Slices, otherwise: string): Promise<Error> {
    for (const kind of ['face', 'vertex', 'triangle'] as const) {
      const reason = await this.#reason(kind, bytes, slices);
      if (reason !== '') return new Error(reason);
    }
    return new Error(otherwise);
  }

  async #reason(kind: LeftOutKind, bytes: Uint8Array, slices: Slices): Promise<string> {
    const reason = this.#reasons.get(kind);
    if (reason === undefined) return '';
    const { text, at } = reason;
    return at === undefined ? text : `line ${String(await lineOf(bytes, at, slices))}: ${text}`;
  }
}
