// Numbers that are only read, in the digits and with the decimal sign of the words around them. Fields keep the point:
// what users type is what stands in HTML.
import { phrase, type ViewerTexts } from '../fields/texts.js';

/** Node has no document. */
const page = globalThis as { readonly document?: { readonly documentElement?: { readonly lang: string } } };

/** The digits from 9 to 0 and the decimal sign, by language. */
const signs = new Map<string, readonly string[]>();

/**
 * A number as text, such as `−0.25`, in the language of the texts. Texts that do not name theirs are in the page's.
 * Without a language, or a known one, unchanged.
 */
export function localNumber(number: string, texts: ViewerTexts | null): string {
  const isUnnamed = texts !== null && texts.en === undefined;
  const lang = isUnnamed ? (page.document?.documentElement?.lang ?? '') : phrase(texts, 'en');
  let own = signs.get(lang);
  if (own === undefined) signs.set(lang, (own = signsOf(lang)));
  return number.replace(/[\d.]/g, (sign) => own[9 - Number(sign)] ?? own[10]!);
}

function signsOf(lang: string): readonly string[] {
  try {
    // A page's first formatter takes 10 to 20 ms.
    if (lang !== '' && lang !== 'en')
      return Array.from(new Intl.NumberFormat(lang, { useGrouping: false }).format(9876543210.5));
  } catch {
    // No language tag.
  }
  return Array.from('9876543210.5');
}
