// Reads the texts of a page from its scripts, with one warning for each bad one. Fetched by pages
// that have one.
import { clip } from '../../../phong/fields/clip.js';
import { nearest } from '../../../phong/fields/nearest.js';
import tables from '../fields/texts.json';
import { checkedTexts, type ViewerTexts } from '../fields/texts.js';

/** Most unknown keys that a warning names. */
const NAMED = 5;

const KEYS: readonly string[] = Object.values(tables).flatMap(Object.keys);

let sources: readonly string[] = [];
let texts: ViewerTexts | null = null;

/**
 * The texts of all scripts; the same object while they are as they were. A key in a later script
 * replaces that in an earlier one.
 */
export function readTexts(scripts: NodeListOf<HTMLScriptElement>): ViewerTexts | null {
  const found = Array.from(scripts, ({ text }) => text);
  const isNew = (text: string) => !sources.includes(text);
  if (found.length === sources.length && !found.some(isNew)) return texts;
  const all: ViewerTexts[] = [];
  for (const text of found) {
    const own = textsIn(text);
    const mistake = typeof own === 'string' ? own : unknownKeys(own);
    if (mistake !== null && isNew(text)) {
      console.warn(`<script data-phong-viewer-texts> ${mistake}`);
    }
    if (typeof own === 'object') {
      all.push(own);
    }
  }
  sources = found;
  return (texts = Object.freeze(Object.assign({}, ...all) as ViewerTexts));
}

function textsIn(script: string): ViewerTexts | string {
  try {
    return checkedTexts(JSON.parse(script)) ?? {};
  } catch (error) {
    return error instanceof SyntaxError
      ? `is not JSON, so it is not used: ${error.message}`
      : 'must be an object of texts by English text, so it is not used. Write {"Try again": "…"}.';
  }
}

function unknownKeys(texts: ViewerTexts): string | null {
  const unknown = Object.keys(texts).filter((key) => !KEYS.includes(key));
  if (unknown.length === 0) return null;
  const named = unknown.slice(0, NAMED).map((key) => {
    const meant = nearest(key, KEYS);
    return `"${clip(key)}"${meant === undefined ? '' : ` (did you mean "${meant}"?)`}`;
  });
  const more = unknown.length > NAMED ? `, and ${String(unknown.length - NAMED)} more` : '';
  return `has texts that no viewer shows: ${named.join(', ')}${more}. phong-viewer/texts/de has all keys.`;
}
