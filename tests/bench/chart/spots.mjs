// @ts-check
// The points of a front as they are drawn: marks, labels with their leaders, and the list that says what numbers stand for.

import { EDGE, FONT, leading, text } from './frame.mjs';
import { element, escaped } from './svg.mjs';
import { figureText, range, short, widthOf, wrapped } from './text.mjs';

/**
 * @typedef {object} Spot
 * @property {import('../front.mjs').Point} point
 * @property {string} number stands for the label where that finds no room
 * @property {number} x @property {number} y of the median
 * @property {number} low @property {number} high x of the quartiles
 * @property {boolean} pale another variant makes it pointless
 * @property {boolean} base
 * @property {boolean} shipped
 * @typedef {import('./labels.mjs').Placed & { lines: readonly string[] }} Label
 * @typedef {import('./svg.mjs').Colors} Colors
 */

/** @param {Spot} spot */
export const nameOf = ({ point, base, shipped }) =>
  point.label + (base ? ' (base)' : '') + (shipped ? ' (ships)' : '');

/** @param {Label} label @param {import('./svg.mjs').Colors} colors */
export function leaderOf({ leader }, colors) {
  if (leader === null) return [];
  const [[x1, y1], [x2, y2]] = [leader.from, leader.to];
  return [
    element('line', { x1, y1, x2, y2, stroke: colors.ink, 'stroke-opacity': 0.45, 'stroke-width': 0.75 }),
  ];
}

/** @param {Label} label @param {Spot} spot @param {import('./svg.mjs').Colors} colors */
export const linesOf = ({ box, lines }, { x, pale, shipped }, colors) =>
  lines.map((line, i) => {
    // Towards its point.
    const middle = box.x + box.width / 2;
    const anchor = middle > x + 8 ? 'start' : middle < x - 8 ? 'end' : 'middle';
    const at = anchor === 'start' ? box.x : anchor === 'end' ? box.x + box.width : middle;
    return text(line, at, box.y + i * leading(FONT.label) + FONT.label, {
      ...{ 'font-size': FONT.label, 'text-anchor': anchor, fill: pale ? colors.pale : colors.ink },
      'font-weight': shipped ? 'bold' : undefined,
      ...halo(colors),
    });
  });

/** Keeps lines off the letters that they pass. @param {Colors} colors */
const halo = ({ paper }) =>
  paper === 'none'
    ? {}
    : { stroke: paper, 'stroke-width': 3, 'stroke-linejoin': 'round', 'paint-order': 'stroke' };

/** The base is a diamond, what ships has a ring; hovering says the figures. @param {Spot} spot @param {import('./svg.mjs').Colors} colors */
export function markOf(spot, colors) {
  const { x, y, low, high, pale, base, shipped } = spot;
  const color = pale ? colors.pale : colors.accent;
  const look = { fill: pale ? colors.paper : color, stroke: color, 'stroke-width': 1.5 };
  return element(
    'g',
    {},
    element('title', {}, escaped(figuresOf(spot))),
    element('line', {
      x1: low,
      y1: y,
      x2: high,
      y2: y,
      stroke: color,
      'stroke-width': 1.5,
      'stroke-opacity': 0.8,
    }),
    base
      ? element('path', { d: `M${x - 6} ${y}L${x} ${y - 6}L${x + 6} ${y}L${x} ${y + 6}Z`, ...look })
      : element('circle', { cx: x, cy: y, r: 4, ...look }),
    ...(shipped
      ? [element('circle', { cx: x, cy: y, r: 8, fill: 'none', stroke: color, 'stroke-width': 1.5 })]
      : []),
  );
}

/** @param {Spot} spot */
function figuresOf(spot) {
  const { time, ratio, error, note } = spot.point;
  return [
    `${nameOf(spot)}: ${range(time)} ms`,
    `${range(ratio)} of the base`,
    `RMSE ${short(error.rmse)}, 99.9 % within ${short(error.p999)}, largest ${short(error.max)}`,
    `other codes ${short(100 * error.share)} %`,
    `CIEDE2000 ${short(error.deltaE)}, FLIP ${short(error.flip)}`,
    ...(note === undefined ? [] : [note]),
  ].join('; ');
}

/**
 * A line a point, in as many columns as there is room for.
 * @param {readonly Spot[]} spots @param {keyof import('../front.mjs').ErrorFigures} key
 * @param {{ width: number, top: number }} place @param {Colors} colors
 */
export function listOf(spots, key, { width, top }, colors) {
  const columns = Math.max(1, Math.floor(width / COLUMN));
  const each = (width - EDGE) / columns;
  const inColumn = Math.ceil(spots.length / columns);
  const rows = [];
  let lowest = top;
  for (let column = 0; column < columns; column++) {
    const left = EDGE + column * each;
    let y = top + leading(FONT.label);
    for (const spot of spots.slice(column * inColumn, (column + 1) * inColumn)) {
      const { time, error } = spot.point;
      const figures = `${figureText(time.median)} ms, ${error[key] === 0 ? 'exact' : figureText(error[key])}`;
      const look = { 'font-size': FONT.label, fill: spot.pale ? colors.pale : colors.ink };
      const weight = spot.shipped ? 'bold' : undefined;
      const room = each - 39 - EDGE - 10 - widthOf(figures, FONT.label);
      const lines = wrapped(nameOf(spot), spot.shipped ? FONT.label * 1.1 : FONT.label, room);
      rows.push(
        markOf({ ...spot, x: left + 8, y: y - 4, low: left + 8, high: left + 8 }, colors),
        text(spot.number, left + 35, y, { ...look, 'text-anchor': 'end', 'font-weight': weight }),
        ...lines.map((line, i) =>
          text(line, left + 41, y + i * leading(FONT.label), { ...look, 'font-weight': weight }),
        ),
        text(figures, left + each - EDGE, y, { ...look, 'text-anchor': 'end' }),
      );
      y += lines.length * leading(FONT.label) + 5;
    }
    lowest = Math.max(lowest, y);
  }
  return { rows, height: Math.ceil(lowest - top) };
}

/** Narrower, a list's lines would wrap. */
const COLUMN = 330;
