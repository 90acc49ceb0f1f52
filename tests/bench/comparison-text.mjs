// @ts-check
// A comparison of two bench runs as a table for a terminal. Knows nothing of how it was made.

import { short } from './chart/text.mjs';

/** @param {import('./compare-results.mjs').Comparison} comparison */
export function comparisonText({ machine, changes, onlyBefore, onlyAfter, incomparable }) {
  const moved = changes.filter((change) => change.moved);
  const widths = /** @type {const} */ (['name', 'what']).map((key) =>
    Math.max(4, ...changes.map((change) => change[key].length)),
  );
  const row = (
    /** @type {readonly string[]} */ [name = '', what = '', a = '', b = '', change = '', note = ''],
  ) =>
    `  ${name.padEnd(widths[0] ?? 0)}  ${what.padEnd(widths[1] ?? 0)}  ${a.padEnd(25)} ${b.padEnd(25)} ${change.padStart(9)}  ${note}`.trimEnd();
  const groups = [...new Set(changes.map(({ group }) => group))].flatMap((group) => [
    `\n${group}`,
    row(['', '', 'before', 'after', 'change']),
    ...changes
      .filter((change) => change.group === group)
      .map((change) =>
        row([
          ...[change.name, change.what, rangeText(change.before), rangeText(change.after)],
          changeText(change),
          [...(change.moved ? ['MOVED'] : []), ...(change.note === undefined ? [] : [change.note])].join(' '),
        ]),
      ),
  ]);
  return [
    ...list('Runs differ in', machine),
    ...groups,
    ...list('Only before', onlyBefore),
    ...list('Only after', onlyAfter),
    ...list('Not compared', incomparable),
    `\n${moved.length} of ${changes.length} moved by more than the noise of both runs${moved.length > 0 ? ':' : '.'}`,
    ...moved.map((change) => `  ${change.group}: ${change.name}, ${change.what} ${changeText(change)}`),
  ].join('\n');
}

/** @param {string} title @param {readonly string[]} lines */
const list = (title, lines) =>
  lines.length === 0 ? [] : [`\n${title}`, ...lines.map((line) => `  ${line}`)];

/** @param {import('./statistics.mjs').Spread} spread */
const rangeText = ({ median, low, high, count }) =>
  count <= 1 ? short(median, 4) : `${short(median, 4)} (${short(low)}–${short(high)})`;

/** A slope can be about 0, so it changes by a difference. @param {import('./compare-results.mjs').Change} change */
function changeText({ what, before, after }) {
  const sign = (/** @type {number} */ x, /** @type {string} */ size) => `${x < 0 ? '−' : '+'}${size}`;
  const [a, b] = [before.median, after.median];
  if (what === 'slope') return sign(b - a, Math.abs(b - a).toFixed(3));
  if (a === b) return '0 %';
  if (a === 0) return 'from 0';
  const percent = 100 * (b / a - 1);
  return `${sign(percent, Math.abs(percent).toFixed(1))} %`;
}
