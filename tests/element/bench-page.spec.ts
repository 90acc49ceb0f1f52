// The demo's bench page: measures in the visitor's browser, tells how far it is, and hands the result on. How long anything
// takes is not asked here.
import type { BenchResult } from '../bench/result-file.mjs';
import { expect, test } from '../support/test.js';

test('measures a front, draws it and copies the result as JSON', async ({ page, context }) => {
  test.setTimeout(120_000);
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.goto('/demo/bench/?only=budget&seconds=0.2');
  await expect(page.locator('#renderer')).toContainText(/SwiftShader|llvmpipe|ANGLE/);
  await expect(page.getByRole('button', { name: 'Copy the result as JSON' })).toBeDisabled();
  await page.getByRole('button', { name: 'Measure' }).click();
  await expect(page.getByRole('progressbar')).toBeVisible();
  await expect(page.locator('#state')).toContainText('Done in', { timeout: 100_000 });
  await expect(page.getByRole('progressbar')).toBeHidden();
  await page.getByRole('button', { name: 'Copy the result as JSON' }).click();
  await expect(page.locator('#state')).toHaveText('Copied.');

  const result = JSON.parse(await page.evaluate(() => navigator.clipboard.readText())) as BenchResult;
  expect(result.machine['renderer']).toBe(await page.locator('#renderer').textContent());
  expect(result.fronts.map(({ axis }) => axis)).toEqual(['budget']);
  for (const { axis, points, base, shipped } of result.fronts) {
    const ids = points.map(({ id }) => id);
    expect(ids).toEqual(expect.arrayContaining([base, shipped]));
    for (const { id, time, ratio, error } of points) {
      expect(time.median, `${axis}, ${id}: time`).toBeGreaterThan(0);
      expect(ratio.count, `${axis}, ${id}: rounds`).toBeGreaterThanOrEqual(2);
      for (const [name, value] of Object.entries(error))
        expect(Number.isFinite(value), `${axis}, ${id}: ${name}`).toBe(true);
    }
    // Every point is told of in the picture and in the table beneath it.
    const section = page.locator(`#front-${axis}`);
    await expect(section.getByRole('img')).toBeVisible();
    await section.getByText('The numbers').click();
    await expect(section.locator('tbody tr')).toHaveCount(points.length);
  }
});

test('keeps its canvases on screen while the reader scrolls, and stops when told', async ({ page }) => {
  test.setTimeout(60_000);
  await page.goto('/demo/bench/?only=shading&seconds=100');
  await page.getByRole('button', { name: 'Measure' }).click();
  await expect(page.getByRole('img')).toBeVisible({ timeout: 50_000 }); // a round was timed
  await page.evaluate(() => {
    scrollTo(0, document.body.scrollHeight);
  });
  await expect(page.locator('#easel')).toBeInViewport();
  await page.getByRole('button', { name: 'Stop' }).click();
  await expect(page.locator('#state')).toHaveText('Stopped.');
  await expect(page.locator('#easel canvas, #easel iframe')).toHaveCount(0);
});
