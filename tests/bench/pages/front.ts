// The fronts of time against error, for the bench to drive.
import { type Front, openFront } from '../front/front.js';

declare global {
  interface Window {
    openFront: (name: string, size: readonly [number, number]) => Front['facts'];
    front: Front;
  }
}

window.openFront = (name, size) => {
  window.front = openFront(document.getElementById('holder')!, name, size);
  return window.front.facts;
};
