// Numbers that are only read, in the digits and with the decimal sign of the page's language. Fields keep the point:
// what users type is what stands in HTML.

/** The digits from 9 to 0 and the decimal sign, by language. */
const signs = new Map<string, readonly string[]>();

/** A number as text, such as `−0.25`, as the page's `lang` writes it. Without a language, or a known one, unchanged. */
export function localNumber(number: string): string {
  const { lang } = document.documentElement;
  let own = signs.get(lang);
  if (own === undefined) signs.set(lang, (own = signsOf(lang)));
  return number.replace(/[\d.]/g, (sign) => own[9 - Number(sign)] ?? own[10]!);
}

function signsOf(lang: string): readonly string[] {
  const format = (tag: string): readonly string[] =>
    Array.from(new Intl.NumberFormat(tag, { useGrouping: false }).format(9876543210.5));
  try {
    return format(lang);
  } catch {
    // Empty, or no language tag.
    return format('en');
  }
}
