// The page for frames: shows the scene of its address, with the playground's limits, and nothing
// else. The address may come from a stranger: nothing in it can run, and no file of another site is
// loaded.
import 'phong-viewer';
import { readFragment } from '../playground/address.js';
import { readScene, withoutHosts, type Scene } from '../playground/scene.js';
import { showScene } from '../playground/show.js';

const viewer = document.createElement('phong-viewer');
const message = document.querySelector('p')!;

const sheet = new CSSStyleSheet();
sheet.replaceSync(`
  html, body { height: 100%; margin: 0; }
  phong-viewer, phong-compare { display: block; width: 100%; height: 100%; }
  p { position: absolute; inset: auto 0 0; margin: 0; padding: 0.5em 1em; background: Canvas; font: 0.875rem/1.4 system-ui, sans-serif; }
  p:empty { display: none; }
`);
document.adoptedStyleSheets = [sheet];

let shown: Scene | null = null;

async function show(): Promise<void> {
  const addressed = await readFragment(location.hash);
  const scene =
    addressed === null || 'example' in addressed
      ? 'There is no scene in this address.'
      : 'fault' in addressed
        ? addressed.fault
        : readScene(addressed.text, document.baseURI);
  if (typeof scene === 'string') {
    message.textContent = scene;
    return;
  }
  message.textContent =
    scene.hosts.length === 0
      ? ''
      : `Files of other sites are not loaded here: ${scene.hosts.join(', ')}.`;
  const own = withoutHosts(scene, new Set(), document.baseURI);
  if (!viewer.isConnected) {
    document.body.prepend(viewer);
  }
  showScene(viewer, shown, own);
  viewer.resetCamera();
  shown = own;
  document.title = viewer.alt || 'A scene';
}

addEventListener('hashchange', () => void show());
await show();
