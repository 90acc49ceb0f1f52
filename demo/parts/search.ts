// The search field in each page's head. Its index is fetched with the first focus. Results are
// links in a list below the field; Enter follows the first one, Escape closes the list.
import type MiniSearch from 'minisearch';
import type { SearchEntry } from './search-options.js';

const MOST = 8;

export function connectSearch(field: HTMLInputElement, list: HTMLElement, root: string): void {
  let index: Promise<MiniSearch<SearchEntry> | null> | undefined;
  const show = async (): Promise<void> => {
    const words = field.value.trim();
    const found =
      words === ''
        ? []
        : ((await (index ??= load(root)))?.search(words, { filter: isReadHere }) ?? null);
    // Typed on, while the index came.
    if (words !== field.value.trim()) return;
    list.replaceChildren(
      ...(found ?? []).slice(0, MOST).map(({ id, title, page }) => {
        const item = document.createElement('li');
        const link = document.createElement('a');
        link.href = root + String(id);
        link.textContent = String(title);
        item.append(link);
        if (page !== '') {
          item.append(` ${String(page)}`);
        }
        return item;
      }),
    );
    if (words !== '' && list.childElementCount === 0) {
      const item = document.createElement('li');
      item.textContent = found === null ? 'The index cannot be fetched.' : 'Nothing found.';
      list.append(item);
    }
    list.hidden = words === '';
  };
  const close = (): void => {
    list.hidden = true;
  };
  field.addEventListener('focus', () => void (index ??= load(root)));
  field.addEventListener('input', () => void show());
  field.addEventListener('keydown', ({ key }) => {
    if (key === 'Enter') {
      list.querySelector('a')?.click();
    }
  });
  const box = field.parentElement!;
  box.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') {
      field.focus();
      close();
    }
  });
  box.addEventListener('focusout', ({ relatedTarget }) => {
    if (!(relatedTarget instanceof Node && box.contains(relatedTarget))) {
      close();
    }
  });
  list.addEventListener('click', close);
}

/** Not the lesson in a language that is neither this page's nor English. */
function isReadHere({ id }: { readonly id: unknown }): boolean {
  const language = /^lesson\/(\w+)\//.exec(String(id))?.[1];
  return language === undefined || language === document.documentElement.lang;
}

/** Null where it cannot be fetched; the next page tries again. */
async function load(root: string): Promise<MiniSearch<SearchEntry> | null> {
  try {
    const [{ default: Search }, { SEARCH_OPTIONS }, response] = await Promise.all([
      import('minisearch'),
      import('./search-options.js'),
      fetch(`${root}search.json`),
    ]);
    return Search.loadJSON<SearchEntry>(await response.text(), SEARCH_OPTIONS);
  } catch {
    return null;
  }
}
