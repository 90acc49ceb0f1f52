// Which advice do authors get for attributes that do not exist, and which names are no mistake?

import { describe, expect, it } from 'vitest';
import { attributeAdvice } from '../../../src/extras/diagnosis/diagnose.js';
import { attributesOf } from '../../../src/viewer/element/fields/field-binding.js';
import { COMPARE_FIELDS } from '../../../src/viewer/element/fields/compare-fields.js';
import { VIEWER_FIELDS } from '../../../src/viewer/element/fields/viewer-fields.js';
import { LIGHT_FIELDS } from '../../../src/phong/light/light-state.js';
import { MESH_FIELDS } from '../../../src/phong/model/mesh-fields.js';

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
function misspelled(word: string) {
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
    unlike.push('client-load', 'phx-click', 'astro-cid-mbfjk2xy', 'foo-bar', '-', 'x-data');
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

it('attributes of other viewers and of OpenGL are answered with ours, however they are hyphenated', () => {
  const ours: readonly (readonly [tag: string, names: string, advice: RegExp])[] = [
    ['phong-viewer', 'camera-orbit cameraorbit min-camera-orbit', /theta="…" and phi="…".* radius/],
    ['phong-viewer', 'field-of-view fieldofview max-field-of-view', /fov="…"/],
    ['phong-viewer', 'camera-controls interaction-prompt', /gui/],
    ['phong-viewer', 'camera-target', /target="x y z"/],
    ['phong-viewer', 'disable-zoom disable-pan', /orbit="false" or zoom="false"/],
    ['phong-viewer', 'exposure light-intensity', /<phong-light>/],
    ['phong-viewer', 'environment-image skybox-image', /<phong-light>/],
    ['phong-viewer', 'shadow-intensity shadow-softness', /no shadows/],
    ['phong-viewer', 'rotation-per-second auto-rotate-delay', /auto-rotate="…"/],
    ['phong-viewer', 'ar ar-modes ios-src', /no augmented reality/],
    ['phong-viewer', 'tone-mapping', /nothing maps tones/],
    ['phong-viewer', 'background-color clear-color', /style="background/],
    ['phong-mesh', 'opacity', /a model brings its own opacity/],
    ['phong-mesh', 'base-color diffuse-color', /kd="…"/],
    ['phong-light', 'spot-exponent spotexponent', /cutoff="…"/],
    ['phong-light', 'spot-cutoff cut-off-angle', /aperture="…"/],
    ['phong-light', 'spot-direction', /axis="x y z"/],
    ['phong-light', 'constant-attenuation quadratic-attenuation', /attenuation="kc kl kq"/],
    ['phong-light', 'cast-shadow', /no shadows/],
  ];
  for (const [tag, names, advice] of ours) {
    for (const name of names.split(' ')) {
      expect(attributeAdvice(tag, name, known), name).toMatch(advice);
    }
  }
});

it('advice for an attribute of another element names that element; `name` needs none', () => {
  expect(attributeAdvice('phong-mesh', 'cutoff', known)).toBe('It belongs to <phong-light>.');
  expect(attributeAdvice('phong-light', 'ka', known)).toBe(
    'It belongs to <phong-mesh> and <phong-viewer>.',
  );
  expect(attributeAdvice('phong-viewer', 'name', known)).toBeUndefined();
  expect([...real].filter((word) => global.includes(word))).toEqual([]);
});
