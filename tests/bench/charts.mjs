// @ts-check
// The report's chart of time against error, drawn by Observable Plot as an SVG file for each stack. Text of fixed size and colour, on
// white, so that it is readable wherever the report is shown.

import * as Plot from '@observablehq/plot';
import { parseHTML } from 'linkedom';
import { panelMarks, panelPoints, panelScales } from './picture-chart.mjs';
import { SERIES } from './pictures.mjs';

/** @typedef {import('./results.mjs').BenchResult} BenchResult */

/** Distinguishable to colour-blind readers (Okabe and Ito). */
const COLORS = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#56b4e9', '#e69f00'];
const WIDTH = 680;
const TITLE = 'RMSE in codes over time, plain picture = 1 (dashed: average of codes)';

/** The chart of a result's whole pictures; undefined without any. @param {BenchResult} result */
export function picturesChart(result) {
  const points = panelPoints(result);
  if (points.length === 0) return undefined;
  const titles = [...new Map(points.map((point) => [point.picture, point])).values()];
  const { x, y, color } = panelScales(points, COLORS);
  const { document } = parseHTML('<!doctype html><html><body></body></html>');
  const svg = Plot.plot({
    ...{ document, width: WIDTH, height: 530, marginTop: 80, marginLeft: 60, marginRight: 30, marginBottom: 45 },
    ariaLabel: TITLE,
    style: { fontSize: '13px', fontFamily: 'sans-serif', color: '#222', background: 'white' },
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
  });
  /** @param {string} text @param {number} x @param {number} y @param {string} fill */
  const write = (text, x, y, fill) => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', 'text');
    const attributes = { x, y, fill, 'font-size': 15, 'font-weight': 'bold', 'text-anchor': 'start' };
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
    element.textContent = text;
    svg.append(element);
  };
  write(TITLE, 10, 20, '#222');
  // Below the title: lines that meet leave no room beside their ends.
  const step = Math.min(170, (WIDTH - 20) / SERIES.length);
  SERIES.forEach(({ series }, i) => write(series, 10 + step * i, 42, COLORS[i] ?? '#222'));
  svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return svg.outerHTML;
}
