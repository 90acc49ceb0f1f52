// The keys of texts, and the ready sets, from the table that the build makes them of.

import { textsIn } from '../../.ci/texts.mjs';
import type { ViewerText } from '../../src/element/fields/text-list.js';
import type { CompleteTexts } from '../../src/element/fields/texts.js';
import type { ViewerErrorCode } from '../../src/element/fields/text-list.js';

export const readyTexts = (language: string): CompleteTexts => textsIn(language) as CompleteTexts;

const KEYS = Object.keys(readyTexts('de')) as (ViewerText | ViewerErrorCode)[];
const first = KEYS.indexOf('load-failed');

export const VIEWER_TEXTS = KEYS.slice(0, first) as ViewerText[];
export const ERROR_TEXTS = KEYS.slice(first) as ViewerErrorCode[];
