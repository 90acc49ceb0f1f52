// How far are the outlines of one scene from those of another, in pixels? Inner outlines count too,
// where something hides what is behind it: both are jumps of depth along a row or a column of the
// picture.
import { dot } from '../../src/phong/math/vector.js';
import type { Tracer } from '../../src/extras/still/tracer.js';

interface OutlineErrors {
  /** The largest distance, across the outline. */
  readonly worst: number;
  /** Points of outlines that were compared, and those that have no counterpart within a pixel. */
  readonly compared: number;
  readonly missed: number;
}

/** Smaller jumps of depth are no outlines: they are where one ends on a surface. Scene units. */
const LEAST_JUMP = 0.05;

/** Pixels between the places that are looked at, and how exactly a jump is found. */
const STEP = 1 / 4;
const EXACT = 1e-4;

/** @param lines rows, and columns, that are looked at. */
export function outlineErrors(truth: Tracer, drawn: Tracer, lines: number): OutlineErrors {
  const { width, height, camera } = truth.screen;
  let [worst, compared, missed] = [0, 0, 0];
  for (const isRow of [true, false]) {
    const [long, wide] = isRow ? [width, height] : [height, width];
    for (let k = 0; k < lines; k++) {
      const line = ((k + 0.5) / lines) * wide;
      const along = (tracer: Tracer) => (at: number) =>
        isRow ? tracer.hitAt(at, line) : tracer.hitAt(line, at);
      const depth = (tracer: Tracer) => (at: number) => along(tracer)(at).t;
      for (const { at, front } of jumps(depth(truth), 0, long, STEP, LEAST_JUMP)) {
        const { normal } = along(truth)(front);
        const [across, upward] = [
          Math.abs(dot(normal, camera.right)),
          Math.abs(dot(normal, camera.up)),
        ];
        // Each outline is measured by the lines that cross it at 45° or more.
        const slant = (isRow ? across : upward) / Math.hypot(across, upward);
        if (slant < Math.SQRT1_2) continue;
        const others = jumps(depth(drawn), at - 1, at + 1, STEP / 4, LEAST_JUMP / 2);
        if (others.length === 0) {
          missed++;
        } else {
          compared++;
          worst = Math.max(
            worst,
            slant * Math.min(...others.map((other) => Math.abs(other.at - at))),
          );
        }
      }
    }
  }
  return { worst, compared, missed };
}

/** Where depth jumps between `from` and `to`; `front` is on the nearer side. */
function jumps(
  depth: (at: number) => number,
  from: number,
  to: number,
  step: number,
  least: number,
): { readonly at: number; readonly front: number }[] {
  const found = [];
  let before = depth(from);
  for (let at = from; at < to; at += step) {
    const after = depth(at + step);
    const jump = between(depth, [at, before], [at + step, after], least);
    if (jump !== null) {
      found.push(jump);
    }
    before = after;
  }
  return found;
}

type At = readonly [at: number, depth: number];

function between(depth: (at: number) => number, first: At, second: At, least: number) {
  let [low, high] = [first, second];
  const isJump = () => low[1] !== high[1] && Math.abs(low[1] - high[1]) >= least;
  while (isJump() && high[0] - low[0] > EXACT) {
    const middle = (low[0] + high[0]) / 2;
    const here = depth(middle);
    const nearLow = here === low[1] || Math.abs(here - low[1]) < Math.abs(here - high[1]);
    if (nearLow) {
      low = [middle, here];
    } else {
      high = [middle, here];
    }
  }
  if (!isJump()) return null;
  return { at: (low[0] + high[0]) / 2, front: low[1] < high[1] ? low[0] : high[0] };
}
