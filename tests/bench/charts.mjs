// @ts-check
// The charts of the report, drawn by Observable Plot as SVG files: four at most for each stack. Text of fixed size and colour, on white,
// so that they are readable wherever the report is shown.

import * as Plot from '@observablehq/plot';
import { parseHTML } from 'linkedom';
import { AIMS, stackKind, TAKE_OVER_MS } from './aims.mjs';
import { panelMarks, panelPoints, panelScales } from './picture-chart.mjs';
import { SERIES } from './pictures.mjs';
import { ratioOf, rowOf, valueOf } from './results.mjs';
import { median, pairedRatios } from './statistics.mjs';
import { SPHERE_LIGHTS } from './subjects.mjs';

/** @typedef {import('./results.mjs').BenchResult} BenchResult @typedef {{ x: number, y: number, series: string }} Point */

/** Distinguishable to colour-blind readers (Okabe and Ito). */
const COLORS = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#56b4e9', '#e69f00'];
const WIDTH = 680;
const HEIGHT = 400;

/** All charts of a result, by the end of their file's name. Those without data are left out. @param {BenchResult} result @returns {Map<string, string>} */
export function chartsOf(result) {
  const charts = new Map();
  /** @param {string} name @param {string | undefined} svg */
  const add = (name, svg) => svg !== undefined && charts.set(name, svg);
  add('sphere', sphereChart(result));
  add('longest-frame', longestChart(result));
  add('fronts', frontsChart(result));
  add('pictures', picturesChart(result));
  return charts;
}

/** @param {BenchResult} result */
function sphereChart(result) {
  /** @param {string} measure @returns {Point[]} */
  const points = (measure) =>
    perLight(result, SPHERE_LIGHTS, measure, (row) => ratioOf(row)?.median, measure);
  /** @param {string} measure @returns {Point[]} */
  const aims = (measure) =>
    SPHERE_LIGHTS.flatMap((count) => {
      const aim = AIMS.find((one) => one.subject === sphereName(count) && one.measure === measure);
      const y = aim?.most[stackKind(result)];
      return y === undefined ? [] : [{ x: count, y, series: measure }];
    });
  return lines(
    [...points('first frames'), ...points('settled')],
    [...aims('first frames'), ...aims('settled')],
    {
      title: 'Frame time of the sphere, MeshPhongMaterial = 1 (dashed: aims)',
      x: 'lights',
      ticks: SPHERE_LIGHTS,
      rule: 1,
    },
  );
}

/** @param {BenchResult} result */
function longestChart(result) {
  /** @param {string} side @param {string} series @returns {Point[]} */
  const points = (side, series) =>
    perLight(
      result,
      [...SPHERE_LIGHTS, 1024],
      'longest frame',
      (row) => (side in row.samples ? valueOf(row, side).median : undefined),
      series,
    );
  return lines([...points('element', 'element'), ...points('three', 'MeshPhongMaterial')], [], {
    title: `Longest frame in ms while a specialised program takes over (line: ${TAKE_OVER_MS[stackKind(result)]} ms)`,
    x: 'lights',
    ticks: [...SPHERE_LIGHTS, 1024],
    rule: TAKE_OVER_MS[stackKind(result)],
  });
}

/** @param {BenchResult} result */
function frontsChart({ fronts }) {
  if (fronts.length === 0) return undefined;
  const points = fronts.flatMap(({ title, variants, base, errors, ms }) =>
    variants.map((variant, i) => ({
      front: title.replace(/ of mixed kinds/, ''),
      variant,
      time: median(pairedRatios(ms[i] ?? [], ms[base] ?? [])),
      error: Math.max(errors[i]?.max ?? NaN, 1e-5),
    })),
  );
  const variants = [...new Set(points.map(({ variant }) => variant))];
  return svgOf({
    ...frame('Light loops: largest error in 1/255, and time (as specified = 1)'),
    marginLeft: 140,
    marginRight: 230,
    facet: { data: points, y: 'front' },
    height: 130 * fronts.length + 80,
    fy: { label: null, domain: [...new Set(points.map(({ front }) => front))] },
    x: {
      type: 'log',
      label: 'largest error',
      grid: true,
      insetLeft: 12,
      insetRight: 70,
      ticks: [1e-4, 1e-2, 1, 100],
      tickFormat: String,
    },
    y: { label: null, domain: variants },
    color: { domain: variants, range: COLORS },
    marks: [
      Plot.dot(points, { x: 'error', y: 'variant', fill: 'variant', r: 5 }),
      Plot.text(points, {
        x: 'error',
        y: 'variant',
        text: ({ time }) => `time ${time.toFixed(2)}`,
        fill: 'variant',
        textAnchor: 'start',
        dx: 10,
      }),
    ],
  });
}

/** @param {BenchResult} result */
function picturesChart(result) {
  const points = panelPoints(result);
  if (points.length === 0) return undefined;
  const titles = [...new Map(points.map((point) => [point.picture, point])).values()];
  const { x, y, color } = panelScales(points, COLORS);
  return svgOf(
    {
      ...frame('RMSE in codes over time, plain picture = 1 (dashed: average of codes)'),
      height: 530,
      marginTop: 80,
      fx: { axis: null, padding: 0.06 },
      fy: { axis: null, padding: 0.16 },
      ...{ x: { ...x, inset: 4 }, y, color },
      marks: [
        Plot.frame({ stroke: '#ccc' }),
        ...panelMarks(points, { fx: 'column', fy: 'row' }),
        Plot.text(titles, {
          ...{ fx: 'column', fy: 'row', text: 'picture', frameAnchor: 'top', dy: -14, fontWeight: 'bold' },
        }),
      ],
    },
    SERIES.map(({ series }) => series),
  );
}

const HALO = { stroke: 'white', strokeWidth: 4 };

/**
 * @param {readonly Point[]} points @param {readonly Point[]} aims
 * @param {{ title: string, x: string, ticks: readonly number[], rule: number }} options
 */
function lines(points, aims, { title, x, ticks, rule }) {
  if (points.length === 0) return undefined;
  const series = [...new Set(points.map((point) => point.series))];
  /** Beside another point on the same place of the axis. @param {Point} point @param {(other: Point) => boolean} test */
  const beside = (point, test) =>
    points.some((other) => other !== point && other.x === point.x && test(other));
  const isLower = (/** @type {Point} */ point) => beside(point, ({ y }) => y > point.y);
  // Two equal figures are one label.
  const isRepeated = (/** @type {Point} */ point) =>
    point.series !== series[0] && beside(point, ({ y }) => short(y) === short(point.y));
  const labelled = points.filter((point) => !isRepeated(point));
  /** @param {readonly Point[]} some @param {number} dy */
  const figures = (some, dy) =>
    Plot.text([...some], {
      ...{ x: 'x', y: 'y', dy, fill: 'series', ...HALO },
      text: (/** @type {Point} */ point) => short(point.y),
    });
  return svgOf(
    {
      ...frame(title),
      x: { type: 'point', label: x, domain: [...ticks], tickFormat: String, padding: 0.3 },
      y: { type: 'log', label: null, grid: true, ticks: 6, tickFormat: short, inset: 26 },
      color: { domain: series, range: COLORS },
      marks: [
        Plot.ruleY([rule], { stroke: '#555' }),
        Plot.line([...aims], { x: 'x', y: 'y', z: 'series', stroke: 'series', strokeDasharray: '5 4' }),
        Plot.line([...points], { x: 'x', y: 'y', z: 'series', stroke: 'series', strokeWidth: 2 }),
        Plot.dot([...points], { x: 'x', y: 'y', fill: 'series', r: 4 }),
        figures(
          labelled.filter((point) => !isLower(point)),
          -12,
        ),
        figures(labelled.filter(isLower), 14),
      ],
    },
    series,
  );
}

/** @param {string} title */
const frame = (title) => ({
  width: WIDTH,
  height: HEIGHT,
  marginTop: 60,
  marginLeft: 60,
  marginRight: 30,
  marginBottom: 45,
  ariaLabel: title,
  style: { fontSize: '13px', fontFamily: 'sans-serif', color: '#222', background: 'white' },
});

/** @param {Plot.PlotOptions} options @param {readonly string[]} [series] named below the title: lines that meet leave no room beside their ends */
function svgOf(options, series = []) {
  const { document } = parseHTML('<!doctype html><html><body></body></html>');
  const svg = Plot.plot({ ...options, document });
  /** @param {string} text @param {number} x @param {number} y @param {string} fill */
  const write = (text, x, y, fill) => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', 'text');
    const attributes = { x, y, fill, 'font-size': 15, 'font-weight': 'bold', 'text-anchor': 'start' };
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
    element.textContent = text;
    svg.append(element);
  };
  write(options.ariaLabel ?? '', 10, 20, '#222');
  const step = Math.min(170, (WIDTH - 20) / series.length);
  series.forEach((name, i) => write(name, 10 + step * i, 42, COLORS[i] ?? '#222'));
  svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return svg.outerHTML;
}

/**
 * One figure for each number of lights that was measured.
 * @param {BenchResult} result @param {readonly number[]} counts @param {string} measure
 * @param {(row: import('./results.mjs').Measure) => number | undefined} figure @param {string} series
 * @returns {Point[]}
 */
function perLight(result, counts, measure, figure, series) {
  return counts.flatMap((x) => {
    const row = rowOf(result, sphereName(x), measure);
    const y = row && figure(row);
    return y === undefined ? [] : [{ x, y, series }];
  });
}

/** @param {number} count */
const sphereName = (count) => `sphere, ${count.toLocaleString('en')} ${count === 1 ? 'light' : 'lights'}`;

/** @param {number} x */
const short = (x) => (x >= 100 ? x.toFixed(0) : String(Number(x.toPrecision(2))));
