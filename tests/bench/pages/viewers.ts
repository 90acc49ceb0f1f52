// Turning viewers that fill the page, in so many columns and rows: viewers.html?columns=5&rows=4.
// They draw at the browser's own frame rate.
import { sphereViewer } from './sphere-viewer.js';

declare global {
  interface Window {
    /** Resolves once all viewers are drawn. */
    viewersReady: Promise<unknown>;
    /** Pictures a second of the slowest viewer, over so many milliseconds. */
    frameRate: (ms: number) => Promise<number>;
  }
}

const query = new URLSearchParams(location.search);
const [columns, rows] = [Number(query.get('columns')), Number(query.get('rows'))];
document.body.style.gridTemplate = `repeat(${String(rows)}, 1fr) / repeat(${String(columns)}, 1fr)`;

const viewers = Array.from({ length: columns * rows }, () => {
  const viewer = sphereViewer();
  viewer.autoRotate = 30;
  viewer.pixelRatio = devicePixelRatio; // all pixels, also where drawing is slow
  return viewer;
});
document.body.append(...viewers);

window.viewersReady = Promise.all(viewers.map((viewer) => viewer.ready));
window.frameRate = async (ms) => {
  const counts = viewers.map(() => 0);
  const listening = new AbortController();
  viewers.forEach((viewer, i) =>
    viewer.addEventListener('render', () => (counts[i]! += 1), { signal: listening.signal }),
  );
  const start = performance.now();
  await new Promise((resolve) => setTimeout(resolve, ms));
  const seconds = (performance.now() - start) / 1000;
  listening.abort();
  return Math.min(...counts) / seconds;
};
