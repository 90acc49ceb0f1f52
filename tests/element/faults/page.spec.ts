// Does the element survive a lost graphics context, a browser without WebGL 2, and a second copy of the bundle?

import { compare, expect, pixelAt, pixels, test } from '../../support/test.js';
import { assign, nextFrame, type PhongViewer, record, settled } from '../support/viewer.js';

const size = { width: 90, height: 60 };
const light = '<phong-light position="1 2 3 0" ambient="60"></phong-light>';
const box = `<phong-viewer geometry="box" kd="200 40 40">${light}</phong-viewer>`;

test('a lost context is reported, and its restoration brings everything back', async ({ mount }) => {
  const viewer = await mount(box.replace('</phong-viewer>', '<phong-mesh src="/fixtures/models/textured.glb" position="1 0 0"></phong-mesh></phong-viewer>'), size); // prettier-ignore
  const before = await pixels(viewer);
  const onScreen = await viewer.screenshot();
  const events = await record(viewer, 'error');
  const extension = await viewer.evaluateHandle((element: PhongViewer) =>
    element.shadowRoot?.querySelector('canvas')?.getContext('webgl2')?.getExtension('WEBGL_lose_context'),
  );
  await extension.evaluate((gl) => gl?.loseContext());
  await expect.poll(() => events.take()).toMatchObject([{ type: 'error', detail: { code: 'context-lost' } }]);
  const notice = viewer.locator('[part=notice]');
  await expect(notice).toBeVisible();
  expect(await viewer.evaluate((element: PhongViewer) => element.ready.then(() => 'ready'))).toBe('ready');
  // No picture is better than an empty one.
  const taken = viewer.evaluate((element: PhongViewer) => element.toBlob().catch((e: unknown) => String(e)));
  expect(await taken).toContain('context is lost');
  // Changes made meanwhile are applied.
  await assign(viewer, { kd: '1 2 3' });
  await assign(viewer, { kd: '200 40 40' });
  await extension.evaluate((gl) => gl?.restoreContext());
  await expect(notice).toHaveCount(0);
  await settled(viewer);
  expect(compare(await pixels(viewer), before).max).toBe(0);
  await expect.poll(async () => Buffer.compare(await viewer.screenshot(), onScreen)).toBe(0);
});

test('without WebGL 2 there is an error, a message to read, and no promise left pending', async ({
  page,
  mount,
}) => {
  await page.addInitScript(() => {
    const real = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      kind: string,
      ...rest: unknown[]
    ) {
      return kind.startsWith('webgl') ? null : (Reflect.apply(real, this, [kind, ...rest]) as null);
    } as typeof real;
    addEventListener('error', (event) => {
      if (event.target instanceof HTMLElement) Object.assign(window, { failure: (event as unknown as CustomEvent<unknown>).detail }); // prettier-ignore
    }, true); // prettier-ignore
  });
  const viewer = await mount(box, size);
  expect(await page.evaluate('window.failure.code')).toBe('no-webgl2');
  await expect(viewer.locator('[part=notice]')).toContainText(/WebGL 2/);
  const facts = await viewer.evaluate(async (element: PhongViewer) => {
    element.theta = 77;
    element.append(document.createElement('phong-light'));
    await element.ready;
    const picture = await element.toBlob().then(
      () => 'a picture',
      (error: unknown) => (error instanceof Error ? 'an error' : 'something'),
    );
    return [element.camera.theta, element.lights.length, element.toHTML().includes('theta="77"'), picture];
  });
  expect(facts).toEqual([77, 2, true, 'an error']);
});

test('two copies of the bundle on a page do no harm', async ({ page, mount }) => {
  const viewer = await mount(box, { ...size, head: '<script type="module" src="/dist/phong-viewer.standalone.js?copy"></script>' }); // prettier-ignore
  await page.addScriptTag({ type: 'module', url: '/dist/phong-viewer.standalone.js?again' });
  await nextFrame(page);
  await viewer.evaluate((element: PhongViewer) => element.append(document.createElement('phong-light')));
  expect(await viewer.evaluate((element: PhongViewer) => element.lights.length)).toBe(2);
  expect(pixelAt(await pixels(viewer), 45, 30)[3]).toBe(255);
});

test('a removed viewer releases everything that it took, and works again when it returns', async ({
  page,
  mount,
}) => {
  const viewer = await mount(box, size);
  const before = await pixels(viewer);
  const facts = await viewer.evaluate(async (element: PhongViewer) => {
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    const gl = canvas.getContext('webgl2')!;
    element.remove();
    await new Promise((resolve) => setTimeout(resolve, 50));
    const given = gl.isContextLost();
    for (let i = 0; i < 20; i++) {
      document.body.append(element);
      await element.ready;
      element.remove();
    }
    document.body.append(element);
    await element.ready;
    return { given };
  });
  expect(facts).toEqual({ given: true });
  expect(compare(await pixels(viewer), before).max).toBe(0);
  await nextFrame(page);
});
