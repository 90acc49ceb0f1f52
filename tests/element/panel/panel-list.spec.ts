// Does the panel open the folders, or show the rows, that `gui` lists?

import type { Locator } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import { assign, type PhongViewer } from '../support/viewer.js';
import { button, panelOf, slider, titleOf, titlesIn } from './panel-rows.js';

const scene = (gui: string): string => `<phong-viewer geometry="torus" theta="20" phi="60" ${gui}>
  <phong-light name="sun"></phong-light>
  <phong-light name="spot" position="0 2 0 1" axis="0 -1 0" aperture="30" cutoff="8"></phong-light></phong-viewer>`;

const openFolders = (viewer: Locator): Promise<string[]> =>
  panelOf(viewer)
    .locator('> .lil-children > .lil-gui > .lil-title[aria-expanded=true]')
    .filter({ visible: true })
    .allTextContents();

test('lights and camera are open without a list, and the folders of the list with one', async ({ mount }) => {
  const viewer = await mount(scene('gui'));
  await expect(slider(viewer, 'θ azimuth °')).toBeVisible();
  expect(await openFolders(viewer)).toEqual(['Lights', 'Camera']);
  await assign(viewer, { gui: ['shading'] });
  await expect(titleOf(viewer, 'Lights')).toHaveAttribute('aria-expanded', 'false');
  expect(await openFolders(viewer)).toEqual(['Shading']);
});

test('a list of attributes shows their rows in its order, without folders and buttons', async ({ mount }) => {
  const viewer = await mount(scene('gui="cutoff shininess theta"'));
  const rows = panelOf(viewer).locator('.lil-controller').filter({ visible: true });
  // The sun is no spot.
  await expect(rows.locator('.lil-name')).toHaveText(['spot: cutoff', 'shininess', 'θ azimuth °']);
  expect(await titlesIn(panelOf(viewer))).toEqual([]);
  await expect(panelOf(viewer).getByRole('button')).toHaveText(['Controls']);
  await slider(viewer, 'shininess').press('ArrowRight');
  expect(await viewer.evaluate(({ shininess }: PhongViewer) => shininess)).toBeGreaterThan(32);
  await viewer.evaluate((element: PhongViewer) => {
    element.theta = -70;
    element.lights[1]!.remove();
    element.lights[0]!.position = [0, 1, 0, 1];
    element.lights[0]!.cutoff = 3;
  });
  await expect(rows.locator('.lil-name')).toHaveText(['cutoff', 'shininess', 'θ azimuth °']);
  await expect(slider(viewer, 'θ azimuth °')).toHaveAttribute('aria-valuetext', '-70');
});

test('a row names its attribute, and models are opened only where they can be dropped', async ({ mount }) => {
  const viewer = await mount(scene('gui'));
  const row = panelOf(viewer).locator('.lil-controller').filter({ hasText: 'auto-rotate' });
  await expect(row).toHaveAttribute('title', 'auto-rotate: Degrees per second about y');
  await expect(button(viewer, 'save PNG')).toBeVisible();
  await expect(button(viewer, 'open model…')).toHaveCount(0);
  await assign(viewer, { droppable: true });
  await expect(button(viewer, 'open model…')).toBeVisible();
});

test('warns of a listed attribute that the panel has no row for', async ({ mount, consoleGuard }) => {
  consoleGuard.allow(/the panel has no row for poster/, 1);
  const viewer = await mount(scene('gui="cutoff poster"'));
  const rows = panelOf(viewer).locator('.lil-controller').filter({ visible: true });
  await expect(rows.locator('.lil-name')).toHaveText(['spot: cutoff']);
});
