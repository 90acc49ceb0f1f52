// What the files and shapes of one viewer claim, before anything is allocated. What meshes share
// counts once.
import { LIMITS, VALUES_PER_TRIANGLE } from './limits.js';
import { ModelError } from './model.js';

/** What is limited, in the order in which it is checked, and its words in messages. */
const WORDS = {
  /** Of files, unpacked. */
  bytes: 'bytes in its files',
  /** Without data in base64. */
  text: 'bytes of text',
  json: 'values in its JSON',
  nodes: 'nodes',
  /** Each instance too: once for each mesh that shows the same content. */
  parts: 'draws',
  /** Repeated meshes of a file counted each time. */
  corners: 'triangle corners',
  /** Of 4 bytes, in vertices and indices. */
  values: 'numbers in its vertices',
  pixels: 'pixels in its images',
  /** Beyond those: keys, list entries, tokens. One takes some 10 ns. */
  work: 'items to read',
};

export type Amounts = Readonly<Record<keyof typeof WORDS, number>>;

/** What is claimed, in the units of the limits. */
export type Claims = Partial<Amounts>;

const KEYS = /* @__PURE__ */ (() => Object.keys(WORDS) as (keyof Claims)[])();

export const NO_CLAIMS = /* @__PURE__ */ (() =>
  Object.fromEntries(KEYS.map((key) => [key, 0])) as unknown as Amounts)();

export function plus(a: Amounts, b: Claims): Amounts {
  const sum = { ...a };
  for (const key of KEYS) {
    sum[key] += b[key] ?? 0;
  }
  return sum;
}

/**
 * Bytes in the page and the GPU process, measured in Chromium with software GL. Values are there
 * twice. A pixel takes 4 bytes in the page and 5.33 on the GPU, with mipmaps; the image that is
 * being uploaded takes 8 more. A draw takes 12 kB, a node 2 kB.
 */
const memoryOf = ({ values, pixels, parts, nodes }: Amounts) =>
  Math.ceil(
    8 * values +
      9.33 * pixels +
      8 * Math.min(pixels, LIMITS.imagePixels) +
      12e3 * parts +
      2000 * nodes,
  );

/**
 * @param share of all limits.
 * @throws ModelError `too-large` if one file claims more than may be shown.
 */
export function requireWithin(amounts: Amounts, subject = 'The model has', share = 1): void {
  for (const key of KEYS) {
    requireAtMost(amounts[key], Math.floor(share * LIMITS[key]), WORDS[key], subject);
  }
  requireAtMost(
    memoryOf(amounts),
    Math.floor(share * LIMITS.memory),
    'bytes in memory (vertices and images)',
    subject,
  );
}

/** @throws ModelError `too-large` if more than the limit of something is claimed. */
export function requireAtMost(
  claimed: number,
  limit: number,
  what: string,
  subject = 'The model has',
): void {
  if (claimed <= limit) return;
  const [count, most] = [claimed, limit].map((value) => value.toLocaleString('en'));
  throw new ModelError(
    'too-large',
    `${subject} ${count ?? ''} ${what}; at most ${most ?? ''} can be shown.`,
    what === 'triangles' ? { advice: FEWER_TRIANGLES, ownAdvice: '' } : undefined,
  );
}

const FEWER_TRIANGLES =
  'Use fewer segments or shapes, or another shading than "flat", which counts each triangle 4.4 times.';

/** Something that a mesh holds. */
export interface Need {
  /** Equal keys are one thing, which is counted once. */
  readonly key: object | string;
  readonly claims: Claims;
  /** It is a copy for flat shading. */
  readonly flat: boolean;
}

/**
 * What the content of one mesh holds. Content that replaces other content of its mesh may take the
 * room of it. Both are in memory until the new one is drawn, but otherwise a model of the largest
 * allowed size could not be replaced by another.
 */
export class Claim {
  readonly budget: Budget;
  readonly owner: object;
  /** Written by the budget. */
  needs: ReadonlyMap<Need['key'], Need> = new Map();

  constructor(budget: Budget, owner: object) {
    this.budget = budget;
    this.owner = owner;
  }

  /**
   * Claims these as well, or more of them. @throws ModelError `too-large`; the claim is as before
   * then.
   */
  add(needs: readonly Need[]): void {
    if (needs.every((need) => isHeld(need, this.needs.get(need.key)))) return;
    this.budget.take(this, [...this.needs.values(), ...needs]);
  }

  dropFlat(): void {
    this.keep([...this.needs.values()].filter(({ flat }) => !flat));
  }

  /** Holds nothing but these, which it holds already. */
  keep(needs: readonly Need[]): void {
    this.budget.hold(this, needs);
  }

  release(): void {
    this.keep([]);
  }
}

const isHeld = ({ claims }: Need, held: Need | undefined) =>
  held !== undefined && KEYS.every((key) => (claims[key] ?? 0) === (held.claims[key] ?? 0));

interface Use {
  claims: Claims;
  readonly holders: Set<Claim>;
}

/** What all meshes of one viewer hold. */
export class Budget {
  #limit: number = LIMITS.triangles;
  #memory: number = LIMITS.memory;
  readonly #total = { ...NO_CLAIMS };
  readonly #uses = new Map<Need['key'], Use>();
  readonly #claims = new Map<object, Set<Claim>>();

  /** Most triangles, weighed by memory. A lower one takes nothing away that is shown. */
  get limit(): number {
    return this.#limit;
  }

  /**
   * Null for the default. @throws TypeError or RangeError unless it is a whole number from 0 to the
   * default.
   */
  set limit(limit: number | null) {
    this.#limit = upTo(LIMITS.triangles, limit, 'maxTriangles');
  }

  /** Most bytes in memory, by {@link memoryOf}. All limits but {@link limit} shrink with it. */
  get memory(): number {
    return this.#memory;
  }

  /** As {@link limit}. */
  set memory(bytes: number | null) {
    this.#memory = upTo(LIMITS.memory, bytes, 'maxMemory');
  }

  /**
   * Triangles that are held now, weighed by memory. Round shapes with automatic segments count by
   * their coarsest level: finer ones take what is left.
   */
  get used(): number {
    return Math.ceil(this.#total.values / VALUES_PER_TRIANGLE);
  }

  claim(owner: object): Claim {
    return new Claim(this, owner);
  }

  /**
   * For claims: {@link hold} within the limits. @throws ModelError `too-large`; all is as before
   * then.
   */
  take(claim: Claim, needs: readonly Need[]): void {
    const before = [...(this.#claims.get(claim.owner) ?? [])].map(
      (own) => [own, [...own.needs.values()]] as const,
    );
    for (const [own] of before) {
      this.hold(own, []);
    }
    this.hold(claim, needs);
    try {
      requireAtMost(this.used, this.#limit, 'triangles', SUBJECT);
      const share = this.#memory / LIMITS.memory;
      // Triangles have been counted, in place of their values.
      const values = Math.min(this.#total.values, Math.floor(share * LIMITS.values));
      requireWithin({ ...this.#total, values }, SUBJECT, share);
    } catch (error) {
      this.hold(claim, []);
      for (const [own, held] of before) {
        this.hold(own, held);
      }
      throw error;
    }
    for (const [own, held] of before) {
      if (own !== claim) {
        this.hold(own, held);
      }
    }
  }

  /** For claims: `claim` holds these and nothing else. */
  hold(claim: Claim, needs: readonly Need[]): void {
    const next = new Map(needs.map((need) => [need.key, need]));
    for (const [key, { claims }] of next) {
      this.#change(key, (holders) => holders.add(claim), claims);
    }
    for (const key of claim.needs.keys()) {
      if (!next.has(key)) {
        this.#change(key, (holders) => holders.delete(claim));
      }
    }
    claim.needs = next;
    const own = this.#claims.get(claim.owner) ?? new Set();
    if (next.size > 0) {
      this.#claims.set(claim.owner, own.add(claim));
    } else if (own.delete(claim) && own.size === 0) {
      this.#claims.delete(claim.owner);
    }
  }

  #change(key: Need['key'], edit: (holders: Set<Claim>) => void, claims?: Claims) {
    const use = this.#uses.get(key) ?? { claims: claims ?? NO_CLAIMS, holders: new Set() };
    const { claims: before, holders } = use;
    const { size } = holders;
    edit(holders);
    use.claims = claims ?? before;
    if (use.claims === before && size > 0 && holders.size > 0) {
      // One holder more or less of many: everything but its draws is counted already.
      this.#total.parts += (holders.size - size) * (before.parts ?? 0);
      return;
    }
    this.#count(before, size, -1);
    this.#count(use.claims, holders.size, 1);
    if (holders.size > 0) {
      this.#uses.set(key, use);
    } else {
      this.#uses.delete(key);
    }
  }

  /** Draws count for each holder, everything else once. */
  #count(claims: Claims, size: number, sign: 1 | -1) {
    for (const key of KEYS) {
      this.#total[key] += sign * (claims[key] ?? 0) * (key === 'parts' ? size : Math.min(size, 1));
    }
  }
}

function upTo(most: number, value: unknown, name: string): number {
  const number = value ?? most;
  if (typeof number !== 'number') {
    throw new TypeError(`${name} must be a number, not ${typeof number}.`);
  }
  if (!Number.isInteger(number) || number < 0 || number > most) {
    throw new RangeError(
      `${name} must be a whole number from 0 to ${String(most)}, not ${String(number)}.`,
    );
  }
  return number;
}

const SUBJECT = 'With this the viewer would hold';

/** What a number of triangles holds, weighed by memory. */
export const claimsOf = (triangles: number, parts = 0): Claims => ({
  values: triangles * VALUES_PER_TRIANGLE,
  parts,
});
