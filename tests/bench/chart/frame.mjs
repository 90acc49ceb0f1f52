// @ts-check
// What every chart has around its points: title, axes with ticks and names, and the SVG that holds all. Pixels, y down.

import { element, escaped, PRINT } from './svg.mjs';
import { tickText, widthOf, wrapped } from './text.mjs';

/**
 * @typedef {object} ChartOptions
 * @property {number} [width] pixels, default 720
 * @property {number} [height] pixels without the list below, default 460
 * @property {Partial<import('./svg.mjs').Colors>} [colors] default: PRINT
 * @property {string} [title] default: what the data say
 */

export const FONT = { title: 15, axis: 12, tick: 11, label: 11.5 };
const LINE = 1.25;

/** Pixels from one line of text to the next. @param {number} size */
export const leading = (size) => LINE * size;

/**
 * Where the axes may go: below as many lines of title, and of what is said under it, as the width needs. What the ticks of the
 * upward axis take on the left is `besideTicks`'s to say.
 * @param {{ width: number, height: number, title: string, subtitle: string }} chart
 */
export function layout({ width, height, title, subtitle }) {
  const titleLines = wrapped(title, FONT.title * BOLD, width - 2 * EDGE);
  const subtitleLines = wrapped(subtitle, FONT.tick, width - 2 * EDGE);
  const head = EDGE + titleLines.length * leading(FONT.title) + subtitleLines.length * leading(FONT.tick);
  const top = head + 12;
  return {
    titleLines,
    subtitleLines,
    plot: { x: EDGE, y: top, width: width - 2 * EDGE, height: height - top - FOOT },
  };
}

/** Under the axes: ticks and the name. */
const FOOT = 54;

/** @param {import('./labels.mjs').Box} plot @param {import('./axis.mjs').Axis} up @returns {import('./labels.mjs').Box} */
export function besideTicks(plot, up) {
  const ticks = Math.max(
    widthOf('exact', FONT.tick),
    ...up.ticks.map((value) => widthOf(tickText(value), FONT.tick)),
  );
  const left = leading(FONT.axis) + ticks + 8;
  return { ...plot, x: plot.x + left, width: plot.width - left };
}

export const EDGE = 14;
/** Bold letters are wider. */
const BOLD = 1.1;

/**
 * @param {ReturnType<typeof layout>} place @param {import('./svg.mjs').Colors} colors
 */
export function heads({ titleLines, subtitleLines }, colors) {
  const top = EDGE + FONT.title * 0.8;
  const below = EDGE + titleLines.length * leading(FONT.title) + FONT.tick;
  return [
    ...titleLines.map((line, i) =>
      text(line, EDGE, top + i * leading(FONT.title), {
        ...{ 'font-size': FONT.title, 'font-weight': 'bold', fill: colors.ink },
      }),
    ),
    ...subtitleLines.map((line, i) =>
      text(line, EDGE, below + i * leading(FONT.tick), { 'font-size': FONT.tick, fill: colors.pale }),
    ),
  ];
}

/**
 * Lines of the grid with their values, the frame, and the names of both axes.
 * @param {import('./labels.mjs').Box} plot
 * @param {{ axis: import('./axis.mjs').Axis, name: string }} across
 * @param {{ axis: import('./axis.mjs').Axis, names: readonly string[] }} up by all its names, the longest first
 * @param {import('./svg.mjs').Colors} colors
 */
export function axes(plot, across, up, colors) {
  const [right, bottom] = [plot.x + plot.width, plot.y + plot.height];
  const grid = { stroke: colors.ink, 'stroke-opacity': 0.14, 'stroke-width': 1 };
  const tick = { 'font-size': FONT.tick, fill: colors.ink };
  const name = { 'font-size': FONT.axis, fill: colors.ink, 'text-anchor': 'middle' };
  const [middleX, middleY] = [plot.x + plot.width / 2, plot.y + plot.height / 2];
  return [
    ...across.axis.ticks.flatMap((value) => {
      const x = across.axis.at(value);
      return [
        element('line', { x1: x, y1: plot.y, x2: x, y2: bottom, ...grid }),
        text(tickText(value), x, bottom + 16, { ...tick, 'text-anchor': 'middle' }),
      ];
    }),
    ...up.axis.ticks.flatMap((value) => {
      const y = up.axis.at(value);
      return [
        element('line', { x1: plot.x, y1: y, x2: right, y2: y, ...grid }),
        text(tickText(value), plot.x - 7, y + 4, { ...tick, 'text-anchor': 'end' }),
      ];
    }),
    element('path', {
      d: `M${plot.x} ${plot.y}V${bottom}H${right}`,
      ...{ fill: 'none', stroke: colors.ink, 'stroke-opacity': 0.6 },
    }),
    text(across.name, middleX, bottom + 38, name),
    text(fitting(up.names, plot.height), EDGE + 4, middleY, {
      ...{ ...name, transform: `rotate(-90 ${EDGE + 4} ${middleY})` },
    }),
  ];
}

/** The longest that fits. @param {readonly string[]} names @param {number} room */
const fitting = (names, room) => names.find((name) => widthOf(name, FONT.axis) <= room) ?? names.at(-1) ?? '';

/** @param {string} content @param {number} x @param {number} y of the baseline @param {Record<string, string | number | undefined>} attributes */
export const text = (content, x, y, attributes) => element('text', { x, y, ...attributes }, escaped(content));

/**
 * The whole picture.
 * @param {{ width: number, height: number, name: string }} size and what it is called where it is not seen
 * @param {import('./svg.mjs').Colors} colors @param {readonly string[]} children
 */
export function svg({ width, height, name }, colors, children) {
  const attributes = {
    ...{ xmlns: 'http://www.w3.org/2000/svg', width, height, viewBox: `0 0 ${width} ${height}` },
    ...{ role: 'img', 'aria-label': name, 'font-family': 'system-ui, "DejaVu Sans", sans-serif' },
  };
  const paper = element('rect', { width, height, rx: 6, fill: colors.paper });
  return element('svg', attributes, ...(colors.paper === 'none' ? [] : [paper]), ...children);
}

/** @param {Partial<import('./svg.mjs').Colors> | undefined} asked @returns {import('./svg.mjs').Colors} */
export const colorsOf = (asked) => ({ ...PRINT, ...asked });
