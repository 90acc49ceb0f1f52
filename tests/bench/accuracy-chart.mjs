// @ts-check
// "What does accuracy cost?" as a plot: the time of a frame against the largest error, for each way to
// write the light loop. For the site's page and for the report.

import * as Plot from '@observablehq/plot';
import {
  accuracySentence,
  EXPONENTS,
  exponentText,
  INVISIBLE,
  MAGNIFIED,
  PICTURED,
  pointsOf,
  short,
  WAYS,
} from './accuracy-words.mjs';

/** @typedef {import('./accuracy-words.mjs').Accuracy} Accuracy */

/** Pixels of a dot's radius, by the exponent. */
const RADII = [3, 4.5, 6];

/** Least error that is shown as it is. */
const LEAST = 1e-4;

/** Of the plot, and of a row of text below it, in pixels. */
const HEIGHT = 380;
const LINE = 18;
/** Of a name with its square. */
const NAME_WIDTH = 160;

/**
 * The plot, with the names of the ways and the pictures of errors below it.
 * @param {Accuracy} accuracy @param {number} width @param {Document} document makes it
 */
export function accuracyPlot(accuracy, width, document) {
  const points = WAYS.flatMap(({ way, color, fill = color }) =>
    pointsOf(accuracy, way).map(({ time, error, exponent }) => ({
      time,
      error: Math.max(error, LEAST),
      color,
      fill,
      radius: RADII[EXPONENTS.indexOf(exponent)],
    })),
  );
  const place = { x: 'time', y: 'error', stroke: 'color' };
  const svg = Plot.plot({
    document,
    width,
    height: HEIGHT,
    marginLeft: 56,
    marginTop: 30,
    marginBottom: 45,
    ariaLabel: accuracySentence(accuracy),
    x: {
      label: '← faster: time of a frame, the plain loop = 1',
      labelArrow: 'none',
      ticks: 5,
      grid: true,
      inset: 12,
      nice: true,
    },
    y: {
      type: 'log',
      label: '↓ more exact: largest error in steps of 256',
      labelArrow: 'none',
      domain: [LEAST / 2, 256],
      ticks: [1e-4, 1e-3, 0.01, 0.1, 1, 10, 100],
      tickFormat: String,
      grid: true,
    },
    r: { type: 'identity' },
    marks: [
      Plot.rect([0], { y1: LEAST / 2, y2: INVISIBLE, fill: 'var(--band)' }),
      Plot.text(['invisible: below half a step'], {
        frameAnchor: 'bottom-right',
        dx: -4,
        dy: -6,
        fill: 'var(--quiet)',
      }),
      Plot.line(points, { ...place, z: 'fill' }),
      Plot.dot(points, { ...place, r: 'radius', fill: 'fill' }),
    ],
  });
  cleaned(svg).setAttribute('font-size', '12');
  const add = writerOf(svg, document);
  let top = HEIGHT + LINE;
  add('text', { x: 0, y: top }, 'The larger a dot, the smaller its highlight:');
  top += LINE;
  add('text', { x: 0, y: top }, `its exponent n is ${EXPONENTS.map(exponentText).join(', ')}.`);
  const columns = Math.max(1, Math.floor(width / NAME_WIDTH));
  WAYS.forEach(({ label, color, fill = color }, i) => {
    const [x, y] = [1 + NAME_WIDTH * (i % columns), top + LINE * (1 + Math.floor(i / columns))];
    add('rect', { x, y: y - 10, width: 11, height: 11, fill, stroke: color });
    add('text', { x: x + 18, y }, label);
  });
  top += LINE * (1 + Math.ceil(WAYS.length / columns));
  if (accuracy.pictures.length > 0) {
    top = addPictures(accuracy, width, top + LINE, add);
  }
  svg.setAttribute('viewBox', `0 0 ${width} ${top}`);
  svg.setAttribute('height', String(top));
  return svg;
}

/**
 * @typedef {ReturnType<typeof writerOf>} Add
 * @param {Accuracy} accuracy @param {number} width @param {number} top @param {Add} add
 */
function addPictures(accuracy, width, top, add) {
  const { pictures } = accuracy;
  const title = `Errors × ${MAGNIFIED}, n = ${exponentText(PICTURED.exponent)}: black is exact`;
  add('text', { x: 0, y: top }, title);
  const gap = 12;
  const side = Math.floor(
    Math.min(170, (width - 2 - gap * (pictures.length - 1)) / pictures.length),
  );
  pictures.forEach(({ way, png }, i) => {
    const x = i * (side + gap);
    const { error = 0 } =
      pointsOf(accuracy, way).find(({ exponent }) => exponent === PICTURED.exponent) ?? {};
    const box = { x: x + 0.5, y: top + 10.5, width: side, height: side };
    add('image', { ...box, href: png });
    // An error may be as white as the page.
    add('rect', { ...box, fill: 'none', stroke: 'var(--quiet)' });
    const label = WAYS.find((one) => one.way === way)?.label ?? way;
    // On a phone.
    add(
      'text',
      { x, y: top + side + 26 },
      width < 500 ? label.replace(/phong-| formula/, '') : label,
    );
    add('text', { x, y: top + side + 41, fill: 'var(--quiet)' }, `${short(error)} steps`);
  });
  return top + side + 48;
}

/** Adds elements to a plot. @param {Element} svg @param {Document} document */
const writerOf =
  (svg, document) =>
  (
    /** @type {string} */ tag,
    /** @type {Readonly<Record<string, string | number | undefined>>} */ attributes,
    /** @type {string} */ words = '',
  ) => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
    for (const [key, value] of Object.entries({ 'text-anchor': 'start', ...attributes })) {
      element.setAttribute(key, String(value));
    }
    element.textContent = words;
    svg.append(element);
  };

/**
 * A plot as one image, without what a strict policy refuses: styles but the page's. Plot names its
 * marks, which ARIA allows only where there is a role. @param {Element} svg
 */
export function cleaned(svg) {
  svg.querySelector('style')?.remove();
  svg.removeAttribute('style');
  svg.removeAttribute('class');
  svg.setAttribute('role', 'img');
  for (const mark of svg.querySelectorAll('g[aria-label]')) {
    mark.removeAttribute('aria-label');
  }
  return svg;
}
