// The value of an animated property at a time. Keyframes of a glTF sampler, evaluated in float64.

export type Interpolation = 'STEP' | 'LINEAR' | 'CUBICSPLINE';

export interface Keyframes {
  /** Seconds, none smaller than the one before; at least one. */
  readonly times: Float32Array;
  /** `width` numbers per keyframe; with `CUBICSPLINE` in-tangent, value and out-tangent, `width` numbers each. */
  readonly values: Float32Array;
  readonly width: number;
  readonly interpolation: Interpolation;
  /** Values are unit quaternions. */
  readonly rotation: boolean;
}

/** Writes the value at `seconds` to `out`. Before the first and after the last keyframe, theirs. */
export function sampleTrack(keyframes: Keyframes, seconds: number, out: Float64Array): void {
  const { times, values, width, interpolation, rotation } = keyframes;
  const cubic = interpolation === 'CUBICSPLINE';
  const stride = cubic ? 3 * width : width;
  const first = cubic ? width : 0;
  const from = lastAtOrBefore(times, seconds);
  const to = from + 1;
  if (from < 0 || to >= times.length || interpolation === 'STEP') {
    const at = first + Math.max(from, 0) * stride;
    for (let c = 0; c < width; c += 1) out[c] = values[at + c]!;
    if (rotation) normalize(out);
    return;
  }
  const step = times[to]! - times[from]!;
  const t = (seconds - times[from]!) / step;
  const a = first + from * stride;
  const b = first + to * stride;
  if (cubic) {
    const [p, m, q, n] = hermite(t, step);
    for (let c = 0; c < width; c += 1) {
      const leaving = values[a + width + c]!;
      const arriving = values[b - width + c]!;
      out[c] = p * values[a + c]! + m * leaving + q * values[b + c]! + n * arriving;
    }
  } else {
    const [p, q] = rotation ? slerp(values, a, b, t) : ([1 - t, t] as const);
    for (let c = 0; c < width; c += 1) out[c] = p * values[a + c]! + q * values[b + c]!;
  }
  if (rotation) normalize(out);
}

/** The index of the last time that is not after `seconds`; −1 if all are. */
function lastAtOrBefore(times: Float32Array, seconds: number): number {
  let low = -1;
  let high = times.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= seconds) low = middle;
    else high = middle;
  }
  return low;
}

/** Factors of value, out-tangent, next value and its in-tangent (glTF 2.0, appendix C.5). */
function hermite(t: number, step: number): readonly [number, number, number, number] {
  const t2 = t * t;
  const t3 = t2 * t;
  return [2 * t3 - 3 * t2 + 1, step * (t3 - 2 * t2 + t), 3 * t2 - 2 * t3, step * (t3 - t2)];
}

/** Rotations closer than this, as the sine of half the angle between them, are blended linearly: equal to 1e-12. */
const NEARLY_EQUAL = 1e-6;

/** Factors of two quaternions for the shorter way between them (glTF 2.0, appendix C.4). */
function slerp(values: Float32Array, a: number, b: number, t: number): readonly [number, number] {
  let dot = 0;
  for (let c = 0; c < 4; c += 1) dot += values[a + c]! * values[b + c]!;
  const sign = dot < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(Math.abs(dot), 1));
  const sine = Math.sin(angle);
  if (sine < NEARLY_EQUAL) return [1 - t, sign * t];
  return [Math.sin((1 - t) * angle) / sine, (sign * Math.sin(t * angle)) / sine];
}

/** A quaternion without length becomes no rotation. */
function normalize(q: Float64Array): void {
  const length = Math.hypot(q[0]!, q[1]!, q[2]!, q[3]!);
  if (!(length > 0)) q.set(NO_ROTATION);
  else for (let c = 0; c < 4; c += 1) q[c]! /= length;
}

const NO_ROTATION = [0, 0, 0, 1];
