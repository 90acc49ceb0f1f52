// How far does a slider reach, and how do its places map to values? Values in whatever unit the control has. Numbers only:
// knows neither the DOM nor what a value means.

/** A slider's way: places from `start` to `end` in steps, and the values that lie there. */
export interface Travel {
  readonly start: number;
  readonly end: number;
  /** Of places. */
  readonly step: number;
  /** Where a value lies; values beyond the ends lie beyond them. */
  place(value: number): number;
  /** The value at a place, rounded to what the slider can tell apart. */
  value(place: number): number;
  /** What one press of an arrow key adds to this value. */
  stepAt(value: number): number;
  /** The same travel, or one wide enough for this value. */
  reaching(value: number): Travel;
}

/** 1, 2 or 5 times a power of ten, not below `n`; `n` > 0. */
export function niceCeil(n: number): number {
  const power = 10 ** Math.floor(Math.log10(n));
  // The slack keeps 0.3 / 0.1 from counting as more than 3.
  const factor = [1, 2, 5, 10].find((f) => n <= f * power * (1 + 1e-9)) ?? 10;
  return tidy(factor * power);
}

/** Without the stray digits of binary fractions: 0.30000000000000004 is 0.3. */
export const tidy = (n: number): number => Number(n.toPrecision(12));

/** About this many steps from end to end: one every pixel or two. */
const STEPS = 200;

/** Even steps from `min` to `max`. */
export function linear(min: number, max: number, step = niceCeil((max - min) / STEPS)): Travel {
  return {
    start: min,
    end: max,
    step,
    place: (value) => value,
    value: tidy,
    stepAt: () => step,
    reaching(value) {
      if (value >= min && value <= max) return this;
      const low = value < min ? (value < 0 ? -niceCeil(-value) : 0) : min;
      const high = value > max ? (value > 0 ? niceCeil(value) : 0) : max;
      return linear(low, high, Math.max(step, niceCeil((high - low) / (2 * STEPS))));
    },
  };
}

/** From 0 to `max`, even up to about `knee` and by ratios beyond it: as usable around 1 as around 1e5. */
export function logarithmic(knee: number, max: number): Travel {
  const span = Math.log1p(max / knee);
  const digits = (value: number): number => Number(value.toPrecision(3));
  return {
    start: 0,
    end: 1,
    step: 1 / (2 * STEPS),
    place: (value) => Math.log1p(Math.max(value, 0) / knee) / span,
    value: (place) => (place >= 1 ? max : digits(knee * Math.expm1(place * span))),
    stepAt: (value) => (value === 0 ? knee / 10 : 10 ** (Math.floor(Math.log10(Math.abs(value))) - 1)),
    reaching(value) {
      return value <= max ? this : logarithmic(knee, niceCeil(value));
    },
  };
}

/** A number as a person would write it; `span`: the size below whose billionth it is only the noise of a zero. */
export function numberText(value: number, span = 0): string {
  return Math.abs(value) <= 1e-9 * span ? '0' : String(Number(value.toPrecision(6)));
}
