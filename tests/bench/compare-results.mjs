// @ts-check
// What moved between two bench runs: times as ratios within a run, which another load of the machine leaves alone, in
// milliseconds only where a GPU's own timer counted them; errors, which are the same in every run of one program on one machine.

import { comparisonText } from './comparison-text.mjs';
import { slopeSpread } from './growth.mjs';
import { named } from './result-file.mjs';

/**
 * @typedef {import('./result-file.mjs').BenchResult} BenchResult
 * @typedef {import('./statistics.mjs').Spread} Spread
 *
 * @typedef {object} Change
 * @property {string} group where it was measured
 * @property {string} name what was measured
 * @property {string} what is compared
 * @property {Spread} before
 * @property {Spread} after
 * @property {boolean} moved by more than both runs' noise
 * @property {string} [note]
 *
 * @typedef {object} Comparison
 * @property {string[]} machine what differs of machines, versions and settings
 * @property {Change[]} changes all that both have, moved or not
 * @property {string[]} onlyBefore
 * @property {string[]} onlyAfter
 * @property {string[]} incomparable what both have, but not of the same thing, and why
 */

/** An error that changed by no more is the same one. */
const ERROR_SHARE = 0.01;

/** @param {BenchResult} before @param {BenchResult} after @returns {Comparison} */
export function comparisonOf(before, after) {
  /** @type {Comparison} */
  const result = {
    machine: machineChanges(before, after),
    ...{ changes: [], onlyBefore: [], onlyAfter: [], incomparable: [] },
  };
  compareFronts(before, after, result);
  compareGrowths(before, after, result);
  comparePeers(before, after, result);
  compareFigures(before, after, result);
  return result;
}

/** @param {BenchResult} before @param {BenchResult} after */
export function printComparison(before, after) {
  console.log(comparisonText(comparisonOf(before, after)));
}

/** Quartiles apart, and medians farther from each other than either range is wide. @param {Spread} a @param {Spread} b */
export const movedBeyondNoise = (a, b) =>
  (a.high < b.low || b.high < a.low) &&
  Math.abs(a.median - b.median) > Math.max(a.high - a.low, b.high - b.low);

/** @param {number} a @param {number} b */
const errorMoved = (a, b) => Math.abs(a - b) > ERROR_SHARE * Math.min(Math.abs(a), Math.abs(b));

/** @param {BenchResult} before @param {BenchResult} after @param {Comparison} result */
function compareFronts(before, after, result) {
  const key = (/** @type {import('./front.mjs').Front} */ { axis, scene }) => `${axis}, ${scene}`;
  for (const [group, a, b] of pairs(before.fronts, after.fronts, key, result)) {
    const sameTime = sameFor(group, 'times', a, b, ['base', 'measure', 'size'], result);
    const sameError = sameFor(group, 'errors', a, b, ['truth', 'errorSize'], result);
    const inGroup = (/** @type {{ id: string }} */ { id }) => `${group}: ${id}`;
    for (const [, p, q] of pairs(a.points, b.points, inGroup, result)) {
      const name = q.label;
      if (sameTime && p.id !== a.base) {
        result.changes.push(spreadChange(group, name, 'time / base', p.ratio, q.ratio));
      }
      if (sameTime && a.measure === 'GPU timer') {
        result.changes.push(spreadChange(group, name, 'ms', p.time, q.time));
      }
      if (!sameError) continue;
      for (const [error, what] of ERRORS) {
        const change = exactChange(group, name, what, p.error[error], q.error[error]);
        // One figure says that an error is what it was; of the others, those that moved.
        if (change.moved || error === 'rmse') result.changes.push(change);
      }
    }
  }
}

const ERRORS = /** @type {const} */ ([
  ['rmse', 'RMSE'],
  ['p999', '99.9 %'],
  ['max', 'largest error'],
  ['share', 'other codes'],
  ['deltaE', 'CIEDE2000'],
  ['deltaEMax', 'largest CIEDE2000'],
  ['flip', 'FLIP'],
]);

/** @param {BenchResult} before @param {BenchResult} after @param {Comparison} result */
function compareGrowths(before, after, result) {
  const key = (/** @type {import('./growth.mjs').Growth} */ { name, unit }) => `growth with ${unit}: ${name}`;
  for (const [called, a, b] of pairs(before.growth, after.growth, key, result)) {
    if (!sameFor(called, 'slopes', a, b, ['measure'], result)) continue;
    const group = `growth with ${b.unit}`;
    const counts = new Set(b.points.map(({ at }) => at));
    const shared = [a, b].map(({ points }) =>
      points.filter(({ at }) => counts.has(at) && a.points.some((point) => point.at === at)),
    );
    const [p = [], q = []] = shared;
    if (p.length < 2) result.incomparable.push(`${called}: slopes, of other counts`);
    else result.changes.push(spreadChange(group, b.name, 'slope', slopeSpread(p), slopeSpread(q)));
    if (a.measure !== 'GPU timer') continue;
    for (const [i, { at, time }] of q.entries()) {
      const earlier = p[i]?.time;
      if (earlier !== undefined)
        result.changes.push(spreadChange(group, b.name, `ms at ${at}`, earlier, time));
    }
  }
}

/** @param {BenchResult} before @param {BenchResult} after @param {Comparison} result */
function comparePeers(before, after, result) {
  const key = (/** @type {import('./result-file.mjs').PeerRow} */ { what, peer, unit }) =>
    `${what}, ${unit}: ${peer}`;
  for (const [called, a, b] of pairs(before.peers, after.peers, key, result)) {
    const group = `${b.what}, ${b.unit}`;
    const name = called.slice(group.length + 2);
    // Of rows of one name the note says what was asked for.
    const notes = [
      ...(a.version === b.version ? [] : [`${a.version} before, ${b.version} after`]),
      ...(name === b.peer || b.note === undefined ? [] : [b.note]),
    ];
    const note = notes.length === 0 ? undefined : notes.join('; ');
    if (a.ratio !== undefined && b.ratio !== undefined) {
      const what = 'peer / phong-viewer';
      result.changes.push({ ...spreadChange(group, name, what, a.ratio, b.ratio), ...noted(note) });
    } else if (a.value.count > 0 && b.value.count > 0) {
      if (isTime(b.unit)) result.incomparable.push(`${called}: ${b.unit} without a ratio`);
      else result.changes.push({ ...spreadChange(group, name, b.unit, a.value, b.value), ...noted(note) });
    } else if (a.value.count !== b.value.count) {
      result.incomparable.push(`${called}: measured only ${a.value.count > 0 ? 'before' : 'after'}`);
    }
  }
}

/** @param {BenchResult} before @param {BenchResult} after @param {Comparison} result */
function compareFigures(before, after, result) {
  const all = (/** @type {BenchResult} */ { figures }) =>
    Object.entries(figures).flatMap(([group, list]) => list.map((figure) => ({ group, ...figure })));
  const key = (/** @type {{ group: string, name: string }} */ { group, name }) => `${group}: ${name}`;
  for (const [, a, b] of pairs(all(before), all(after), key, result)) {
    const [met, meets] = [a, b].map(({ ratio, atMost }) => atMost === undefined || ratio.median <= atMost);
    const note = met === meets ? undefined : meets ? `meets ${a.atMost} now` : `misses ${b.atMost} now`;
    result.changes.push({ ...spreadChange(b.group, b.name, 'ratio', a.ratio, b.ratio), ...noted(note) });
  }
}

/** @param {string} group @param {string} name @param {string} what @param {Spread} before @param {Spread} after @returns {Change} */
function spreadChange(group, name, what, before, after) {
  // What was measured once has no noise: counts, bytes, errors.
  const once = before.count <= 1 && after.count <= 1;
  const moved = once ? errorMoved(before.median, after.median) : movedBeyondNoise(before, after);
  return { group, name, what, before, after, moved };
}

/** @param {string} group @param {string} name @param {string} what @param {number} a @param {number} b @returns {Change} */
function exactChange(group, name, what, a, b) {
  const alone = (/** @type {number} */ x) => ({ median: x, low: x, high: x, count: 1 });
  return spreadChange(group, name, what, alone(a), alone(b));
}

/** @param {string | undefined} note */
const noted = (note) => (note === undefined ? {} : { note });

/** @param {string} unit */
const isTime = (unit) => /^(s|ms|µs)\b/.test(unit);

/**
 * Whether two are of the same thing; what is not is said.
 * @template {object} T
 * @param {string} name @param {string} what @param {T} a @param {T} b @param {readonly (keyof T & string)[]} keys @param {Comparison} result
 */
function sameFor(name, what, a, b, keys, result) {
  const other = keys.filter((key) => String(a[key]) !== String(b[key]));
  for (const key of other)
    result.incomparable.push(
      `${name}: ${what}, of another ${key}: ${String(a[key])} before, ${String(b[key])} after`,
    );
  return other.length === 0;
}

/**
 * Those that both lists have, in the order of the second.
 * @template T
 * @param {readonly T[]} before @param {readonly T[]} after @param {(one: T) => string} key @param {Comparison} result
 * @returns {[string, T, T][]}
 */
function pairs(before, after, key, result) {
  const [first, second] = [before, after].map((list) => named(list, key));
  for (const name of first?.keys() ?? []) if (!second?.has(name)) result.onlyBefore.push(name);
  /** @type {[string, T, T][]} */
  const both = [];
  for (const [name, one] of second ?? []) {
    const earlier = first?.get(name);
    if (earlier === undefined) result.onlyAfter.push(name);
    else both.push([name, earlier, one]);
  }
  return both;
}

/** @param {BenchResult} before @param {BenchResult} after */
function machineChanges(before, after) {
  const facts = (/** @type {BenchResult} */ { machine, seed, launches, rounds }) => ({
    ...machine,
    ...{ seed, launches, rounds },
  });
  /** @type {[Record<string, unknown>, Record<string, unknown>]} */
  const [a, b] = [facts(before), facts(after)];
  return [...new Set([...Object.keys(a), ...Object.keys(b)])]
    .filter((key) => String(a[key]) !== String(b[key]))
    .map((key) => `${key}: ${String(a[key] ?? '–')} before, ${String(b[key] ?? '–')} after`);
}
