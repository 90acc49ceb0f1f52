// The demo's bench page: it shows the recorded figures of whole pictures, measures in the visitor's
// browser, shows its progress, and copies the result.
import { type Accuracy, WAYS } from '../../bench/accuracy-words.mjs';
import { expect, test } from '../../support/test.js';
import { nextFrame } from '../support/viewer.js';

test('@release measures every way to write the loop, plots it and copies the result as JSON', async ({
  page,
  context,
}) => {
  // Six programs are compiled and measured in software.
  test.setTimeout(180_000);
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.goto('/demo/bench/?seconds=0.1&exponent=100000');
  await expect(page.locator('#renderer')).toContainText(/SwiftShader|llvmpipe|ANGLE/);
  const copy = page.getByRole('button', { name: 'Copy the result as JSON' });
  await expect(copy).toBeDisabled();
  const example = (await page.locator('#here p').textContent())!;
  expect(example).toMatch(/^(On an NVIDIA|In software).* exactness costs/);
  await page.getByRole('button', { name: 'Measure' }).click();
  await expect(page.getByRole('progressbar')).toBeVisible();
  await expect(page.locator('#state')).toContainText('Done in', { timeout: 150_000 });
  await expect(page.getByRole('progressbar')).toBeHidden();
  await copy.click();
  await expect(page.locator('#state')).toHaveText('Copied.');

  const result = JSON.parse(await page.evaluate(() => navigator.clipboard.readText())) as Accuracy;
  expect(result.renderer).toBe(await page.locator('#renderer').textContent());
  expect(result.points).toHaveLength(WAYS.length);
  for (const { way, exponent, ms, time, error } of result.points) {
    expect(ms, way).toBeGreaterThan(0);
    expect(time, way).toBeGreaterThan(0);
    // Exactness is what this is about.
    if (way === 'first' || way === 'settled') {
      expect(error, `${way}, ${exponent}`).toBeLessThan(0.5);
    }
  }
  const here = page.locator('#here');
  await expect(here).toContainText('On this machine exactness costs');
  const plot = here.getByRole('img', { name: /exactness costs/ });
  await expect(plot.locator('circle')).toHaveCount(result.points.length);
  await expect(plot.locator('image')).toHaveCount(3);
  await expect(here.getByRole('row')).toHaveCount(1 + WAYS.length);
  // Drawn anew for a phone: its letters stay as large.
  await page.setViewportSize({ width: 390, height: 844 });
  const widthOf = () => plot.evaluate((svg) => svg.getBoundingClientRect().width);
  await expect.poll(widthOf).toBeLessThan(391);
  const letters = await plot
    .locator('text')
    .first()
    .evaluate((text) => text.getBoundingClientRect().height);
  expect(letters).toBeGreaterThan(11);
  // What stood there was measured elsewhere, and is below now.
  await expect(page.locator('#machines')).toContainText(example);
});

test('shows recorded pictures; its canvas stays on screen, and it stops on request', async ({
  page,
}) => {
  await page.goto('/demo/bench/');
  const recorded = page.locator('.recorded');
  await expect(recorded.filter({ hasText: 'Software rendering' })).toHaveCount(1);
  for (const section of await recorded.all()) {
    await expect(section.getByRole('img', { name: 'torus: error over time' })).toBeVisible();
    const cells = section.getByRole('row', { name: /^TAARenderPass, 32/ }).getByRole('cell');
    await expect(cells).toHaveCount(await section.getByRole('img').count());
    await expect(section).not.toContainText(/–|NaN/);
  }
  // Hidden, a plot has no width to be drawn in: the console would say so.
  await page.locator('#here').evaluate((here: HTMLElement) => {
    here.hidden = true;
  });
  await nextFrame(page);
  await page.getByRole('button', { name: 'Measure' }).click();
  await expect(page.getByRole('progressbar')).toBeVisible();
  await page.evaluate(() => {
    scrollTo(0, document.body.scrollHeight);
  });
  await expect(page.locator('#easel')).toBeInViewport();
  await page.getByRole('button', { name: 'Stop' }).click();
  await expect(page.locator('#state')).toHaveText('Stopped.');
  await expect(page.locator('#easel canvas')).toHaveCount(0);
});
