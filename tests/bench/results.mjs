// @ts-check
// A result of the bench: samples of every subject by measure and side, one file for each stack.
// Says its shape, adds to it, reads it and makes ratios of it.

import { readResultFiles } from '../support/command-line.mjs';
import { median, pairedRatios, spread } from './statistics.mjs';

/**
 * @typedef {object} Measure
 * @property {string} subject
 * @property {string} measure such as `settled`
 * @property {string} unit
 * @property {Record<string, number[]>} samples by side, round by round; the last side is the base
 * of ratios
 *
 * @typedef {object} BenchResult
 * @property {string} stack
 * @property {Record<string, string>} machine
 * @property {string} date
 * @property {number} launches
 * @property {readonly [number, number]} size of pictures, in pixels
 * @property {Measure[]} measures
 * @property {{ subject: string, message: string }[]} failures
 * @property {{ subjects: string[], machine: Record<string, string>, date: string, launches: number,
 * note: string }[]} [added] subjects that were measured on their own, with `--add`
 */

/**
 * Adds one round's samples.
 * @param {BenchResult} result @param {string} subject @param {string} measure @param {string} unit
 * @param {Readonly<Record<string, number>>} values by side, the base last
 */
export function addSamples(result, subject, measure, unit, values) {
  let row = rowOf(result, subject, measure);
  if (row === undefined) {
    row = { subject, measure, unit, samples: {} };
    result.measures.push(row);
  }
  for (const [side, value] of Object.entries(values)) {
    (row.samples[side] ??= []).push(Number(value.toPrecision(4)));
  }
}

/**
 * A subject's measure; undefined where it was not measured.
 * @param {BenchResult} result @param {string} subject @param {string} measure
 */
export const rowOf = ({ measures }, subject, measure) =>
  measures.find((row) => row.subject === subject && row.measure === measure);

/**
 * Median and quartiles of one side. @param {Measure} measure @param {string} [side] default: the
 * first
 */
export const valueOf = ({ samples }, side = Object.keys(samples)[0] ?? '') =>
  spread(samples[side] ?? []);

/**
 * Of a side to the base, in rounds that both were measured in; undefined where there is one side.
 * @param {Measure} measure @param {string} [side] default: the first
 */
export function ratioOf({ samples }, side = Object.keys(samples)[0] ?? '') {
  const base = Object.keys(samples).at(-1) ?? '';
  if (base === side) return undefined;
  return spread(pairedRatios(samples[side] ?? [], samples[base] ?? []));
}

/**
 * Of the first side to the better one of the others: the one with the least median. Undefined where
 * there is one side.
 * @param {Measure} measure
 */
export function ratioToBest({ samples }) {
  const [ours = [], ...others] = Object.values(samples);
  const [best] = others.sort((a, b) => median(a) - median(b));
  return best === undefined ? undefined : spread(pairedRatios(ours, best));
}

/**
 * Its spread over several subjects: each one's median counts once. Undefined where none was
 * measured. @param {BenchResult} result @param {readonly string[]} subjects @param {string} measure
 */
export function ratioOverSubjects({ measures }, subjects, measure) {
  const ratios = measures
    .filter((one) => subjects.includes(one.subject) && one.measure === measure)
    .flatMap((one) => ratioToBest(one)?.median ?? []);
  return ratios.length === 0 ? undefined : spread(ratios);
}

/** All results of a folder, by stack. @param {string} folder @returns {BenchResult[]} */
export const readResults = (folder) =>
  readResultFiles(folder, 'npm run bench').map(({ content }) => content);
