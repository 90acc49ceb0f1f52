// Does the list of texts contain each text of the source once, and no other? The compiler refuses texts that the list
// lacks.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, expectTypeOf, it } from 'vitest';
import type { ViewerText } from '../../src/element/fields/text-list.js';
import { VIEWER_TEXTS } from '../support/texts.js';
import { checkedTexts, phrase, type ViewerTexts } from '../../src/element/fields/texts.js';
import type { PhongViewerProps } from '../../src/element/jsx.js';
import { HELPERS } from '../../src/element/fields/viewer-fields.js';
import { KINDS, TERMS } from '../../src/light/light-state.js';

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
  it('has no text twice', () => {
    expect(new Set(VIEWER_TEXTS).size).toBe(VIEWER_TEXTS.length);
  });

  it.each(VIEWER_TEXTS)('has "%s" because the viewer uses it', (text) => {
    const inSource = [`'${text}'`, `"${text}"`].some((literal) => source.includes(literal));
    expect(inSource || composed.has(text)).toBe(true);
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

describe("a viewer's texts", () => {
  it('are a frozen copy, and null for none', () => {
    const texts = { Loading: 'Lädt' };
    const copy = checkedTexts(texts);
    texts.Loading = '';
    expect(copy).toEqual({ Loading: 'Lädt' });
    expect(Object.isFrozen(copy)).toBe(true);
    expect([checkedTexts(null), checkedTexts(undefined)]).toEqual([null, null]);
  });

  it('replace texts, even by empty ones', () => {
    const texts = { Loading: '', 'Try again': undefined };
    expect(phrase(texts, 'Loading')).toBe('');
    expect(phrase(texts, 'Try again')).toBe('Try again');
    expect(phrase(texts, 'light {number}', { number: '3' })).toBe('light 3');
  });
});
