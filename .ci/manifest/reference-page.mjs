// @ts-check
// Writes a part of demo/guide/reference.md: for each element tables of its attributes, properties,
// methods, events, slots, parts and states, from the descriptions in the source.

/**
 * @typedef {import('./elements.mjs').Element} Element
 * @typedef {import('./elements.mjs').Value} Value
 */

const [OPEN, CLOSE] = ['<!-- elements: written by npm run manifest -->', '<!-- /elements -->'];

/**
 * The elements in the order in which they are written: a scene needs a light and a mesh before it
 * needs the rest. Others follow.
 */
const ORDER = [
  'phong-light',
  'phong-mesh',
  'phong-viewer',
  'phong-compare',
  'phong-control',
  'phong-probe',
  'phong-exercise',
];

/**
 * The page with the part written anew. @param {string} page @param {Element[]} elements
 * @returns {string}
 */
export function referencePage(page, elements) {
  const mesh = elements.find(({ tag }) => tag === 'phong-mesh')?.values ?? [];
  const rank = (/** @type {Element} */ { tag }) =>
    ORDER.includes(tag) ? ORDER.indexOf(tag) : ORDER.length;
  const inOrder = [...elements].sort((a, b) => rank(a) - rank(b));
  const part = inOrder.map((element) => section(element, mesh)).join('\n');
  const [from, to] = [page.indexOf(OPEN), page.indexOf(CLOSE)];
  if (from < 0 || to < from) throw new Error(`The page has lost its marks ${OPEN} and ${CLOSE}`);
  return `${page.slice(0, from)}${OPEN}\n\n${part}\n${page.slice(to)}`;
}

/**
 * @param {Element} element @param {Value[]} mesh the values of a mesh: those that a viewer shares
 * are one row
 */
function section(element, mesh) {
  const { tag, description, values, properties, readonly, methods, events } = element;
  const isShared = (/** @type {Value} */ value) =>
    tag === 'phong-viewer' && mesh.some(({ field }) => field === value.field);
  const shared = values.filter(isShared).map(({ attribute }) => `\`${attribute}\``);
  const rows = values.filter((value) => !isShared(value)).map(row);
  if (shared.length > 0) {
    rows.unshift(
      `${shared.join(', ')} | As of a mesh. It is shown with the meshes inside. | as there | as there`,
    );
  }
  const called = methods.map(({ name, parameters, ...rest }) => {
    const given = parameters.map((parameter) => parameter.name).join(', ');
    return { ...rest, name: `${name}(${given})` };
  });
  return [
    `## \`<${tag}>\`\n\n${words(description.replace(SAID, ''))}\n`,
    table('attribute | meaning | takes | default', rows),
    namedTable('property', [...properties, ...readonly]),
    namedTable('method', called),
    namedTable('event', events),
    namedTable('slot', element.slots),
    namedTable('part', element.parts),
    namedTable('state', element.states),
  ]
    .filter((part) => part !== '')
    .join('\n');
}

/** @param {string} head @param {string[]} rows */
function table(head, rows) {
  if (rows.length === 0) return '';
  const rule = head.replaceAll(/[^|]+/g, '---');
  return `${[head, rule, ...rows].map((cells) => cells.trim()).join('\n')}\n`;
}

/** @param {string} kind @param {{ name: string, description: string }[]} items */
const namedTable = (kind, items) =>
  table(
    `${kind} | meaning`,
    items.map(({ name, description }) =>
      [`\`${name || 'none'}\``, words(description)].map(escaped).join(' | '),
    ),
  );

/** What the page says of all elements. */
const SAID =
  /(?:Its p|P)roperties have the attributes' names[^.]*\.\s+A bad attribute value[^.]*\./;

/** @param {string} cell */
const escaped = (cell) => cell.replaceAll('|', '\\|');

/** On one line, links as names. @param {string} text */
const words = (text) =>
  text
    .replaceAll(/\{@link (?:\w+\.)?(\w+)\}/g, '`$1`')
    .replaceAll(/\s+/g, ' ')
    .trim();

/** @param {Value} value */
function row({ attribute, description, field, fallback }) {
  const meaning = words(description.replace(DEFAULT, ''));
  const takes = takesText(field);
  const isSaid = (field.choices ?? []).every((choice) => meaning.includes(`\`${choice}\``));
  const shown = isSaid && field.kind === 'choice' ? 'one of these' : takes;
  const cells = [`\`${attribute}\``, meaning, shown, defaultText(field, fallback)];
  return cells.map(escaped).join(' | ');
}

/** @param {Value['field']} field */
function takesText({ kind, choices, expected }) {
  if (kind === 'text') return 'text';
  if (kind === 'presence') return 'nothing';
  if (kind === 'color') return 'a colour';
  if (choices === undefined) {
    return expected
      .replace(/;.*/, '') // advice to who writes something else
      .replace('a whole number', 'whole,')
      .replace(/,? ?(?:each )?a number (from|above)/, (_, word) => ` ${word}`)
      .trim();
  }
  return (kind === 'words' ? 'any of ' : '') + choices.map((choice) => `\`${choice}\``).join(', ');
}

/** A docstring's own sentence about the default, which has a column. */
const DEFAULT = / Default [^.:\n]+(\.\d+[^.:\n]*)*\.(?=\s|$)/;

/** @param {Value['field']} field @param {string | undefined} fallback */
function defaultText({ kind }, fallback) {
  if (kind === 'presence') return '';
  return fallback === undefined || fallback === '' ? '' : `\`${fallback}\``;
}
