// The demo's bench page: it shows the recorded figures of whole pictures, measures in the visitor's
// browser, shows its progress, and copies the result.
import { expect, test } from '../../support/test.js';

interface Copied {
  readonly renderer: string;
  readonly tables: readonly {
    readonly rows: readonly { readonly label: string; readonly ms: number }[];
  }[];
}

test('measures every front, shows a table for each and copies the result as JSON', async ({
  page,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.goto('/demo/bench/?seconds=0.1');
  await expect(page.locator('#renderer')).toContainText(/SwiftShader|llvmpipe|ANGLE/);
  const copy = page.getByRole('button', { name: 'Copy the result as JSON' });
  await expect(copy).toBeDisabled();
  const recorded = page.locator('.recorded');
  await expect(recorded.filter({ hasText: 'Software rendering' })).toHaveCount(1);
  for (const section of await recorded.all()) {
    await expect(section.getByRole('img', { name: 'torus: error over time' })).toBeVisible();
    const cells = section.getByRole('row', { name: /^TAARenderPass, 32/ }).getByRole('cell');
    await expect(cells).toHaveCount(await section.getByRole('img').count());
    await expect(section).not.toContainText(/–|NaN/);
  }
  await page.getByRole('button', { name: 'Measure' }).click();
  await expect(page.getByRole('progressbar')).toBeVisible();
  await expect(page.locator('#state')).toContainText('Done in', { timeout: 50_000 });
  await expect(page.getByRole('progressbar')).toBeHidden();
  await copy.click();
  await expect(page.locator('#state')).toHaveText('Copied.');

  const result = JSON.parse(await page.evaluate(() => navigator.clipboard.readText())) as Copied;
  expect(result.renderer).toBe(await page.locator('#renderer').textContent());
  await expect(page.locator('#fronts .front')).toHaveCount(result.tables.length);
  for (const { rows } of result.tables) {
    for (const { label, ms } of rows) {
      expect(ms, label).toBeGreaterThan(0);
    }
    expect(new Set(rows.map(({ label }) => label)).size).toBe(rows.length);
  }
});

test('keeps its canvas on screen while the reader scrolls, and stops on request', async ({
  page,
}) => {
  await page.goto('/demo/bench/?seconds=100');
  await page.getByRole('button', { name: 'Measure' }).click();
  await expect(page.locator('#fronts').getByRole('table')).toBeVisible({ timeout: 50_000 });
  await page.evaluate(() => {
    scrollTo(0, document.body.scrollHeight);
  });
  await expect(page.locator('#easel')).toBeInViewport();
  await page.getByRole('button', { name: 'Stop' }).click();
  await expect(page.locator('#state')).toHaveText('Stopped.');
  await expect(page.locator('#easel canvas')).toHaveCount(0);
});
