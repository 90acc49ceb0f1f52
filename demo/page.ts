// What every demo page loads: the elements, the listings of their markup, the search, and the
// contents list of narrow screens. Knows no particular page.
import 'phong-viewer';
import { showListings } from './parts/listings.js';
import { connectSearch } from './parts/search.js';

showListings(document);

const field = document.querySelector<HTMLInputElement>('#search');
const found = document.querySelector<HTMLElement>('#found');
const root = document.querySelector<HTMLAnchorElement>('.mark')?.href ?? '';
if (field !== null && found !== null) {
  connectSearch(field, found, root);
}

const contents = document.querySelector<HTMLElement>('.topics');
const button = contents?.querySelector('button');
const topics = contents?.querySelector<HTMLElement>('#topics');

function open(is: boolean): void {
  button?.setAttribute('aria-expanded', String(is));
  reachCurrent();
}

/** Scrolls the list, and nothing else, to the page that is shown. */
function reachCurrent(): void {
  const current = topics?.querySelector('[aria-current=page]');
  for (const list of [contents, topics]) {
    if (list && current && list.scrollHeight > list.clientHeight) {
      const { top, height } = list.getBoundingClientRect();
      list.scrollTop += current.getBoundingClientRect().top - top - height / 3;
    }
  }
}

button?.addEventListener('click', () => open(button.getAttribute('aria-expanded') !== 'true'));
topics?.addEventListener('click', () => open(false));
contents?.addEventListener('keydown', ({ key }) => {
  if (key === 'Escape' && button?.getAttribute('aria-expanded') === 'true') {
    open(false);
    button.focus();
  }
});
reachCurrent();
