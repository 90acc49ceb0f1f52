// @ts-check
// The chart of whole pictures: error over time, both logarithmic, one panel for each picture. The
// report has all panels in one SVG file for each stack, with text of fixed size and colour, on
// white; the site lets each panel have the width that there is.

import * as Plot from '@observablehq/plot';
import { parseHTML } from 'linkedom';
import { accuracyPlot, cleaned, writerOf } from './accuracy-chart.mjs';
import { picturePoints, SERIES } from './pictures.mjs';
import { PICTURES, pictureSubject } from './subjects.mjs';

/** @typedef {keyof typeof PICTURES} Picture */
/**
 * @typedef {import('./pictures.mjs').PicturePoint & { picture: string, column: number, row: number
 * }} PanelPoint
 */

const COLUMNS = 3;

/**
 * Of all pictures that were measured. @param {import('./results.mjs').BenchResult} result @returns
 * {PanelPoint[]}
 */
export function panelPoints(result) {
  const pictures = /** @type {Picture[]} */ (Object.keys(PICTURES));
  return pictures
    .map((picture) => ({ picture, points: picturePoints(result, pictureSubject(picture)) }))
    .filter(({ points }) => points.length > 0)
    .flatMap(({ picture, points }, i) =>
      points.map((point) => ({
        ...point,
        picture,
        column: i % COLUMNS,
        row: Math.floor(i / COLUMNS),
      })),
    );
}

/**
 * The lines of panels. @param {readonly PanelPoint[]} points @param {{ fx?: string, fy?: string }}
 * facets
 */
function panelMarks(points, facets) {
  const place = { x: 'time', y: 'error', stroke: 'series', ...facets };
  const kinds = [false, true].map((codes) => points.filter((point) => point.codes === codes));
  const [shipped = [], averaged = []] = kinds;
  const few = points.filter(({ series }) => series !== 'TAARenderPass');
  return [
    Plot.line(shipped, { ...place, z: 'series', strokeWidth: 2 }),
    Plot.line(averaged, { ...place, z: 'series', strokeWidth: 1.5, strokeDasharray: '3 3' }),
    Plot.dot(few, { x: 'time', y: 'error', fill: 'series', r: 3, ...facets }),
  ];
}

/**
 * Scales that all panels share. @param {readonly PanelPoint[]} points @param {readonly string[]}
 * colors
 */
const panelScales = (points, colors) => ({
  x: scaleOf(points, 'time'),
  y: scaleOf(points, 'error'),
  color: { domain: SERIES.map(({ series }) => series), range: [...colors] },
});

/** Distinguishable to colour-blind readers (Okabe and Ito). */
const COLORS = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#56b4e9', '#e69f00'];
const WIDTH = 680;
const TITLE = 'RMSE in codes over time, plain picture = 1 (dashed: average of codes)';

const newDocument = () => parseHTML('<!doctype html><html><body></body></html>').document;

/**
 * What accuracy costs, as a file of its own: what a page says of colours stands in it. @param
 * {import('./accuracy-words.mjs').Accuracy} accuracy @param {number} width
 */
export function accuracyFile(accuracy, width) {
  const svg = accuracyPlot(accuracy, width, newDocument());
  svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return svg.outerHTML.replace(
    '>',
    `><style>svg{background:var(--paper);color:var(--ink);--paper:#fff;--ink:#15171a;--quiet:#565c64;--band:#eceef0;--series-1:#0072b2;--series-2:#d55e00;--series-3:#009e73;--series-4:#cc79a7}
@media (prefers-color-scheme:dark){svg{--paper:#131417;--ink:#e3e4e6;--quiet:#a0a5ad;--band:#25282d;--series-1:#56b4e9;--series-2:#e8803a;--series-3:#2fbf95}}</style>`,
  );
}

/**
 * The chart of a result's whole pictures; undefined without any. @param
 * {import('./results.mjs').BenchResult} result
 */
export function picturesChart(result) {
  const points = panelPoints(result);
  if (points.length === 0) return undefined;
  const titles = [...new Map(points.map((point) => [point.picture, point])).values()];
  const { x, y, color } = panelScales(points, COLORS);
  const document = newDocument();
  const svg = Plot.plot({
    document,
    width: WIDTH,
    height: 530,
    marginTop: 80,
    marginLeft: 60,
    marginRight: 30,
    marginBottom: 45,
    ariaLabel: TITLE,
    style: { fontSize: '13px', fontFamily: 'sans-serif', color: '#222', background: 'white' },
    fx: { axis: null, padding: 0.06 },
    fy: { axis: null, padding: 0.16 },
    x: { ...x, inset: 4 },
    y,
    color,
    marks: [
      Plot.frame({ stroke: '#ccc' }),
      ...panelMarks(points, { fx: 'column', fy: 'row' }),
      Plot.text(titles, {
        fx: 'column',
        fy: 'row',
        text: 'picture',
        frameAnchor: 'top',
        dy: -14,
        fontWeight: 'bold',
      }),
    ],
  });
  const add = writerOf(svg, document);
  const write = (
    /** @type {string} */ text,
    /** @type {number} */ x,
    /** @type {number} */ y,
    /** @type {string | undefined} */ fill,
  ) => add('text', { x, y, fill, 'font-size': 15, 'font-weight': 'bold' }, text);
  write(TITLE, 10, 20, '#222');
  // Below the title: lines that meet leave no room beside their ends.
  const step = Math.min(170, (WIDTH - 20) / SERIES.length);
  SERIES.forEach(({ series }, i) => write(series, 10 + step * i, 42, COLORS[i]));
  svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return svg.outerHTML;
}

/**
 * One panel for the site, whose colours are the page's. @param {readonly PanelPoint[]} points of
 * all panels @param {string} picture @param {readonly string[]} colors
 */
export function panelSvg(points, picture, colors) {
  const document = newDocument();
  const svg = Plot.plot({
    document,
    width: 300,
    height: 230,
    marginLeft: 34,
    marginRight: 8,
    marginTop: 8,
    marginBottom: 24,
    ...panelScales(points, colors),
    ariaLabel: `${picture}: error over time`,
    marks: panelMarks(
      points.filter((point) => point.picture === picture),
      {},
    ),
  });
  cleaned(svg);
  for (const name of ['width', 'height']) {
    svg.removeAttribute(name);
  }
  return svg.outerHTML;
}

/**
 * From the least to the most, widened so that no dot is cut. @param {readonly PanelPoint[]} points
 * @param {'time' | 'error'} key
 */
function scaleOf(points, key) {
  const values = points.map((point) => point[key]);
  const type = /** @type {const} */ ('log');
  const domain = [Math.min(...values) / 1.2, Math.max(...values) * 1.2];
  return { type, label: null, grid: true, domain, ticks: 4, tickFormat: short };
}

/** @param {number} x */
const short = (x) => (x >= 1000 ? `${x / 1000} k` : String(x));
