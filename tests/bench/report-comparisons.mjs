// @ts-check
// A report's sections beside its fronts: how times grow, peers, figures against their aims. A column a stack.

import { range, short } from './chart/text.mjs';
import { plain, table } from './markdown.mjs';
import { named } from './result-file.mjs';
import { chartName, images, nameOf, unique, unitsOf } from './stacks.mjs';

/** @typedef {import('./stacks.mjs').Stack} Stack */

/** @param {readonly Stack[]} stacks */
export function growth(stacks) {
  const units = unitsOf(stacks);
  if (units.length === 0) return '';
  const parts = units.map((unit) => {
    const having = stacks.filter(({ growth: list }) => list.some((one) => one.unit === unit));
    const rows = having.flatMap((stack) =>
      stack.growth.filter((one) => one.unit === unit).map((one) => growthRow(nameOf(stack), one)),
    );
    return [
      `### With the number of ${plain(unit)}`,
      images(
        having.map((stack) => ({ stack, name: chartName(stack, 'growth', unit), of: `Time with ${unit}` })),
      ),
      table(['stack', 'what', 'slope', 'upper half', 'from', 'to', 'measure', 'note'], rows),
    ].join('\n\n');
  });
  return [
    '## Growth\n\nSlopes of the logarithm of time against that of the count: 1 where twice as many take twice as long; over the upper half of the counts, what any frame costs weighs less.',
    ...parts,
  ].join('\n\n');
}

/** @param {string} stack @param {import('./growth.mjs').Growth} growth */
function growthRow(stack, { name, slope, slopeUpper, points, measure, note }) {
  const ends = [points[0], points.at(-1)].map((end) =>
    end === undefined ? '–' : `${short(end.time.median)} ms at ${short(end.at, 6)}`,
  );
  return [
    ...[plain(stack), plain(name), slope.toFixed(2), slopeUpper.toFixed(2), ...ends],
    ...[measure, plain(note ?? '')],
  ];
}

/** A table for each thing measured, a row a peer and what was asked of it. @param {readonly Stack[]} stacks */
export function peers(stacks) {
  const key = (/** @type {import('./result-file.mjs').PeerRow} */ { what, unit }) => `${what}, ${unit}`;
  const parts = unique(stacks.flatMap((stack) => stack.peers.map(key))).map((measured) =>
    comparison(
      measured,
      stacks,
      (stack) =>
        named(
          stack.peers.filter((row) => key(row) === measured),
          ({ peer }) => peer,
        ),
      peerCell,
      ({ peer, version }) => `${peer} ${version}`,
    ),
  );
  if (parts.length === 0) return '';
  return [
    '## Beside other viewers\n\nBehind × the ratio to phong-viewer, paired within rounds.',
    ...parts,
  ].join('\n\n');
}

/** @param {import('./result-file.mjs').PeerRow} row */
function peerCell({ value, ratio }) {
  if (value.count === 0) return '–';
  return ratio === undefined ? range(value) : `${range(value)} × ${short(ratio.median)}`;
}

/** @param {readonly Stack[]} stacks */
export function figures(stacks) {
  const all = stacks.flatMap((stack) => Object.values(stack.figures).flat());
  if (all.length === 0) return '';
  const aimed = all.filter(({ atMost }) => atMost !== undefined);
  const opening = `Ratios of the first to the second, paired within rounds, with the aims that they are to stay under: ${aimed.filter(meets).length} of ${aimed.length} met.`;
  const groups = unique(stacks.flatMap((stack) => Object.keys(stack.figures)));
  const parts = groups.map((group) =>
    comparison(
      group,
      stacks,
      (stack) => named(stack.figures[group] ?? [], ({ name }) => name),
      figureCell,
      ({ name }) => name,
    ),
  );
  return ['## Figures against aims', opening, ...parts].join('\n\n');
}

/** @param {import('./report.mjs').Figure} figure */
const meets = ({ ratio, atMost }) => atMost === undefined || ratio.median <= atMost;

/** @param {import('./report.mjs').Figure} figure */
function figureCell(figure) {
  const { ratio, value, peer, unit, atMost } = figure;
  if (!Number.isFinite(ratio.median)) return '–';
  const aim = atMost === undefined ? '' : meets(figure) ? `, meets ${atMost}` : `, **misses ${atMost}**`;
  return `${range(ratio)}${aim}: ${short(value.median)} of ${short(peer.median)} ${plain(unit)}`;
}

/**
 * A table with a column a stack, and the notes last; a note that is one stack's alone says whose.
 * @template {{ note?: string }} T
 * @param {string} title @param {readonly Stack[]} stacks
 * @param {(stack: Stack) => Map<string, T>} rowsOf by what tells them apart
 * @param {(row: T) => string} cell @param {(row: T) => string} label
 */
function comparison(title, stacks, rowsOf, cell, label) {
  const columns = stacks
    .map((stack) => ({ name: nameOf(stack), rows: rowsOf(stack) }))
    .filter(({ rows }) => rows.size > 0);
  const names = unique(columns.flatMap(({ rows }) => [...rows.keys()]));
  const rows = names.map((name) => {
    const here = columns.map(({ name: stack, rows: list }) => ({ stack, row: list.get(name) }));
    const labels = unique(here.flatMap(({ row }) => (row === undefined ? [] : [label(row)])));
    const notes = unique(here.map(({ row }) => row?.note));
    const said = here.flatMap(({ stack, row }) => (row?.note === undefined ? [] : [`${stack}: ${row.note}`]));
    const note = notes.length === 1 ? (notes[0] ?? '') : said.join('; ');
    return [
      labels.map(plain).join(', '),
      ...here.map(({ row }) => (row === undefined ? '–' : cell(row))),
      plain(note),
    ];
  });
  const head = ['', ...columns.map(({ name }) => plain(name)), 'note'];
  return `### ${plain(capital(title))}\n\n${table(head, rows)}`;
}

/** @param {string} text */
const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
