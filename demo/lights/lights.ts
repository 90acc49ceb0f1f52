// The lights page. Its buttons call spiral.ts, which the page also shows as text.
import '../page.js';
import { listing } from '../parts/listings.js';
import { connectBoard } from './board.js';
import source from './spiral.ts?raw';

const viewer = document.querySelector('phong-viewer');
if (viewer !== null) {
  connectBoard(viewer);
}

const place = document.getElementById('script');
if (place !== null) {
  // Only this page needs the `export`s.
  const text = source.trim().replaceAll(/^export /gm, '');
  listing(place, place.dataset['title'] ?? '').textContent = text;
}
