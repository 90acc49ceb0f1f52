// @ts-check
// SVG as text: elements with presentation attributes alone, since pages that show charts allow no styles. All text is escaped here.

/** @param {string} text */
export const escaped = (text) =>
  text
    // XML has no place for these, escaped or not.
    .replaceAll(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]|\p{Surrogate}/gu, '')
    .replaceAll('&', '&amp;')
    .replaceAll('<', '&lt;')
    .replaceAll('>', '&gt;')
    .replaceAll('"', '&quot;');

/**
 * Numbers to a hundredth of a pixel; an attribute that is undefined is left out. Children are elements, or text from `escaped`.
 * @param {string} name
 * @param {Record<string, string | number | undefined>} attributes
 * @param {...string} children
 */
export function element(name, attributes, ...children) {
  const written = Object.entries(attributes)
    .filter(([, value]) => value !== undefined)
    .map(([key, value]) => ` ${key}="${typeof value === 'number' ? rounded(value) : escaped(value ?? '')}"`)
    .join('');
  return children.length === 0 ? `<${name}${written}/>` : `<${name}${written}>${children.join('')}</${name}>`;
}

/** @param {number} x */
const rounded = (x) => String(Math.round(100 * x) / 100);

/** @param {readonly (readonly [number, number])[]} points */
export const polyline = (points) =>
  points.map(([x, y], i) => `${i === 0 ? 'M' : 'L'}${rounded(x)} ${rounded(y)}`).join('');

/**
 * @typedef {object} Colors
 * @property {string} ink text, axes
 * @property {string} paper behind everything; `none` shows the page
 * @property {string} accent what stands out: the front, its points
 * @property {string} pale what does not: text needs 4.5:1 on paper
 * @property {readonly string[]} series lines of a growth chart, in turns
 */

/**
 * Dark on white, which reads on pages of either theme. The series are Okabe and Ito's (2008), whom colour-blind readers
 * tell apart, darkened to 3:1 on white.
 * @type {Colors}
 */
export const PRINT = {
  ink: '#1f2328',
  paper: '#ffffff',
  accent: '#0b57d0',
  pale: '#656d76',
  series: ['#0b57d0', '#c04a00', '#00795a', '#a3487e', '#8a6d00', '#1f7ea8'],
};

/** The colour of the text around. @type {Colors} */
export const PAGE = {
  ...{ ink: 'currentColor', paper: 'none', accent: 'currentColor', pale: 'currentColor' },
  series: ['currentColor'],
};
