// The index for the search over all pages: each section, and each name of the reference, is one
// entry. HTML in, text out; built with the site, and read by demo/parts/search.ts.

import MiniSearch from 'minisearch';
import { SEARCH_OPTIONS, type SearchEntry } from '../../demo/parts/search-options.js';

export interface SearchedPage {
  readonly path: string;
  /** The whole page. */
  readonly html: string;
}

export function searchIndex(pages: readonly SearchedPage[]): string {
  const index = new MiniSearch<SearchEntry>(SEARCH_OPTIONS);
  const entries = new Map(pages.flatMap(entriesOf).map((entry) => [entry.address, entry]));
  index.addAll([...entries.values()]);
  return JSON.stringify(index);
}

/** What begins an entry: a heading, or a name in the first cell of a row. */
const START = /<(?:h([1-3])|(?:code|section))\b[^>]*\bid="([^"]+)"[^>]*>|<h1[^>]*>/g;

export function entriesOf({ path, html }: SearchedPage): SearchEntry[] {
  const main = (/<main\b[^>]*>([^]*)<\/main\s*>/.exec(html)?.[1] ?? '').replaceAll(
    /<(script|math|svg|phong-viewer|phong-compare)\b[^]*?<\/\1\s*>|<!--[^]*?-->/g,
    ' ',
  );
  const page = textOf(/<h1[^>]*>([^]*?)<\/h1\s*>/.exec(main)?.[1] ?? '');
  const starts = [...main.matchAll(START)];
  return starts.flatMap((start, i) => {
    const id = start[2];
    const part = main.slice(start.index, starts[i + 1]?.index);
    const [whole, name = ''] = /^<(?:h\d|code|section)\b[^>]*>([^]*?)<\/(?:h\d|code|h2)\s*>/.exec(part) ?? []; // oxfmt-ignore
    const title = textOf(name);
    if (whole === undefined || title === '') return [];
    const address = path + (id === undefined || start[1] === '1' ? '' : `#${id}`);
    // Of a name in a table, its element too: several have a `position`.
    const element = /^<code/.test(part) ? `${/^phong-[a-z]+/.exec(id ?? '')?.[0] ?? ''}, ` : '';
    const of = title === page ? '' : element + page;
    return [{ address, title, page: of, text: textOf(part.slice(whole.length)) }];
  });
}

const textOf = (html: string): string =>
  html
    .replaceAll(/<\/(?:p|li|td|th|tr|h\d|div)\s*>/g, ' ')
    .replaceAll(/<[^>]*>/g, '')
    .replaceAll(/&(lt|gt|quot|amp);/g, (_, name: keyof typeof ENTITIES) => ENTITIES[name])
    .replaceAll(/\s+/g, ' ')
    .trim();

const ENTITIES = { lt: '<', gt: '>', quot: '"', amp: '&' } as const;
