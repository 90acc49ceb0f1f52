// PNG files dropped on a viewer and on the playground: a scene opens again, and one made to attack
// does nothing.
import type { Locator, Page } from '@playwright/test';
import { PNG } from 'pngjs';
import { linkTo } from '../../support/site-pages.js';
import { markupIn } from '../../../src/extras/png/index.js';
import { withMarkup } from '../../../src/extras/png/chunks.js';
import { allReady, expect, test } from '../../support/test.js';
import { htmlOf, settled } from '../../element/support/viewer.js';

const plain = new Uint8Array(PNG.sync.write(new PNG({ width: 2, height: 2 })));
const holding = (markup: string): Uint8Array => withMarkup(plain.slice(), markup);

async function drop(target: Locator, bytes: Uint8Array, name = 'scene.png') {
  const transfer = await target.evaluateHandle(
    (_element, [content, title]) => {
      const data = new DataTransfer();
      data.items.add(new File([Uint8Array.from(content)], title, { type: 'image/png' }));
      return data;
    },
    [[...bytes], name] as const,
  );
  for (const type of ['dragover', 'drop']) {
    await target.dispatchEvent(type, { dataTransfer: transfer });
  }
}

const BEFORE = `<phong-viewer droppable gui="lights" geometry="box" kd="200 0 0" theta="10" phi="60" radius="4" target="0 0 0">
  <phong-light name="old" position="1 2 3 0"></phong-light>
</phong-viewer>`;
const SCENE = `<phong-viewer alt="A ring" geometry="torus" theta="50" phi="40" radius="3" target="0 0 0" shading="flat">
  <div><phong-light name="new" position="3 2 1 0" diffuse="tomato"></phong-light></div>
  <phong-mesh geometry="cone" position="1 0 0"></phong-mesh>
</phong-viewer>`;

test('a saved picture is the scene again, as one step of undo', async ({ page, mount }) => {
  const viewer = await mount(BEFORE);
  const before = await htmlOf(viewer);
  await drop(viewer, holding(SCENE));
  await expect.poll(() => htmlOf(viewer)).toContain('geometry="cone"');
  const after = await htmlOf(viewer);
  expect(after).toContain('<phong-viewer geometry="torus" alt="A ring" droppable');
  expect(after).toContain('theta="50" phi="40" radius="3"');
  expect(after).toContain('shading="flat" gui="lights"');
  expect(after).toMatch(/name="new"[^>]*diffuse="255 99 71"|diffuse="255 99 71"[^>]*name="new"/);
  expect(after).not.toMatch(/old|kd=/);
  await viewer.focus();
  await page.keyboard.press('ControlOrMeta+z');
  await expect.poll(() => htmlOf(viewer)).toBe(before);
  await page.keyboard.press('ControlOrMeta+y');
  await expect.poll(() => htmlOf(viewer)).toBe(after);
  // What toBlob writes opens again.
  const blob = await viewer.evaluate(async (element) => [
    ...new Uint8Array(await (await element.toBlob({ markup: true })).arrayBuffer()),
  ]);
  expect(await markupIn(Uint8Array.from(blob))).toBe(after);
  const bare = await viewer.evaluate(async (element) => (await element.toBlob()).size);
  expect(blob.length).toBeGreaterThan(bare);
});

test('a picture without a scene, of too many elements or of a missing file is a sentence in the page’s language', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/);
  const viewer = await mount(BEFORE);
  const before = await htmlOf(viewer);
  await drop(viewer, plain);
  const notice = viewer.locator('[part=notice]');
  await expect(notice).toHaveText(
    'The picture holds no scene: only PNG files that a viewer saved do. (scene.png)',
  );
  await viewer.evaluate((element) => {
    element.texts = { 'no-scene': 'Keine Szene. ({message})' };
  });
  await expect(notice).toHaveText(/^Keine Szene\. \(The picture/);
  await page.keyboard.press('Escape');
  await expect(notice).toBeHidden();
  expect(await htmlOf(viewer)).toBe(before);
  for (const [markup, words] of [
    ['<p>No viewer</p>', 'Keine Szene'],
    [`<phong-viewer>${'<b>'.repeat(1000)}</phong-viewer>`, 'too large to open'],
    ['<phong-viewer src="models/nowhere.glb"></phong-viewer>', 'nowhere.glb'],
  ] as const) {
    await drop(viewer, holding(markup));
    await expect(notice).toContainText(words);
  }
});

const HOSTILE = {
  scripts:
    '<script>window.hit = 1</script><phong-viewer><script>window.hit = 1</script></phong-viewer>',
  handlers:
    '<phong-viewer onload="window.hit=1" onclick="window.hit=1"><phong-mesh onerror="window.hit=1" src="none.glb"></phong-mesh></phong-viewer>',
  frames:
    '<phong-viewer><iframe srcdoc="<script>parent.hit=1</script>"></iframe><iframe src="javascript:parent.hit=1"></iframe></phong-viewer>',
  images:
    '<img src=x onerror="window.hit=1"><phong-viewer><svg onload="window.hit=1"></svg></phong-viewer>',
  'addresses of other sites':
    '<phong-viewer src="https://evil.example/a.glb" poster="https://evil.example/b.png"><phong-mesh src="//evil.example/c.glb"></phong-mesh></phong-viewer>',
  'addresses that run':
    '<phong-viewer src="javascript:window.hit=1"><phong-mesh src="data:model/gltf+json,{}"></phong-mesh><phong-mesh src="blob:http://localhost/1"></phong-mesh></phong-viewer>',
  'templates and styles':
    '<style>* { display: none }</style><phong-viewer class="x" style="position: fixed" id="y"><template><phong-mesh></phong-mesh></template></phong-viewer>',
};

test('a scene made to attack runs nothing and fetches nothing from elsewhere', async ({
  page,
  mount,
  consoleGuard,
}) => {
  // Chromium reports what the policy would refuse in markup that it only parses.
  consoleGuard.allow(/inline|404/);
  consoleGuard.allow(/is left out/);
  const foreign: string[] = [];
  page.on('request', (request) => {
    if (!request.url().startsWith('http://localhost') && !/^(data|blob):/.test(request.url())) {
      foreign.push(request.url());
    }
  });
  const viewer = await mount(BEFORE);
  for (const [what, markup] of Object.entries(HOSTILE)) {
    await viewer.evaluate((element, html) => (element.outerHTML = html), BEFORE);
    await settled(viewer);
    await drop(viewer, holding(markup));
    await expect.poll(() => htmlOf(viewer), what).not.toContain('kd=');
    await page.waitForTimeout(100);
    const state = await viewer.evaluate((element) => ({
      hit: (window as { hit?: number }).hit,
      inner: [...element.querySelectorAll('*')].map(({ localName }) => localName),
      own: element.getAttributeNames().filter((name) => /^(on|class|id|style)/.test(name)),
    }));
    expect(state.hit, what).toBeUndefined();
    expect(
      state.inner.filter((name) => !/^phong-(light|mesh)$/.test(name)),
      what,
    ).toEqual([]);
    expect(state.own, what).toEqual([]);
    expect(foreign, what).toEqual([]);
  }
});

const text = async (page: Page) => (await page.locator('.cm-line').allTextContents()).join('\n');

test('the playground takes the scene of a dropped picture as its text, and takes it back', async ({
  page,
}) => {
  await page.goto(`/demo/${linkTo(BEFORE)}`);
  await allReady(page);
  await expect(page.locator('.cm-content')).toBeVisible();
  const before = await text(page);
  await drop(page.locator('.picture'), holding(SCENE));
  await expect.poll(() => text(page)).toContain('tomato');
  expect(await htmlOf(page.locator('phong-viewer'))).toContain('geometry="cone"');
  await page.locator('.cm-content').click();
  await page.keyboard.press('ControlOrMeta+z');
  await expect.poll(() => text(page)).toBe(before);
  await drop(page.locator('.picture'), plain);
  await expect(page.locator('#messages')).toHaveText(/holds no scene/);
});
