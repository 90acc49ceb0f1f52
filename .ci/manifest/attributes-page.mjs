// @ts-check
// Writes src/ATTRIBUTES.md: a table of attributes for each element, from the same descriptions as
// the API page.

/**
 * @typedef {import('./elements.mjs').Element} Element
 * @typedef {import('./elements.mjs').Value} Value
 */

const HEAD = `# Attributes

For people who write the markup: every attribute, what it takes, and its default. Written by \`npm run manifest\` from the tables of fields in
the source; do not edit. [Properties, methods and events](API.md) have a page of their own; [See light](SEEING.md) shows helpers, views,
probe and comparisons in use.

Angles are degrees, lengths scene units. A colour is \`r g b\` with 255 as full (each number from 0 to 1e6; more than 255 is a brighter light), one number for
grey, or a CSS colour in sRGB of up to 200 characters. Vectors are numbers separated by spaces or commas. An attribute that is not understood is ignored: its default applies,
and one warning on the console says what was expected. Every attribute is also a property, in camel case.
`;

/**
 * The elements in the order in which they are written: a scene needs a light and a mesh before it
 * needs the rest.
 */
const ORDER = ['phong-light', 'phong-mesh', 'phong-viewer', 'phong-compare', 'phong-control'];

/** @param {Element[]} elements @returns {string} */
export function attributesPage(elements) {
  const mesh = elements.find(({ tag }) => tag === 'phong-mesh')?.values ?? [];
  const inOrder = ORDER.map((tag) => elements.find((element) => element.tag === tag)).filter(
    (element) => element !== undefined,
  );
  return [HEAD, ...inOrder.map((element) => section(element, mesh))].join('\n');
}

/**
 * @param {Element} element @param {Value[]} mesh the values of a mesh: those that a viewer shares
 * are one row
 */
function section({ tag, description, values }, mesh) {
  const isShared = (/** @type {Value} */ value) =>
    tag === 'phong-viewer' && mesh.some(({ field }) => field === value.field);
  const shared = values.filter(isShared).map(({ attribute }) => `\`${attribute}\``);
  const rows = values.filter((value) => !isShared(value)).map(row);
  if (shared.length > 0) {
    rows.unshift(
      `| ${shared.join(', ')} | One mesh without a child element. It is shown together with all meshes inside the viewer. | as for a mesh | as for a mesh |`,
    );
  }
  return `## \`<${tag}>\`

${description}

| attribute | meaning | takes | default |
| --- | --- | --- | --- |
${rows.join('\n')}
`;
}

/** @param {Value} value */
function row({ attribute, description, field, fallback }) {
  const words = description.replace(DEFAULT, '').replaceAll(/\s+/g, ' ');
  const cells = [`\`${attribute}\``, words, takesText(field), defaultText(field, fallback)];
  return `| ${cells.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |`;
}

/** @param {Value['field']} field */
function takesText({ kind, choices, expected }) {
  if (kind === 'text') return 'text';
  if (kind === 'presence') return 'nothing';
  if (kind === 'color') return 'a colour';
  if (choices === undefined) return expected;
  return (kind === 'words' ? 'any of ' : '') + choices.map((choice) => `\`${choice}\``).join(', ');
}

/** A docstring's own sentence about the default, which has a column. */
export const DEFAULT = / Default [^.:\n]+(\.\d+[^.:\n]*)*\.(?=\s|$)/;

/** @param {Value['field']} field @param {string | undefined} fallback */
function defaultText({ kind }, fallback) {
  if (kind === 'presence') return 'absent';
  return fallback === undefined || fallback === '' ? 'none' : `\`${fallback}\``;
}
