// Do drags turn the scene by the specified angles? A real mouse and real fingers on a viewer of 600 × 400 CSS pixels:
// one width is 360° of azimuth, one height 180° of polar angle.

import { compare, expect, pixels, test } from '../../support/test.js';
import { assign, cameraOf, drag, nextFrame, type PhongViewer, record } from '../support/viewer.js';

const box = '<phong-viewer geometry="box" theta="30" phi="70"></phong-viewer>';
const odd = { theta: 12.345678901234567, phi: 71.30000000000001, radius: 3.3333333333333335 };
const oddBox = `<phong-viewer geometry="box" theta="${odd.theta}" phi="${odd.phi}" radius="${odd.radius}"></phong-viewer>`;

test.describe('a drag with the primary button', () => {
  test('turns −36° for 60 px to the right on 600 px of width', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [300, 200], [60, 0]);
    expect(await cameraOf(viewer)).toMatchObject({ theta: -6, phi: 70 });
  });

  test('lowers φ by 18° for 40 px down on 400 px of height, and raises it upwards', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(box);
    await drag(page, [300, 200], [0, 40]);
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 52 });
    await drag(page, [300, 200], [0, -80]);
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 88 });
  });

  test('turns during the drag, before the button is released', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [100, 100], [30, 10], { release: false });
    expect(await cameraOf(viewer)).toMatchObject({ theta: 12, phi: 65.5 });
    await page.mouse.up();
    expect(await cameraOf(viewer)).toMatchObject({ theta: 12, phi: 65.5 });
  });

  test('depends on the total travel only', async ({ page, mount }) => {
    const viewer = await mount(oddBox);
    await drag(page, [300, 200], [37, 23], { steps: 1 });
    const direct = await cameraOf(viewer);
    await assign(viewer, odd);
    await page.mouse.move(300, 200);
    await page.mouse.down();
    for (const [x, y] of [[512, 31], [7, 390], [301, 201], [337, 223]] as const) await page.mouse.move(x, y); // prettier-ignore
    await page.mouse.up();
    expect(await cameraOf(viewer)).toEqual(direct);
  });

  test('returns exactly to the start with the pointer', async ({ page, mount }) => {
    const viewer = await mount(oddBox);
    const start = await cameraOf(viewer);
    const before = await pixels(viewer);
    await drag(page, [300, 200], [173, -391], { steps: 7, release: false });
    expect(await cameraOf(viewer)).not.toEqual(start);
    await page.mouse.move(300, 200, { steps: 5 });
    await page.mouse.up();
    expect(await cameraOf(viewer)).toEqual(start);
    expect(start).toMatchObject(odd);
    expect(compare(await pixels(viewer), before).max).toBe(0);
  });

  test('shows the same picture as the same angles in markup', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [300, 200], [60, 40]);
    const dragged = await pixels(viewer);
    const declared = await mount('<phong-viewer geometry="box" theta="-6" phi="52"></phong-viewer>');
    expect(compare(dragged, await pixels(declared)).max).toBe(0);
  });

  test('stops at the poles and comes back with the pointer', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [300, 100], [0, 250], { release: false });
    expect((await cameraOf(viewer)).phi).toBe(0);
    await page.mouse.move(360, 350);
    expect(await cameraOf(viewer)).toMatchObject({ theta: -6, phi: 0 });
    await page.mouse.move(300, 140);
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 52 });
    await page.mouse.move(300, -280);
    expect((await cameraOf(viewer)).phi).toBe(180);
    await page.mouse.up();
  });

  test('continues outside the element and outside the page', async ({ page, mount }) => {
    const viewer = await mount(box, { width: 200, height: 200 });
    await drag(page, [100, 100], [300, 0], { release: false });
    expect((await cameraOf(viewer)).theta).toBe(30 - 540 + 360);
    await page.mouse.move(-100, 100);
    expect((await cameraOf(viewer)).theta).toBe(30 + 360 - 360);
    await page.mouse.up();
    await page.mouse.move(150, 150);
    expect((await cameraOf(viewer)).theta).toBe(30);
  });

  test('starts anew with each press', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [100, 100], [60, 0]);
    await drag(page, [500, 300], [60, 0]);
    expect((await cameraOf(viewer)).theta).toBe(-42);
  });

  test('does nothing without a press, and nothing with the middle button', async ({ page, mount }) => {
    const viewer = await mount(box);
    await page.mouse.move(100, 100);
    await page.mouse.move(300, 300);
    await drag(page, [300, 200], [60, 40], { button: 'middle' });
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70 });
  });

  test('leaves the declared angles and the markup alone', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [300, 200], [60, 40]);
    const declared = await viewer.evaluate((element: PhongViewer) => [
      element.theta,
      element.phi,
      element.radius,
      element.getAttribute('theta'),
    ]);
    expect(declared).toEqual([30, 70, 'auto', '30']);
  });

  test('selects no text of the page', async ({ page, mount }) => {
    await mount(`<p>Before</p>${box}<p>After</p>`);
    await drag(page, [300, 200], [100, 350]);
    expect(await page.evaluate(() => getSelection()?.toString())).toBe('');
  });

  test('does not turn if orbit is false', async ({ page, mount }) => {
    const viewer = await mount(box);
    await assign(viewer, { orbit: false });
    await drag(page, [300, 200], [60, 40]);
    await drag(page, [300, 200], [60, 40], { button: 'right' });
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70, target: [0, 0, 0] });
    await assign(viewer, { orbit: true });
    await drag(page, [300, 200], [60, 0]);
    expect((await cameraOf(viewer)).theta).toBe(-6);
  });
});

test.describe('what happens during a drag', () => {
  test('a property write acts at once, and the drag continues from there', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [300, 200], [60, 0], { release: false });
    await assign(viewer, { theta: 100 });
    expect((await cameraOf(viewer)).theta).toBe(100);
    await page.mouse.move(420, 200);
    expect((await cameraOf(viewer)).theta).toBe(64);
    await page.mouse.up();
  });

  test('a property write after a drag acts, even with the same value', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [300, 200], [60, 40]);
    await assign(viewer, { theta: 30 });
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 52 });
    await viewer.evaluate((element) => element.setAttribute('phi', '70'));
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70 });
  });

  test('a resize sets a new anchor', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [100, 100], [60, 0], { release: false });
    await viewer.evaluate((element) => (element.style.width = '300px'));
    await nextFrame(page);
    expect((await cameraOf(viewer)).theta).toBe(-6);
    await page.mouse.move(190, 100);
    expect((await cameraOf(viewer)).theta).toBe(-42);
    await page.mouse.up();
  });

  test('a turn of the wheel zooms and sets a new anchor', async ({ page, mount }) => {
    const viewer = await mount(box);
    const { radius } = await cameraOf(viewer);
    await drag(page, [300, 200], [60, 0], { release: false });
    await page.mouse.wheel(0, 100);
    await expect.poll(async () => (await cameraOf(viewer)).radius).toBeCloseTo(radius * Math.exp(0.1), 12);
    await page.mouse.move(300, 200);
    expect((await cameraOf(viewer)).theta).toBe(30);
    await page.mouse.up();
  });

  for (const [what, end] of [
    ['lostpointercapture', (surface: HTMLElement, id: number) => surface.releasePointerCapture(id)],
    [
      'pointercancel',
      (surface: HTMLElement, id: number) =>
        surface.dispatchEvent(new PointerEvent('pointercancel', { pointerId: id, bubbles: true })),
    ],
    ['blur of the window', () => window.dispatchEvent(new Event('blur'))],
  ] as const) {
    test(`${what} ends the drag`, async ({ page, mount }) => {
      const viewer = await mount(box);
      await viewer.evaluate((element: PhongViewer) => {
        const surface = element.shadowRoot?.querySelector<HTMLElement>('[part=surface]');
        surface?.addEventListener('pointerdown', ({ pointerId }) => Object.assign(window, { pointerId }));
        Object.assign(window, { surface });
      });
      await drag(page, [300, 200], [60, 0], { release: false });
      await page.evaluate(`(${end.toString()})(window.surface, window.pointerId)`);
      await page.mouse.move(400, 300);
      await page.mouse.move(200, 100);
      expect(await cameraOf(viewer)).toMatchObject({ theta: -6, phi: 70 });
      await page.mouse.up();
    });
  }

  test('removing the viewer from the document ends the drag', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [300, 200], [60, 0], { release: false });
    await viewer.evaluate((element) => {
      element.remove();
      document.body.append(element);
    });
    await page.mouse.move(420, 200);
    expect((await cameraOf(viewer)).theta).toBe(-6);
    await page.mouse.up();
  });
});

test.describe('in transformed parents, a drag follows the element’s own axes', () => {
  /** The pointer travels 60 px along the element's width and 40 px along its height, of 600 and 400: −36° and −18°. */
  const cases: Readonly<Record<string, string>> = {
    'rotated by 90°': 'rotate(90deg)',
    'rotated by 30°': 'rotate(30deg)',
    'upside down': 'rotate(180deg)',
    mirrored: 'scale(-1, 1)',
    scaled: 'scale(0.5)',
    'scaled unevenly and rotated': 'rotate(-50deg) scale(0.5, 0.75)',
    skewed: 'skewX(30deg) skewY(-10deg)',
    'turned in space': 'rotateY(50deg) rotateZ(20deg)',
  };
  for (const [what, transform] of Object.entries(cases)) {
    test(what, async ({ page, mount }) => {
      const viewer = await mount(`<main><section>${box}</section></main>`, {
        css: `main { position: absolute; left: 200px; top: 150px; width: 600px; height: 400px; transform: ${transform} }
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
      await page.mouse.move(...(await place(300, 200)));
      await page.mouse.down();
      await page.mouse.move(...(await place(360, 240)), { steps: 3 });
      const { theta, phi } = await cameraOf(viewer);
      expect(theta).toBeCloseTo(-6, 2);
      expect(phi).toBeCloseTo(52, 2);
      const start = await place(300, 200);
      await page.mouse.move(...start);
      await page.mouse.up();
      expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70 });
    });
  }

  test('the target shifts with the pointer', async ({ page, mount }) => {
    const viewer = await mount(`<main>${box}</main>`, {
      css: 'main { position: absolute; left: 100px; top: 50px; width: 600px; height: 400px; rotate: 90deg }',
    });
    const upright = await viewer.evaluate((element: PhongViewer) => element.camera);
    await drag(page, [400, 250], [0, 60], { button: 'right' });
    const { target, up } = await cameraOf(viewer);
    // Down the page is to the right in the picture: nothing moves along its height.
    expect(Math.hypot(...target)).toBeGreaterThan(0.1);
    expect(target[0] * up[0] + target[1] * up[1] + target[2] * up[2]).toBeCloseTo(0, 6);
    expect(await cameraOf(viewer)).toMatchObject({ theta: upright.theta, phi: upright.phi });
  });

  test('rotating the parent during a drag does not move the camera', async ({ page, mount }) => {
    const viewer = await mount(`<main>${box}</main>`, { css: 'main { width: 600px; height: 400px }' });
    await drag(page, [300, 200], [60, 0], { release: false });
    await viewer.evaluate((element) => (element.parentElement!.style.rotate = '90deg'));
    await page.mouse.move(360, 200.5);
    expect((await cameraOf(viewer)).theta).toBeCloseTo(-6, 0);
    await page.mouse.move(360, 260.5);
    expect((await cameraOf(viewer)).theta).toBeCloseTo(-42, 0);
    await page.mouse.up();
  });
});

test('reports the camera once per task, with the source pointer', async ({ page, mount }) => {
  const viewer = await mount(box);
  const events = await record(viewer, 'camera-change');
  await drag(page, [300, 200], [60, 0], { steps: 1 });
  expect(await events.take()).toEqual([{ type: 'camera-change', detail: { source: 'pointer' } }]);
  await drag(page, [300, 200], [0, 0], { steps: 1 });
  expect(await events.take()).toEqual([]);
});

test('turns in a link, a draggable card, a label and a summary, which take plain clicks only', async ({
  page,
  mount,
}) => {
  await mount(
    `<a href="#went">${box}</a><div draggable="true">${box}</div><label>${box}<input type="checkbox"></label>
    <details><summary>${box}</summary>text</details>`,
    { width: 200, height: 130, css: 'summary { display: block } input { display: block; margin: 0 }' },
  );
  await page.evaluate(() => {
    const heard: string[] = [];
    for (const type of ['dragstart', 'click'])
      for (const around of document.querySelectorAll('a, [draggable], label, summary'))
        around.addEventListener(type, ({ target }) => {
          if (target !== document.querySelector('input')) heard.push(`${type} ${around.localName}`);
        });
    Object.assign(window, { heard });
  });
  const outcome = (): Promise<unknown> =>
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
  for (const viewer of viewers) await viewer.click();
  const heard = ['a', 'div', 'label', 'summary'].map((around) => `click ${around}`);
  expect(await outcome()).toEqual({ heard, hash: '#went', checked: true, open: true });
});
