// @ts-check
// A front as a picture: run time against error, both logarithmic, with the variants that nothing beats joined by steps. An SVG
// as text, for a report or a page; the same front gives the same text.

import { logAxis } from './axis.mjs';
import { axes, besideTicks, colorsOf, FONT, heads, layout, leading, svg, text } from './frame.mjs';
import { placeLabels } from './labels.mjs';
import { leaderOf, linesOf, listOf, markOf, nameOf } from './spots.mjs';
import { element, polyline } from './svg.mjs';
import { balanced, widthOf } from './text.mjs';
import { dominated, frontier } from '../front.mjs';

/**
 * @typedef {import('../front.mjs').Front} Front
 * @typedef {import('../front.mjs').Point} Point
 * @typedef {import('./frame.mjs').ChartOptions & { shipped?: string, key?: keyof typeof ERRORS }} FrontOptions
 *   the variant that users get, default the front's own; the error on the axis, default rmse
 */

/** What the errors of a front can be shown in. */
const ERRORS = {
  rmse: ['error: RMSE of channels, 1/255', 'RMSE, 1/255'],
  p999: ['error: 99.9 % of channels within, 1/255', '99.9 %, 1/255'],
  max: ['error: largest of a channel, 1/255', 'largest, 1/255'],
  share: ['error: share of other 8-bit codes', 'other codes'],
  deltaE: ['error: mean CIEDE2000', 'CIEDE2000'],
  deltaEMax: ['error: largest CIEDE2000', 'CIEDE2000'],
  flip: ['error: mean FLIP', 'FLIP'],
};

/** Below this width labels are numbers, with a list below the chart. */
const NARROW = 520;
/** Labels wrap beyond. */
const LABEL_WIDTH = 150;
/** Pixels at least between labels side by side. */
const BETWEEN = 6;
/** The band at the bottom for errors of 0, which a logarithm has no place for. */
const BAND = 30;

/**
 * Where labels find no room, numbers stand for them, and the picture is taller by a list.
 * @param {Front} front @param {FrontOptions} [options]
 */
export function frontChart(front, options = {}) {
  const { width = 720, height = 460, shipped = front.shipped, key = 'rmse' } = options;
  const { title = front.title } = options;
  const colors = colorsOf(options.colors);
  const place = layout({ width, height, title, subtitle: subtitleOf(front) });
  const exact = front.points.some(({ error }) => error[key] === 0);
  const floor = place.plot.y + place.plot.height - (exact ? BAND : 0);
  const times = front.points.flatMap(({ time }) => [time.low, time.median, time.high]);
  const errors = front.points.map(({ error }) => error[key]).filter((x) => x > 0);
  const up = logAxis(errors, floor, place.plot.y, 26);
  const plot = besideTicks(place.plot, up);
  const across = logAxis(times, plot.x, plot.x + plot.width, 46);
  const pointless = dominated(front.points, key);
  const spots = front.points.map((point, i) => ({
    ...{ point, number: String(i + 1) },
    x: across.at(point.time.median),
    y: point.error[key] === 0 ? floor + BAND / 2 : up.at(point.error[key]),
    low: across.at(point.time.low),
    high: across.at(point.time.high),
    pale: pointless.has(point.id),
    base: point.id === front.base,
    shipped: point.id === shipped,
  }));
  const best = frontier(front.points, key).map(({ id }) => spots.find(({ point }) => point.id === id));
  const steps = stepsOf(/** @type {Spot[]} */ (best), plot);
  const lines = segmentsOf(steps).concat(
    spots.map(({ low, high, y }) => ({ from: [low, y], to: [high, y] })),
  );
  const named = labelsOf(spots, plot, lines, (spot) => balanced(nameOf(spot), FONT.label, LABEL_WIDTH));
  const numbered = width < NARROW || named.some(({ unclear }) => unclear);
  const labels = numbered ? labelsOf(spots, plot, lines, ({ number }) => [number]) : named;
  const list = numbered ? listOf(spots, key, { width, top: height }, colors) : { rows: [], height: 0 };
  const name = `${title}. ${ERRORS[key][0]}, against ms a frame; of ${spots.length} variants ${best.length} that none beats: ${best.map((spot) => spot?.point.label).join(', ')}.`;
  return svg({ width, height: height + list.height, name }, colors, [
    ...heads(place, colors),
    ...axes(plot, { axis: across, name: 'time: ms a frame' }, { axis: up, names: ERRORS[key] }, colors),
    ...(exact ? band(plot, floor, colors) : []),
    element('path', {
      d: polyline(steps),
      ...{ fill: 'none', stroke: colors.accent, 'stroke-width': 1.75, 'stroke-opacity': 0.75 },
    }),
    ...labels.flatMap((label) => leaderOf(label, colors)),
    ...[...spots].sort((a, b) => Number(b.pale) - Number(a.pale)).map((spot) => markOf(spot, colors)),
    ...labels.flatMap((label, i) => linesOf(label, /** @type {Spot} */ (spots[i]), colors)),
    ...list.rows,
  ]);
}

/** @param {Front} front */
const subtitleOf = ({ truth, measure, size, errorSize }) =>
  `Against ${truth}. ${measure}, ${size.join(' × ')}; errors of ${errorSize.join(' × ')}. ` +
  'Dots are medians, bars quartiles; hollow: another is no slower and no worse.';

/**
 * @typedef {import('./spots.mjs').Spot} Spot
 * @typedef {import('./spots.mjs').Label} Label
 * @typedef {import('./labels.mjs').Segment} Segment
 */

/** From the top down to the first, then the least error to be had at each time. @param {readonly Spot[]} best @param {import('./labels.mjs').Box} plot */
function stepsOf(best, plot) {
  /** @type {[number, number][]} */
  const corners = [];
  let height = plot.y;
  for (const { x, y } of best) {
    corners.push([x, height], [x, y]);
    height = y;
  }
  return [...corners, /** @type {[number, number]} */ ([plot.x + plot.width, height])];
}

/** @param {readonly [number, number][]} corners @returns {Segment[]} */
const segmentsOf = (corners) =>
  corners.slice(1).map((to, i) => ({ from: /** @type {[number, number]} */ (corners[i]), to }));

/**
 * @param {readonly Spot[]} spots @param {import('./labels.mjs').Box} plot @param {readonly Segment[]} lines
 * @param {(spot: Spot) => readonly string[]} textOf
 * @returns {Label[]}
 */
function labelsOf(spots, plot, lines, textOf) {
  const texts = spots.map(textOf);
  const wanted = spots.map(({ x, y, shipped }, i) => {
    const text = texts[i] ?? [];
    const size = shipped ? FONT.label * 1.1 : FONT.label; // bold
    const width = Math.max(...text.map((line) => widthOf(line, size))) + BETWEEN;
    return { x, y, width, height: leading(FONT.label) * text.length + 3 };
  });
  const marks = spots.map(({ x, y, shipped }) => {
    const radius = shipped ? 9.5 : 7;
    return { x: x - radius, y: y - radius, width: 2 * radius, height: 2 * radius };
  });
  return placeLabels(wanted, plot, { marks, lines }).map((label, i) => ({ ...label, lines: texts[i] ?? [] }));
}

/** @param {import('./labels.mjs').Box} plot @param {number} floor @param {import('./svg.mjs').Colors} colors */
const band = (plot, floor, colors) => [
  element('rect', {
    ...{ x: plot.x, y: floor, width: plot.width, height: BAND },
    ...{ fill: colors.ink, 'fill-opacity': 0.06 },
  }),
  text('exact', plot.x - 7, floor + BAND / 2 + 4, {
    ...{ 'font-size': FONT.tick, 'text-anchor': 'end', fill: colors.ink },
  }),
];
