// @ts-check
// How times grow, as a picture: lines of time against a count, both logarithmic, each named at its end with its slope.

import { logAxis } from './axis.mjs';
import { axes, besideTicks, colorsOf, EDGE, FONT, heads, layout, leading, svg, text } from './frame.mjs';
import { element, escaped, polyline } from './svg.mjs';
import { balanced, range, short, widthOf } from './text.mjs';

/** @typedef {import('../growth.mjs').Growth} Growth */

/** Below this width names stand in a list below the chart. */
const NARROW = 520;
/** Names beside the chart wrap beyond. */
const NAME_WIDTH = 165;

/**
 * All of one unit.
 * @param {readonly Growth[]} growths @param {import('./frame.mjs').ChartOptions} [options]
 */
export function growthChart(growths, options = {}) {
  const { width = 720, height = 460 } = options;
  const units = new Set(growths.map(({ unit }) => unit));
  const [unit = ''] = units;
  if (units.size !== 1) throw new RangeError(`one chart of ${[...units].join(' and ') || 'nothing'}`);
  const { title = `Time with the number of ${unit}` } = options;
  const colors = colorsOf(options.colors);
  const narrow = width < NARROW;
  const names = growths.map((growth) => [
    ...balanced(growth.name, FONT.label, narrow ? width - 60 : NAME_WIDTH),
    slopesOf(growth),
  ]);
  const gutter = narrow ? 18 : 22 + Math.max(...names.flat().map((line) => widthOf(line, FONT.label)));
  const place = layout({ width, height, title, subtitle: subtitleOf(growths) });
  const points = growths.flatMap((growth) => growth.points);
  const times = points.flatMap(({ time }) => [time.low, time.high]);
  const up = logAxis(times, place.plot.y + place.plot.height, place.plot.y, 26);
  const beside = besideTicks(place.plot, up);
  const plot = { ...beside, width: beside.width - gutter };
  const counts = points.map(({ at }) => at);
  const across = logAxis(counts, plot.x, plot.x + plot.width, 46);
  const lines = growths.map((growth, i) => ({
    ...{ growth, names: narrow ? [String(i + 1)] : (names[i] ?? []) },
    ...{ color: colors.series[i % colors.series.length] ?? colors.ink, dash: DASHES[i % DASHES.length] },
    corners: growth.points.map(({ at, time }) => /** @type {const} */ ([across.at(at), up.at(time.median)])),
  }));
  const list = narrow ? listOf(names, lines, height, colors) : { rows: [], height: 0 };
  const name = `${title}. ${growths.map((growth) => `${growth.name}: ${slopesOf(growth)}`).join('; ')}.`;
  return svg({ width, height: height + list.height, name }, colors, [
    ...heads(place, colors),
    ...axes(
      plot,
      { axis: across, name: unit },
      { axis: up, names: ['time: ms a frame', 'ms a frame'] },
      colors,
    ),
    ...lines.flatMap((line) => drawn(line, up)),
    ...endNames(lines, plot, colors),
    ...list.rows,
  ]);
}

/** Tells lines apart where colours do not. */
const DASHES = [undefined, '7 3', '2 3', '9 3 2 3', '4 2', '12 4'];

/** @param {Growth} growth */
const slopesOf = ({ slope, slopeUpper }) => `slope ${slope.toFixed(2)}, upper half ${slopeUpper.toFixed(2)}`;

/** @param {readonly Growth[]} growths */
const subtitleOf = (growths) =>
  `${[...new Set(growths.map(({ measure }) => measure))].join(', ')}. ` +
  'Dots are medians, bars quartiles; slope 1: twice as many take twice as long.';

/**
 * @typedef {{ growth: Growth, names: readonly string[], color: string, dash: string | undefined, corners: readonly (readonly [number, number])[] }} Line
 * @param {Line} line @param {import('./axis.mjs').Axis} up
 */
const drawn = ({ growth, color, dash, corners }, up) => [
  element('path', {
    d: polyline(corners),
    ...{ fill: 'none', stroke: color, 'stroke-width': 1.75, 'stroke-dasharray': dash },
  }),
  ...growth.points.map(({ at, time }, i) => {
    const [x = 0, y = 0] = corners[i] ?? [];
    return element(
      'g',
      {},
      element('title', {}, escaped(`${growth.name}: ${range(time)} ms at ${short(at, 6)} ${growth.unit}`)),
      element('line', {
        x1: x,
        y1: up.at(time.low),
        x2: x,
        y2: up.at(time.high),
        stroke: color,
        'stroke-width': 1.5,
      }),
      element('circle', { cx: x, cy: y, r: 3.5, fill: color }),
    );
  }),
];

/**
 * In the order of the lines' ends, pushed apart where they would lie on each other.
 * @param {readonly Line[]} lines @param {import('./labels.mjs').Box} plot @param {import('./svg.mjs').Colors} colors
 */
function endNames(lines, plot, colors) {
  const ends = lines
    .map(({ names, corners, color }) => {
      const [x = 0, y = 0] = corners.at(-1) ?? [];
      return { names, color, x, y, height: names.length * leading(FONT.label) + 4 };
    })
    .sort((a, b) => a.y - b.y);
  const right = plot.x + plot.width;
  const total = ends.reduce((sum, { height }) => sum + height, 0);
  // From the top down each as high as it may be, then from the bottom up those that were pushed out.
  const tops = ends.map(({ y, height }) => y - height / 2);
  for (let i = 0; i < ends.length; i++) {
    const above = i === 0 ? plot.y : (tops[i - 1] ?? 0) + (ends[i - 1]?.height ?? 0);
    tops[i] = Math.max(tops[i] ?? 0, above);
  }
  let floor = Math.max(plot.y + plot.height, plot.y + total);
  for (let i = ends.length - 1; i >= 0; i--) {
    floor = Math.min(tops[i] ?? 0, floor - (ends[i]?.height ?? 0));
    tops[i] = floor;
  }
  return ends.flatMap(({ names, color, x, y, height }, i) => {
    const top = tops[i] ?? 0;
    const leader = { x1: x + 5, y1: y, x2: right + 10, y2: top + height / 2 };
    return [
      element('line', { ...leader, stroke: color, 'stroke-opacity': 0.5, 'stroke-width': 0.75 }),
      ...names.map((line, k) =>
        text(line, right + 13, top + k * leading(FONT.label) + FONT.label, {
          ...{ 'font-size': FONT.label, fill: colors.ink },
        }),
      ),
    ];
  });
}

/**
 * @param {readonly (readonly string[])[]} names @param {readonly Line[]} lines @param {number} top
 * @param {import('./svg.mjs').Colors} colors
 */
function listOf(names, lines, top, colors) {
  const rows = [];
  let y = top + leading(FONT.label);
  for (const [i, { color, dash }] of lines.entries()) {
    const look = { 'font-size': FONT.label, fill: colors.ink };
    const stroke = { stroke: color, 'stroke-width': 1.75, 'stroke-dasharray': dash };
    rows.push(
      element('line', { x1: EDGE, y1: y - 4, x2: EDGE + 16, y2: y - 4, ...stroke }),
      text(String(i + 1), EDGE + 30, y, { ...look, 'text-anchor': 'end' }),
      ...(names[i] ?? []).map((line, k) => text(line, EDGE + 36, y + k * leading(FONT.label), look)),
    );
    y += (names[i]?.length ?? 1) * leading(FONT.label) + 5;
  }
  return { rows, height: Math.ceil(y - top) };
}
