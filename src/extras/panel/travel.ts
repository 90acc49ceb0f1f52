// The range that a slider covers, and how its positions map to values, in the unit of the control.
import type { PhongViewer } from '../../viewer/extra.js';
import { niceCeil, tidy } from '../../phong/math/round-number.js';
import { ORIGIN, type Vec3 } from '../../phong/math/vector.js';
import { measure } from '../../phong/geometry/bounds.js';

/** A slider's scale: positions from `start` to `end` in steps, and the value at each. */
export interface SliderScale {
  readonly start: number;
  readonly end: number;
  /** Distance of neighbouring positions. */
  readonly step: number;
  /** The position of a value; outside `start` to `end` for values outside the range. */
  place(value: number): number;
  /** The value at a position, rounded to the slider's resolution. */
  value(place: number): number;
  /** The change by one press of an arrow key, at this value. */
  stepAt(value: number): number;
  /** This scale, or one wide enough for the value. */
  reaching(value: number): SliderScale;
  /**
   * This scale between these ends and in this step, null as it is now. With an end it no longer
   * grows.
   */
  within(min: number | null, max: number | null, step: number | null): SliderScale;
  /** Decimals of the numbers shown; undefined: all that matter. */
  readonly decimals?: number;
  /** Values outside cannot be typed. */
  readonly limits?: readonly [least: number, most: number];
}

/** Steps from end to end: about one per pixel or two. */
const STEPS = 200;

export function linear(
  min: number,
  max: number,
  step = niceCeil((max - min) / STEPS),
): SliderScale {
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
    within(least, most, by) {
      const [low, high] = [least ?? min, most ?? max];
      const even = linear(low, high, by ?? ((least ?? most) === null ? step : undefined));
      return low < high ? limited({ ...even, ...shownBy(by) }, least, most) : this;
    },
  };
}

/**
 * From 0 to `max`: linear up to about `knee`, logarithmic beyond. Usable around 1 as well as around
 * 1e5.
 */
export function logarithmic(knee: number, max: number): SliderScale {
  const span = Math.log1p(max / knee);
  const digits = (value: number) => Number(value.toPrecision(3));
  return {
    start: 0,
    end: 1,
    step: 1 / (2 * STEPS),
    place: (value) => Math.log1p(Math.max(value, 0) / knee) / span,
    value: (place) => (place >= 1 ? max : digits(knee * Math.expm1(place * span))),
    stepAt: (value) =>
      value === 0 ? knee / 10 : 10 ** (Math.floor(Math.log10(Math.abs(value))) - 1),
    reaching(value) {
      return value <= max ? this : logarithmic(knee, niceCeil(value));
    },
    within(least, most, by) {
      const scale = logarithmic(knee, most ?? max);
      const start = scale.place(least ?? 0);
      if (!(start < 1)) return this;
      const even = (value: number) =>
        tidy((least ?? 0) + Math.round((value - (least ?? 0)) / by!) * by!);
      const stepped =
        by === null
          ? {}
          : { value: (p: number) => even(scale.value(p)), stepAt: () => by, ...shownBy(by) };
      return limited({ ...scale, start, ...stepped }, least, most);
    },
  };
}

/** As many decimals as the step has. */
const shownBy = (step: number | null): Pick<SliderScale, 'decimals'> =>
  step === null || step < 1e-6 ? {} : { decimals: String(step).split('.')[1]?.length ?? 0 };

/** Keeps a scale from growing beyond the ends that are given. */
const limited = (scale: SliderScale, least: number | null, most: number | null): SliderScale =>
  least === null && most === null
    ? scale
    : {
        ...scale,
        limits: [least ?? -Infinity, most ?? Infinity],
        reaching() {
          return this;
        },
      };

/**
 * A number as a person would write it. Values below 1e-9 of `span` are rounding noise and become 0.
 */
export function numberText(value: number, span = 0, decimals?: number): string {
  const shown = decimals === undefined ? value.toPrecision(6) : value.toFixed(decimals);
  return Math.abs(value) <= 1e-9 * span ? '0' : String(Number(shown));
}

/** In radii of the scene, because lights are placed around a scene as well as inside it. */
const REACH = 3;

/** In scene units, where the scene has no size. */
const EMPTY_REACH = 5;

/**
 * The range that sliders for positions cover: the surroundings of the scene. Measured when it is
 * first read and once something new is there, not while a slider moves a mesh: the range would move
 * with it. World space, scene units.
 */
export class SceneRange {
  readonly #viewer: PhongViewer;
  /** Null: the next read measures the scene. */
  #measured: { readonly center: Vec3; readonly reach: number } | null = null;

  constructor(viewer: PhongViewer) {
    this.#viewer = viewer;
  }

  expire(): void {
    this.#measured = null;
  }

  get center(): Vec3 {
    return this.#measure().center;
  }

  /** Half the range of the sliders. */
  get reach(): number {
    return this.#measure().reach;
  }

  /** For a position in world space. */
  place(axis: 0 | 1 | 2): SliderScale {
    const { center, reach } = this.#measure();
    const step = niceCeil(reach / 500);
    const middle = Math.round(center[axis] / step) * step;
    // If the scene is close to the origin, 0 is the middle of the sliders.
    const shift = Math.abs(middle) < reach / 2 ? 0 : middle;
    return linear(shift - reach, shift + reach, step);
  }

  /** For a vector around zero: a direction, or a position in camera space. */
  vector(): SliderScale {
    return linear(-this.reach, this.reach, niceCeil(this.reach / 500));
  }

  #measure(): { readonly center: Vec3; readonly reach: number } {
    if (this.#measured !== null) return this.#measured;
    const { scene } = this.#viewer;
    scene.updateMatrixWorld();
    const { center = ORIGIN, radius = 0 } = measure(scene).bounds ?? {};
    return (this.#measured = {
      center,
      reach: radius > 0 ? niceCeil(REACH * radius) : EMPTY_REACH,
    });
  }
}
