// Pages in other languages: the English page's HTML with other words. The words are in files beside
// the page, such as demo/lesson/de.json, by the English text. Scenes and formulas are the page's
// own, so that each is written once. In a text {1}, {2} stand for the elements inside it.

/** English texts, and what stands in place of each. */
export type Words = Readonly<Record<string, string>>;

/** Elements whose content is a text. Of these only controls are inside another. */
const TEXT = /(<(title|h1|h2|p|figcaption|summary|phong-control)\b[^>]*>)([^]*?)(<\/\2\s*>)/g;
const INSIDE = /<(math|phong-control|phong-probe|a|i|sub|sup|code)\b[^>]*>[^]*?<\/\1\s*>/g;
/** Texts that are values: descriptions, and the names of lights. */
const VALUE =
  /(<(?:meta\b[^>]*\scontent|phong-viewer\b[^>]*\salt|phong-light\b[^>]*\sname)=")([^"]*)"/g;

const plain = (text: string): string => text.replaceAll(/\s+/g, ' ').trim();

/** `replace` gets each text of a page; what it returns takes its place. */
function replaceTexts(html: string, replace: (text: string) => string): string {
  const inText = (part: string): string =>
    part.replaceAll(TEXT, (_, start: string, __, inner: string, end: string) => {
      const elements: string[] = [];
      const text = plain(
        inner.replaceAll(INSIDE, (element) => `{${String(elements.push(inText(element)))}}`),
      );
      const words = /\p{L}/u.test(text) ? replace(text) : text;
      return `${start}${words.replaceAll(/\{(\d)\}/g, (_all, i: string) => elements[Number(i) - 1] ?? '')}${end}`;
    });
  return inText(html).replaceAll(
    VALUE,
    (_, before: string, value: string) => `${before}${replace(value)}"`,
  );
}

/** The texts of a page, in its order: the keys of its words in another language. */
export function textsOf(html: string): string[] {
  const found = new Set<string>();
  replaceTexts(html, (text) => {
    found.add(text);
    return text;
  });
  return [...found];
}

/**
 * The page in another language, one folder deeper. A text without a translation stays English.
 * @param language as in `lang`; the viewers' own texts are in it too
 */
export const translated = (html: string, language: string, words: Words): string =>
  replaceTexts(html, (text) => words[text] ?? text)
    .replace('<html lang="en">', `<html lang="${language}">`)
    .replace('</head>', `<!-- texts ${language} --></head>`)
    .replaceAll(/\s(src|href)="\.\.\//g, ' $1="../../');

/** The languages of a page. */
export interface Languages {
  /** The English page, relative to the site's root. */
  readonly original: string;
  readonly all: readonly string[];
  readonly own: string;
}

/** The way from a page to the site's root. */
export const rootFrom = (path: string): string => '../'.repeat(path.split('/').length - 1) || './';

/** The menu of a page's languages. */
export function languagesHtml({ original, all, own }: Languages, path: string): string {
  const items = all.map((language) => {
    const current = language === own ? ' aria-current="page"' : '';
    const href = rootFrom(path) + addressIn(original, language);
    return `<li><a href="${href}" lang="${language}" hreflang="${language}"${current}>${nameOf(language)}</a></li>`;
  });
  return `<nav class="languages" aria-label="Languages" lang="en"><ul>${items.join('')}</ul></nav>`;
}

/**
 * For search engines; '' for a page in one language. To Vite the address would be a file.
 * @param site the way to the site's root
 */
export const alternatesHtml = ({ original, all }: Languages, site: string): string =>
  all.length < 2
    ? ''
    : all
        .map(
          (language) =>
            `<link rel="alternate" vite-ignore hreflang="${language}" href="${site}${addressIn(original, language)}" />\n    `,
        )
        .join('');

const addressIn = (page: string, language: string): string =>
  language === 'en' ? page : `${page}${language}/`;

/** A language's name in itself, as a title. */
function nameOf(language: string): string {
  const name = new Intl.DisplayNames([language], { type: 'language' }).of(language) ?? language;
  return name.charAt(0).toLocaleUpperCase(language) + name.slice(1);
}
