// A verdict in sentences, as much of it as the exercise's `hint` allows.
import type { Term } from '../../phong/light/light-state.js';
import { MISTAKES, NO_MISTAKE } from '../../phong/mistakes/mistakes.js';
import type { ViewerText } from '../../viewer/extra.js';
import type { Verdict } from './check.js';
import type { ExerciseValues } from './exercise-fields.js';
import type { Fault } from './guard.js';
import type { Region } from '../../phong/mistakes/judge.js';

type Say = (text: ViewerText, values?: Fault['values']) => string;

const TERM_NAMES = {
  ambient: 'Ambient term',
  diffuse: 'Diffuse term',
  specular: 'Specular term',
} as const satisfies Record<Term, ViewerText>;

const REGION_TEXTS = {
  away: 'Only on the side away from the light.',
  outside: 'Only outside the cone.',
  highlight: 'Only in the highlight.',
  near: 'Only closer to the light than 1.',
  lit: 'Only on the side toward the light.',
} as const satisfies Record<Region, ViewerText>;

const UNDEFINED_POWER =
  'But it takes a power of a negative number, which GLSL leaves undefined: another GPU may draw something else.';

export function sentencesFor(
  verdict: Verdict,
  hint: Exclude<ExerciseValues['hint'], 'none'>,
  say: Say,
): string[] {
  const { right, share, pixels, undefinedPixels, mistakes, terms, difference, pixel, scene } =
    verdict;
  const count = { right: Math.round(share * pixels), count: pixels };
  if (hint === 'verdict') return [say(right ? NO_MISTAKE : 'Not right yet.')];
  if (right) {
    return [
      say(
        share === 1
          ? 'Right: within one 8-bit step at all {count} pixels, and at the test scenes.'
          : 'Right: within one 8-bit step at {right} of {count} pixels, and at the test scenes.',
        count,
      ),
      ...(terms.length > 0 ? [say(UNDEFINED_POWER)] : []),
    ];
  }
  const list = (texts: readonly ViewerText[]) => texts.map((text) => say(text)).join(', ');
  const sentences = [
    scene === null
      ? say('Not right yet: {right} of {count} pixels are within one 8-bit step.', count)
      : say('Right in this picture, but not under other lights.'),
  ];
  const named = hint === 'what' ? mistakes : [];
  sentences.push(...named.map((id) => say(MISTAKES[id].sentence)));
  if (terms.length > 0) {
    const names = list(terms.map((term) => TERM_NAMES[term]));
    sentences.push(say('It differs in: {terms}.', { terms: names }));
  }
  if (named.length === 0) {
    const { kinds, regions } = difference;
    sentences.push(say('Under these lights: {lights}.', { lights: list(kinds) }));
    if (undefinedPixels > 0) {
      sentences.push(
        say(
          'At {count} pixels the result is not a number: a power of a negative number, a root of one, or a division by 0.',
          { count: undefinedPixels },
        ),
      );
    }
    sentences.push(...regions.map((region) => say(REGION_TEXTS[region])));
  }
  if (pixel !== null) {
    sentences.push(
      say('Pixel {x}, {y}: yours {found}, exact {exact}; 255 is full.', {
        ...pixel,
        found: pixel.found.join(' '),
        exact: pixel.exact.join(' '),
      }),
    );
  }
  return sentences;
}
