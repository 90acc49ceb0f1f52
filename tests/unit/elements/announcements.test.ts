// @vitest-environment happy-dom
// What is announced to a screen reader? Only what the user did, once the motion has ended.

import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { PhongViewer } from '../../../src/viewer/index.js';
import { onPage, partOf } from './on-page.js';

const SCENE = `<phong-viewer alt="A box" geometry="box" theta="30" phi="70" radius="4">
    <phong-light name="sun" position="1 2 3 0"></phong-light></phong-viewer>`;

/** Longer than the pause before an announcement. */
const A_WHILE = 1500;

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

const press = (viewer: PhongViewer, key: string) =>
  partOf(viewer, '.surface')!.dispatchEvent(new KeyboardEvent('keydown', { key }));

/** What is said after a while; null if nothing ever was. */
async function said(viewer: PhongViewer) {
  await vi.advanceTimersByTimeAsync(A_WHILE);
  return partOf(viewer, '.reader > [aria-live=polite]')?.textContent ?? null;
}

it('a key or the wheel is announced politely, with the resulting camera', async () => {
  const viewer = await onPage(SCENE);
  expect(await said(viewer)).toBeNull();
  press(viewer, 'ArrowLeft');
  expect(await said(viewer)).toBe('Camera: azimuth 35°, polar angle 70°, distance 4.');
  partOf(viewer, '.surface')!.focus();
  partOf(viewer, '.surface')!.dispatchEvent(new WheelEvent('wheel', { deltaY: 100 }));
  expect(await said(viewer)).toBe('Camera: azimuth 35°, polar angle 70°, distance 4.42.');
  press(viewer, 'Home');
  expect(await said(viewer)).toBe('Camera: azimuth 30°, polar angle 70°, distance 4.');
});

it('a motion of many steps is announced once, when it has ended', async () => {
  const viewer = await onPage(SCENE);
  const texts = new Set<string | null>();
  for (let i = 0; i < 30; i++) {
    press(viewer, 'ArrowLeft');
    await vi.advanceTimersByTimeAsync(17);
    texts.add(partOf(viewer, '[aria-live]')?.textContent ?? '');
  }
  expect([...texts]).toEqual(['']);
  expect(await said(viewer)).toBe('Camera: azimuth −180°, polar angle 70°, distance 4.');
});

it('scripts announce nothing, not even together with user input', async () => {
  const viewer = await onPage(SCENE);
  viewer.theta = 10;
  viewer.lights[0]!.active = false;
  viewer.append(document.createElement('phong-light'));
  viewer.resetCamera();
  viewer.autoRotate = 20;
  expect(await said(viewer)).toBeNull();
  viewer.autoRotate = 0;
  viewer.theta = 30;
  viewer.lights[1]!.diffuse = [255, 0, 0];
  press(viewer, 'ArrowLeft');
  expect(await said(viewer)).toBe('Camera: azimuth 35°, polar angle 70°, distance 4.');
});
