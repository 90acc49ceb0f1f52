// The keys of texts, and the ready sets, from the table that the build makes them of.

import { textsIn } from '../../.ci/texts.mjs';
import type {
  CompleteTexts,
  ViewerErrorCode,
  ViewerText,
} from '../../src/viewer/element/fields/texts.js';

export const readyTexts = (language: string): CompleteTexts => textsIn(language) as CompleteTexts;

const KEYS = Object.keys(readyTexts('de')) as (ViewerText | ViewerErrorCode)[];
const first = KEYS.indexOf('load-failed');

export const VIEWER_TEXTS = KEYS.slice(0, first) as ViewerText[];
export const ERROR_TEXTS = KEYS.slice(first) as ViewerErrorCode[];
