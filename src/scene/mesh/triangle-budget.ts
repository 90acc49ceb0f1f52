// The triangles that the meshes of one viewer hold: claimed before a geometry is built or read, within one limit for
// all of them.
import type { BufferGeometry } from 'three';
import { TRIANGLE_LIMIT, VALUES_PER_TRIANGLE } from '../../model/limits.js';
import { ModelError } from '../../model/model.js';

/** A geometry that a mesh holds. */
export interface Need {
  /** Equal keys are one geometry, which is counted once. */
  readonly key: object | string;
  /** Its triangles, weighed by memory: see {@link TRIANGLE_LIMIT}. A whole number, so that sums are exact. */
  readonly triangles: number;
  /** It is a copy for flat shading. */
  readonly flat: boolean;
}

/** A mesh that claims triangles. */
export interface Claimant {
  readonly wantsFlat: boolean;
  /** What was refused has room now. */
  again(): void;
}

/**
 * What the content of one mesh holds. Content that replaces other content of its mesh may take the room of it: until
 * the new one is drawn both are in memory, as before, so a model of any allowed size can be replaced by another.
 */
export class Claim {
  readonly #budget: TriangleBudget;
  readonly claimant: Claimant;
  /** Written by the budget. */
  needs: ReadonlyMap<Need['key'], Need> = new Map();

  constructor(budget: TriangleBudget, claimant: Claimant) {
    this.#budget = budget;
    this.claimant = claimant;
  }

  /** Claims these as well. @throws ModelError `too-large` past the limit; the claim is as before then. */
  add(needs: readonly Need[]): void {
    if (needs.every(({ key }) => this.needs.has(key))) return;
    this.#budget.take(this, [...this.needs.values(), ...needs]);
  }

  /** Claims what a model is about to allocate, in values of 4 bytes. @throws as {@link add} does. */
  readonly addValues = (values: number): void => {
    const before = this.needs.get(this)?.triangles ?? 0;
    const triangles = before + Math.ceil(values / VALUES_PER_TRIANGLE);
    const needs = new Map(this.needs).set(this, { key: this, triangles, flat: false });
    this.#budget.take(this, [...needs.values()]);
  };

  dropFlat(): void {
    this.keep([...this.needs.values()].filter(({ flat }) => !flat));
  }

  /** Holds nothing but these, which it holds already. */
  keep(needs: readonly Need[]): void {
    this.#budget.hold(this, needs);
  }

  release(): void {
    this.#budget.hold(this, []);
  }
}

interface Use {
  triangles: number;
  readonly claims: Set<Claim>;
}

export class TriangleBudget {
  #limit = TRIANGLE_LIMIT;
  #used = 0;
  readonly #uses = new Map<Need['key'], Use>();
  readonly #claims = new Map<Claimant, Set<Claim>>();
  /** What was claimed in vain, in the order in which it gets room again. */
  readonly #refused = new Map<Claimant, readonly Need[]>();
  #reviewing = false;

  /**
   * Most triangles, weighed by memory. Default and most: {@link TRIANGLE_LIMIT}. A lower one takes nothing away that is
   * shown.
   */
  get limit(): number {
    return this.#limit;
  }

  /** Null for the default. @throws TypeError or RangeError unless it is a whole number from 0 to the default. */
  set limit(limit: number | null) {
    const most = limit ?? TRIANGLE_LIMIT;
    if (typeof most !== 'number') throw new TypeError(`maxTriangles must be a number, not ${typeof most}.`);
    if (!Number.isInteger(most) || most < 0 || most > TRIANGLE_LIMIT)
      throw new RangeError(
        `maxTriangles must be a whole number from 0 to ${String(TRIANGLE_LIMIT)}, not ${String(most)}.`,
      );
    this.#limit = most;
    this.review();
  }

  /**
   * Triangles that are held now, weighed by memory. Round shapes with automatic segments count by their coarsest level:
   * a finer one takes at most what is left.
   */
  get used(): number {
    return this.#used;
  }

  claim(claimant: Claimant): Claim {
    return new Claim(this, claimant);
  }

  /** What was refused to this mesh is no longer wanted. */
  forget(claimant: Claimant): void {
    this.#refused.delete(claimant);
  }

  /**
   * At the end of the task, lets meshes that were refused try again as far as there is room. Call when they may need
   * less.
   */
  review(): void {
    if (this.#reviewing || this.#refused.size === 0) return;
    this.#reviewing = true;
    queueMicrotask(() => {
      this.#reviewing = false;
      for (const [claimant, needs] of [...this.#refused]) {
        const wanted = needs.filter(({ flat }) => !flat || claimant.wantsFlat);
        if (this.#totalWith(claimant, wanted) > this.#limit) continue;
        this.#refused.delete(claimant);
        claimant.again();
      }
    });
  }

  /** For claims: {@link hold} within the limit. @throws ModelError `too-large`. */
  take(claim: Claim, needs: readonly Need[]): void {
    const { claimant } = claim;
    const total = this.#totalWith(claimant, needs);
    if (total > this.#limit) {
      this.#refused.set(claimant, needs);
      throw new ModelError('too-large', tooLarge(total, this.#limit));
    }
    this.#refused.delete(claimant);
    this.hold(claim, needs);
  }

  /** For claims: `claim` holds these and nothing else. */
  hold(claim: Claim, needs: readonly Need[]): void {
    const next = new Map(needs.map((need) => [need.key, need]));
    for (const [key, { triangles }] of next) this.#use(claim, key, triangles);
    for (const key of claim.needs.keys()) if (!next.has(key)) this.#drop(claim, key);
    claim.needs = next;
    const claims = this.#claims.get(claim.claimant) ?? new Set();
    if (next.size > 0) this.#claims.set(claim.claimant, claims.add(claim));
    else if (claims.delete(claim) && claims.size === 0) this.#claims.delete(claim.claimant);
  }

  #use(claim: Claim, key: Need['key'], triangles: number): void {
    const use = this.#uses.get(key) ?? { triangles: 0, claims: new Set() };
    this.#uses.set(key, use);
    use.claims.add(claim);
    this.#used += triangles - use.triangles;
    use.triangles = triangles;
  }

  #drop(claim: Claim, key: Need['key']): void {
    const use = this.#uses.get(key);
    if (use?.claims.delete(claim) !== true || use.claims.size > 0) return;
    this.#uses.delete(key);
    this.#used -= use.triangles;
    this.review();
  }

  /** The triangles of all meshes if this one held these needs and nothing else. */
  #totalWith(claimant: Claimant, needs: readonly Need[]): number {
    const own = new Map<Need['key'], number>();
    for (const claim of this.#claims.get(claimant) ?? [])
      for (const key of claim.needs.keys()) {
        const { claims, triangles } = this.#uses.get(key)!;
        if (areOf(claimant, claims)) own.set(key, triangles);
      }
    let total = this.#used;
    for (const triangles of own.values()) total -= triangles;
    for (const { key, triangles } of new Map(needs.map((need) => [need.key, need])).values())
      if (own.has(key) || !this.#uses.has(key)) total += triangles;
    return total;
  }
}

/** Thousands of meshes can share a geometry: ends at the first one of another. */
function areOf(claimant: Claimant, claims: Iterable<Claim>): boolean {
  for (const claim of claims) if (claim.claimant !== claimant) return false;
  return true;
}

function tooLarge(triangles: number, limit: number): string {
  const [count, most] = [Math.ceil(triangles), limit].map((value) => value.toLocaleString('en'));
  return (
    `With this the viewer would hold ${count ?? ''} triangles; at most ${most ?? ''} can be shown. ` +
    'Use fewer segments, fewer different shapes, or another shading than "flat", which counts each triangle 4.4 times.'
  );
}

/** The triangles of a geometry's flat copy, weighed by memory: every corner has values of its own, as floats. */
export function flatTriangles({ attributes, index }: BufferGeometry): number {
  const sizes = Object.entries(attributes).map(([name, { itemSize }]) => (name === 'normal' ? 0 : itemSize));
  const corners = index?.count ?? attributes['position']?.count ?? 0;
  return Math.ceil((corners * sizes.reduce((sum, size) => sum + size, 3)) / VALUES_PER_TRIANGLE);
}
