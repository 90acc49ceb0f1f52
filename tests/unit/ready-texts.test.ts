// Are the ready sets of texts complete, and does the document list all keys?
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { ERROR_TEXTS, VIEWER_TEXTS } from '../../src/element/fields/text-list.js';
import type { CompleteTexts } from '../../src/element/fields/texts.js';
import de from '../../src/element/texts/de.json' with { type: 'json' };
import es from '../../src/element/texts/es.json' with { type: 'json' };
import fr from '../../src/element/texts/fr.json' with { type: 'json' };
import pt from '../../src/element/texts/pt.json' with { type: 'json' };

const bracesOf = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).sort();

/** What every error's message may contain. */
const ERROR_VALUES = ['{message}', '{url}'];

describe.each(Object.entries<CompleteTexts>({ de, es, fr, pt }))('the texts in %s', (_language, texts) => {
  it('have every key, in the order of the list', () => {
    expect(Object.keys(texts)).toEqual([...VIEWER_TEXTS, ...ERROR_TEXTS]);
  });

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
  for (const [key, text] of Object.entries(fr))
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
