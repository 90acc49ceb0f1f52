// Does the list of texts contain no text that the source does not use, are the ready sets complete,
// and does the document list all keys? The compiler refuses texts that the list lacks.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, expectTypeOf, it } from 'vitest';
import {
  checkedTexts,
  phrase,
  type ViewerText,
  type ViewerTexts,
} from '../../../src/viewer/element/fields/texts.js';
import { LANGUAGES } from '../../../.ci/texts.mjs';
import { ERROR_TEXTS, readyTexts, VIEWER_TEXTS } from '../../support/texts.js';
import type { PhongViewerProps } from '../../../src/viewer/element/template-types.js';
import { HELPERS } from '../../../src/viewer/element/fields/viewer-fields.js';
import { KINDS, TERMS } from '../../../src/phong/light/light-state.js';

const source = readdirSync('src', { recursive: true, encoding: 'utf8' })
  .filter((path) => path.endsWith('.ts'))
  .map((path) => readFileSync(join('src', path), 'utf8'))
  .join('\n');

/** Texts that the source puts together. */
const composed = new Set<string>([
  ...TERMS.map((term) => `${term} term`),
  ...HELPERS.map((helper) => `show ${helper}`),
  ...KINDS.map((kind) => `{name}: ${kind} light, position {position}, diffuse {diffuse}`),
]);

describe('the list of texts', () => {
  it('has only texts that the viewer uses', () => {
    const unused = VIEWER_TEXTS.filter(
      (text) =>
        !composed.has(text) &&
        ![`'${text}'`, `"${text}"`].some((literal) => source.includes(literal)),
    );
    expect(unused).toEqual([]);
  });

  it('accepts texts from a file, and rejects values of other types', () => {
    expectTypeOf<Record<ViewerText, string>>().toExtend<ViewerTexts>();
    expectTypeOf<Record<string, string>>().toExtend<ViewerTexts>();
    expectTypeOf<{ 'Try again': string; 'load-failed': string }>().toExtend<ViewerTexts>();
    expectTypeOf<{ 'Try again': number }>().not.toExtend<ViewerTexts>();
    expectTypeOf<{ retry: string }>().not.toExtend<ViewerTexts>();
    expectTypeOf<PhongViewerProps['texts']>().toEqualTypeOf<ViewerTexts | null | undefined>();
  });
});

it("a viewer's texts are a frozen copy, null for none, and replace others even by empty ones", () => {
  const texts = { Loading: '', 'Try again': undefined };
  const copy = checkedTexts(texts);
  texts.Loading = 'Lädt';
  expect(copy?.Loading).toBe('');
  expect(Object.isFrozen(copy)).toBe(true);
  expect([checkedTexts(null), checkedTexts(undefined)]).toEqual([null, null]);
  expect(phrase(copy, 'Loading')).toBe('');
  expect(phrase(copy, 'Try again')).toBe('Try again');
  expect(phrase(copy, 'light {number}', { number: '3' })).toBe('light 3');
});

const bracesOf = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).sort();

describe.each(LANGUAGES)('the texts in %s', (language) => {
  const texts = readyTexts(language);

  it('keep the values in braces; a message may have its cause and address', () => {
    for (const key of VIEWER_TEXTS) {
      expect(bracesOf(texts[key]), key).toEqual(bracesOf(key));
    }
    for (const code of ERROR_TEXTS) {
      for (const value of bracesOf(texts[code])) {
        expect(['{message}', '{url}'], code).toContain(value);
      }
    }
  });

  it('end in a full stop where the English text does, and have no space too many', () => {
    for (const [key, text] of Object.entries(texts)) {
      expect(text, key).toMatch(/^\S(.*\S)?$/su);
      expect(text, key).not.toContain('  ');
      if (key.includes(' ') && !key.includes(': ')) {
        expect(text.endsWith('.'), key).toBe(key.endsWith('.'));
      }
    }
  });
});
