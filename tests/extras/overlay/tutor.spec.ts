// Does the probe show the equation and judge answers, and does `explain` say what `shadeAt` says?

import type { Locator } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import type { PhongViewerEventMap } from '../../../src/viewer/index.js';
import { assign, type PhongViewer } from '../../element/support/viewer.js';

/** A floor below a lamp at 60 degrees, 2 away; its half covered by a box, seen from above. */
const scene = (attributes: string): string =>
  `<phong-viewer alt="A floor" geometry="plane" theta="0" phi="30" radius="4" target="0 0 0" ka="255" kd="200" ks="255" probe-at="0 0 0" ${attributes}>
     <phong-light name="lamp" position="1.7320508 1 0 1" ambient="51" diffuse="204" specular="128" attenuation="1 0 0.75"></phong-light></phong-viewer>`;

const box = (viewer: Locator): Locator => viewer.locator('[part=probe]');

test('`formula` puts the numbers of the point into the equation; `probe` alone keeps the table', async ({
  mount,
}) => {
  const viewer = await mount(scene('probe="formula"'));
  const lines = box(viewer).getByRole('listitem');
  await expect(lines.filter({ hasText: 'lamp · diffuse' }).locator('math').nth(1)).toHaveText(
    '=0.78·0.80·0.25·0.50',
  );
  await expect(lines.filter({ hasText: 'lamp · diffuse' }).locator('math').nth(2)).toHaveText(
    '=0.08',
  );
  await expect(box(viewer).getByRole('table')).toHaveCount(0);
  expect(await viewer.evaluate((element: PhongViewer) => element.probe)).toBe('formula');
  await assign(viewer, { probe: true });
  await expect(box(viewer).getByRole('table')).toBeVisible();
  await assign(viewer, { probe: 'formula', shading: 'gouraud' });
  await expect(box(viewer).getByRole('table'), 'corners have no equation here').toBeVisible();
});

test('`ask` hides results, judges by keyboard, reports `answer`, then shows', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene('probe="ask"'));
  await expect(box(viewer)).not.toContainText('0.078');
  await expect(box(viewer).locator('.codes')).toBeHidden();
  const answers = await viewer.evaluateHandle((element: PhongViewer) => {
    const list: unknown[] = [];
    element.addEventListener('answer', ({ detail }) =>
      list.push({ ...detail, light: detail.light?.name }),
    );
    return list;
  });
  const field = box(viewer).getByRole('textbox', { name: 'lamp · diffuse' });
  const row = box(viewer).getByRole('listitem').filter({ hasText: 'lamp · diffuse' });
  await field.focus();
  await page.keyboard.type('0.314');
  await page.keyboard.press('Enter');
  await expect(row.getByRole('status')).toHaveText('That is the value without att.');
  await expect(field, 'it keeps the focus').toBeFocused();
  await field.fill('0,078');
  await page.keyboard.press('Enter');
  await expect(row.getByRole('status')).toHaveText('Right.');
  const same = {
    term: 'diffuse',
    light: 'lamp',
    channel: null,
    expected: expect.closeTo(0.0784, 3) as unknown,
  };
  expect(await answers.jsonValue()).toEqual([
    { ...same, text: '0.314', value: 0.314, correct: false, mistake: 'left-out' },
    { ...same, text: '0,078', value: 0.078, correct: true, mistake: null },
  ]);
  await row.getByRole('button', { name: 'Show' }).click();
  await expect(box(viewer)).toContainText('=0.08');
});

test('a copy that has no clipboard says so, and shows the text selected', async ({
  page,
  mount,
}) => {
  await page.addInitScript(() => {
    const written: string[] = [];
    Reflect.set(window, 'written', written);
    let refuses = true;
    Reflect.set(window, 'allow', () => (refuses = false));
    Object.defineProperty(Navigator.prototype, 'clipboard', {
      get: () =>
        refuses ? undefined : { writeText: (text: string) => Promise.resolve(written.push(text)) },
    });
  });
  const viewer = await mount(scene('probe="formula"'));
  const [first, button] = ['Copy as text', 'Copy as LaTeX'].map((name) =>
    box(viewer).locator('p button').filter({ hasText: name }),
  );
  await expect(box(viewer).getByRole('textbox')).toHaveCount(0);
  const latex = (await button!.elementHandle())!;
  await button!.click();
  await expect.poll(() => latex.textContent()).toBe('select and copy below');
  const field = box(viewer).getByRole('textbox', { name: 'Copy as LaTeX' });
  await expect(field).toBeFocused();
  const selected = await field.evaluate((area: HTMLTextAreaElement) =>
    area.value.slice(area.selectionStart, area.selectionEnd),
  );
  expect(selected).toContain('\\cdot');
  await expect.poll(() => latex.textContent()).toBe('Copy as LaTeX');

  await page.evaluate(() => (Reflect.get(window, 'allow') as () => void)());
  const text = (await first!.elementHandle())!;
  await first!.click();
  await expect.poll(() => text.textContent()).toBe('copied ✓');
  await expect(field).toHaveCount(0);
  expect(await page.evaluate(() => Reflect.get(window, 'written') as string[])).toHaveLength(1);
});

test('`explain` says what `shadeAt` says, of hidden points and outside the picture too', async ({
  mount,
}) => {
  const viewer = await mount(scene(''));
  const [drawn, pixel, hidden, away, none] = await viewer.evaluate(async (element: PhongViewer) => {
    const red = async (point: [number, number, number]): Promise<number | null> =>
      (await element.explain(point))?.sum[0] ?? null;
    const [x, y] = [element.clientWidth / 2, element.clientHeight / 2];
    const drawn = await red([0, 0, 0]);
    const pixel = (await element.shadeAt(x, y, { exact: true }))?.sum[0] ?? null;
    element.insertAdjacentHTML(
      'beforeend',
      '<phong-mesh geometry="box" position="0 1 0" scale="0.2"></phong-mesh>',
    );
    await element.ready;
    const hidden = await red([0, 0, 0]);
    element.target = [30, 0, 0];
    return [drawn, pixel, hidden, await red([0, 0, 0]), await red([0, 5, 0])];
  });
  expect(drawn).toBeCloseTo(pixel!, 9);
  expect(hidden).toBe(drawn);
  expect(away, 'from another eye').not.toBeNull();
  expect(none).toBeNull();
  for (const [point, name] of [
    [[0, 0], 'TypeError'],
    [[0, NaN, 0], 'RangeError'],
  ] as const) {
    expect(
      await viewer.evaluate(
        (element: PhongViewer, wrong) =>
          element.explain(wrong as never).catch((error: Error) => error.name),
        point,
      ),
    ).toBe(name);
  }
});

test('`probe-change` is the same with and without `probe`, and inside CSS zoom', async ({
  mount,
}) => {
  const viewer = await mount(scene(''), { css: 'phong-viewer { zoom: 2 }' });
  const { without, boxes, probed, gone } = await viewer.evaluate(async (element: PhongViewer) => {
    type Detail = PhongViewerEventMap['probe-change']['detail'];
    const next = (change: object): Promise<Detail> =>
      new Promise((resolve) => {
        element.addEventListener('probe-change', ({ detail }) => resolve(detail), { once: true });
        Object.assign(element, change);
      });
    const told = ({ fragment, x, y }: Detail): readonly number[] => [
      fragment!.kd[0],
      Math.round(x!),
      Math.round(y!),
    ];
    const without = told(await next({ kd: [100, 100, 100] }));
    const boxes = element.shadowRoot!.querySelectorAll('[part=probe]').length;
    const probed = told(await next({ probe: true }));
    element.probe = false;
    element.style.display = 'none';
    return { without, boxes, probed, gone: await next({ kd: [90, 90, 90] }) };
  });
  expect(without[0]).toBeCloseTo(100 / 255, 6);
  expect(without).toEqual(probed);
  expect(boxes).toBe(0);
  expect(gone).toEqual({ fragment: null, x: null, y: null, pinned: true });
});
