// How long a page takes to connect many lights, one in each microtask.
import { runFrame } from './page-hooks.js';
import { drawUntilReady, lightElement } from './element-side.js';
import { mixedLights } from './scenes.js';

declare global {
  interface Window {
    /** Milliseconds by the clock until all lights are connected. */
    connectLights: (count: number) => Promise<number>;
  }
}

window.connectLights = async (count) => {
  const viewer = document.querySelector('phong-viewer')!;
  await drawUntilReady(viewer);
  const lights = mixedLights(count).map(lightElement);
  const start = performance.now();
  for (const light of lights) {
    viewer.append(light);
    await Promise.resolve();
  }
  const ms = performance.now() - start;
  runFrame();
  if (viewer.lights.length !== count) throw new Error(`the viewer has ${viewer.lights.length} of ${count} lights`);
  return ms;
};
