// @ts-check
// Text and tables of Markdown as GitHub shows it, HTML within it included.

/** Nothing in it is taken for markup, nor ends a table's cell. @param {string} text */
export const plain = (text) =>
  inHtml(text)
    .replaceAll(/[\\`*_[\]|~]/g, '\\$&')
    .replaceAll(/\s+/g, ' ')
    .trim();

/** The same within tags. @param {string} text */
export const inHtml = (text) =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

/** @param {readonly string[]} head @param {readonly (readonly string[])[]} rows of cells that are Markdown already */
export function table(head, rows) {
  const line = (/** @type {readonly string[]} */ cells) => `| ${cells.join(' | ')} |`;
  return [line(head), line(head.map(() => '---')), ...rows.map(line)].join('\n');
}

/** Part of an address. @param {string} text */
export const slug = (text) => text.replaceAll(/[^\w.]+/g, '-').replaceAll(/^-|-$/g, '');
