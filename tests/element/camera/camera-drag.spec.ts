// Do drags with a real mouse and real fingers turn the scene by the specified angles, and nothing
// else? unit/ has the rest of the gestures. One width is 360° of azimuth, one height 180° of polar
// angle.

import { compare, expect, pixels, test } from '../../support/test.js';
import { assign, cameraOf, drag, Fingers } from '../support/viewer.js';

const box = '<phong-viewer geometry="box" theta="30" phi="70"></phong-viewer>';

test('a drag shows the picture of new angles, and leaves declared ones and markup alone', async ({
  page,
  mount,
}) => {
  const viewer = await mount(box);
  await drag(page, [300, 200], [60, 40]);
  const dragged = await pixels(viewer);
  const declared = await viewer.evaluate((element) => [
    element.theta,
    element.phi,
    element.radius,
    element.getAttribute('theta'),
  ]);
  expect(declared).toEqual([30, 70, 'auto', '30']);
  const same = await mount('<phong-viewer geometry="box" theta="-6" phi="52"></phong-viewer>');
  expect(compare(dragged, await pixels(same)).max).toBe(0);
});

test('a drag continues outside the page and from a property, until the viewer is removed', async ({
  page,
  mount,
}) => {
  const viewer = await mount(box, { width: 200, height: 200 });
  const theta = async () => (await cameraOf(viewer)).theta;
  await drag(page, [100, 100], [300, 0], { release: false });
  expect(await theta()).toBe(30 - 540 + 360);
  await page.mouse.move(-100, 100);
  expect(await theta()).toBe(30 + 360 - 360);
  await page.mouse.move(150, 150);
  await assign(viewer, { theta: 100 });
  expect(await theta()).toBe(100);
  await page.mouse.move(170, 150);
  expect(await theta()).toBe(64);
  await viewer.evaluate((element) => {
    element.remove();
    document.body.append(element);
  });
  await page.mouse.move(100, 150);
  expect(await theta()).toBe(64);
  await page.mouse.up();
  await drag(page, [100, 100], [20, 0]);
  await page.mouse.move(150, 150);
  expect(await theta(), 'released').toBe(28);
});

test('in transformed parents a drag follows the element’s own axes, and back to its start', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`<main><section>${box}</section></main>`, {
    css: `main { position: absolute; left: 200px; top: 150px; width: 600px; height: 400px }
      section { rotate: 10deg; zoom: 0.5 }`,
  });
  /** Where a point of the element, in its own pixels, is on the page. */
  const place = (x: number, y: number): Promise<[number, number]> =>
    viewer.evaluate(
      (element, [left, top]) => {
        const mark = document.createElement('i');
        mark.style.cssText = `position: absolute; left: ${left}px; top: ${top}px`;
        element.shadowRoot!.append(mark);
        const at = mark.getBoundingClientRect();
        mark.remove();
        return [at.left, at.top];
      },
      [x, y] as const,
    );
  for (const transform of [
    'rotate(90deg)',
    'scale(-1, 1)',
    'rotate(-50deg) scale(0.5, 0.75)',
    'skewX(30deg) skewY(-10deg)',
    'rotateY(50deg) rotateZ(20deg)',
  ]) {
    await page.locator('main').evaluate((main, value) => (main.style.transform = value), transform);
    const start = await place(300, 200);
    await page.mouse.move(...start);
    await page.mouse.down();
    await page.mouse.move(...(await place(360, 240)), { steps: 3 });
    const { theta, phi } = await cameraOf(viewer);
    expect(theta, transform).toBeCloseTo(-6, 2);
    expect(phi, transform).toBeCloseTo(52, 2);
    await page.mouse.move(...start);
    await page.mouse.up();
    expect(await cameraOf(viewer), transform).toMatchObject({ theta: 30, phi: 70 });
  }
});

test('turns in a link, a draggable card, a label and a summary, which take clicks only', async ({
  page,
  mount,
}) => {
  await mount(
    `<a href="#went">${box}</a><div draggable="true">${box}</div><label>${box}<input type="checkbox"></label>
    <details><summary>${box}</summary>text</details>`,
    {
      width: 200,
      height: 130,
      css: 'summary { display: block } input { display: block; margin: 0 }',
    },
  );
  await page.evaluate(() => {
    const heard: string[] = [];
    for (const type of ['dragstart', 'click']) {
      for (const around of document.querySelectorAll('a, [draggable], label, summary')) {
        around.addEventListener(type, ({ target }) => {
          if (target !== document.querySelector('input')) {
            heard.push(`${type} ${around.localName}`);
          }
        });
      }
    }
    Object.assign(window, { heard });
  });
  const outcome = () =>
    page.evaluate(() => ({
      heard: (window as unknown as { heard: string[] }).heard.splice(0),
      hash: location.hash,
      checked: document.querySelector('input')!.checked,
      open: document.querySelector('details')!.open,
    }));
  const viewers = await page.locator('phong-viewer').all();
  for (const viewer of viewers) {
    const { x, y } = (await viewer.boundingBox())!;
    await drag(page, [x + 40, y + 60], [100, 0]);
    expect(await cameraOf(viewer)).toMatchObject({ theta: -150, phi: 70 });
  }
  expect(await outcome()).toEqual({ heard: [], hash: '', checked: false, open: false });
  for (const viewer of viewers) {
    await viewer.click();
  }
  const heard = ['a', 'div', 'label', 'summary'].map((around) => `click ${around}`);
  expect(await outcome()).toEqual({ heard, hash: '#went', checked: true, open: true });
});

test.describe('fingers', () => {
  test.use({ hasTouch: true });

  test('one finger turns as the mouse does; a stroke down the picture scrolls the page', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(`${box}<div class="tall"></div>`, {
      css: '.tall { height: 3000px }',
    });
    const fingers = await Fingers.on(page);
    await fingers.down([300, 200]);
    await fingers.move([330, 200]);
    await fingers.move([360, 240]);
    await fingers.up();
    expect(await cameraOf(viewer)).toMatchObject({ theta: -6, phi: 52 });
    await fingers.down([300, 350]);
    for (let y = 345; y >= 150; y -= 5) {
      await fingers.move([300, y]);
    }
    await fingers.up();
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(100);
    expect(await cameraOf(viewer)).toMatchObject({ theta: -6, phi: 52 });
  });
});
