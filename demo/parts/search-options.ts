// What the search index is made of: the same where it is built (.ci/site/search.ts) and where it is
// read.
import type { Options } from 'minisearch';

export interface SearchEntry {
  /** From the site's root, with an anchor. */
  readonly address: string;
  readonly title: string;
  /** The title of its page; empty for the page itself. */
  readonly page: string;
  readonly text: string;
}

export const SEARCH_OPTIONS: Options<SearchEntry> = {
  idField: 'address',
  fields: ['title', 'page', 'text'],
  storeFields: ['title', 'page'],
  searchOptions: {
    boost: { title: 4, page: 2 },
    // A name in a table comes before a section only where it is the word itself.
    boostDocument: (id) => (String(id).includes('#phong-') ? 0.4 : 1),
    prefix: true,
    fuzzy: (word) => (word.length > 4 ? 0.2 : false),
    combineWith: 'AND',
  },
};
