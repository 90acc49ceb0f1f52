// Is the lesson whole in each of its languages, and are its scenes and formulas the same in all?

import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { languagesOf, originalOf, pagePaths, sourceOf } from '../../.ci/site/pages.js';
import { textsOf, translated, type Words } from '../../.ci/site/translation.js';

const LESSON = 'lesson/';
const english = sourceOf(LESSON, '');
const texts = textsOf(english);

const wordsIn = (language: string) =>
  JSON.parse(readFileSync(`demo/${LESSON}${language}.json`, 'utf8')) as Words;

/** Elements and attributes without words. */
const skeletonOf = (html: string) =>
  Array.from(html.matchAll(/<(\/?[\w-]+)((?:\s[^>]*)?)>/g), ([, tag = '', attributes = '']) =>
    `${tag} ${attributes.replaceAll(/\s(alt|content|name|lang|src)="[^"]*"/g, '').replaceAll(/\s+/g, ' ')}`.trim(),
  ).sort();

const bracesOf = (text: string) => (text.match(/\{\d\}/g) ?? []).sort();

it('the lesson is in four languages, a page each', () => {
  expect(languagesOf(LESSON)).toEqual(['en', 'de', 'es', 'pt']);
  expect(pagePaths()).toEqual(
    expect.arrayContaining(['lesson/', 'lesson/de/', 'lesson/es/', 'lesson/pt/']),
  );
  expect(originalOf('lesson/pt/')).toEqual({ page: LESSON, language: 'pt' });
  for (const path of ['', 'lesson/', 'lesson/fr/', 'examples/', 'guide/light/']) {
    expect(originalOf(path), path).toBeNull();
  }
});

describe.each(languagesOf(LESSON).slice(1))('the lesson in %s', (language) => {
  const words = wordsIn(language);

  it('has each text of the English one, and no other', () => {
    expect(texts.filter((text) => words[text] === undefined)).toEqual([]);
    expect(Object.keys(words).filter((text) => !texts.includes(text))).toEqual([]);
  });

  it('has a text’s formulas and controls where they belong', () => {
    for (const [text, translation] of Object.entries(words)) {
      expect(bracesOf(translation), text).toEqual(bracesOf(text));
    }
  });

  it('has the same scenes, controls and formulas', () => {
    const html = sourceOf(`${LESSON}${language}/`, '');
    expect(skeletonOf(html)).toEqual(skeletonOf(english));
    expect(html).toContain(`<html lang="${language}">`);
    expect(html).toContain('src="../../page.ts"');
    expect(html).toContain(`<!-- texts ${language} -->`);
  });

  it('writes decimals with a comma, and speaks to one person in one way', () => {
    const prose = Object.values(words).join('\n');
    expect(prose).not.toMatch(/\d\.\d/);
    expect(prose).not.toMatch(/\busted/i);
    if (language === 'de') {
      expect(prose).not.toMatch(/\b(du|dein\w*|dir|dich|schreib|finde|gib)\b/i);
    }
    if (language === 'es') {
      expect(prose).not.toMatch(/ambiente/);
    }
    if (language === 'pt') {
      expect(prose).not.toMatch(/\p{L}-(?:[ao]s?|l[ao]s?|n[ao]s?|me|te|se|lhes?)(?!\p{L})/u);
    }
  });
});

it('no picture that is asked about shows the answer in its table', () => {
  const asked = Array.from(english.matchAll(/<phong-probe for="([^"]+)" ask=/g), ([, id]) => id!);
  expect(asked).toHaveLength(5);
  const viewers = Array.from(english.matchAll(/<phong-viewer\s[^>]*>/g), ([tag]) => tag);
  for (const id of asked) {
    const viewer = viewers.find((tag) => tag.includes(`id="${id}"`));
    expect(viewer, id).toMatch(/\sprobe-at="/);
    expect(viewer, id).not.toMatch(/\sprobe[\s>]/);
  }
});

it('a text without a translation stays English', () => {
  const page = '<html lang="en"><head></head><p>One <i>n</i>, two.</p><h2>Two</h2></html>';
  const html = translated(page, 'pt', { 'One {1}, two.': 'Dois, um {1}.' });
  expect(html).toContain('<p>Dois, um <i>n</i>.</p><h2>Two</h2>');
});
