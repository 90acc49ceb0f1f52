// Are models of every format shown as written, from addresses, files and drops, under a strict
// policy? Do unknown formats, missing files and several models at once give an error with the cure?

import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { wasmPolicy } from '../../support/site.js';
import { type ViewerLocator, expect, pixelAt, pixels, same, test } from '../../support/test.js';
import {
  assign,
  type PhongMesh,
  type PhongViewer,
  record,
  set,
  settled,
} from '../../element/support/viewer.js';
import { requestsOf } from '../../support/requests.js';

const size = { width: 400, height: 200 };
const folder = fileURLToPath(new URL('../../fixtures/models', import.meta.url));
const model = (name: string) => `/fixtures/models/${name}`;
/** The eye sees 2.31 × 4.62 units of the plane z = 0; one light of full strength along the view. */
const straight = 'theta="0" phi="90" radius="2" target="0 0 0" fov="60"';
const light =
  '<phong-light position="0 0 1 0" ambient="255 255 255" diffuse="255 255 255"></phong-light>';
const viewerOf = (attributes: string, inner = '') =>
  `<phong-viewer ${straight} ${attributes}>${light}${inner}</phong-viewer>`;

/** The colour at a point of the plane z = 0. */
async function colorAt(viewer: ViewerLocator, x: number, y: number): Promise<readonly number[]> {
  const perUnit = 100 / (2 * Math.tan(Math.PI / 6));
  return [
    ...pixelAt(await pixels(viewer), Math.floor(200 + x * perUnit), Math.floor(100 - y * perUnit)),
  ].slice(0, 3);
}

function expectNear(color: readonly number[], wanted: readonly number[], tolerance = 1): void {
  const far = color.filter((code, i) => !(Math.abs(code - (wanted[i] ?? NaN)) <= tolerance));
  expect(far, `${color.join(' ')} is not ${wanted.join(' ')}`).toEqual([]);
}

/** The contents of fixtures as files, in the page. */
async function filesIn(page: Page, names: readonly string[], as: readonly string[] = names) {
  await page.evaluate(
    async ([paths, given]) => {
      const files = paths.map(async (path, i) => {
        const bytes = await (await fetch(`/fixtures/models/${path}`)).arrayBuffer();
        return new File([bytes], given[i] ?? path);
      });
      Reflect.set(window, 'files', await Promise.all(files));
    },
    [names, as] as const,
  );
}

/** Sets `src` to the first of those files, or to a Blob of the same bytes. */
const setFile = (element: ViewerLocator, blob = false) =>
  element.evaluate((target: PhongViewer | PhongMesh, asBlob) => {
    const [file] = Reflect.get(window, 'files') as [File];
    target.src = asBlob ? new Blob([file]) : file;
  }, blob);

/** Drops the page's files on the viewer. Returns whether the event was used. */
const dropFiles = (viewer: ViewerLocator) =>
  viewer.evaluate((element) => {
    const dataTransfer = new DataTransfer();
    for (const file of Reflect.get(window, 'files') as File[]) {
      dataTransfer.items.add(file);
    }
    const over = new DragEvent('dragover', { dataTransfer, bubbles: true, cancelable: true });
    const drop = new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true });
    return { taken: !element.dispatchEvent(over) && !element.dispatchEvent(drop) };
  });

/** Drops files and folders of this disk, as a user does. */
async function dropPaths(page: Page, paths: readonly string[]) {
  const session = await page.context().newCDPSession(page);
  const data = { items: [], files: [...paths], dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
    await session.send('Input.dispatchDragEvent', { type, x: 200, y: 100, data });
  }
}

interface Outcome {
  readonly type: string;
  readonly detail: {
    readonly code?: string;
    readonly message?: string;
    readonly url?: string;
    readonly missing?: readonly string[];
  };
}

/** The load or error event that `act` causes. */
async function outcomeOf(viewer: ViewerLocator, act: () => Promise<unknown>) {
  const events = await record(viewer, 'load', 'error');
  await act();
  const heard: Outcome[] = [];
  const more = async () => heard.push(...((await events.take()) as Outcome[]));
  await expect.poll(more).toBe(1);
  await settled(viewer);
  return heard[0]!;
}

const drop = (viewer: ViewerLocator) => outcomeOf(viewer, () => dropFiles(viewer));

test('an OBJ file shows the coefficients of its MTL file, and its texture the right way up', async ({
  mount,
}) => {
  const viewer = await mount(viewerOf(`src="${model('quads.obj')}" terms="ambient"`), size);
  expectNear(await colorAt(viewer, -0.5, 0), [25.5, 51, 76.5]);
  expectNear(await colorAt(viewer, 0.25, 0.25), [255, 0, 0], 8);
  expectNear(await colorAt(viewer, 0.75, 0.25), [0, 255, 0], 8);
  expectNear(await colorAt(viewer, 0.25, -0.25), [0, 0, 255], 8);
  expectNear(await colorAt(viewer, 0.75, -0.25), [188, 64, 20], 8);
  await set(viewer, { terms: 'diffuse' });
  expectNear(await colorAt(viewer, -0.5, 0), [204, 102, 51]);
  await set(viewer, { terms: 'diffuse', kd: '255 0 0' });
  expectNear(await colorAt(viewer, -0.5, 0), [255, 0, 0]);
});

test('`type` names the format if nothing else does', async ({ mount, consoleGuard }) => {
  consoleGuard.allow(
    /The format is not supported: the data: URI\. Export it as one that is: glTF/,
    1,
  );
  const text = 'unknown words\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3';
  const src = `data:text/plain,${encodeURIComponent(text)}`;
  const viewer = await mount(viewerOf(`src="${src}"`), size);
  await expect(viewer.locator('[part=notice]')).toHaveText(
    'The format is not supported: the data: URI.',
  );
  expect((await outcomeOf(viewer, () => assign(viewer, { type: 'model/obj' }))).type).toBe('load');
  await expect(viewer.locator('[part=notice]')).toHaveCount(0);
});

test('`src` can be a File or a Blob, which toHTML says must be hosted', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/warning: <phong-viewer src="my quad.glb"> is a file on this device/, 1);
  const viewer = await mount(viewerOf('terms="diffuse"', '<phong-mesh></phong-mesh>'), size);
  await filesIn(page, ['textured.glb'], ['my quad.glb']);
  const outcome = await outcomeOf(viewer, () => setFile(viewer));
  expect(outcome).toEqual({ type: 'load', detail: { url: 'file:///my%20quad.glb', missing: [] } });
  const shown = await pixels(viewer);
  const facts = await viewer.evaluate((element) => {
    const [file] = Reflect.get(window, 'files') as File[];
    const html = element.toHTML();
    return [
      element.src === file,
      Object.isFrozen(file),
      element.loaded,
      html === element.toHTML(),
      html,
    ];
  });
  expect(facts).toEqual([true, false, true, true, expect.stringContaining('src="my%20quad.glb"')]);
  await assign(viewer, { src: '' });
  const mesh = viewer.locator('phong-mesh');
  expect((await outcomeOf(viewer, () => setFile(mesh, true))).type).toBe('load');
  same(await pixels(viewer), shown);
});

test('a model compressed by meshopt without WebAssembly is an error with the cure for authors, and for visitors', async ({
  page,
  mount,
  consoleGuard,
}) => {
  const source = `src="${model('meshopt.glb')}"`;
  const shown = await mount(viewerOf(source), { ...size, csp: wasmPolicy });
  const picture = await pixels(shown);
  await set(shown, { src: model('no-normals.glb') });
  same(await pixels(shown), picture);
  consoleGuard.allow(/Content Security Policy|violates the following|CSP report|wasm/i);
  const refused = await mount(viewerOf(`droppable ${source}`), size);
  const notice = refused.locator('[part=notice]');
  await expect(notice).toContainText('compressed by meshopt');
  await expect(notice).not.toContainText('script-src');
  await filesIn(page, ['meshopt.glb']);
  expect((await drop(refused)).detail.message).toContain("Add 'wasm-unsafe-eval' to script-src");
  await expect(notice).toContainText('Save it without that compression (meshopt.glb).');
  await expect(notice).not.toContainText('script-src');
});

test.describe('a droppable viewer', () => {
  test('shows a folder dropped on it as one model, and files dropped together too', async ({
    page,
    mount,
  }) => {
    const wanted = await pixels(await mount(viewerOf(`src="${model('beside/quad.gltf')}"`), size));
    const viewer = await mount(viewerOf('droppable'), size);
    expect((await outcomeOf(viewer, () => dropPaths(page, [`${folder}/beside`]))).type).toBe(
      'load',
    );
    same(await pixels(viewer), wanted);
    // All files in one place, although the names inside contain folders.
    await filesIn(
      page,
      ['beside/quad.bin', 'beside/quad.gltf', 'beside/textures/four colours.png'],
      ['QUAD.BIN', 'quad.gltf', 'four colours.png'],
    );
    const outcome = await drop(viewer);
    expect(outcome).toMatchObject({ type: 'load', detail: { url: 'file:///quad.gltf' } });
    same(await pixels(viewer), wanted);
  });

  test('lists missing files', async ({ page, mount, consoleGuard }) => {
    consoleGuard.allow(
      /quads\.obj is shown without 1 of .*: beside\/textures\/four colours\.png\. Drop them together/,
      1,
    );
    const viewer = await mount(viewerOf('droppable'), size);
    await filesIn(page, ['quads.obj', 'quads.mtl']);
    expect(await drop(viewer)).toEqual({
      type: 'load',
      detail: { url: 'file:///quads.obj', missing: ['beside/textures/four colours.png'] },
    });
  });

  test('names a broken file in a message until its button, Escape or the next file', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(viewerOf(`droppable src="${model('textured.glb')}"`), size);
    const before = await pixels(viewer);
    const [notice, close, retry] = ['notice', 'dismiss', 'retry'].map((part) =>
      viewer.locator(`[part=${part}]`),
    );
    const fail = async () => {
      await filesIn(page, ['truncated.glb']);
      const { detail } = await drop(viewer);
      expect(detail.code).toBe('bad-model');
      expect(detail.message).toMatch(
        /^The model cannot be read: it is truncated.* \(truncated\.glb\)\.$/,
      );
      await expect(notice!).toContainText('truncated.glb');
      same(await pixels(viewer), before);
      await expect(retry!).toHaveCount(0);
    };
    await fail();
    await expect(close!).toHaveAccessibleName('Close');
    await assign(viewer, { texts: { Close: 'Schließen' } });
    await expect(close!).toHaveAccessibleName('Schließen');
    const box = await close!.boundingBox();
    expect(Math.min(box!.width, box!.height)).toBeGreaterThanOrEqual(24);
    await close!.click();
    await expect(notice!).toHaveCount(0);
    expect(await viewer.evaluate((element) => element.matches(':state(error)'))).toBe(false);

    await fail();
    // The drop has moved the focus into the viewer. An Escape that it used does not reach a
    // listener around it.
    await viewer.evaluate((element) => {
      const keys: boolean[] = [];
      Reflect.set(window, 'keys', keys);
      element.parentElement?.addEventListener('keydown', (event) =>
        keys.push(event.defaultPrevented),
      );
    });
    await page.keyboard.press('Escape');
    await expect(notice!).toHaveCount(0);
    await page.keyboard.press('Escape');
    expect(await page.evaluate(() => Reflect.get(window, 'keys') as unknown)).toEqual([false]);

    await fail();
    await filesIn(page, ['textured.glb']);
    expect((await drop(viewer)).type).toBe('load');
    await expect(notice!).toHaveCount(0);

    // An address can be tried again, and its message stays.
    await assign(viewer, { src: model('truncated.glb') });
    await expect(retry!).toBeVisible();
    await expect(close!).toHaveCount(0);
    await viewer.focus();
    await page.keyboard.press('Escape');
    await expect(notice!).toBeVisible();
  });

  test('is the author’s again when the message about a broken file is closed, and a drop can be undone', async ({
    page,
    mount,
  }) => {
    const address = model('textured.glb');
    const viewer = await mount(
      viewerOf(`droppable gui src="${address}"`, '<phong-mesh></phong-mesh>'),
      { width: 700, height: 300 },
    );
    const sourceOf = (element: ViewerLocator) =>
      element.evaluate(({ src }) => (typeof src === 'string' ? src : 'a file'));
    const loads = requestsOf(page);
    const close = viewer.locator('[part=dismiss]');
    const undo = viewer.locator('button', { hasText: /^undo$/ });
    await expect(undo).toHaveAttribute('aria-disabled', 'true');
    const before = await pixels(viewer);

    // Two in a row: the second does not make the first the one to go back to.
    for (const name of ['a.glb', 'b.glb']) {
      await filesIn(page, ['truncated.glb'], [name]);
      expect((await drop(viewer)).detail.code).toBe('bad-model');
    }
    expect(await sourceOf(viewer)).toBe('a file');
    await expect(undo).toHaveAttribute('aria-disabled', 'false');
    await close.click();
    await expect.poll(() => sourceOf(viewer)).toBe(address);
    await settled(viewer);
    await expect(viewer).toHaveJSProperty('loaded', true);
    same(await pixels(viewer), before);
    expect(loads.filter((url) => url.endsWith(address))).toEqual([]); // it was shown all the time

    // A file that can be shown: undo shows the author's again, redo the file.
    await filesIn(page, ['no-normals.glb'], ['mine.glb']);
    expect((await drop(viewer)).type).toBe('load');
    const mine = await pixels(viewer);
    await page.keyboard.press('Control+Z');
    await expect.poll(() => sourceOf(viewer)).toBe(address);
    await settled(viewer);
    same(await pixels(viewer), before);
    await page.keyboard.press('Control+Shift+Z');
    await expect.poll(() => sourceOf(viewer)).toBe('a file');
    await settled(viewer);
    same(await pixels(viewer), mine);

    // The same for a mesh, which has nothing to go back to.
    const mesh = viewer.locator('phong-mesh');
    await filesIn(page, ['truncated.glb'], ['c.glb']);
    await setFile(mesh, true);
    await close.click();
    await expect.poll(() => sourceOf(mesh)).toBe('');
    await expect(viewer.locator('[part=notice]')).toHaveCount(0);
  });

  test('leaves drops to the page without the attribute, and where the page has taken them', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(viewerOf(''), size);
    await filesIn(page, ['textured.glb']);
    expect(await dropFiles(viewer)).toEqual({ taken: false });
    await assign(viewer, { droppable: true });
    await page.evaluate(() =>
      document.addEventListener('drop', (event) => event.preventDefault(), { capture: true }),
    );
    await dropFiles(viewer);
    await settled(viewer);
    await expect(viewer).toHaveJSProperty('src', '');
  });
});
