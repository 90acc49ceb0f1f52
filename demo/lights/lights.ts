// The lights page: what its buttons do is in spiral.ts, which the page shows as it is.
import '../page.js';
import { listing } from '../parts/listings.js';
import { connectBoard } from './board.js';
import source from './spiral.ts?raw';

const viewer = document.querySelector('phong-viewer');
if (viewer !== null) connectBoard(viewer);

const place = document.getElementById('script');
if (place !== null) {
  // `export` is for this page's own sake.
  const text = source.trim().replaceAll(/^export /gm, '');
  listing(place, place.dataset['title'] ?? '').textContent = text;
}
