// @ts-check
// Writes the elements' descriptions in three formats that editors and documentation tools read:
// Custom Elements Manifest, JetBrains' web-types, VS Code's HTML data.

/**
 * @typedef {import('./elements.mjs').Element} Element
 * @typedef {import('./elements.mjs').Value} Value
 * @typedef {{ name: string, version: string }} Package
 */

/** The file that exports the classes, relative to the package's root. */
const module = 'dist/index.js';

/** @param {Element[]} elements @returns {import('custom-elements-manifest').Package} */
export function customElementsManifest(elements) {
  return {
    schemaVersion: '2.1.0',
    readme: 'README.md',
    modules: [
      {
        kind: 'javascript-module',
        path: module,
        declarations: elements.map(declaration),
        exports: elements.flatMap(({ tag, className }) => [
          { kind: 'js', name: className, declaration: { name: className, module } },
          {
            kind: 'custom-element-definition',
            name: tag,
            declaration: { name: className, module },
          },
        ]),
      },
    ],
  };
}

/**
 * @param {Element} element @returns {import('custom-elements-manifest').CustomElementDeclaration}
 */
function declaration(element) {
  const {
    tag,
    className,
    description,
    values,
    properties,
    ofForms,
    readonly,
    methods,
    events,
    slots,
    parts,
    states,
  } = element;
  return {
    kind: 'class',
    customElement: true,
    tagName: tag,
    name: className,
    description,
    superclass: { name: 'HTMLElement' },
    attributes: values.map((value) => ({
      name: value.attribute,
      fieldName: value.name,
      description: described(value),
      type: { text: attributeType(value) },
      ...(value.fallback === undefined ? {} : { default: value.fallback }),
    })),
    members: [
      ...values.map(property),
      ...[...properties, ...ofForms].map((typed) => ({
        kind: /** @type {const} */ ('field'),
        ...typed,
        type: { text: typed.type },
      })),
      ...readonly.map(readonlyProperty),
      ...methods.map(method),
    ],
    events: events.map(({ type, ...named }) => ({ ...named, type: { text: type } })),
    slots,
    cssParts: parts,
    cssStates: states,
  };
}

/** @param {Value} value @returns {import('custom-elements-manifest').CustomElementField} */
function property(value) {
  return {
    kind: 'field',
    name: value.name,
    attribute: value.attribute,
    description: described(value),
    type: { text: value.type },
    default: JSON.stringify(value.field.fallback),
  };
}

/**
 * @param {import('./elements.mjs').Typed} typed @returns
 * {import('custom-elements-manifest').ClassField}
 */
function readonlyProperty({ name, description, type }) {
  return { kind: 'field', name, description, type: { text: type }, readonly: true };
}

/**
 * @param {import('./elements.mjs').Method} method @returns
 * {import('custom-elements-manifest').ClassMethod}
 */
function method({ name, description, type, parameters }) {
  return {
    kind: 'method',
    name,
    description,
    parameters: parameters.map((p) => ({
      name: p.name,
      type: { text: p.type },
      ...(p.optional ? { optional: true } : {}),
    })),
    return: { type: { text: type } },
  };
}

/** @param {Element[]} elements @param {Package} manifest */
export function webTypes(elements, { name, version }) {
  return {
    $schema: 'https://json.schemastore.org/web-types',
    name,
    version,
    'js-types-syntax': 'typescript',
    'description-markup': 'markdown',
    contributions: {
      html: {
        elements: elements.map((element) => ({
          name: element.tag,
          description: element.description,
          source: { symbol: element.className },
          attributes: element.values.map((value) => ({
            name: value.attribute,
            description: described(value),
            value: { type: attributeType(value) },
            ...(value.fallback === undefined ? {} : { default: value.fallback }),
          })),
          slots: element.slots,
          css: { parts: element.parts },
          js: {
            properties: [
              ...element.values.map((value) => ({
                name: value.name,
                description: described(value),
                type: value.type,
                default: JSON.stringify(value.field.fallback),
              })),
              ...element.properties,
              ...element.ofForms,
              ...element.readonly.map((typed) => ({ ...typed, 'read-only': true })),
            ],
            events: element.events,
          },
        })),
      },
    },
  };
}

/** @param {Element[]} elements */
export function vsCodeHtmlData(elements) {
  return {
    version: 1.1,
    tags: elements.map(({ tag, description, values }) => ({
      name: tag,
      description: markdown(description),
      attributes: values.map((value) => ({
        name: value.attribute,
        description: markdown(described(value)),
        ...suggestions(value),
      })),
    })),
  };
}

/** @param {string} value */
const markdown = (value) => ({ kind: 'markdown', value });

/** `v` is VS Code's built-in set for attributes without a value. @param {Value} value */
function suggestions({ field, choices }) {
  if (field.kind === 'presence' || field.kind === 'flag-or-words') return { valueSet: 'v' };
  const words = field.kind === 'boolean' ? ['true', 'false'] : choices;
  return words.length > 0 ? { values: words.map((name) => ({ name })) } : {};
}

/** The docstring and the accepted values. @param {Value} value */
function described({ description, field }) {
  return field.kind === 'text' ? description : `${description}\n\nTakes ${field.expected}.`;
}

/** The type of the attribute's text. @param {Value} value */
function attributeType({ field, choices }) {
  if (field.kind === 'boolean' || field.kind === 'presence') return 'boolean';
  const words = choices.map((word) => `'${word}'`);
  if (field.kind === 'number') return ['number', ...words].join(' | ');
  return field.kind === 'choice' ? words.join(' | ') : 'string';
}
