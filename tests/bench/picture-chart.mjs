// @ts-check
// The chart of whole pictures: error over time, both logarithmic, one panel for each picture. The
// site lets each panel have the width that there is; the report has them in one file for each stack.

import * as Plot from '@observablehq/plot';
import { parseHTML } from 'linkedom';
import { accuracyPlot, cleaned } from './accuracy-chart.mjs';
import { picturePoints, SERIES } from './pictures.mjs';
import { PICTURES, pictureSubject } from './subjects.mjs';

/** @typedef {keyof typeof PICTURES} Picture */
/** @typedef {import('./pictures.mjs').PicturePoint & { picture: Picture }} PanelPoint */

/** The pages' custom properties, by line. */
const COLORS = SERIES.map((_, i) => `var(--series-${i + 1})`);

/** Of a panel, in pixels. */
const SIZE = { width: 300, height: 230 };
/** Of the report's chart, with two panels in a row, each below its name. */
const WIDTH = 680;
const ROW = 265;
const TOP = 80;

/**
 * Of all pictures that were measured. @param {import('./results.mjs').BenchResult} result @returns
 * {PanelPoint[]}
 */
export const panelPoints = (result) =>
  /** @type {Picture[]} */ (Object.keys(PICTURES)).flatMap((picture) =>
    picturePoints(result, pictureSubject(picture)).map((point) => ({ ...point, picture })),
  );

const newDocument = () => parseHTML('<!doctype html><html><body></body></html>').document;

/**
 * One panel, whose colours are the page's. @param {readonly PanelPoint[]} points of all panels
 * @param {Picture} picture
 */
export function panelSvg(points, picture) {
  const place = { x: 'time', y: 'error', stroke: 'series', z: 'series' };
  const own = points.filter((point) => point.picture === picture);
  const shipped = own.filter(({ codes }) => !codes);
  const averaged = own.filter(({ codes }) => codes);
  const few = own.filter(({ series }) => series !== 'TAARenderPass');
  const svg = Plot.plot({
    document: newDocument(),
    ...SIZE,
    marginLeft: 34,
    marginRight: 8,
    marginTop: 8,
    marginBottom: 24,
    x: scaleOf(points, 'time'),
    y: scaleOf(points, 'error'),
    color: { domain: SERIES.map(({ series }) => series), range: COLORS },
    ariaLabel: `${picture}: error over time`,
    marks: [
      Plot.line(shipped, { ...place, strokeWidth: 2 }),
      Plot.line(averaged, { ...place, strokeWidth: 1.5, strokeDasharray: '3 3' }),
      Plot.dot(few, { x: 'time', y: 'error', fill: 'series', r: 3 }),
    ],
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

/**
 * All panels of a result in one file; undefined without any. @param
 * {import('./results.mjs').BenchResult} result
 */
export function picturesChart(result) {
  const points = panelPoints(result);
  const pictures = [...new Set(points.map(({ picture }) => picture))];
  if (pictures.length === 0) return undefined;
  const panels = pictures.map((picture, i) => {
    const [x, y] = [(WIDTH / 2) * (i % 2), TOP + ROW * Math.floor(i / 2)];
    const panel = panelSvg(points, picture).replace(
      '<svg',
      `<svg x="${x}" y="${y}" width="${SIZE.width}" height="${SIZE.height}"`,
    );
    return `<text x="${x + 34}" y="${y - 4}" font-weight="bold">${picture}</text>${panel}`;
  });
  const names = SERIES.map(
    ({ series }, i) => `<text x="${10 + 170 * i}" y="42" fill="${COLORS[i]}">${series}</text>`,
  );
  const height = TOP + ROW * Math.ceil(pictures.length / 2);
  return fileOf(`<svg width="${WIDTH}" height="${height}" font-family="sans-serif" font-size="14">
<text x="10" y="20" fill="currentColor">RMSE in codes over time, plain picture = 1 (dashed: average of codes)</text>
${names.join('\n')}
<g fill="currentColor">${panels.join('\n')}</g></svg>`);
}

/**
 * What accuracy costs, as a file of its own. @param {import('./accuracy-words.mjs').Accuracy}
 * accuracy @param {number} width
 */
export const accuracyFile = (accuracy, width) =>
  fileOf(accuracyPlot(accuracy, width, newDocument()).outerHTML);

/** What a page says of colours stands in a file. @param {string} svg */
const fileOf = (svg) =>
  svg.replace('<svg ', '<svg xmlns="http://www.w3.org/2000/svg" ').replace(
    '>',
    `><style>svg{background:var(--paper);color:var(--ink);--paper:#fff;--ink:#15171a;--quiet:#565c64;--band:#eceef0;--series-1:#0072b2;--series-2:#d55e00;--series-3:#009e73;--series-4:#cc79a7}
@media (prefers-color-scheme:dark){svg{--paper:#131417;--ink:#e3e4e6;--quiet:#a0a5ad;--band:#25282d;--series-1:#56b4e9;--series-2:#e8803a;--series-3:#2fbf95}}</style>`,
  );
