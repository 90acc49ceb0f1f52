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
import { HELPERS } from '../../../src/phong/fields/viewer-words.js';
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

const bracesOf = (text: string) => (text.match(/\{\w+\}/g) ?? []).sort();

describe('the ready sets', () => {
  const entriesOf = (language: string) => Object.entries(readyTexts(language));

  it('are in five languages, and one of them as in Portugal', () => {
    expect(LANGUAGES).toEqual(['de', 'es', 'fr', 'pt', 'pt-PT']);
    for (const language of LANGUAGES) {
      expect(readyTexts(language).en).toBe(language);
    }
  });

  it('are complete: what Portugal says as Brazil does is from the set of Brazil', () => {
    expect(readyTexts('pt-PT').Close).toBe('Fechar');
    for (const language of LANGUAGES) {
      expect(entriesOf(language).filter(([, text]) => text === '')).toEqual([]);
    }
  });

  it('keep each Portuguese apart: no clitic after a verb in Brazil, no word of Brazil in Portugal', () => {
    const clitic = /\p{L}-(?:[ao]s?|l[ao]s?|n[ao]s?|me|te|se|lhes?)(?!\p{L})/iu;
    expect(entriesOf('pt').filter(([, text]) => clitic.test(text))).toEqual([]);
    const brazilian =
      /câmera|arquivo|\btela\b|salvar|carregando|controles|\bpixel\b|placa de vídeo|conexão|você|desfaz/i;
    expect(entriesOf('pt-PT').filter(([, text]) => brazilian.test(text))).toEqual([]);
  });

  it('have a word each for highlight, shininess and brightness, and address readers in one way', () => {
    for (const language of LANGUAGES) {
      const texts = new Map(entriesOf(language));
      // Of two extras, which may be missing.
      const words = [
        '{cosines} = {cosine} is not above 0: no highlight.',
        'shininess',
        '{color} brightness',
      ].map((key) =>
        (texts.get(key) ?? '').split(/[ .:\u00ad]/u).filter((word) => word.length > 4),
      );
      const [highlight = [], shininess = [], brightness = []] = words;
      expect(shininess.filter((word) => highlight.includes(word))).toEqual([]);
      expect(brightness.filter((word) => [...highlight, ...shininess].includes(word))).toEqual([]);
    }
    expect(entriesOf('es').filter(([, text]) => /\busted/i.test(text))).toEqual([]);
    for (const language of ['es', 'pt', 'pt-PT']) {
      const shiny = ([key, text]: [string, string]) =>
        key.includes('highlight') && /brilho|brillo/i.test(text);
      expect(entriesOf(language).filter(shiny)).toEqual([]);
    }
    expect(entriesOf('es').filter(([, text]) => /ambiente|decaimiento/.test(text))).toEqual([]);
    expect(
      entriesOf('de').filter(([, text]) => /\b(dein|du|dir|schreib|lass)\b/i.test(text)),
    ).toEqual([]);
  });
});

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
