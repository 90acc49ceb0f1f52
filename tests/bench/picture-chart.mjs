// @ts-check
// The chart of whole pictures: error over time, both logarithmic, one panel for each picture. The report has all panels in one file;
// the site lets each one have the width that there is.

import * as Plot from '@observablehq/plot';
import { parseHTML } from 'linkedom';
import { picturePoints, SERIES } from './pictures.mjs';
import { PICTURES, pictureSubject } from './subjects.mjs';

/** @typedef {keyof typeof PICTURES} Picture */
/** @typedef {import('./pictures.mjs').PicturePoint & { picture: string, column: number, row: number }} PanelPoint */

const COLUMNS = 3;

/** Of all pictures that were measured. @param {import('./results.mjs').BenchResult} result @returns {PanelPoint[]} */
export function panelPoints(result) {
  const pictures = /** @type {Picture[]} */ (Object.keys(PICTURES));
  return pictures
    .map((picture) => ({ picture, points: picturePoints(result, pictureSubject(picture)) }))
    .filter(({ points }) => points.length > 0)
    .flatMap(({ picture, points }, i) =>
      points.map((point) => ({ ...point, picture, column: i % COLUMNS, row: Math.floor(i / COLUMNS) })),
    );
}

/** The lines of panels. @param {readonly PanelPoint[]} points @param {{ fx?: string, fy?: string }} facets */
export function panelMarks(points, facets) {
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

/** Scales that all panels share. @param {readonly PanelPoint[]} points @param {readonly string[]} colors */
export const panelScales = (points, colors) => ({
  x: scaleOf(points, 'time'),
  y: scaleOf(points, 'error'),
  color: { domain: SERIES.map(({ series }) => series), range: [...colors] },
});

/** One panel for the site, whose colours are the page's. @param {readonly PanelPoint[]} points of all panels @param {string} picture @param {readonly string[]} colors */
export function panelSvg(points, picture, colors) {
  const { document } = parseHTML('<!doctype html><html><body></body></html>');
  const svg = Plot.plot({
    ...{ document, width: 300, height: 230, marginLeft: 34, marginRight: 8, marginTop: 8, marginBottom: 24 },
    ...panelScales(points, colors),
    ariaLabel: `${picture}: error over time`,
    marks: panelMarks(
      points.filter((point) => point.picture === picture),
      {},
    ),
  });
  svg.querySelector('style')?.remove(); // a strict policy allows no styles but the page's
  for (const name of ['style', 'class', 'width', 'height']) svg.removeAttribute(name);
  svg.setAttribute('role', 'img');
  // Plot names its marks, which ARIA allows only where there is a role.
  for (const mark of svg.querySelectorAll('g[aria-label]')) mark.removeAttribute('aria-label');
  return svg.outerHTML;
}

/** From the least to the most, widened so that no dot is cut. @param {readonly PanelPoint[]} points @param {'time' | 'error'} key */
function scaleOf(points, key) {
  const values = points.map((point) => point[key]);
  const type = /** @type {const} */ ('log');
  const domain = [Math.min(...values) / 1.2, Math.max(...values) * 1.2];
  return { type, label: null, grid: true, domain, ticks: 4, tickFormat: short };
}

/** @param {number} x */
const short = (x) => (x >= 1000 ? `${x / 1000} k` : String(x));
