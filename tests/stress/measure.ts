// How far what a driver made of stress cases is from float64: errors, wrong codes, numbers that are
// none.
import type { PassResult } from '../glsl/float-pass.js';
import type { Category } from './categories.js';
import type { Shaded } from '../../src/phong/reference/equation.js';
import { intensity, reference, type StressCase, type Variant } from './case.js';
import { branch, coneMargin } from './contract.js';

/** What a category came to. Errors are in 1/255, over max(1, the sum of intensities). */
export interface Measured {
  readonly id: string;
  readonly title: string;
  readonly bound: number;
  /** Cases at random, in all programs. */
  cases: number;
  /**
   * Cases that were found by climbing: they count for the largest error, wrong codes and numbers
   * that are none, not for shares.
   */
  searched: number;
  /** Cases beside a branch point, by its name: they count for NaN and Infinity alone. */
  readonly excluded: Record<string, number>;
  /** Channels that are NaN or infinite. */
  notFinite: number;
  max: number;
  /** The largest of each form of program, by its name. */
  readonly forms: Record<string, number>;
  channels: number;
  /**
   * Channels whose 8-bit code is exactly the nearest to float64; where the bound allows more than
   * one code, within the bound.
   */
  exact: number;
  /**
   * Channels more than one code off, where the sum of intensities is at most 1; beyond, more than
   * the bound too.
   */
  wrongCodes: number;
  /**
   * Largest distance from a cone's edge, radians, at which a fragment was taken for one of the
   * other side.
   */
  edge: number;
  /** The case with the largest error, to look into, where that breaks the contract; else empty. */
  worst: string;
}

export const nothingMeasured = (of: Pick<Category, 'id' | 'title' | 'bound'>): Measured => ({
  id: of.id,
  title: of.title,
  bound: of.bound,
  cases: 0,
  searched: 0,
  excluded: {},
  notFinite: 0,
  max: 0,
  forms: {},
  channels: 0,
  exact: 0,
  wrongCodes: 0,
  edge: 0,
  worst: '',
});

/** Parts of one run, measured apart, as one. */
export function mergeMeasured(parts: readonly Measured[]): Measured {
  const sum = nothingMeasured(parts[0]!);
  for (const part of parts) {
    for (const key of [
      'cases',
      'searched',
      'notFinite',
      'channels',
      'exact',
      'wrongCodes',
    ] as const) {
      sum[key] += part[key];
    }
    for (const [name, count] of Object.entries(part.excluded)) {
      sum.excluded[name] = (sum.excluded[name] ?? 0) + count;
    }
    sum.edge = Math.max(sum.edge, part.edge);
    for (const [name, max] of Object.entries(part.forms)) {
      sum.forms[name] = Math.max(sum.forms[name] ?? 0, max);
    }
    if (part.max > sum.max) {
      sum.max = part.max;
      sum.worst = part.worst;
    }
  }
  return sum;
}

/** A case and what float64 makes of it, for all programs that draw it. */
export interface Judged {
  readonly stress: StressCase;
  readonly variant: Variant;
  readonly shaded: Shaded;
  /** The branch point that the case is beside: {@link branch}. */
  readonly beside: string | null;
  /** The random numbers that the case was made from. */
  readonly numbers: readonly number[];
  /** Found by climbing, and so no sample of its category. */
  readonly found: boolean;
  /** The largest of its channels in any program; 0 beside a branch point. */
  error: number;
}

export function judged(
  stress: StressCase,
  variant: Variant,
  { numbers, found }: Pick<Judged, 'numbers' | 'found'> = { numbers: [], found: false },
): Judged {
  const shaded = reference(stress, variant);
  const beside = branch(stress, shaded, variant);
  return { stress, variant, shaded, beside, numbers, found, error: 0 };
}

/** Adds what the program of this name made of a batch to what was measured before. */
export function measureBatch(
  into: Measured,
  category: Category,
  program: string,
  cases: readonly Judged[],
  { floats, codes }: PassResult,
): void {
  let max = into.forms[program] ?? 0;
  cases.forEach((one, i) => {
    const { stress, variant, shaded, beside, found } = one;
    into[found ? 'searched' : 'cases'] += 1;
    const got = floats.subarray(i * 4, i * 4 + 3);
    for (const x of got) {
      if (!Number.isFinite(x)) {
        into.notFinite += 1;
      }
    }
    const scale = 255 / Math.max(1, intensity(stress));
    const error = (channel: number) => {
      const off = Math.abs(got[channel]! - shaded.sum[channel]!) * scale;
      return Number.isNaN(off) ? Infinity : off; // a comparison with NaN would let it pass
    };
    if (beside === 'edge' && Math.max(error(0), error(1), error(2)) > category.bound) {
      into.edge = Math.max(into.edge, Math.abs(coneMargin(stress.lights, shaded)));
    }
    if (beside !== null) {
      if (!found) {
        into.excluded[beside] = (into.excluded[beside] ?? 0) + 1;
      }
      return;
    }
    for (let channel = 0; channel < 3; channel++) {
      const off = error(channel);
      one.error = Math.max(one.error, off);
      max = Math.max(max, off);
      if (off > into.max) {
        into.max = off;
        if (off > category.bound) {
          into.worst = JSON.stringify({
            program,
            variant,
            stress,
            got: [...got],
            expected: shaded.sum,
          });
        }
      }
      const code = codes[i * 4 + channel]!;
      const exact = shaded.color[channel]! * 255;
      // Where lights are brighter than full, the bound itself may be more than a code.
      const allowed = Math.max(1, Math.ceil((category.bound * 255) / scale));
      const away = Math.abs(code - Math.round(exact));
      if (!found) {
        into.channels += 1;
        into.exact += away <= (allowed > 1 ? allowed : 0) ? 1 : 0;
      }
      if (away > allowed) {
        into.wrongCodes += 1;
      }
    }
  });
  into.forms[program] = max;
}
