// Does the packed tarball work in a fresh Astro project? The elements in Astro's own markup, and the React components
// without and with hydration. Installs from the registry, so it is slow: @release.

import { join } from 'node:path';
import type { PhongLight, PhongViewer } from '../../src/index.js';
import { expect, pixelAt, pixels, test } from '../support/test.js';
import { expectHeard, useFreshProject } from './fresh-project.js';

const config = `
import react from '@astrojs/react';
import { defineConfig } from 'astro/config';
export default defineConfig({ integrations: [react()] });
`;

const page = `
---
import { PhongLight, PhongViewer } from 'phong-viewer/react';
import Watched from '../watched.jsx';
const color = [200, 100, 50];
---
<html lang="en">
  <head><meta charset="utf-8" /><title>Fresh</title><link rel="icon" href="data:," /></head>
  <body>
    <phong-viewer id="markup" geometry="sphere" ka={255} orbit={false} gui={false}>
      <phong-light ambient={[0, 0, 255]} active={false} />
      <phong-light ambient={color} diffuse={0} specular={0} />
    </phong-viewer>
    <PhongViewer id="still" geometry="sphere" ka={255} orbit={false} gui={false}>
      <PhongLight ambient={[0, 0, 255]} active={false} />
      <PhongLight ambient={color} diffuse={0} specular={0} />
    </PhongViewer>
    <Watched client:load />
    <script>import 'phong-viewer';</script>
  </body>
</html>
`;

const watched = `
import { useState } from 'react';
import { PhongLight, PhongViewer } from 'phong-viewer/react';

export default function Watched() {
  const [moved, setMoved] = useState('nothing');
  return (
    <>
      <PhongViewer
        id="hydrated" geometry="sphere" ka={255} orbit={false}
        onCameraChange={({ detail, target }) => setMoved(detail.source + ' to ' + target.theta)}
      >
        <PhongLight ambient={[0, 0, 255]} active={false} />
        <PhongLight ambient={[200, 100, 50]} diffuse={0} specular={0} />
      </PhongViewer>
      <output>{moved}</output>
    </>
  );
}
`;

test.describe('the packed tarball in a fresh Astro project @release', () => {
  // Astro 6 and later need Node 22.
  const astro = ['astro@^5', '@astrojs/react@^4', 'react', 'react-dom'];
  const project = useFreshProject(['three', ...astro], ({ write, run }) => {
    write('astro.config.mjs', config);
    write('src/pages/index.astro', page.trimStart());
    write('src/watched.jsx', watched);
    run('npx astro build');
  });

  test('shows arrays and false as they were written, and dispatches events on hydrated markup', async ({ page }) => {
    // Astro's own islands start from inline scripts.
    await project().open(page, join(project().folder, 'dist'), '');
    for (const id of ['markup', 'still', 'hydrated']) {
      const viewer = page.locator(`#${id}`);
      const found = await viewer.evaluate(({ orbit, gui, lights }: PhongViewer) => [
        ...[orbit, gui],
        ...lights.map(({ active, ambient }: PhongLight) => [active, ambient]),
      ]);
      expect(found, id).toEqual([false, false, [false, [0, 0, 255]], [true, [200, 100, 50]]]);
      const picture = await pixels(viewer, { width: 60, height: 40 });
      expect(pixelAt(picture, 30, 20), id).toEqual([200, 100, 50, 255]);
    }
    await expectHeard(page, page.locator('#hydrated'));
  });
});
