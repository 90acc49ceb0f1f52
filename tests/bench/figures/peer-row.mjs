// @ts-check
// Rows of the comparison with peers: how samples become them, how they read, and when a viewer counts as lit. Knows no browser.

import { pairedRatios, spread } from '../statistics.mjs';

/**
 * @typedef {object} PeerRow
 * @property {string} what is measured
 * @property {string} peer
 * @property {string} version of the peer
 * @property {string} unit of the values
 * @property {import('../statistics.mjs').Spread} value its count is 0 where there is none
 * @property {import('../statistics.mjs').Spread} [ratio] peer / phong-viewer, paired within rounds
 * @property {string} [note]
 *
 * @typedef {readonly [number, number, number]} Rgb of 8 bits
 */

/** Of what cannot be measured: plain zeros, so that it survives JSON. @type {import('../statistics.mjs').Spread} */
export const NOTHING = { median: 0, low: 0, high: 0, count: 0 };

/**
 * A row for each peer, from samples of the same rounds. The first peer is the one that the others' ratios are to. Samples that
 * are NaN are of what never came: a peer with one has no value.
 * @template S
 * @param {readonly { name: string, version: string }[]} peers @param {string} what @param {string} unit
 * @param {readonly (readonly S[])[]} samples [peer][round] @param {(sample: S) => number} of
 * @param {{ ratios?: boolean, note?: (samples: readonly S[], index: number) => string | undefined }} [more]
 * @returns {PeerRow[]}
 */
export function rowsOf(peers, what, unit, samples, of, { ratios = true, note } = {}) {
  const values = samples.map((list) => list.map(of));
  const ours = values[0] ?? [];
  return peers.map(({ name, version }, i) => {
    const theirs = values[i] ?? [];
    const said = note?.(samples[i] ?? [], i);
    const ratio = pairedRatios(theirs, ours);
    return {
      ...{ what, unit, peer: name, version },
      value: theirs.every(Number.isFinite) ? spread(theirs) : NOTHING,
      ...(ratios && i > 0 && ratio.every(Number.isFinite) ? { ratio: spread(ratio) } : {}),
      ...(said === undefined ? {} : { note: said }),
    };
  });
}

/** @param {PeerRow} row */
export function peerLine({ what, peer, version, unit, value, ratio, note }) {
  const number = value.count > 0 ? `${String(Number(value.median.toPrecision(4)))} ${unit}` : '–';
  const range = value.count > 1 ? `(${value.low.toPrecision(3)}–${value.high.toPrecision(3)})` : '';
  const times = ratio === undefined ? '' : `${ratio.median.toFixed(2)} ×`;
  const subject = `${peer} ${version}`;
  return `${what.padEnd(50)} ${subject.padEnd(34)} ${number.padStart(16)} ${range.padEnd(18)} ${times.padStart(8)}${note ? `  ${note}` : ''}`;
}

/** A box looks the same on each of a peer's viewers, but for a fade that has not quite ended. Of 255. */
const SAME_COLOR = 24;

/**
 * How many viewers show the peer's box, by the colour at their middles: splash screens, buttons and broken pictures are none.
 * @param {readonly Rgb[]} middles @param {Rgb} box what a viewer alone on its page shows there
 */
export const litCount = (middles, box) =>
  middles.filter(
    (color) =>
      color.some((channel) => channel < 255) && // not the page's white
      color.every((channel, k) => Math.abs(channel - Number(box[k])) <= SAME_COLOR),
  ).length;
