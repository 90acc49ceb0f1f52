// Do markup, picture and address of the playground always agree? Served under the strict policy.

import type { Page } from '@playwright/test';
import { allReady, expect, test } from '../../support/test.js';
import { linkTo } from '../../support/site-pages.js';
import { drag, type PhongViewer, htmlOf } from '../support/viewer.js';

const SCENE = `<phong-viewer theta="10" phi="70" radius="4" target="0 0 0" gui>
  <phong-light name="sun" position="1 2 3 0"></phong-light>
  <phong-mesh geometry="sphere"></phong-mesh>
</phong-viewer>
`;

const editorOf = (page: Page) => page.getByRole('textbox', { name: 'Markup of the scene' });

const textOf = async (page: Page) =>
  (await editorOf(page).locator('.cm-line').allTextContents()).join('\n');

async function open(page: Page, scene = SCENE) {
  await page.goto('about:blank');
  await page.goto(`/demo/${linkTo(scene)}`);
  await allReady(page);
  await expect(page.locator('.cm-content')).toBeVisible();
  return page.locator('phong-viewer');
}

async function rewrite(page: Page, text: string) {
  await editorOf(page).click();
  await page.keyboard.press('ControlOrMeta+a');
  await page.keyboard.insertText(text);
}

/** What another page shows at this address. */
async function htmlAt(page: Page, address: string) {
  const other = await page.context().newPage();
  await other.goto(address);
  await allReady(other);
  const html = await htmlOf(other.locator('phong-viewer'));
  await other.close();
  return html;
}

test('a link shows its scene, typed markup is shown too, and a button copies its link', async ({
  page,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const first = SCENE.replace('geometry="sphere"', 'geometry="sphere" kd="9"');
  const viewer = await open(page, first);
  const kd = () => viewer.evaluate((v: PhongViewer) => v.meshes[0]!.kd);
  await expect(viewer.locator('phong-light')).toHaveAttribute('position', '1 2 3 0');
  expect(await textOf(page)).toBe(first);
  expect(page.url()).toContain(linkTo(first));
  expect(await kd()).toEqual([9, 9, 9]);
  const second = '  <phong-light name="two"></phong-light>\n  <phong-mesh';
  await rewrite(page, SCENE.replace('sphere', 'torus').replace('  <phong-mesh', second));
  await expect(viewer.locator('phong-light')).toHaveCount(2);
  await expect(viewer.locator('phong-mesh')).toHaveAttribute('geometry', 'torus');
  await expect.poll(kd).toEqual([200, 200, 200]);
  await page.getByRole('button', { name: 'Copy a link' }).click();
  await expect(page.locator('#shared')).toHaveText('Copied.');
  const link = await page.evaluate(() => navigator.clipboard.readText());
  await expect.poll(() => page.url()).toBe(link);
  expect(await htmlAt(page, link)).toContain('torus');
});

test('a drag is written into the markup, and undoing it there turns the picture back', async ({
  page,
}) => {
  const viewer = await open(page);
  const box = (await viewer.boundingBox())!;
  await drag(page, [box.x + 40, box.y + 200], [60, 0]);
  await expect.poll(() => textOf(page)).not.toContain('theta="10"');
  const theta = await viewer.evaluate((v: PhongViewer) => v.camera.theta);
  const written = /theta="([^"]*)"/.exec(await textOf(page))?.[1];
  expect(Number(written)).toBeCloseTo(theta, 2);
  await editorOf(page).click();
  await page.keyboard.press('ControlOrMeta+z');
  await expect.poll(() => textOf(page)).toContain('theta="10"');
  await expect.poll(() => viewer.evaluate((v: PhongViewer) => v.camera.theta)).toBeCloseTo(10, 9);
});

test('changes by the panel are written into the markup, and can be changed there', async ({
  page,
}) => {
  const viewer = await open(page);
  await viewer.getByRole('checkbox').first().click();
  await expect.poll(() => textOf(page)).toContain('active="false"');
  const html = await htmlOf(viewer);
  await expect.poll(() => page.url()).not.toContain(linkTo(SCENE));
  expect(await htmlAt(page, page.url())).toBe(html);
  await rewrite(page, SCENE);
  await expect.poll(() => viewer.evaluate((v: PhongViewer) => v.lights[0]!.active)).toBe(true);
  await viewer.getByRole('button', { name: 'add light' }).click();
  await expect.poll(async () => (await textOf(page)).match(/<phong-light/g)?.length).toBe(2);
  await rewrite(
    page,
    (await textOf(page)).replaceAll('<phong-light ', '<phong-light diffuse="7" '),
  );
  await expect(viewer.locator('phong-light[diffuse="7"]')).toHaveCount(2);
});

test('typing fetches each model once, and none by half of its name; missing ones are named', async ({
  page,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/, 3);
  const fetched: string[] = [];
  page.on('request', (request) => {
    fetched.push(...(/[\w-]*\.glb$/.exec(request.url()) ?? []));
  });
  const scene = SCENE.replace(
    'geometry="sphere"',
    'src="../assets/models/bunny.glb"></phong-mesh><phong-mesh src="none.glb"',
  );
  const viewer = await open(page, scene);
  await rewrite(page, scene.replace('1 2 3 0', '3 2 1 0').replace(/<\/phong-viewer>\s/, ''));
  await page.keyboard.type('<phong-mesh src=no.glb></phong-mesh>');
  await expect(viewer.locator('phong-light')).toHaveAttribute('position', '3 2 1 0');
  await expect(viewer.locator('[src="no.glb"]')).toHaveCount(1);
  await allReady(page);
  expect(fetched).toEqual(['bunny.glb', 'none.glb', 'no.glb']);
  await expect(page.locator('#messages')).toHaveText(
    /^Line 3: The server .* for none\.glb\.Line 4:/,
  );
  const faults = page.locator('.cm-fault .cm-attribute');
  await expect(faults).toHaveText(['src="none.glb"', 'src=no.glb']);
  await page.route('**/no.glb', (route) => route.fulfill({ path: 'demo/assets/models/bunny.glb' }));
  await page.getByRole('button', { name: 'Try again' }).click();
  await expect(faults).toHaveText(['src="none.glb"']);
});

test('a bad value is named with its line and marked, each time it is there', async ({
  page,
  consoleGuard,
}) => {
  consoleGuard.allow(/position="1\\t2"/, 1);
  const bad = SCENE.replace('1 2 3 0', '1\t&#50;');
  await open(page, bad);
  const messages = page.locator('#messages');
  for (let i = 0; i < 2; i++) {
    await expect(messages).toContainText('Line 2: <phong-light> position="1\\t2": expected');
    const fault = page.locator('.cm-fault .cm-attribute');
    await expect(fault).toHaveText('position="1 &#50;"');
    await expect(fault).toHaveCSS('text-decoration-line', 'underline');
    await rewrite(page, SCENE);
    await expect(messages).toBeEmpty();
    await expect(page.locator('.cm-fault')).toHaveCount(0);
    await rewrite(page, bad);
  }
});

test('a comparison is shown, a drag of its divider is written, and one viewer can be left', async ({
  page,
}) => {
  await page.goto('/demo/playground/#example=compare');
  await allReady(page);
  await expect(page.locator('.cm-content')).toBeVisible();
  await expect(page.locator('phong-compare > phong-viewer')).toHaveCount(2);
  await expect(page.locator('#messages')).toBeEmpty();
  await page.getByRole('separator').press('ArrowRight');
  await expect.poll(() => textOf(page)).toContain('at="51"');
  await rewrite(page, SCENE);
  await expect(page.locator('phong-compare')).toHaveCount(0);
  await expect(page.locator('phong-viewer')).toHaveCount(1);
});

test('the picture waits for complete markup; words are completed; lines break between attributes', async ({
  page,
}) => {
  const values = Array.from({ length: 12 }, (_, i) => `data${String(i)}="${'1 2 3 '.repeat(4)}"`);
  const viewer = await open(page, `<phong-viewer ${values.join(' ')}></phong-viewer>`);
  const heights = await page
    .locator('.cm-attribute')
    .evaluateAll((all) =>
      all.map((one) => one.getClientRects().length * one.getBoundingClientRect().height),
    );
  expect(heights.length).toBe(12);
  expect(Math.max(...heights)).toBeLessThan(30);
  await rewrite(page, '<phong-viewer geometry="box"><phong-light position="1 1 ');
  await expect(viewer).toHaveAttribute('geometry', 'box');
  await rewrite(page, '<phong-vie');
  await expect(page.locator('#messages')).toHaveText('Write a <phong-viewer> to see a picture.');
  await expect(viewer).toHaveAttribute('geometry', 'box');
  await rewrite(page, '<phong-viewer>\n');
  await page.keyboard.type('<phong-me');
  await page.getByRole('option', { name: 'phong-mesh' }).click();
  await page.keyboard.type(' ');
  await expect(page.getByRole('option', { name: 'kd' })).toBeVisible();
  await page.keyboard.type('geom');
  await page.getByRole('option', { name: 'geometry' }).click();
  await page.keyboard.type('tea');
  await page.getByRole('option', { name: 'teapot' }).click();
  expect(await textOf(page)).toContain('<phong-mesh geometry="teapot"');
});

test('examples are opened by the list and by their address', async ({ page }) => {
  await page.goto('/demo/playground/#example=lesson');
  await expect(page.locator('phong-viewer')).toHaveAttribute('view', 'n-dot-l');
  const choice = page.getByRole('combobox', { name: 'Example' });
  await expect(choice).toHaveValue('lesson');
  await choice.selectOption('spot');
  await expect(page.locator('phong-light[name=spot]')).toHaveCount(1);
  await expect(page.locator('phong-viewer')).not.toHaveAttribute('view');
  await page.goBack();
  await expect(page.locator('phong-viewer')).toHaveAttribute('view', 'n-dot-l');
});

test('a frame and one HTML file show the scene with its model, also from disk', async ({
  page,
  context,
}, info) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const scene = SCENE.replace(
    'geometry="sphere"',
    'src="../assets/models/bunny.glb" name="a &lt;b&gt;"',
  );
  await open(page, scene);
  await page.getByRole('button', { name: 'Copy a frame' }).click();
  await expect(page.locator('#shared')).toHaveText('Copied.');
  const frame = await page.evaluate(() => navigator.clipboard.readText());
  const saved = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save one HTML file' }).click();
  const file = info.outputPath('scene.html');
  await (await saved).saveAs(file);
  for (const address of [/src="([^"]+)"/.exec(frame)![1]!, `file://${file}`]) {
    const other = await context.newPage();
    await other.goto(address);
    await allReady(other);
    const viewer = other.locator('phong-viewer');
    const found = viewer.evaluate(({ loaded, lights, meshes, scene }: PhongViewer) => ({
      loaded,
      lights: lights.length,
      name: meshes[0]!.name,
      shown: scene.children.length,
    }));
    expect(await found).toEqual({ loaded: true, lights: 1, name: 'a <b>', shown: 1 });
    await other.close();
  }
});

test('the editor is there with the first picture, long before all samples of a still one', async ({
  page,
}) => {
  await page.goto(`/demo/${linkTo(SCENE.replace('gui', 'gui antialias="full" samples="1024"'))}`);
  await expect(page.locator('.cm-content')).toBeVisible();
  expect(
    await page.evaluate(() => document.querySelector('phong-viewer')!.stats.samples),
  ).toBeLessThan(1024);
});

test('below 1,100 pixels the panel is under the picture, above them beside it', async ({
  page,
}) => {
  const viewer = await open(page);
  await viewer.getByText('add light').waitFor();
  const gaps = (): Promise<{ readonly beside: number; readonly under: number }> =>
    viewer.evaluate((element) => {
      const boxOf = (name: string) =>
        element.shadowRoot!.querySelector(`[part~=${name}]`)!.getBoundingClientRect();
      const [picture, panel] = [boxOf('surface'), boxOf('panel')];
      return { beside: panel.left - picture.right, under: panel.top - picture.bottom };
    });
  for (const [width, place] of [
    [1100, 'beside'],
    [1099, 'under'],
    [680, 'under'],
  ] as const) {
    await page.setViewportSize({ width, height: 900 });
    await expect.poll(async () => (await gaps())[place], String(width)).toBeGreaterThan(-1);
  }
});
