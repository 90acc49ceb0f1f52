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

const contents = document.querySelector<HTMLButtonElement>('.topics button');
contents?.addEventListener('click', () => {
  const open = contents.getAttribute('aria-expanded') === 'true';
  contents.setAttribute('aria-expanded', String(!open));
});
contents?.nextElementSibling?.addEventListener('click', () => {
  contents.setAttribute('aria-expanded', 'false');
});
