// @ts-check
// Figures as people read them: what was measured, on what, a line each, with the aim beside it.

import { pairedRatios, spread } from './statistics.mjs';

/**
 * @typedef {object} Figure
 * @property {string} name what is compared, and with what
 * @property {string} unit of the values
 * @property {import('./statistics.mjs').Spread} value ours
 * @property {import('./statistics.mjs').Spread} peer theirs
 * @property {import('./statistics.mjs').Spread} ratio paired within rounds
 * @property {number} [atMost] the aim for the ratio
 * @property {string} [note]
 */

/**
 * @param {string} name @param {string} unit @param {readonly number[]} ours @param {readonly number[]} theirs of the same rounds
 * @param {{ atMost?: number | undefined, note?: string }} [more]
 * @returns {Figure}
 */
export function figure(name, unit, ours, theirs, { atMost, note } = {}) {
  return {
    name,
    unit,
    value: spread(ours),
    peer: spread(theirs),
    ratio: spread(pairedRatios(ours, theirs)),
    ...(atMost === undefined ? {} : { atMost }),
    ...(note === undefined ? {} : { note }),
  };
}

/** @param {Figure} figure */
export function line({ name, unit, value, peer, ratio, atMost, note }) {
  const verdict = atMost === undefined ? '' : ratio.median <= atMost ? `meets ${atMost}` : `MISSES ${atMost}`;
  const values = `${value.median.toPrecision(3)} of ${peer.median.toPrecision(3)} ${unit}`;
  const quartiles = `(${ratio.low.toFixed(3)}–${ratio.high.toFixed(3)}, ${ratio.count} pairs)`;
  return `${name.padEnd(58)} ${ratio.median.toFixed(3).padStart(7)} ${quartiles.padEnd(26)} ${values.padEnd(24)} ${verdict}${note ? `  ${note}` : ''}`;
}

/** @param {Record<string, unknown>} machine */
export const heading = (machine) =>
  Object.entries(machine)
    .map(([key, value]) => `${key}: ${String(value)}`)
    .join('\n');
