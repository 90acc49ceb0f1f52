// Does `ready` settle in every situation, and only when it may? Every wait here is raced against ten seconds.

import type { Page } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import { type PhongViewer } from '../support/viewer.js';

const bunny = '/assets/models/bunny.glb';
const css =
  'main { height: 200px } .gone { display: none } .flat { width: 0; height: 0 } .below { margin-top: 5000px }';

/** Runs in the page: creates a viewer, waits for `ready` and returns the viewer's state. */
async function readiness(
  page: Page,
  setting: { attributes?: Record<string, string>; className?: string; remove?: boolean } = {}, // prettier-ignore
): Promise<unknown> {
  return page.evaluate(async ({ attributes = {}, className = '', remove = false }) => {
    const viewer = document.createElement('phong-viewer');
    for (const [name, value] of Object.entries(attributes)) viewer.setAttribute(name, value);
    viewer.className = className;
    document.querySelector('main')?.append(viewer);
    if (remove) viewer.remove();
    const late = new Promise((resolve) => setTimeout(() => resolve('pending'), 10_000));
    const outcome = await Promise.race([viewer.ready.then(() => 'ready'), late]);
    const { frames } = viewer.stats;
    const { loaded } = viewer;
    viewer.remove();
    return { outcome, drawn: frames > 0, loaded };
  }, setting);
}

test('resolves in every situation', async ({ page, mount, consoleGuard }) => {
  consoleGuard.allow(/error: Failed to load resource.*404/, 1);
  await mount('<main></main>', { css });
  const outcome = 'ready';
  const src = { attributes: { src: bunny } };
  // An empty scene is drawn too: it may have a background of its own.
  expect(await readiness(page), 'no src').toEqual({ outcome, drawn: true, loaded: false });
  expect(await readiness(page, src), 'on screen').toEqual({ outcome, drawn: true, loaded: true });
  expect(await readiness(page, { ...src, className: 'gone' }), 'not displayed').toEqual({ outcome, drawn: false, loaded: true }); // prettier-ignore
  expect(await readiness(page, { ...src, className: 'flat' }), '0 × 0').toEqual({ outcome, drawn: false, loaded: true }); // prettier-ignore
  expect(await readiness(page, { ...src, className: 'below' }), 'off screen').toEqual({ outcome, drawn: false, loaded: true }); // prettier-ignore
  expect(await readiness(page, { ...src, remove: true }), 'removed').toMatchObject({ outcome, drawn: false });
  expect(await readiness(page, { attributes: { src: '/none.glb' } }), 'failing').toMatchObject({ outcome, loaded: false }); // prettier-ignore
  expect(await readiness(page, { attributes: { src: 'http://[' } }), 'no address').toMatchObject({ outcome, loaded: false }); // prettier-ignore
  const lazy = { attributes: { src: bunny, loading: 'lazy' } };
  expect(await readiness(page, { ...lazy, className: 'below' }), 'lazy').toEqual({ outcome, drawn: false, loaded: false }); // prettier-ignore
  expect(await readiness(page, lazy), 'lazy on screen').toEqual({ outcome, drawn: true, loaded: true });
});

test('is a new promise for a newer src, which resolves the old one, and for later changes', async ({
  page,
  mount,
}) => {
  await mount('<main></main>', { css });
  const facts = await page.evaluate(async (address) => {
    const viewer = document.createElement('phong-viewer');
    document.querySelector('main')?.append(viewer);
    viewer.src = address;
    const first = viewer.ready;
    const same = viewer.ready === first;
    viewer.src = '/fixtures/models/no-normals.glb';
    await Promise.resolve();
    const second = viewer.ready;
    const late = new Promise((resolve) => setTimeout(() => resolve('pending'), 10_000));
    const firstOutcome = await Promise.race([first, late]);
    await Promise.race([second, late]);
    const { loaded } = viewer;
    const before = viewer.stats.frames;
    viewer.theta = 77;
    await viewer.ready;
    return { same, renewed: first !== second, firstOutcome, loaded, drawn: viewer.stats.frames - before };
  }, bunny);
  expect(facts).toEqual({ same: true, renewed: true, firstOutcome: undefined, loaded: true, drawn: 1 });
});

test('resolves for a viewer that is hidden or removed while its model loads', async ({ page, mount }) => {
  await mount('<main></main>', { css });
  for (const what of ['hide', 'remove', 'move', 'clear'] as const) {
    const outcome = await page.evaluate(
      async ({ address, deed }) => {
        const viewer: PhongViewer = document.createElement('phong-viewer');
        viewer.src = address;
        document.querySelector('main')?.append(viewer);
        const { ready } = viewer;
        await Promise.resolve();
        if (deed === 'hide') viewer.className = 'gone';
        else if (deed === 'remove') viewer.remove();
        else if (deed === 'move') document.body.append(viewer);
        else viewer.src = '';
        const late = new Promise((resolve) => setTimeout(() => resolve('pending'), 10_000));
        const result = await Promise.race([ready.then(() => 'ready'), late]);
        const again = await Promise.race([viewer.ready.then(() => 'ready'), late]);
        viewer.remove();
        return [result, again];
      },
      { address: bunny, deed: what },
    );
    expect(outcome, what).toEqual(['ready', 'ready']);
  }
});

test('waits for children that load', async ({ mount }) => {
  const viewer = await mount(`<phong-viewer><phong-mesh src="${bunny}"></phong-mesh><phong-mesh geometry="teapot"></phong-mesh></phong-viewer>`); // prettier-ignore
  const facts = await viewer.evaluate((element: PhongViewer) => ({
    loaded: element.loaded,
    drawCalls: element.stats.drawCalls,
  }));
  expect(facts).toEqual({ loaded: true, drawCalls: 2 });
});

test('waits for a comparison to place its viewers, and for one that was just shown', async ({
  mount,
  page,
}) => {
  await mount('<main></main>', { css: `${css} phong-compare { width: 200px; height: 100px }` });
  const found = await page.evaluate(async () => {
    const drawn: boolean[] = [];
    const viewer = '<phong-viewer geometry="sphere"></phong-viewer>';
    const main = document.querySelector('main')!;
    for (const layout of ['split', 'side']) {
      main.innerHTML = `<phong-compare layout="${layout}">${viewer}${viewer}</phong-compare>`;
      for (const each of document.querySelectorAll('phong-viewer')) {
        await each.ready;
        drawn.push(each.stats.frames > 0);
      }
    }
    main.innerHTML = `<div class="gone"><phong-compare>${viewer}</phong-compare>${viewer}</div>`;
    for (const each of document.querySelectorAll('phong-viewer')) {
      await each.ready;
      drawn.push(each.stats.frames > 0);
    }
    const last = document.querySelector<HTMLElementTagNameMap['phong-viewer']>('.gone > phong-viewer')!;
    last.parentElement!.className = '';
    await last.ready;
    return { drawn, shown: last.stats.frames };
  });
  expect(found).toEqual({ drawn: [true, true, true, true, false, false], shown: 1 });
});

test('waits for a viewer that is shown between a frame and the reports of its observers', async ({
  mount,
  page,
}) => {
  await mount('<main></main>', { css });
  const frames = await page.evaluate(async () => {
    const counts: number[] = [];
    for (let i = 0; i < 8; i++) {
      const box = document.createElement('div');
      box.className = 'gone';
      box.innerHTML = '<phong-viewer alt="" geometry="sphere"></phong-viewer>';
      await new Promise(requestAnimationFrame);
      document.querySelector('main')!.append(box);
      const { port1, port2 } = new MessageChannel();
      await new Promise((resolve) => {
        port1.onmessage = resolve;
        port2.postMessage(null);
      });
      box.className = '';
      const viewer = box.querySelector('phong-viewer')!;
      await viewer.ready;
      counts.push(viewer.stats.frames);
      box.remove();
    }
    return counts;
  });
  expect(frames).toEqual(Array(8).fill(1));
});
