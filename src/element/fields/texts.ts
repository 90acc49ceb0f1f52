// How does a page replace the words that a viewer itself shows or announces? English by default; text-list.ts has all texts. Knows no
// place where a text is shown.
import type { ViewerErrorCode } from '../viewer/loading.js';
import type { ViewerText } from './text-list.js';

/**
 * Texts in place of the element's own, by the English text: `{ 'Try again': 'Nochmal' }`. Words in braces stand for values. A text for
 * a code of `error`, such as `load-failed`, replaces the English message, which is its `{message}`; `{url}` is the address.
 */
export type ViewerTexts = { readonly [text in ViewerText | ViewerErrorCode]?: string | undefined };

/** A text, in the page's words if it has its own, with values in place of the words in braces. */
export const phrase = (
  texts: ViewerTexts | null,
  text: keyof ViewerTexts,
  values: Readonly<Record<string, string>> = {},
): string =>
  // By a function: in a replacement text `$&` would have a meaning, and names may contain it.
  (texts?.[text] ?? text).replace(/\{(\w+)\}/g, (_, key: string) => values[key] ?? '');

/** A frozen copy; null for no texts. Throws TypeError for anything but an object of strings. */
export function checkedTexts(value: unknown): ViewerTexts | null {
  if (value === null || value === undefined) return null;
  const texts = Object.entries(value);
  const isText = (text: unknown): boolean => typeof text === 'string' || text === undefined;
  if (typeof value !== 'object' || Array.isArray(value) || !texts.every(([, text]) => isText(text)))
    throw new TypeError('<phong-viewer>.texts: expected an object of texts by English text');
  return Object.freeze(Object.fromEntries(texts) as ViewerTexts);
}

/** Texts assigned before the upgrade are an own property, which hides the accessor. Wrong ones are warned of and dropped. */
export function upgradeTexts(element: { texts: ViewerTexts | null }): void {
  if (!Object.hasOwn(element, 'texts')) return;
  const { texts } = element;
  Reflect.deleteProperty(element, 'texts');
  try {
    element.texts = texts;
  } catch (error) {
    console.warn((error as Error).message);
  }
}
