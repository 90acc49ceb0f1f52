// Do the folders for shading, for the viewer's own material and for its meshes work?

import { type ViewerLocator, expect, test } from '../../support/test.js';
import { type PhongMesh, type PhongViewer } from '../../element/support/viewer.js';
import { button, choice, field, flag, opened, picker, slider } from './panel-rows.js';

const own = '<phong-viewer gui geometry="box" kd="200 0 0"></phong-viewer>';

const valuesOf = (viewer: ViewerLocator, ...keys: (keyof PhongViewer)[]): Promise<unknown[]> =>
  viewer.evaluate((element, names) => names.map((name) => element[name]), keys);

test('writes and follows shading, reflection, terms, colour space and antialiasing', async ({
  mount,
}) => {
  const viewer = await mount(own);
  const folder = await opened(viewer, 'Shading');
  await choice(folder, 'shading').selectOption('gouraud');
  await choice(folder, 'reflection').selectOption('blinn-phong');
  await flag(folder, 'diffuse term').click();
  await choice(folder, 'colour space').selectOption('linear');
  await choice(folder, 'antialias').selectOption('full');
  const keys = ['shading', 'reflection', 'terms', 'colorInterpolation', 'antialias'] as const;
  expect(await valuesOf(viewer, ...keys)).toEqual([
    'gouraud',
    'blinn-phong',
    ['ambient', 'specular'],
    'linear',
    'full',
  ]);
  await viewer.evaluate((element) => {
    element.setAttribute('shading', 'flat');
    element.setAttribute('terms', 'diffuse');
  });
  await expect(choice(folder, 'shading')).toHaveValue('flat');
  await expect(flag(folder, 'diffuse term')).toBeChecked();
  await expect(flag(folder, 'ambient term')).not.toBeChecked();
});

test("edits and shows the viewer's own material, its shininess in fine steps where it is small", async ({
  mount,
}) => {
  const viewer = await mount(own);
  const folder = await opened(viewer, 'Material');
  await expect(field(folder, 'kd')).toHaveValue('200 0 0');
  await expect(picker(folder, 'kd')).toHaveValue('#c80000');
  await picker(folder, 'kd').fill('#00ff00');
  await slider(folder, 'ks brightness').fill('1');
  await slider(folder, 'shininess').fill('0.5');
  const [shininess] = await valuesOf(viewer, 'shininess');
  expect(Math.abs(Number(shininess) - 1250)).toBeLessThan(750);
  await field(folder, 'shininess').fill('1000000');
  expect(await valuesOf(viewer, 'kd', 'ks', 'shininess')).toEqual([
    [0, 255, 0],
    [255, 255, 255],
    1e6,
  ]);
  await expect(slider(folder, 'shininess')).toHaveValue('1');
  await slider(folder, 'shininess').fill('0');
  expect(await valuesOf(viewer, 'shininess')).toEqual([0]);
  await button(folder, 'reset material').click();
  expect(await valuesOf(viewer, 'kd', 'ks', 'shininess')).toEqual([
    [200, 200, 200],
    [128, 128, 128],
    32,
  ]);
  await expect(field(folder, 'shininess')).toHaveValue('32');
});

test("edits and shows a mesh's surface, style and transform", async ({ mount }) => {
  const viewer = await mount(
    '<phong-viewer gui><phong-mesh geometry="sphere" kd="#c33"></phong-mesh></phong-viewer>',
  );
  const mesh = viewer.locator('phong-mesh').first();
  await opened(viewer, 'Meshes');
  const folder = await opened(viewer, 'sphere');
  await picker(folder, 'ka').fill('#010203');
  await choice(folder, 'shading').selectOption('flat');
  await choice(folder, 'reflection').selectOption('blinn-phong');
  await field(folder, 'position x').fill('1.5');
  await field(folder, 'rotation ° y').fill('45');
  await field(folder, 'scale z').fill('-2');
  const read = () =>
    mesh.evaluate(({ ka, kd, shading, reflection, position, rotation, scale }: PhongMesh) => ({
      ka,
      kd,
      shading,
      reflection,
      position,
      rotation,
      scale,
    }));
  expect(await read()).toEqual({
    ka: [1, 2, 3],
    kd: [204, 51, 51],
    shading: 'flat',
    reflection: 'blinn-phong',
    position: [1.5, 0, 0],
    rotation: [0, 45, 0],
    scale: [1, 1, -2],
  });
  await choice(folder, 'shading').selectOption('as viewer');
  expect((await read()).shading).toBeNull();
  await mesh.evaluate((element) => element.setAttribute('rotation', '10 20 30'));
  await expect(field(folder, 'rotation ° z')).toHaveValue('30');
});
