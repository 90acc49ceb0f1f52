// @ts-check
// The report's charts of time against error, drawn by Observable Plot as SVG files: two at most for each stack. Text of fixed size and
// colour, on white, so that they are readable wherever the report is shown. What a table shows as well has no chart.

import * as Plot from '@observablehq/plot';
import { parseHTML } from 'linkedom';
import { panelMarks, panelPoints, panelScales } from './picture-chart.mjs';
import { SERIES } from './pictures.mjs';
import { median, pairedRatios } from './statistics.mjs';

/** @typedef {import('./results.mjs').BenchResult} BenchResult */

/** Distinguishable to colour-blind readers (Okabe and Ito). */
const COLORS = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#56b4e9', '#e69f00'];
const WIDTH = 680;
const HEIGHT = 400;

/** All charts of a result, by the end of their file's name. Those without data are left out. @param {BenchResult} result @returns {Map<string, string>} */
export function chartsOf(result) {
  const charts = { fronts: frontsChart(result), pictures: picturesChart(result) };
  return new Map(Object.entries(charts).flatMap(([name, svg]) => (svg === undefined ? [] : [[name, svg]])));
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
