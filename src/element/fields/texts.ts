// The page's own words in place of a viewer's texts. English by default; texts.json has all texts.
import type { ViewerErrorCode, ViewerText } from './text-list.js';

/**
 * Texts in place of the element's own, by the English text: `{ 'Try again': 'Nochmal' }`. Words in braces stand for
 * values. A text for a code of `error`, such as `load-failed`, replaces the English message, which is its `{message}`;
 * `{url}` is the address.
 */
export type ViewerTexts = { readonly [text in ViewerText | ViewerErrorCode]?: string | undefined };

/** Every text in one language, and a message for every error. */
export type CompleteTexts = Readonly<Record<ViewerText | ViewerErrorCode, string>>;

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

/**
 * A value assigned before the upgrade is an own property, which hides the accessor. Wrong ones are warned of and
 * dropped.
 */
export function upgradeProperty(element: object, key: 'texts' | 'maxTriangles'): void {
  if (!Object.hasOwn(element, key)) return;
  const value: unknown = Reflect.get(element, key);
  Reflect.deleteProperty(element, key);
  try {
    Reflect.set(element, key, value);
  } catch (error) {
    console.warn((error as Error).message);
  }
}
