// Are numbers that are only read written as the language of the words around them writes them?
import { afterEach, describe, expect, it, vi } from 'vitest';
import { localNumber } from '../../../src/viewer/element/fields/texts.js';
import { readyTexts } from '../../support/texts.js';

const de = readyTexts('de');

const inLanguage = (lang: string) => {
  vi.stubGlobal('document', { documentElement: { lang } });
};

describe('numbers that are only read', () => {
  afterEach(() => {
    vi.unstubAllGlobals();
  });

  it.each([
    ['', '−0.25', '−0.25'],
    ['en-GB', '1234567.5', '1234567.5'],
    ['de', '−0.25', '−0,25'],
    ['fr-CH', '12', '12'],
    ['pt-BR', '1234.5', '1234,5'],
    ['es', '1.0e+7', '1,0e+7'],
    ['ar-EG', '−0.25', '−٠٫٢٥'],
    ['no language at all!', '0.5', '0.5'],
    ['de', '∞', '∞'],
  ])('under lang="%s" %s is %s', (lang, number, expected) => {
    inLanguage(lang);
    expect(localNumber(number, {})).toBe(expected);
  });

  it('are English without texts, and in the language that texts name, whatever the page', () => {
    inLanguage('fr');
    expect([null, {}, de].map((texts) => localNumber('0.5', texts))).toEqual(['0.5', '0,5', '0,5']);
    inLanguage('en');
    expect([null, {}, de].map((texts) => localNumber('0.5', texts))).toEqual(['0.5', '0.5', '0,5']);
  });
});
