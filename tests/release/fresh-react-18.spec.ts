// Do the React components work with the oldest supported React? Types, a page rendered on a server, and its hydration.
// Installs from the registry, so it is slow: @release.

import type { PhongLight, PhongViewer } from '../../src/index.js';
import { allReady, expect, pixelAt, pixels, test } from '../support/test.js';
import { expectHeard, freshProject, strictOptions } from './fresh-project.js';

const app = `
import { createElement as h, useRef, useState } from 'react';
import { PhongLight, PhongViewer } from 'phong-viewer/react';

export function App() {
  const viewer = useRef(null);
  const [moved, setMoved] = useState('nothing');
  const [ambient, setAmbient] = useState([200, 100, 50]);
  return h('main', null,
    h(PhongViewer, {
      ref: viewer, className: 'picture', geometry: 'sphere', ka: 255, orbit: false,
      onCameraChange: ({ detail }) => setMoved(detail.source + ' to ' + viewer.current.theta),
    },
      h(PhongLight, { active: false, ambient: [0, 0, 255] }),
      h(PhongLight, { ambient, diffuse: 0, specular: 0 })),
    h('button', { onClick: () => setAmbient([1, 2, 3]) }, 'darken'),
    h('output', null, moved));
}
`;

const server = `
import { createElement } from 'react';
import { renderToString } from 'react-dom/server';
import { App } from './app.js';
process.stdout.write(renderToString(createElement(App)));
`;

const client = `
import { createElement } from 'react';
import { hydrateRoot } from 'react-dom/client';
import { App } from './app.js';
hydrateRoot(document.getElementById('root'), createElement(App));
`;

const types = `
import { createRef } from 'react';
import { PhongLight, PhongViewer, type PhongViewerElement } from 'phong-viewer/react';

export const known = (
  <PhongViewer ref={createRef<PhongViewerElement>()} className="wide" onCameraChange={({ detail }) => detail.source}>
    <PhongLight diffuse={[1, 2, 3]} active={false} />
  </PhongViewer>
);
// @ts-expect-error an angle is not a boolean
export const unknown = <PhongViewer theta={true} />;
`;

test('the React components work with React 18, in types, on a server and hydrated @release', async ({ page }) => {
  test.setTimeout(400_000);
  const react = ['react@18.0.0', 'react-dom@18.0.0', '@types/react@^18', '@types/react-dom@^18'];
  const project = freshProject(['three', '@types/three', 'typescript', 'vite', ...react]);
  const compilerOptions = { ...strictOptions, jsx: 'react-jsx' };
  project.write('tsconfig.json', JSON.stringify({ compilerOptions, files: ['types.tsx'] }));
  project.write('app.js', app);
  project.write('server.js', server);
  project.write('client.js', client);
  project.write('types.tsx', types);
  project.run('npx tsc -p .');

  const markup = project.run('node server.js');
  expect(markup).toContain('<phong-light active="false" ambient="0 0 255">');
  expect(markup).toContain(' class="picture" geometry="sphere" ka="255" orbit="false"');

  const body = `<div id="root">${markup}</div><script type="module" src="./client.js"></script>`;
  await project.open(page, project.build(body));
  const viewer = page.locator('phong-viewer.picture');
  await expectHeard(page, viewer);
  await allReady(page);
  expect(pixelAt(await pixels(viewer, { width: 60, height: 40 }), 30, 20)).toEqual([200, 100, 50, 255]);
  await page.getByText('darken').click();
  const second = () => viewer.evaluate(({ lights: [, light] }: PhongViewer) => (light as PhongLight).ambient);
  await expect.poll(second).toEqual([1, 2, 3]);
  await project.remove();
});
