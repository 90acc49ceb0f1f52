// @vitest-environment happy-dom
// Does every attribute and property behave as its row of the table says? The elements are outside
// the document.

import { expect, it } from 'vitest';
import { type Row, tables } from './attribute-rows.js';
import './on-page.js';

const propertyOf = ({ attribute, property }: Row) =>
  property ?? attribute.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());

const rowsOf = Object.entries(tables).flatMap(([tag, rows]) =>
  rows.map((row) => [tag, row.attribute, row] as const),
);

it.each(rowsOf)('<%s> %s behaves as its row of the table says', (tag, _, row) => {
  expect(faultsOf(tag, row)).toEqual([]);
});

it.each(Object.entries(tables))(
  '<%s> has no attribute or property beside its rows',
  (tag, rows) => {
    const { observedAttributes: observed } = customElements.get(tag) as unknown as {
      observedAttributes: string[];
    };
    const element = document.createElement(tag);
    const names = new Set(Object.getOwnPropertyNames(element));
    const base = Object.getOwnPropertyNames(document.createElement('x-plain'));
    for (
      let at: object = Object.getPrototypeOf(element) as object;
      at !== HTMLElement.prototype;
      at = Object.getPrototypeOf(at) as object
    ) {
      for (const key of Object.getOwnPropertyNames(at)) {
        names.add(key);
      }
    }
    const known = [
      ...rows.map(({ attribute }) => attribute),
      'aria-label',
      'aria-labelledby',
      'role',
    ];
    expect(observed.filter((attribute) => !known.includes(attribute))).toEqual([]);
    // Internals are not properties. Viewers and comparisons have methods and Lit’s properties as well.
    const internals = ['state', 'declared', 'moveFrom', 'store', 'binding', 'context'];
    const properties = rows.map(propertyOf);
    const isFull = tag === 'phong-viewer' || tag === 'phong-compare';
    const inside = [...names].filter((key) =>
      isFull
        ? internals.includes(key)
        : !['constructor', ...properties, ...base].includes(key) && !key.endsWith('Callback'),
    );
    expect(inside).toEqual([]);
  },
);

/** What is wrong with an attribute and its property. */
function faultsOf(tag: string, row: Row) {
  const property = propertyOf(row);
  const { attribute, fallback, valid, bad, refused } = row;
  const faults: string[] = [];
  const warnings: string[] = [];
  const warn = console.warn;
  console.warn = (...given: unknown[]) => warnings.push(given.join(' '));
  let element = document.createElement(tag);
  const texts = Object.entries(valid);
  const [good, itsValue] = texts[0]!;
  const check = (what: string, wanted: unknown) => {
    const value = Reflect.get(element, property) as unknown;
    const got = JSON.stringify(value);
    if (got !== JSON.stringify(wanted)) {
      faults.push(`${what} gives ${got}, not ${JSON.stringify(wanted)}`);
    }
    if ([value].flat().some((n) => Object.is(n, -0))) {
      faults.push(`${what} gives -0`);
    }
    if (Array.isArray(value) && !Object.isFrozen(value)) {
      faults.push(`${what} gives a list that is not frozen`);
    }
  };
  check('absence', fallback);
  for (const [text, value] of texts) {
    element.setAttribute(attribute, text);
    check(`"${text}"`, value);
    element.removeAttribute(attribute);
    check(`removal after "${text}"`, fallback);
  }
  if (warnings.length > 0) {
    faults.push(`good values are warned of: ${warnings.join(' | ')}`);
  }
  for (const text of bad) {
    warnings.length = 0;
    element.setAttribute(attribute, good);
    element.setAttribute(attribute, text);
    check(`"${text}"`, fallback);
    element.setAttribute(attribute, good);
    check(`a valid value after "${text}"`, itsValue);
    element.setAttribute(attribute, text);
    const instead = fallback === null ? 'none' : [fallback].flat().join(' ');
    const named = [`<${tag}>`, attribute, JSON.stringify(text), 'expected', instead];
    const missing = named.filter((part) => warnings[0]?.includes(part) !== true);
    if (missing.length > 0) {
      faults.push(`the warning of "${text}" lacks ${missing.join()}: ${warnings[0]}`);
    }
    if (warnings.length > 1) {
      faults.push(`"${text}" is warned of ${warnings.length} times`);
    }
  }
  console.warn = warn;

  element = document.createElement(tag);
  for (const [text, value] of texts) {
    for (const given of [text, value]) {
      const what = JSON.stringify(given);
      Reflect.set(element, property, given);
      check(`the property ${what}`, value);
      if (Array.isArray(given) && Reflect.get(element, property) === given) {
        faults.push('keeps the list that it was given');
      }
      for (const nothing of [null, undefined]) {
        Reflect.set(element, property, given);
        Reflect.set(element, property, nothing);
        check(`${nothing} after ${what}`, fallback);
      }
    }
  }
  Reflect.set(element, property, good);
  for (const [kind, values] of Object.entries(refused)) {
    for (const wrong of values) {
      let error = 'nothing';
      try {
        (element as unknown as Record<string, unknown>)[property] = wrong;
      } catch (thrown) {
        error = String(thrown);
      }
      const what = JSON.stringify(wrong);
      if (!error.startsWith(kind) || !error.includes(`<${tag}>`)) {
        faults.push(`${what} throws ${error}, not a ${kind} that names the element`);
      }
      check(`the refusal of ${what}`, itsValue);
    }
  }
  if (element.hasAttribute(attribute)) {
    faults.push('is reflected');
  }
  return faults;
}
