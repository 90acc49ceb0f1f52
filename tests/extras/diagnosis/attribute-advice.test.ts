// Which advice do authors get for attributes that do not exist, and which names are no mistake?

import { describe, expect, it } from 'vitest';
import { attributeAdvice } from '../../../src/extras/diagnosis/diagnose.js';
import { attributesOf } from '../../../src/viewer/element/fields/field-binding.js';
import { COMPARE_FIELDS } from '../../../src/viewer/element/fields/compare-fields.js';
import { VIEWER_FIELDS } from '../../../src/viewer/element/fields/viewer-fields.js';
import { LIGHT_FIELDS } from '../../../src/phong/light/light-state.js';
import { MESH_FIELDS } from '../../../src/viewer/scene/mesh/mesh-fields.js';

const known = new Map([
  ['phong-light', attributesOf(LIGHT_FIELDS)],
  ['phong-mesh', attributesOf(MESH_FIELDS)],
  ['phong-viewer', attributesOf(VIEWER_FIELDS)],
  ['phong-compare', attributesOf(COMPARE_FIELDS)],
]);
const real = new Set([...known.values()].flat());
const global = (
  'accesskey autocapitalize autocorrect autofocus class contenteditable dir draggable enterkeyhint exportparts hidden id ' +
  'inert inputmode is itemid itemprop itemref itemscope itemtype lang nonce part popover role slot spellcheck style ' +
  'tabindex title translate virtualkeyboardpolicy writingsuggestions'
).split(' ');

/** All words one edit away: a letter removed, replaced or added, or two letters swapped. */
function misspelled(word: string): string[] {
  const words: string[] = [];
  for (let i = 0; i <= word.length; i++) {
    const [before, after] = [word.slice(0, i), word.slice(i)];
    words.push(before + after.slice(1), `${before}z${after.slice(1)}`, `${before}z${after}`);
    words.push(before + after.slice(1, 2) + after.slice(0, 1) + after.slice(2));
  }
  return words.filter((other) => other !== '' && other !== word);
}

describe.each([...known.keys()])('<%s>', (tag) => {
  it('has advice for every attribute that is misspelled once', () => {
    const own = known.get(tag) ?? [];
    const silent = own
      .flatMap(misspelled)
      .filter((word) => !own.includes(word) && !global.includes(word))
      .filter((word) => attributeAdvice(tag, word, known) === undefined);
    // `name` is no mistake on a viewer.
    expect(silent.filter((word) => word !== 'name')).toEqual([]);
  });

  it('has no advice for attributes of HTML and for words unlike any attribute', () => {
    const unlike = ['datetime', 'xyz', 'q', 'constructor', 'tostring', 'x'.repeat(1e5)];
    for (const word of [...global, ...unlike]) {
      expect(attributeAdvice(tag, word, known), word).toBeUndefined();
    }
  });

  it('has advice for usual guesses', () => {
    const guesses = {
      'phong-light': 'color colour intensity pos rotate distance',
      'phong-mesh': 'color colour pos width height rotate',
      'phong-viewer': 'color colour intensity pos width height rotate distance',
      'phong-compare': 'width position value vertical label mode',
    }[tag];
    for (const word of guesses?.split(' ') ?? []) {
      expect(attributeAdvice(tag, word, known), word).toMatch(/^(Write|CSS) .*\.$/);
    }
  });
});

it('advice for an attribute of another element names that element; `name` needs none', () => {
  expect(attributeAdvice('phong-mesh', 'cutoff', known)).toBe('It belongs to <phong-light>.');
  expect(attributeAdvice('phong-light', 'ka', known)).toBe(
    'It belongs to <phong-mesh> and <phong-viewer>.',
  );
  expect(attributeAdvice('phong-viewer', 'name', known)).toBeUndefined();
  expect([...real].filter((word) => global.includes(word))).toEqual([]);
});
