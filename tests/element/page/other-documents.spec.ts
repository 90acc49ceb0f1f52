// Does a viewer work in the document of an iframe or a popup, and again when it returns? Every page
// is under a strict Content-Security-Policy, which new documents inherit.

import type { Locator, Page } from '@playwright/test';
import {
  type ViewerLocator,
  compare,
  expect,
  pixels,
  strictPolicy,
  same,
  test,
} from '../../support/test.js';
import { decodePng } from '../../support/picture.js';
import {
  cameraOf,
  drag,
  framesOf,
  nextFrame,
  type PhongViewer,
  set,
  settled,
  assign,
} from '../support/viewer.js';

const scene = `<phong-viewer geometry="box" theta="30" phi="70">
  <phong-light name="sun" position="1 2 3 0" diffuse="200 40 40"></phong-light>
  <phong-mesh geometry="sphere" position="0.8 0 0" scale="0.5"></phong-mesh></phong-viewer>`;
const css = 'iframe { border: 0; width: 500px; height: 300px; margin: 40px 60px }';
const SIZE = { width: 200, height: 150 };
const framing = { ...SIZE, css, csp: `${strictPolicy}; frame-src 'self'` };

/** Moves the first viewer into the iframe's document. */
const intoFrame = (page: Page) =>
  page.evaluate(async () => {
    const viewer = document.querySelector('phong-viewer')!;
    const inner = document.querySelector('iframe')!.contentDocument!;
    inner.body.style.margin = '0';
    viewer.style.cssText = 'display: block; width: 200px; height: 150px';
    inner.body.append(viewer);
    await viewer.ready;
  });

/** How many pixels on the screen are dark in what the viewer covers. */
async function inkOn(page: Page, viewer: ViewerLocator) {
  const { data } = decodePng(await page.screenshot({ clip: (await viewer.boundingBox())! }));
  let ink = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i]! + data[i + 1]! + data[i + 2]! < 600) {
      ink += 1;
    }
  }
  return ink;
}

test('a viewer among others shows its picture in an iframe, and again when it returns', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`${scene}<iframe></iframe>${scene}`, { ...SIZE, css });
  await nextFrame(page);
  const before = await pixels(viewer);
  const ink = await inkOn(page, viewer);
  expect(ink).toBeGreaterThan(500);
  for (let time = 0; time < 2; time++) {
    await intoFrame(page);
    const inside = page.frameLocator('iframe').locator('phong-viewer');
    same(await pixels(inside), before);
    await expect.poll(() => inkOn(page, inside)).toBe(ink);
    await page.evaluate(async () => {
      const moved = document
        .querySelector('iframe')!
        .contentDocument!.querySelector('phong-viewer')!;
      document.body.prepend(moved);
      await moved.ready;
    });
    same(await pixels(viewer), before);
    await expect.poll(() => inkOn(page, viewer)).toBe(ink);
  }
});
test('lights and meshes move with the viewer into an iframe, whose media queries hold', async ({
  page,
  mount,
}) => {
  await mount(`${scene}<iframe></iframe>`, { ...SIZE, css });
  await intoFrame(page);
  const inside = page.frameLocator('iframe').locator('phong-viewer');
  const facts = await page.evaluate(async () => {
    const moved = document.querySelector('iframe')!.contentDocument!.querySelector('phong-viewer')!;
    const wrapper = moved.ownerDocument.createElement('div');
    const host = moved.ownerDocument.createElement('div');
    moved.append(wrapper, host);
    wrapper.append(document.createElement('phong-light'));
    host.attachShadow({ mode: 'closed' }).append(document.createElement('phong-light'));
    await moved.ready;
    const { lightsDeclared, lightsActive } = moved.stats;
    return { lightsDeclared, lightsActive, meshes: moved.meshes.length };
  });
  expect(facts).toEqual({ lightsDeclared: 3, lightsActive: 3, meshes: 1 });
  const frames = () => framesOf(inside);
  const before = await frames();
  const left = await inside.evaluate((element: PhongViewer) => {
    element.lights[0]!.remove();
    element.autoRotate = 90;
    return element.lights.length;
  });
  expect(left).toBe(2);
  await expect.poll(frames).toBeGreaterThan(before + 1);
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await nextFrame(page);
  await settled(inside);
  const still = await frames();
  await nextFrame(page);
  await nextFrame(page);
  expect(await frames()).toBe(still);
  await page.emulateMedia({ reducedMotion: 'no-preference' });
  await expect.poll(frames).toBeGreaterThan(still);
});

test('drags, wheel, keys, sizes and the panel work in an iframe', async ({ page, mount }) => {
  const viewer = await mount(`${scene}<iframe></iframe>`, { ...SIZE, css });
  await viewer.evaluate((element) => {
    element.gui = true;
  });
  await expect(viewer.locator('[part=panel] .lil-root')).toBeVisible();
  const look = (place: Locator) =>
    place.locator('[part=panel] .lil-root').evaluate((element) => {
      const style = element.ownerDocument.defaultView!.getComputedStyle(element);
      return [style.backgroundColor, style.fontSize, style.colorScheme, style.display];
    });
  const styled = await look(viewer);
  await intoFrame(page);
  const inside = page.frameLocator('iframe').locator('phong-viewer');
  expect(await look(inside)).toEqual(styled);
  await inside.evaluate((element: PhongViewer) => {
    element.gui = false;
  });
  await expect(inside.locator('[part=panel] .lil-root')).toHaveCount(0);
  const box = (await inside.boundingBox())!;
  await drag(page, [box.x + 50, box.y + 50], [20, 15]);
  expect(await cameraOf(inside)).toMatchObject({ theta: -6, phi: 52 });
  const { radius } = await cameraOf(inside);
  await page.mouse.wheel(0, 100);
  await expect
    .poll(async () => (await cameraOf(inside)).radius)
    .toBeCloseTo(radius * Math.exp(0.1), 6);
  await page.keyboard.press('ArrowRight');
  expect((await cameraOf(inside)).theta).toBe(-11);
  await inside.evaluate((element: PhongViewer) => (element.style.width = '300px'));
  const width = () =>
    inside.evaluate(({ shadowRoot }: PhongViewer) => shadowRoot!.querySelector('canvas')!.width);
  await expect.poll(width).toBe(300);
  // Created there, not moved there.
  await inside.evaluate((element: PhongViewer) => {
    element.gui = true;
  });
  await expect(inside.locator('[part=panel] .lil-root')).toBeVisible();
  expect(await look(inside)).toEqual(styled);
});

test('a viewer first connected in an iframe with a strict policy of its own works', async ({
  page,
  mount,
  site,
}) => {
  await mount(`<phong-viewer></phong-viewer><iframe src="${site.page('')}"></iframe>`, framing);
  await expect(page.frameLocator('iframe').locator('body')).toHaveCount(1);
  const facts = await page.evaluate(async () => {
    const viewer = document.createElement('phong-viewer');
    viewer.geometry = 'box';
    viewer.gui = true;
    document.querySelector('iframe')!.contentDocument!.body.append(viewer);
    await viewer.ready;
    const { frames } = viewer.stats;
    return { frames, width: viewer.clientWidth, height: viewer.clientHeight };
  });
  expect(facts).toEqual({ frames: 1, width: 300, height: 150 });
  await expect(page.frameLocator('iframe').locator('[part=panel] .lil-root')).toBeVisible();
});

for (const how of ['removed', 'navigated'] as const) {
  test(`an iframe that is ${how} while a frame is pending breaks nothing`, async ({
    page,
    mount,
    site,
  }) => {
    const viewer = await mount(`${scene}<iframe></iframe>${scene}`, framing);
    const before = await pixels(viewer);
    await intoFrame(page);
    const facts = await page.evaluate(
      async ({ how, address }) => {
        const frame = document.querySelector('iframe')!;
        const moved = frame.contentDocument!.querySelector('phong-viewer')!;
        const other = document.querySelector('phong-viewer')!;
        moved.kd = [1, 2, 3];
        const { ready } = moved;
        if (how === 'removed') {
          frame.remove();
        } else {
          frame.src = address;
          await new Promise((resolve) => (frame.onload = resolve));
        }
        await ready;
        moved.kd = [200, 200, 200];
        await moved.ready;
        const { frames } = other.stats;
        other.theta = 50;
        await other.ready;
        const drawn = other.stats.frames - frames;
        // Alone now: the picture is the WebGL canvas itself.
        const direct = other.shadowRoot!.querySelector('canvas')!.getContext('webgl2') !== null;
        moved.kd = null;
        document.body.prepend(moved);
        await moved.ready;
        return { drawn, direct };
      },
      { how, address: site.page('') },
    );
    expect(facts).toEqual({ drawn: 1, direct: true });
    same(await pixels(viewer), before);
  });
}

test('a document without a window counts as outside the page', async ({ page, mount }) => {
  const viewer = await mount(scene, SIZE);
  const before = await pixels(viewer);
  const frames = await viewer.evaluate(async (element) => {
    const inert = document.implementation.createHTMLDocument();
    inert.body.append(element);
    element.theta = 50;
    await element.ready;
    const fresh = inert.body.appendChild(document.createElement('phong-viewer'));
    fresh.geometry = 'box';
    await fresh.ready;
    const drawn = fresh.stats.frames;
    element.theta = 30;
    document.body.append(element, fresh);
    await Promise.all([element.ready, fresh.ready]);
    return [drawn, fresh.stats.frames];
  });
  expect(frames).toEqual([0, 1]);
  same(await pixels(page.locator('phong-viewer').first(), SIZE), before);
});

test('a viewer in a popup draws by the popup’s frames, drags, prints and returns', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`${scene}<p></p>`, SIZE);
  const before = await pixels(viewer);
  const opened = page.waitForEvent('popup');
  await page.evaluate(() => void open('about:blank', 'popup', 'width=600,height=500'));
  const popup = await opened;
  await page.evaluate(() => {
    const inner = open('', 'popup')!;
    const viewer = document.querySelector('phong-viewer')!;
    Object.assign(window, { viewer, realFrame: window.requestAnimationFrame });
    // As in a minimised window: no frames, and the document is hidden.
    window.requestAnimationFrame = () => 1;
    Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
    viewer.style.cssText = 'display: block; width: 200px; height: 150px; margin: 0';
    inner.document.body.append(viewer);
  });
  const inside = popup.locator('phong-viewer');
  await settled(inside);
  await nextFrame(popup);
  same(await pixels(inside), before);
  expect(await inkOn(popup, inside)).toBeGreaterThan(500);
  const box = (await inside.boundingBox())!;
  await drag(popup, [box.x + 50, box.y + 50], [20, 15]);
  await settled(inside);
  expect(await cameraOf(inside)).toMatchObject({ theta: -6, phi: 52 });
  const turned = await pixels(inside);
  expect(compare(turned, before).max).toBeGreaterThan(50);
  // The probe follows by the popup's frames, too.
  await inside.evaluate((element: PhongViewer) => {
    element.addEventListener('probe-change', () => (element.title += '.'));
    element.probe = true;
  });
  let x = box.x + 60;
  await expect
    .poll(() => popup.mouse.move((x += 3), box.y + 75).then(() => inside.getAttribute('title')))
    .toMatch(/^\.{3}/);
  await inside.evaluate((element: PhongViewer) =>
    Object.assign(element, { title: '', probe: false }),
  );
  // Below the fold it is drawn for print.
  const frames = () => framesOf(inside);
  await inside.evaluate((element: PhongViewer) => {
    element.style.marginTop = '5000px';
    // Its own observer, which is older, hears of the place first.
    return new Promise((resolve) => new IntersectionObserver(resolve).observe(element));
  });
  await assign(inside, { kd: [9, 9, 9] });
  const still = await frames();
  await popup.pdf();
  expect(await frames()).toBe(still + 1);
  await inside.evaluate((element: PhongViewer) => {
    element.style.marginTop = '0';
    element.kd = null;
    element.resetCamera();
  });
  await page.evaluate(() => {
    const { viewer, realFrame } = window as unknown as {
      viewer: PhongViewer;
      realFrame: typeof requestAnimationFrame;
    };
    window.requestAnimationFrame = realFrame;
    Reflect.deleteProperty(document, 'visibilityState');
    // As picture-in-picture is ended.
    open('', 'popup')!.addEventListener('pagehide', () =>
      document.querySelector('p')!.append(viewer),
    );
  });
  await page.evaluate(() => open('', 'popup')!.close());
  await expect(viewer).toBeAttached();
  await set(viewer, { geometry: 'torus' });
  expect(compare(await pixels(viewer), before).max).toBeGreaterThan(50);
  await set(viewer, { geometry: 'box' });
  same(await pixels(viewer), before);
});
