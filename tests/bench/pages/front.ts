// The fronts of time against error, for the bench to drive.
import { type Front, FRONTS, openFront } from '../front/front.js';

declare global {
  interface Window {
    frontNames: readonly string[];
    openFront: (name: string, size: readonly [number, number]) => Front['facts'];
    front: Front;
  }
}

window.frontNames = FRONTS;
window.openFront = (name, size) => {
  window.front = openFront(document.getElementById('holder')!, name, size);
  return window.front.facts;
};
