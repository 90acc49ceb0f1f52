// The keys of texts, and the ready sets, from the table that the build makes them of.

import { readFileSync } from 'node:fs';
import { textsIn } from '../../.ci/texts.mjs';
import type {
  CompleteTexts,
  ViewerErrorCode,
  ViewerText,
} from '../../src/viewer/element/fields/texts.js';

export const readyTexts = (language: string): CompleteTexts => textsIn(language) as CompleteTexts;

const own = JSON.parse(
  readFileSync(new URL('../../src/viewer/element/fields/texts.json', import.meta.url), 'utf8'),
) as Readonly<Record<string, object>>;

export const ERROR_TEXTS = Object.keys(
  own['Messages of errors, by the code of `error`'] ?? {},
) as ViewerErrorCode[];

export const VIEWER_TEXTS = (
  Object.keys(readyTexts('de')) as (ViewerText | ViewerErrorCode)[]
).filter((key): key is ViewerText => !(ERROR_TEXTS as string[]).includes(key));
