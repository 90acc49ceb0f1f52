// The axes of time against error, for the driver to open and sample.
import { Runner } from '../stands/runner.js';

declare global {
  interface Window {
    fronts: Runner;
  }
}

window.fronts = new Runner(document.getElementById('holder')!);
