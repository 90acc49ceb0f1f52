// Does `ready` settle in every situation, and only when it may? Every wait here is raced against
// ten seconds.

import type { Page } from '@playwright/test';
import { expect, test } from '../../support/test.js';

const bunny = '/assets/models/bunny.glb';
const css =
  'main { height: 200px } .gone { display: none } .flat { width: 0; height: 0 } .below { margin-top: 5000px }';

/** What happens to a viewer once it is on the page: in the same task, or while its model loads. */
type Deed = '' | 'remove at once' | 'hide' | 'remove' | 'move' | 'clear';

/** Runs in the page: creates a viewer, waits for `ready` twice and returns the viewer's state. */
const readiness = (page: Page, attributes: Record<string, string>, deed: Deed) =>
  page.evaluate(
    async ({ attributes, deed }) => {
      const viewer = document.createElement('phong-viewer');
      for (const [name, value] of Object.entries(attributes)) {
        viewer.setAttribute(name, value);
      }
      document.querySelector('main')?.append(viewer);
      if (deed === 'remove at once') {
        viewer.remove();
      }
      const { ready } = viewer;
      await Promise.resolve();
      if (deed === 'hide') {
        viewer.className = 'gone';
      } else if (deed === 'remove') {
        viewer.remove();
      } else if (deed === 'move') {
        document.body.append(viewer);
      } else if (deed === 'clear') {
        viewer.src = '';
      }
      const late = new Promise((resolve) => setTimeout(() => resolve('pending'), 10_000));
      const outcome = await Promise.race([ready.then(() => 'ready'), late]);
      const again = await Promise.race([viewer.ready.then(() => 'ready'), late]);
      const { loaded, stats } = viewer;
      viewer.remove();
      return { outcome, again, drawn: stats.frames > 0, loaded };
    },
    { attributes, deed },
  );

test('resolves in every situation', async ({ page, mount, consoleGuard }) => {
  consoleGuard.allow(/error: Failed to load resource.*404/, 1);
  await mount('<main></main>', { css });
  const either: unknown = expect.any(Boolean);
  const src = bunny;
  const lazy = { src, loading: 'lazy' };
  for (const [what, attributes, deed, drawn, loaded] of [
    // An empty scene is drawn too: it may have a background of its own.
    ['no src', {}, '', true, false],
    ['on screen', { src }, '', true, true],
    ['not displayed', { src, class: 'gone' }, '', false, true],
    ['0 × 0', { src, class: 'flat' }, '', false, true],
    ['off screen', { src, class: 'below' }, '', false, true],
    ['removed', { src }, 'remove at once', false, either],
    ['failing', { src: '/none.glb' }, '', either, false],
    ['no address', { src: 'http://[' }, '', either, false],
    ['lazy', { ...lazy, class: 'below' }, '', false, false],
    ['lazy on screen', lazy, '', true, true],
    ['hidden while it loads', { src }, 'hide', either, either],
    ['removed while it loads', { src }, 'remove', either, either],
    ['moved while it loads', { src }, 'move', either, either],
    ['cleared while it loads', { src }, 'clear', either, either],
    ['cleared while it loads, not displayed', { src, class: 'gone' }, 'clear', false, false],
  ] as const) {
    const ready = { outcome: 'ready', again: 'ready' };
    expect(await readiness(page, attributes, deed), what).toEqual({ ...ready, drawn, loaded });
  }
});

test('is a new promise for a newer src, which resolves the old one, and for later changes', async ({
  page,
  mount,
}) => {
  await mount('<main></main>', { css });
  const facts = await page.evaluate(async (address) => {
    const viewer = document.createElement('phong-viewer');
    document.querySelector('main')?.append(viewer);
    const shown: string[] = [];
    viewer.addEventListener('load', ({ detail }) => shown.push(new URL(detail.url).pathname));
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
    return {
      same,
      renewed: first !== second,
      firstOutcome,
      loaded,
      shown,
      drawn: viewer.stats.frames - before,
    };
  }, bunny);
  const shown = ['/fixtures/models/no-normals.glb'];
  expect(facts).toEqual({
    same: true,
    renewed: true,
    firstOutcome: undefined,
    loaded: true,
    shown,
    drawn: 1,
  });
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
    const last =
      document.querySelector<HTMLElementTagNameMap['phong-viewer']>('.gone > phong-viewer')!;
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
