// The texts that a viewer shows or announces, the page's own words in place of them, and numbers in
// their language. Of their table only the keys' type is imported, so that the first file contains
// no texts.
import type { TextKey } from './text-key.js';

export type ViewerErrorCode =
  | 'load-failed'
  | 'bad-model'
  | 'too-large'
  | 'csp'
  | 'no-scene'
  | 'context-lost'
  | 'no-webgl2';

/** A text by its English form, the key of `texts`; words in braces stand for values. */
export type ViewerText = Exclude<TextKey, ViewerErrorCode>;

/**
 * Texts in place of the element's own, by the English text: `{ 'Try again': 'Nochmal' }`. Words in
 * braces stand for values. A text for a code of `error`, such as `load-failed`, replaces the
 * English message, which is its `{message}`; `{url}` is the address.
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
  const isText = (text: unknown) => typeof text === 'string' || text === undefined;
  if (
    typeof value !== 'object' ||
    Array.isArray(value) ||
    !texts.every(([, text]) => isText(text))
  ) {
    throw new TypeError('<phong-viewer>.texts: expected an object of texts by English text');
  }
  return Object.freeze(Object.fromEntries(texts) as ViewerTexts);
}

/**
 * A value assigned before the upgrade is an own property, which hides the accessor. A wrong value is
 * dropped with a warning, a value of a read-only property without one.
 */
export function upgradeProperty(element: object, key: string): void {
  if (!Object.hasOwn(element, key)) return;
  const value: unknown = Reflect.get(element, key);
  Reflect.deleteProperty(element, key);
  try {
    Reflect.set(element, key, value);
  } catch (error) {
    console.warn((error as Error).message);
  }
}

/** Node has no document. */
const page = globalThis as {
  readonly document?: { readonly documentElement?: { readonly lang: string } };
};

/** The digits from 9 to 0 and the decimal sign, by language. */
const signs = new Map<string, readonly string[]>();

/**
 * A number that is only read, as text such as `−0.25`, in the digits and with the decimal sign of
 * the texts' language. Texts that do not name theirs are in the page's. Unchanged without a
 * language or with an unknown one. Fields keep the point: what users type is what stands in HTML.
 */
export function localNumber(number: string, texts: ViewerTexts | null): string {
  const isUnnamed = texts !== null && texts.en === undefined;
  const lang = isUnnamed ? (page.document?.documentElement?.lang ?? '') : phrase(texts, 'en');
  let own = signs.get(lang);
  if (own === undefined) {
    signs.set(lang, (own = signsOf(lang)));
  }
  return number.replace(/[\d.]/g, (sign) => own[9 - Number(sign)] ?? own[10]!);
}

function signsOf(lang: string): readonly string[] {
  try {
    // A page's first formatter takes 10 to 20 ms.
    if (lang !== '' && lang !== 'en') {
      return Array.from(new Intl.NumberFormat(lang, { useGrouping: false }).format(9876543210.5));
    }
  } catch {
    // No language tag.
  }
  return Array.from('9876543210.5');
}
