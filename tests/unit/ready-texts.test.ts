// Are the ready sets of texts complete, and does the document list all keys?
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { LANGUAGES } from '../../.ci/texts.mjs';
import { ERROR_TEXTS, readyTexts, VIEWER_TEXTS } from '../support/texts.js';

const bracesOf = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).sort();

/** What every error's message may contain. */
const ERROR_VALUES = ['{message}', '{url}'];

describe.each(LANGUAGES)('the texts in %s', (language) => {
  const texts = readyTexts(language);

  it('keep the values in braces', () => {
    for (const key of VIEWER_TEXTS) expect(bracesOf(texts[key]), key).toEqual(bracesOf(key));
    for (const code of ERROR_TEXTS)
      for (const value of bracesOf(texts[code])) expect(ERROR_VALUES, code).toContain(value);
  });

  it('end in a full stop where the English text does, and have no space too many', () => {
    for (const [key, text] of Object.entries(texts)) {
      expect(text, key).toMatch(/^\S(.*\S)?$/su);
      expect(text, key).not.toContain('  ');
      if (key.includes(' ') && !key.includes(': ')) expect(text.endsWith('.'), key).toBe(key.endsWith('.'));
    }
  });

  it('are a language of their own: most texts differ from the English ones', () => {
    const same = VIEWER_TEXTS.filter((key) => texts[key] === key);
    expect(same.length).toBeLessThan(0.15 * VIEWER_TEXTS.length);
  });
});

it('French has no-break spaces before colons, and narrow ones before semicolons', () => {
  for (const [key, text] of Object.entries(readyTexts('fr')))
    expect(text, key).not.toMatch(/(?<!\u00a0):|(?<!\u202f);|(?<!\u202f)[?!]/u);
});

describe('TEXTS.md', () => {
  const document = readFileSync(new URL('../../src/TEXTS.md', import.meta.url), 'utf8');
  const listed = [...document.slice(document.indexOf('## The keys')).matchAll(/^- `(.+)`$/gm)].map(
    ([, key]) => key,
  );

  it('lists every key, in the order of the list', () => {
    expect(listed).toEqual([...VIEWER_TEXTS, ...ERROR_TEXTS]);
  });
});
