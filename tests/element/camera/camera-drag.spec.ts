// Do drags turn the scene by the specified angles? A real mouse and real fingers on a viewer of 600 × 400 CSS pixels:
// one width is 360° of azimuth, one height 180° of polar angle.

import { compare, expect, pixels, test } from '../../support/test.js';
import { assign, cameraOf, drag, type PhongViewer } from '../support/viewer.js';

const box = '<phong-viewer geometry="box" theta="30" phi="70"></phong-viewer>';
const odd = { theta: 12.345678901234567, phi: 71.30000000000001, radius: 3.3333333333333335 };
const oddBox = `<phong-viewer geometry="box" theta="${odd.theta}" phi="${odd.phi}" radius="${odd.radius}"></phong-viewer>`;

test.describe('a drag with the primary button', () => {
  test('turns −36° for 60 px to the right on 600 px of width', async ({ page, mount }) => {
    const viewer = await mount(box);
    await drag(page, [300, 200], [60, 0]);
    expect(await cameraOf(viewer)).toMatchObject({ theta: -6, phi: 70 });
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
