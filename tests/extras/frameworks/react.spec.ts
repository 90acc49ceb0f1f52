// Do the components of `phong-viewer/react` render the same on the server and in the browser? dist/
// renders a page in Node, and React's development build hydrates it in the browser and reports
// differences on the console.

import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Page } from '@playwright/test';
import type { PhongLight, PhongMesh, PhongViewer } from '../../../src/viewer/index.js';
import { outputFolder } from '../../../.ci/output-folder.mjs';
import { assign } from '../../element/support/viewer.js';
import type { ConsoleGuard } from '../../support/console-guard.js';
import type { Site } from '../../support/site.js';
import { allReady, expect, pixelAt, pixels, test } from '../../support/test.js';
import { bundleOf, renderedByServer } from '../../package/bundle.js';

const components = join(outputFolder('dist'), 'react.js');

/** A component `App`. Its buttons say what they do. */
const app = (file: string) => `
  import { createElement as h, useEffect, useRef, useState } from 'react';
  import { PhongLight, PhongMesh, PhongViewer } from ${JSON.stringify(file)};

  function App() {
    const viewer = useRef(null);
    const [light, setLight] = useState({ active: false, ambient: [200, 100, 50] });
    const [props, setProps] = useState({ theta: 20, autoRotate: 0, terms: ['ambient'], orbit: false, gui: false, texts: { Loading: 'Lädt' } });
    const [moved, setMoved] = useState('nothing');
    const [said, setSaid] = useState('nothing');
    useEffect(() => { document.body.dataset.shown = ''; }, []);
    const button = (text, onClick) => h('button', { onClick }, text);
    return h('main', null,
      button('light up', () => setLight({ active: true, ambient: new Uint8Array([0, 100, 200]) })),
      button('spoil', () => setLight({ active: true, ambient: 'no colour' })),
      button('turn', () => setProps({ theta: 90, terms: [], orbit: true })),
      button('ask the ref', () => setSaid(viewer.current.localName + ' at ' + viewer.current.theta)),
      h('output', null, moved),
      h('samp', null, said),
      h(PhongViewer, {
        ref: viewer, id: 'scene', className: 'picture', 'data-kind': 'test',
        style: { display: 'block', width: 300, height: 200 },
        alt: 'A "quoted" sphere', geometry: 'sphere', phi: 90, target: [0, 0, 0], radius: 2, ka: 255, ...props,
        onCameraChange: ({ detail }) => setMoved(moved + ', ' + detail.source),
        onPointerDown: () => setSaid('pressed'),
      },
        h(PhongLight, { position: [0, 0, 1, 0], space: 'camera', specular: 0, name: undefined, ...light }),
        h('div', null, h(PhongMesh, { geometry: 'box', position: [5, 0, 0], shininess: 1e-7, scale: 0.5 }))));
  }
`;

const fromServer = () => renderedByServer(app(pathToFileURL(components).href));

// One worker for all, so that the script is bundled once.
test.describe.configure({ mode: 'default' });

let script: Promise<string> | undefined;

/** Hydrates what is in the root, or renders into an empty one. */
const renderedByClient = () =>
  (script ??= bundleOf(
    `${app(components)}
    import { createRoot, hydrateRoot } from 'react-dom/client';
    const root = document.getElementById('root');
    if (root.hasChildNodes()) hydrateRoot(root, h(App));
    else createRoot(root).render(h(App));`,
    { whole: true, define: { 'process.env.NODE_ENV': '"development"' } },
  ));

async function show(page: Page, site: Site, consoleGuard: ConsoleGuard, markup: string) {
  consoleGuard.allow(/^info: .*React DevTools/);
  const body = await renderedByClient();
  await page.route('**/app.js', (route) => route.fulfill({ contentType: 'text/javascript', body }));
  const head = '<script type="module" src="/app.js"></script>';
  await page.goto(site.page(`<div id="root">${markup}</div>`, { csp: '', head }));
  await expect(page.locator('body')).toHaveAttribute('data-shown', '');
  await allReady(page);
}

const values = (page: Page) =>
  page.locator('phong-viewer').evaluate((viewer: PhongViewer) => {
    const { theta, phi, terms, orbit, gui, alt, texts, lights, meshes } = viewer;
    const { active, ambient, name } = lights[0] as PhongLight;
    const { scale, shininess } = meshes[0] as PhongMesh;
    return {
      theta,
      phi,
      terms,
      orbit,
      gui,
      alt,
      texts,
      light: { active, ambient, name },
      mesh: { scale, shininess },
    };
  });

test('arrays, false, numbers and text are attributes of the markup that a server sends', () => {
  const markup = fromServer();
  for (const attribute of [
    'active="false"',
    'ambient="200 100 50"',
    'specular="0"',
    'shininess="1e-7"',
    'terms="ambient"',
    'auto-rotate="0"',
    'orbit="false"',
    'gui="false"',
    'alt="A &quot;quoted&quot; sphere"',
    'target="0 0 0"',
    'class="picture"',
    'data-kind="test"',
    'style="display:block;width:300px;height:200px"',
  ]) {
    expect(markup).toContain(` ${attribute}`);
  }
  expect(markup).not.toMatch(/ name=| texts=|undefined|on[A-Z]/);
});

for (const way of ['hydrated', 'rendered by the client alone']) {
  test(`a page that is ${way} has the values of its props, hears events, and draws changes`, async ({
    page,
    site,
    consoleGuard,
  }) => {
    await show(page, site, consoleGuard, way === 'hydrated' ? fromServer() : '');
    expect(await values(page)).toEqual({
      theta: 20,
      phi: 90,
      terms: ['ambient'],
      orbit: false,
      gui: false,
      alt: 'A "quoted" sphere',
      texts: { Loading: 'Lädt' },
      light: { active: false, ambient: [200, 100, 50], name: 'light 1' },
      mesh: { scale: [0.5, 0.5, 0.5], shininess: 1e-7 },
    });
    const viewer = page.locator('phong-viewer#scene.picture[data-kind=test]');
    const middle = async () => pixelAt(await pixels(viewer, { width: 30, height: 20 }), 15, 10);
    expect(await middle()).toEqual([0, 0, 0, 255]);

    // The element's events come once each, React's too, and the ref is set.
    const turn = (theta: number) => assign(viewer, { theta });
    await turn(30);
    await expect(page.locator('output')).toHaveText('nothing, script');
    // The handler of the first render would say the same again.
    await turn(40);
    await expect(page.locator('output')).toHaveText('nothing, script, script');
    await page.getByText('ask the ref').click();
    await expect(page.locator('samp')).toHaveText('phong-viewer at 40');
    await viewer.click();
    await expect(page.locator('samp')).toHaveText('pressed');

    // Changed props are drawn, props that have gone restore defaults, refused ones are named.
    await page.getByText('light up').click();
    await allReady(page);
    expect(await middle()).toEqual([0, 100, 200, 255]);
    await page.getByText('turn').click();
    expect(await values(page)).toMatchObject({
      theta: 90,
      phi: 90,
      terms: [],
      orbit: true,
      gui: false,
      texts: null,
    });
    await expect(viewer).toHaveAttribute('theta', '90');
    await expect(viewer).toHaveAttribute('terms', '');
    await expect(viewer).not.toHaveAttribute('auto-rotate');
    await expect(viewer).not.toHaveAttribute('gui');
    await expect(page.locator('phong-light')).toHaveAttribute('active', 'true');
    consoleGuard.allow(/^warning: <phong-light> ambient="no colour": expected .* using 0 0 0/, 1);
    await page.getByText('spoil').click();
    await expect(page.locator('phong-light')).toHaveAttribute('ambient', 'no colour');
    expect(await values(page)).toMatchObject({ light: { active: true, ambient: [0, 0, 0] } });
  });
}
