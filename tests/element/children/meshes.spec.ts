// Do meshes match the markup, however it was created and changed? Pictures are compared with those of the same scene in
// markup, with a declared camera, so that no refit hides a difference.

import { readFileSync } from 'node:fs';
import { compare, expect, pixels, test, type Picture } from '../../support/test.js';
import { drawUntilSpecialised } from '../frames/driving.js';
import { logGl } from '../support/gl-log.js';
import { assign, type PhongViewer, record, settled } from '../support/viewer.js';
import { different, same, shown, size } from './plane-scene.js';

const open = '<phong-viewer theta="20" phi="60" radius="3" target="0 0 0">';
const light = '<phong-light position="0.6 1 1.2 0" ambient="60" diffuse="120"></phong-light>';
const scene = (...meshes: readonly string[]): string => `${open}${light}${meshes.join('')}</phong-viewer>`;

test('of meshes at one place the last one in document order is visible, with any program', async ({ page, mount }) => {
  await logGl(page);
  const red = '<phong-mesh geometry="sphere" kd="200 40 40"></phong-mesh>';
  const green = red.replace('200 40', '40 200');
  const blue = red.replace('200 40 40', '40 40 200');
  const viewer = await mount(scene(red, green), size);
  const wanted = { red: await shown(page, scene(red)), green: await shown(page, scene(green)) };
  different(wanted.red, wanted.green);
  same(await pixels(viewer), wanted.green);
  await viewer.evaluate((element: PhongViewer) => element.append(element.meshes[0]!));
  same(await pixels(viewer), wanted.red);
  await viewer.evaluate((element, html) => element.insertAdjacentHTML('afterbegin', html), blue);
  same(await pixels(viewer), wanted.red);
  await viewer.evaluate((element: PhongViewer) => (element.meshes[1]!.shading = 'gouraud'));
  await viewer.evaluate((element: PhongViewer) => (element.meshes[1]!.shading = null));
  await drawUntilSpecialised(page);
  expectAlike(await pixels(viewer), wanted.red, 'by programs of their own');
  await viewer.evaluate((element: PhongViewer) => (element.meshes[0]!.kd = [40, 40, 180]));
  expectAlike(await pixels(viewer), wanted.red, 'one of them changed');
});

test('of blended meshes at one place the last one in document order lies over the others', async ({ page, mount }) => {
  const file = readFileSync(new URL('../../fixtures/models/mask.glb', import.meta.url), 'latin1');
  const blended = file.replace(/"MASK"(.*?) (?= *[^ ]{4}BIN)/s, '"BLEND"$1'); // a space less keeps its length
  expect(blended).toHaveLength(file.length);
  await page.route('**/blended.glb', (route) => route.fulfill({ body: Buffer.from(blended, 'latin1') }));
  const red = '<phong-mesh src="/blended.glb" kd="255 0 0"></phong-mesh>';
  const green = red.replace('255 0', '0 255');
  const viewer = await mount(scene(red, green), size);
  const [first, second] = [await shown(page, scene(red, green)), await shown(page, scene(green, red))];
  different(first, second);
  same(await pixels(viewer), first);
  await viewer.evaluate((element: PhongViewer) => element.append(element.meshes[0]!));
  same(await pixels(viewer), second);
});

/** Other programs may be off by one code on 0.02 % of channels. */
function expectAlike(actual: Picture, wanted: Picture, name: string): void {
  const { max, share } = compare(actual, wanted, 0);
  expect(max, name).toBeLessThanOrEqual(1);
  expect(share, name).toBeLessThanOrEqual(2e-4);
}

test('a mesh takes shading and reflection from the viewer unless it has its own', async ({ page, mount }) => {
  const facets = '<phong-mesh geometry="sphere" segments="8"></phong-mesh>';
  const viewer = await mount(scene(facets), size);
  const flat = await shown(page, scene(facets.replace('<phong-mesh', '<phong-mesh shading="flat"')));
  const smooth = await shown(page, scene(facets));
  different(flat, smooth);
  await assign(viewer, { shading: 'flat' });
  same(await pixels(viewer), flat);
  await assign(viewer.locator('phong-mesh'), { shading: 'phong' });
  same(await pixels(viewer), smooth);
  await assign(viewer.locator('phong-mesh'), { shading: null });
  same(await pixels(viewer), flat);
});

test('a model of a mesh brings its own materials, unless an attribute is given', async ({ page, mount }) => {
  const own = '<phong-mesh src="/fixtures/models/no-normals.glb"></phong-mesh>';
  const viewer = await mount(scene(own), size);
  const plain = await pixels(viewer);
  const red = await shown(page, scene(own.replace('src', 'kd="255 0 0" ka="255 0 0" ks="0" src')));
  different(plain, red);
  await assign(viewer.locator('phong-mesh'), { kd: [255, 0, 0], ka: [255, 0, 0], ks: 0 });
  same(await pixels(viewer), red);
  await assign(viewer.locator('phong-mesh'), { kd: null, ka: undefined, ks: null });
  same(await pixels(viewer), plain);
});

test('a mesh dispatches its own load and error events, and so does the viewer', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/error: Failed to load resource.*404/, 1);
  const viewer = await mount(scene('<phong-mesh></phong-mesh>'), size);
  const mesh = viewer.locator('phong-mesh');
  const own = await record(mesh, 'load', 'error');
  const viewers = await record(viewer, 'load', 'error');
  await assign(mesh, { src: '/fixtures/models/no-normals.glb' });
  await settled(viewer);
  const url = new URL('/fixtures/models/no-normals.glb', page.url()).href;
  expect(await own.take()).toEqual([{ type: 'load', detail: { url, missing: [] } }]);
  expect(await viewers.take()).toEqual([{ type: 'load', detail: { url, missing: [] } }]);
  const before = await pixels(viewer);
  await assign(mesh, { src: '/fixtures/models/none.glb' });
  await settled(viewer);
  const failed = { type: 'error', detail: expect.objectContaining({ code: 'load-failed' }) as unknown };
  expect(await own.take()).toEqual([failed]);
  expect(await viewers.take()).toEqual([failed]);
  same(await pixels(viewer), before);
});
