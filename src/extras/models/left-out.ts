// What a text file's model is shown without, for the one warning: things that are counted, each
// with its first reason, and features by name.

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
  /** The first of each kind. */
  readonly #reasons = new Map<LeftOutKind, string>();
  readonly #features = new Set<string>();

  add(kind: LeftOutKind, count = 1): void {
    if (count > 0) {
      this.#counts.set(kind, (this.#counts.get(kind) ?? 0) + count);
    }
  }

  /** Keeps the first reason of a kind, whether or not the thing will be left out. */
  because(kind: LeftOutKind, reason: () => string): void {
    if (!this.#reasons.has(kind)) {
      this.#reasons.set(kind, reason());
    }
  }

  /** A feature that the equation has no place for, by the file's own name. */
  feature(name: string): void {
    this.#features.add(name);
  }

  /** The phrases of the warning. */
  get names(): ReadonlySet<string> {
    const names = new Set<string>();
    for (const [kind, count] of this.#counts) {
      const reason = this.#reasons.get(kind);
      const what = `${count.toLocaleString('en')} ${NAMES[kind][count === 1 ? 0 : 1]}`;
      names.add(reason === undefined ? what : `${what} (${reason})`);
    }
    for (const feature of this.#features) {
      names.add(feature);
    }
    return names;
  }

  /** Why nothing is left of a model: the first reason known, or `otherwise`. */
  error(otherwise: string): Error {
    const reasons = (['face', 'vertex', 'triangle'] as const).map((kind) =>
      this.#reasons.get(kind),
    );
    return new Error(reasons.find((reason) => reason !== undefined) ?? otherwise);
  }
}
