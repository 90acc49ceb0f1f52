// Do a light's folder and its element agree? Each row writes the element, and each write to the
// element shows in the row.

import type { Locator } from '@playwright/test';
import { type ViewerLocator, expect, test } from '../../support/test.js';
import { assign, drag, type PhongLight } from '../../element/support/viewer.js';
import {
  button,
  choice,
  field,
  flag,
  folderOf,
  opened,
  panelOf,
  row,
  slider,
  titleOf,
  titlesIn,
} from './panel-rows.js';

const scene = (...lights: readonly string[]) =>
  `<phong-viewer gui geometry="box" target="0 0 0">${lights.join('')}</phong-viewer>`;
const lamp = '<phong-light name="lamp" position="1 2 3 1" diffuse="400 200 0"></phong-light>';
const sun = '<phong-light name="sun" position="1 1 1 0"></phong-light>';
const spot =
  '<phong-light name="spot" position="0 3 3 1" axis="0 -1 -1" aperture="20" cutoff="12"></phong-light>';

const lightOf = (viewer: ViewerLocator, name: string) =>
  viewer.locator(`phong-light[name=${name}]`);

const read = <K extends keyof PhongLight>(light: Locator, key: K) =>
  light.evaluate((element: PhongLight, name) => element[name as K], key);

test('has a folder for each light, in order, which stays as it is while others come and go', async ({
  mount,
}) => {
  const viewer = await mount(scene(sun, '<phong-light></phong-light>', spot));
  const titles = () => titlesIn(folderOf(viewer, 'Lights'));
  await expect.poll(titles).toEqual(['sun', 'light 2', 'spot']); // the panel's code comes with its first use
  await opened(viewer, 'sun');
  const before = await folderOf(viewer, 'sun').elementHandle();
  await assign(lightOf(viewer, 'spot'), { name: 'beam' });
  await expect.poll(titles).toEqual(['sun', 'light 2', 'beam']);
  await viewer.evaluate((element) => {
    element.prepend(element.lights[1]!);
    element.lights.find(({ name }) => name === 'beam')!.remove();
    element.append(document.createElement('phong-light'));
  });
  await expect.poll(titles).toEqual(['light 1', 'sun', 'light 3']);
  await expect(titleOf(viewer, 'sun')).toHaveAttribute('aria-expanded', 'true');
  await expect(titleOf(viewer, 'light 3')).toHaveAttribute('aria-expanded', 'false');
  expect(await folderOf(viewer, 'sun').evaluate((node, old) => node === old, before)).toBe(true);
});

test('writes every attribute of a light through its properties', async ({ mount }) => {
  const viewer = await mount(scene(spot));
  const light = lightOf(viewer, 'spot');
  const folder = await opened(viewer, 'spot');
  await flag(folder, 'active').click();
  await field(folder, 'ambient').fill('16 32 48');
  await slider(folder, 'specular brightness').fill('0.5');
  await field(folder, 'position x').fill('-1.25');
  await field(folder, 'axis y').fill('-2');
  await field(folder, 'aperture °').fill('33');
  await slider(folder, 'aperture °').fill('40');
  await field(folder, 'cutoff').fill('7');
  await field(folder, 'kq quadratic').fill('0.25');
  await choice(folder, 'space').selectOption('camera');
  const expected = {
    active: false,
    ambient: [16, 32, 48],
    specular: [127.5, 127.5, 127.5],
    position: [-1.25, 3, 3, 1],
    axis: [0, -2, -1],
    aperture: 40,
    cutoff: 7,
    attenuation: [1, 0, 0.25],
    space: 'camera',
  };
  for (const [key, value] of Object.entries(expected)) {
    expect(await read(light, key as keyof typeof expected), key).toEqual(value);
  }
  await field(folder, 'name').fill('beam');
  await expect(titleOf(viewer, 'beam')).toBeVisible();
  expect(await viewer.evaluate((element) => element.lights[0]!.name)).toBe('beam');
});

test('shows changes of attributes and properties', async ({ mount }) => {
  const viewer = await mount(scene(lamp));
  const light = lightOf(viewer, 'lamp');
  const folder = await opened(viewer, 'lamp');
  await light.evaluate((element) =>
    element.setAttribute('position', '0.1 0.30000000000000004 1e-7 1'),
  );
  await expect(field(folder, 'position x')).toHaveValue('0.1');
  await expect(field(folder, 'position y')).toHaveValue('0.3');
  await expect(field(folder, 'position z')).toHaveValue('1e-7');
  await assign(light, {
    active: false,
    diffuse: [0, 0, 255],
    space: 'camera',
    attenuation: [1, 0.5, 0],
  });
  await expect(flag(folder, 'active')).not.toBeChecked();
  await expect(field(folder, 'diffuse')).toHaveValue('0 0 255');
  await expect(choice(folder, 'space')).toHaveValue('camera');
  await expect(field(folder, 'kl linear')).toHaveValue('0.5');
  await light.evaluate((element) => element.removeAttribute('position'));
  await expect(choice(folder, 'kind')).toHaveValue('directional');
  await titleOf(viewer, 'lamp').click();
  const toggle = flag(folderOf(viewer, 'lamp'), 'lamp active');
  await expect(toggle).not.toBeChecked();
  await toggle.click();
  expect(await read(light, 'active')).toBe(true);
  await expect(titleOf(viewer, 'lamp'), 'stays closed').toHaveAttribute('aria-expanded', 'false');
});

test('colours are accepted in all spellings, and stay as typed', async ({ mount }) => {
  const viewer = await mount(scene(lamp));
  const diffuse = field(await opened(viewer, 'lamp'), 'diffuse');
  for (const [text, value] of [
    ['200 80 60', [200, 80, 60]],
    ['200, 80.5, 60', [200, 80.5, 60]],
    ['#c85', [204, 136, 85]],
    ['orange', [255, 165, 0]],
    ['128', [128, 128, 128]],
    ['1020 510 0', [1020, 510, 0]],
  ] as const) {
    await diffuse.fill(text);
    expect(await read(lightOf(viewer, 'lamp'), 'diffuse')).toEqual(value);
    await diffuse.blur();
    await expect(diffuse).toHaveValue(text);
  }
  await assign(lightOf(viewer, 'lamp'), { diffuse: [1, 2, 3] });
  await expect(diffuse).toHaveValue('1 2 3');
});

test.describe('kind', () => {
  test('shows only the rows that have an effect', async ({ mount }) => {
    const viewer = await mount(scene(lamp));
    const folder = await opened(viewer, 'lamp');
    const shown = async () =>
      Promise.all(
        ['axis', 'aperture °', 'cutoff', 'attenuation'].map((name) =>
          row(folder, name).isVisible(),
        ),
      );
    expect(await shown()).toEqual([false, false, false, true]);
    await choice(folder, 'kind').selectOption('spot');
    await expect.poll(shown).toEqual([true, true, true, true]);
    await choice(folder, 'kind').selectOption('directional');
    await expect.poll(shown).toEqual([false, false, false, false]);
  });

  test('keeps the aperture row while the user opens the cone with it', async ({ mount }) => {
    const viewer = await mount(scene(spot.replace('cutoff="12"', '')));
    const folder = await opened(viewer, 'spot');
    await field(folder, 'aperture °').fill('180');
    await expect(choice(folder, 'kind')).toHaveValue('point');
    await expect(field(folder, 'aperture °')).toBeFocused();
    await field(folder, 'aperture °').fill('15');
    await expect(choice(folder, 'kind')).toHaveValue('spot');
  });
});

test.describe('numbers', () => {
  test('refuse what the light refuses, return to its value, and are updated after typing', async ({
    mount,
  }) => {
    const viewer = await mount(scene(spot));
    const folder = await opened(viewer, 'spot');
    const aperture = field(folder, 'aperture °');
    for (const text of ['181', '-1', 'wide', '']) {
      await aperture.fill(text);
      await expect(aperture).toHaveAttribute('aria-invalid', 'true');
    }
    expect(await read(lightOf(viewer, 'spot'), 'aperture')).toBe(20);
    await aperture.press('Enter');
    await expect(aperture).toHaveValue('20');
    await expect(aperture).not.toHaveAttribute('aria-invalid');
    const x = field(folder, 'position x');
    await x.fill('-');
    await assign(lightOf(viewer, 'spot'), { position: [7, 8, 9, 1] });
    await expect(field(folder, 'position y')).toHaveValue('8');
    await expect(x).toHaveValue('-');
    await x.blur();
    await expect(x).toHaveValue('7');
  });

  test('follow a drag of a slider or across the field, which ends exactly where it began', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene(spot));
    const light = lightOf(viewer, 'spot');
    const folder = await opened(viewer, 'spot');
    const rowOf = (axis: string) => field(folder, `position ${axis}`).boundingBox();
    const boxes = await Promise.all(['x', 'y', 'z'].map(rowOf));
    expect(new Set(boxes.map((box) => box?.y)).size, 'a vector has one row').toBe(1);
    await drag(page, [boxes[2]!.x + 20, boxes[2]!.y + 8], [2, -12]); // up or down scrolls
    expect(await read(light, 'position')).toEqual([0, 3, 3, 1]);
    const { x, y } = boxes[1]!;
    await page.mouse.move(x + 20, y + 8);
    await page.mouse.down();
    await page.mouse.move(x + 40, y + 8, { steps: 4 });
    expect((await read(light, 'position'))[1]).toBeGreaterThan(3);
    await page.mouse.move(x + 20, y + 8, { steps: 4 });
    expect(await read(light, 'position')).toEqual([0, 3, 3, 1]);
    await page.mouse.up();
    await expect(field(folder, 'position y')).not.toBeFocused();
    await field(folder, 'position y').click();
    await expect(field(folder, 'position y')).toBeFocused();
    expect(await read(light, 'position')).toEqual([0, 3, 3, 1]);

    const aperture = slider(folder, 'aperture °');
    await aperture.scrollIntoViewIfNeeded();
    const box = (await aperture.boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + 8);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width - 1, box.y + 8, { steps: 5 });
    expect(await aperture.inputValue()).toBe('180');
    expect(await read(light, 'aperture')).toBe(180);
    await assign(light, { aperture: 10 });
    await expect(field(folder, 'aperture °')).toHaveValue('10');
    expect(await aperture.inputValue()).toBe('180');
    await page.mouse.up();
    await expect(aperture).toHaveValue('10');
  });
});

test('a field that is removed under the pointer leaves no trace of its drag', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene(spot).replace('gui', 'gui="position"'));
  const { x, y } = (await field(panelOf(viewer), 'position y').boundingBox())!;
  await drag(page, [x + 20, y + 8], [5, 0], { release: false });
  await viewer.evaluate((element) => element.append(document.createElement('phong-light')));
  await expect(panelOf(viewer).getByText('position')).toHaveCount(2);
  await page.mouse.up();
  const start = () => document.body.dispatchEvent(new Event('dragstart', { cancelable: true }));
  expect(await page.evaluate(start), 'the page drags again').toBe(true);
});

test('an added light can be edited at once; a removed one gives the focus to the next', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene(sun, spot));
  await button(folderOf(viewer, 'Lights'), 'add light').click();
  await expect(titleOf(viewer, 'light 3')).toHaveAttribute('aria-expanded', 'true');
  await expect(titleOf(viewer, 'light 3')).toBeFocused();
  await expect(field(folderOf(viewer, 'light 3'), 'name')).toHaveAttribute(
    'placeholder',
    'light 3',
  );
  await button(folderOf(viewer, 'Lights'), 'add light').click();
  const added = await viewer.evaluate((element) =>
    element.lights
      .slice(2)
      .map(({ localName, position, active }) => ({ localName, position, active })),
  );
  expect(added).toHaveLength(2);
  for (const light of added) {
    expect(light).toMatchObject({ localName: 'phong-light', active: true });
  }
  expect(added[0]?.position).not.toEqual(added[1]?.position);
  await expect(page.locator('phong-viewer > phong-light')).toHaveCount(4);
  await button(await opened(viewer, 'sun'), 'remove').click();
  expect(await titlesIn(folderOf(viewer, 'Lights'))).toEqual(['spot', 'light 2', 'light 3']);
  await expect(titleOf(viewer, 'spot')).toBeFocused();
  await expect(page.locator('phong-viewer > phong-light')).toHaveCount(3);
});

test('builds the rows of many lights only when their folders are opened', async ({ mount }) => {
  const many = Array.from({ length: 60 }, (_, i) => `<phong-light name="n${i}"></phong-light>`);
  // From far away, because this test does not look at pixels under sixty lights.
  const viewer = await mount(scene(...many).replace('gui', 'gui radius="300"'));
  const lights = folderOf(viewer, 'Lights');
  await expect(lights.locator('.lil-gui')).toHaveCount(60);
  expect(await lights.locator('.lil-controller').count()).toBe(1);
  const folder = await opened(viewer, 'n30');
  await expect(field(folder, 'position x')).toHaveValue('1');
  expect(await lights.locator('.lil-controller').count()).toBeLessThan(40);
});
