// Can everything that the panel does be undone, and do copies, order and files work?

import { fileURLToPath } from 'node:url';
import type { Locator, Page } from '@playwright/test';
import { type ViewerLocator, expect, test } from '../../support/test.js';
import {
  assign,
  cameraOf,
  drag,
  type PhongLight,
  type PhongMesh,
  htmlOf,
} from '../../element/support/viewer.js';
import {
  button,
  choice,
  field,
  flag,
  folderOf,
  opened,
  panelOf,
  picker,
  slider,
  titleOf,
} from './panel-rows.js';

const scene = `<phong-viewer gui geometry="box" theta="20" phi="60">
  <phong-light name="sun"></phong-light>
  <div id="rig"><phong-light name="lamp" id="lamp" position="1 2 3 1"></phong-light></div>
  <phong-light name="spot" position="0 3 3 1" axis="0 -1 -1" aperture="20"></phong-light>
</phong-viewer>`;

const names = (viewer: ViewerLocator) =>
  viewer.evaluate((element) => element.lights.map(({ name }) => name));
const undo = (viewer: ViewerLocator) => button(panelOf(viewer), 'undo').click();
const redo = (viewer: ViewerLocator) => button(panelOf(viewer), 'redo').click();
const lamp = (viewer: ViewerLocator): Promise<Pick<PhongLight, 'diffuse' | 'position' | 'name'>> =>
  viewer.evaluate((element) => {
    const { diffuse, position, name } = element.lights.find(({ id }) => id === 'lamp')!;
    return { diffuse, position, name };
  });

async function dragAcross(page: Page, control: Locator, pixels: number) {
  await control.scrollIntoViewIfNeeded();
  const { x, y, width } = (await control.boundingBox())!;
  await drag(page, [x + width / 2, y + 8], [pixels, 0], { steps: 6 });
}

test.describe('undo', () => {
  test('reverts a drag of a slider or a field as one step, and keeps later script changes', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene);
    const folder = await opened(viewer, 'lamp');
    await dragAcross(page, slider(folder, 'diffuse brightness'), 20);
    await dragAcross(page, slider(folder, 'diffuse brightness'), 10);
    await dragAcross(page, field(folder, 'position x'), 30);
    const last = await lamp(viewer);
    await undo(viewer);
    expect((await lamp(viewer)).position).toEqual([1, 2, 3, 1]);
    await undo(viewer);
    await undo(viewer);
    expect((await lamp(viewer)).diffuse).toEqual([255, 255, 255]);
    await expect(button(panelOf(viewer), 'undo')).toHaveAttribute('aria-disabled', 'true');
    for (let steps = 0; steps < 3; steps++) {
      await redo(viewer);
    }
    expect(await lamp(viewer)).toEqual(last);
    await expect(button(panelOf(viewer), 'redo')).toHaveAttribute('aria-disabled', 'true');
    await expect(field(folder, 'position x')).toHaveValue(String(last.position[0]));
    await assign(viewer.locator('#lamp'), { diffuse: [1, 2, 3] });
    await undo(viewer);
    expect(await lamp(viewer)).toEqual({
      diffuse: [1, 2, 3],
      position: [1, 2, 3, 1],
      name: 'lamp',
    });
  });

  test('reverts text, colours, switches, kinds and a reset, down to the same markup', async ({
    mount,
  }) => {
    const viewer = await mount(scene);
    const html = () => htmlOf(viewer);
    const texts = [await html()];
    const folder = await opened(viewer, 'lamp');
    const surface = await opened(viewer, 'Material');
    for (const act of [
      () => field(folder, 'name').fill('moon'),
      () => field(folderOf(viewer, 'moon'), 'diffuse').fill('orange'),
      () => picker(folderOf(viewer, 'moon'), 'specular').fill('#102030'),
      () => flag(folderOf(viewer, 'sun'), 'sun active').click(),
      () => choice(folderOf(viewer, 'moon'), 'kind').selectOption('spot'),
      () => field(surface, 'shininess').fill('7'),
      () => button(surface, 'reset material').click(),
    ]) {
      await act();
      texts.push(await html());
    }
    for (const text of texts.slice(0, -1).reverse()) {
      await undo(viewer);
      expect(await html()).toBe(text);
    }
    for (const text of texts.slice(1)) {
      await redo(viewer);
      expect(await html()).toBe(text);
    }
  });

  test('restores the previous camera, not the declared one', async ({ page, mount }) => {
    const viewer = await mount(scene);
    const folder = await opened(viewer, 'Camera');
    await button(folder, 'reset camera').click();
    await expect(button(panelOf(viewer), 'undo'), 'nothing has moved').toHaveAttribute(
      'aria-disabled',
      'true',
    );
    await drag(page, [100, 100], [60, 20]);
    const dragged = await cameraOf(viewer);
    await field(folder, 'θ azimuth °').fill('100');
    await field(folder, 'target x').fill('1');
    await button(folder, 'reset camera').click();
    expect((await cameraOf(viewer)).theta).toBe(20);
    await undo(viewer);
    expect(await cameraOf(viewer)).toMatchObject({ theta: 100, target: [1, 0, 0] });
    await undo(viewer);
    await undo(viewer);
    expect(await cameraOf(viewer)).toEqual(dragged);
    await expect(viewer).toHaveJSProperty('theta', 20);
  });

  test('works by Ctrl+Z, Ctrl+Shift+Z and Ctrl+Y in panel and picture, not in text fields', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene);
    const folder = await opened(viewer, 'lamp');
    await viewer.evaluate((element) =>
      element.insertAdjacentHTML(
        'beforeend',
        '<p slot="error"><button>b</button><input value="text"></p>',
      ),
    );
    const x = async () => (await lamp(viewer)).position[0];
    await field(folder, 'position x').fill('5');
    for (const [place, keys, expected] of [
      [field(folder, 'position x'), 'Control+z', 1],
      [field(folder, 'position x'), 'Control+Shift+z', 5],
      [viewer.locator('[part=surface]'), 'Meta+z', 1],
      [viewer.locator('[part=surface]'), 'Meta+Shift+z', 5],
    ] as const) {
      await place.press(keys);
      expect(await x(), keys).toBe(expected);
    }
    // The slot is not shown, so these cannot have the focus.
    for (const [place, init, expected] of [
      ['p input', { key: 'z', ctrlKey: true }, 5],
      ['p button', { key: 'z', metaKey: true }, 1],
      ['p button', { key: 'y', ctrlKey: true }, 5],
    ] as const) {
      await viewer.locator(place).evaluate((element, keys) => {
        const event = { ...keys, bubbles: true, composed: true, cancelable: true };
        element.dispatchEvent(new KeyboardEvent('keydown', event));
      }, init);
      expect(await x(), `${init.key} in ${place}`).toBe(expected);
    }
    await field(folder, 'name').focus();
    await page.keyboard.type('ab');
    await page.keyboard.press('Control+z');
    expect(await x()).toBe(5);
    await titleOf(viewer, 'Camera').focus();
    await page.keyboard.press('Control+z');
    expect((await lamp(viewer)).name).toBe('lamp');
    await assign(viewer, { gui: false });
    await viewer.locator('[part=surface]').press('Control+z');
    expect(await x()).toBe(5);
  });
});

test.describe('lights', () => {
  test('are duplicated with their current values and a new name', async ({ mount }) => {
    const viewer = await mount(scene);
    const folder = await opened(viewer, 'lamp');
    await field(folder, 'diffuse').fill('#123');
    await button(folder, 'duplicate').click();
    expect(await names(viewer)).toEqual(['sun', 'lamp', 'lamp 2', 'spot']);
    await expect(titleOf(viewer, 'lamp 2')).toBeFocused();
    const copy = await viewer.evaluate((element) => {
      const { id, parentElement, diffuse, position } = element.lights[2]!;
      return { id, parent: parentElement?.id, diffuse, position };
    });
    expect(copy).toEqual({ id: '', parent: 'rig', diffuse: [17, 34, 51], position: [1, 2, 3, 1] });
    await undo(viewer);
    expect(await names(viewer)).toEqual(['sun', 'lamp', 'spot']);
    await redo(viewer);
    await expect(titleOf(viewer, 'lamp 2')).toBeVisible();
  });

  test('are reordered, renamed and removed by buttons and keys, and keep the focus', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene);
    const folder = await opened(viewer, 'spot');
    await button(folder, 'move up').click();
    expect(await names(viewer)).toEqual(['sun', 'spot', 'lamp']);
    await expect(button(folder, 'move up')).toBeFocused();
    await titleOf(viewer, 'lamp').focus();
    await page.keyboard.press('Alt+ArrowUp');
    await page.keyboard.press('Alt+ArrowUp');
    expect(await names(viewer)).toEqual(['lamp', 'sun', 'spot']);
    await expect(titleOf(viewer, 'lamp')).toBeFocused();
    await page.keyboard.press('Alt+ArrowUp');
    await page.keyboard.press('Alt+ArrowDown');
    expect(await names(viewer)).toEqual(['sun', 'lamp', 'spot']);
    for (let steps = 0; steps < 4; steps++) {
      await page.keyboard.press('Control+z');
    }
    expect(await names(viewer)).toEqual(['sun', 'lamp', 'spot']);
    expect(await viewer.locator('#rig > #lamp').count()).toBe(1);
    await titleOf(viewer, 'spot').focus();
    await page.keyboard.press('F2');
    await page.keyboard.type('beam');
    await expect(titleOf(viewer, 'beam')).toBeVisible();
    await titleOf(viewer, 'beam').focus();
    await page.keyboard.press('Delete');
    expect(await names(viewer)).toEqual(['sun', 'lamp']);
    await page.keyboard.press('Control+z');
    expect(await names(viewer)).toEqual(['sun', 'lamp', 'beam']);
  });
});

test('meshes are renamed, duplicated, reordered and removed', async ({ mount }) => {
  const viewer =
    await mount(`<phong-viewer gui><phong-mesh geometry="box" name="cube" kd="#f00"></phong-mesh>
    <phong-mesh geometry="sphere" name="ball"></phong-mesh></phong-viewer>`);
  await opened(viewer, 'Meshes');
  const meshes = () =>
    viewer.evaluate((element) => element.meshes.map(({ name, geometry }) => [name, geometry]));
  const cube = await opened(viewer, 'cube');
  await button(cube, 'duplicate').click();
  await field(folderOf(viewer, 'cube 2'), 'name').fill('die');
  await button(folderOf(viewer, 'die'), 'move down').click();
  await button(cube, 'remove').click();
  expect(await meshes()).toEqual([
    ['ball', 'sphere'],
    ['die', 'box'],
  ]);
  for (let steps = 0; steps < 4; steps++) {
    await undo(viewer);
  }
  expect(await meshes()).toEqual([
    ['cube', 'box'],
    ['ball', 'sphere'],
  ]);
});

test('a model file can be chosen for a mesh and for the viewer', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/is a file on this device/, 1);
  const viewer = await mount(
    '<phong-viewer gui droppable><phong-mesh geometry="box"></phong-mesh></phong-viewer>',
  );
  const file = fileURLToPath(new URL('../../fixtures/models/textured.glb', import.meta.url));
  await opened(viewer, 'Meshes');
  const folder = await opened(viewer, 'box');
  const choose = async (name: string) => {
    const dialog = page.waitForEvent('filechooser');
    await button(panelOf(viewer), name).click();
    await (await dialog).setFiles(file);
  };
  await choose('choose model file…');
  await expect(titleOf(viewer, 'textured.glb')).toBeVisible();
  await expect.poll(() => viewer.evaluate((element) => element.loaded)).toBe(true);
  const html = await htmlOf(viewer);
  expect(html).toContain('src="textured.glb"');
  await expect(folder).toBeHidden();
  await undo(viewer);
  expect(await viewer.evaluate((element) => (element.meshes[0] as PhongMesh).src)).toBe('');
  await choose('open model…');
  await expect.poll(() => viewer.evaluate((element) => element.src instanceof File)).toBe(true);
});
