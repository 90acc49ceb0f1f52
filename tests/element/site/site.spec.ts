// Is every page of the site fit for publication? An empty console, a policy, a link to the package,
// a layout for phones, no problem found by axe, pictures as before, and data for search engines and
// link previews. One load of each page serves all of these.

import { axeOn } from '../../support/axe.js';
import type { APIRequestContext, Page } from '@playwright/test';
import { allReady, expect, test } from '../../support/test.js';
import type { PhongViewer } from '../support/viewer.js';
import { firstOf } from '../../support/repeats.js';
import { strictPolicy } from '../../support/site.js';
import { moved } from '../../../.ci/site/contents.js';
import { countJumps, jumpsOf } from '../../support/jumps.js';
import { sitePages, takeNoSamples } from '../../support/site-pages.js';
import { expectPictures } from '../../visual/contact-sheet.js';

/** Pages whose pictures are compared with a baseline. The others show none, or some that change. */
const PICTURED: ReadonlySet<string> = new Set([
  '',
  ...['light/', 'see/', 'lessons/', 'camera/', 'models/', 'reliability/'].map(
    (page) => `guide/${page}`,
  ),
]);

/**
 * Pages whose tests run in every run, in dark colours too: together they have all that is coloured,
 * and the others are made of the same parts.
 */
const OFTEN: ReadonlySet<string> = new Set([
  '',
  'guide/light/',
  'guide/see/',
  'lesson/',
  'playground/',
]);

test.beforeEach(({ page }) => takeNoSamples(page));

const PHONE = { width: 390, height: 844 };

async function open(page: Page, path: string) {
  await page.goto(`/demo/${path}`);
  await allReady(page);
}

const contentOf = (page: Page, selector: string) => page.locator(selector).getAttribute('content');

async function expectFitAndAccessible(page: Page, dark: boolean) {
  const tooWide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect.soft(tooWide, 'pixels beside the screen').toBeLessThanOrEqual(0);
  const links = await page.locator('.head a').evaluateAll((all) =>
    all.flatMap((link) => {
      const { left, right } = link.getBoundingClientRect();
      return left < 0 || right > innerWidth ? [link.textContent] : [];
    }),
  );
  expect.soft(links, 'links of the menu beside the screen').toEqual([]);
  for (const colorScheme of firstOf(['light', 'dark'] as const, dark ? 2 : 1)) {
    await page.emulateMedia({ colorScheme });
    const axe = axeOn(page);
    // The dark page is the light one in other colours.
    if (colorScheme === 'dark') {
      axe.withRules(['color-contrast', 'link-in-text-block']);
    }
    const { violations } = await axe.analyze();
    expect
      .soft(violations.map(({ id, nodes }) => [colorScheme, id, nodes.map(({ html }) => html)]))
      .toEqual([]);
  }
}

async function expectHead(page: Page, request: APIRequestContext) {
  const policy = await contentOf(page, 'meta[http-equiv="Content-Security-Policy"]');
  for (const rule of strictPolicy.split('; ')) {
    expect.soft(policy).toContain(rule);
  }
  expect.soft(policy).not.toContain('unsafe');
  expect.soft(await page.title()).toContain('phong-viewer');
  expect.soft(await contentOf(page, 'meta[name=description]')).toMatch(/^.{40,170}$/);
  expect.soft(await contentOf(page, 'meta[property="og:title"]')).toBe(await page.title());
  // The repository's address is a placeholder until it is published.
  expect.soft(await page.content()).not.toContain('OWNER');
  const picture = await contentOf(page, 'meta[property="og:image"]');
  // Absolute, once the site has an address.
  const [, asset] = /^https:.*\/(assets\/.*)/.exec(picture ?? '') ?? [];
  const response = await request.get(
    asset === undefined ? new URL(picture ?? '', page.url()).href : `/demo/${asset}`,
  );
  expect.soft(response.headers()['content-type']).toBe('image/png');
}

/**
 * Addresses that were fetched, with their text; empty where there is none. One fetch serves all
 * pages of a worker.
 */
const fetched = new Map<string, string>();

async function brokenLinks(page: Page, request: APIRequestContext) {
  const links = await page
    .locator('a[href]')
    .evaluateAll((all) =>
      all
        .map((a) => (a as HTMLAnchorElement).href)
        .filter((href) => new URL(href).origin === location.origin),
    );
  const broken: string[] = [];
  for (const link of new Set(links)) {
    const [address = '', id = ''] = link.split('#');
    if (!fetched.has(address)) {
      const response = await request.get(address);
      fetched.set(address, response.ok() ? await response.text() : '');
    }
    const text = fetched.get(address)!;
    const found = id === '' || id.includes('=') ? text !== '' : text.includes(`id="${id}"`);
    if (!found) {
      broken.push(link);
    }
  }
  return broken;
}

for (const path of sitePages) {
  const name = path === '' ? 'start page' : `page ${path}`;

  const pictured = PICTURED.has(path);
  const looks = pictured ? ', looks as before' : '';
  const often = OFTEN.has(path);

  test(`${often ? '' : '@release '}the ${name} fits a phone and passes axe${looks}`, async ({
    page,
    request,
  }) => {
    test.setTimeout(120_000);
    await page.setViewportSize(PHONE);
    await page.emulateMedia({ colorScheme: 'light' });
    await open(page, path);
    await expectFitAndAccessible(page, often);
    await expectHead(page, request);
    if (pictured) {
      await expectPictures(
        page,
        `demo-${path === '' ? 'landing' : path.slice(0, -1).replace('/', '-')}`,
      );
    }
    await expect.soft(page.getByText('npm install phong-viewer three').first()).toBeVisible();
    const nav = page.getByRole('navigation', { name: 'Pages', exact: true });
    const pages = ['Lesson', 'Guide', 'Examples', 'Playground', 'Reference', 'Install'];
    await expect.soft(nav.getByRole('link')).toHaveText(pages);
    await expect
      .soft(page.getByRole('contentinfo').getByRole('link', { name: /^(Twenty models|Bench)$/ }))
      .toHaveCount(2);
    await expect.soft(page.getByRole('heading', { level: 1 })).toHaveCount(1);
    expect.soft(await brokenLinks(page, request), 'links that lead nowhere').toEqual([]);
  });
}

test('the reference lists every attribute, property, method and event of the manifest', async ({
  page,
  request,
}) => {
  interface Named {
    readonly name: string;
  }
  interface Declaration {
    readonly tagName: string;
    readonly attributes: readonly Named[];
    readonly members: readonly (Named & { readonly attribute?: string })[];
    readonly events: readonly Named[];
  }
  const manifest = (await (await request.get('/dist/custom-elements.json')).json()) as {
    readonly modules: readonly { readonly declarations: readonly Declaration[] }[];
  };
  await page.goto('/demo/guide/reference/');
  const ids = new Set(
    await page.locator('td code[id]').evaluateAll((all) => all.map(({ id }) => id)),
  );
  const wanted = manifest.modules[0]!.declarations.flatMap(
    ({ tagName, attributes, members, events }) => [
      ...attributes.map(({ name }) => `${tagName}-${name}`),
      // The value of a form's control stands in the element's description.
      ...members
        .filter(({ attribute, name }) => attribute === undefined && name !== 'value')
        .map(({ name }) => `${tagName}-${name}`),
      ...events.map(({ name }) => `${tagName}-${name}-event`),
    ],
  );
  expect(wanted.filter((id) => !ids.has(id))).toEqual([]);
  expect(ids.size).toBe(wanted.length);
});

test('start page and install page give the size of the standalone file, as in dist/', async ({
  page,
  request,
}) => {
  const { brotliCompressSync } = await import('node:zlib');
  const file = await (await request.get('/dist/phong-viewer.standalone.js')).body();
  const kilobytes = Math.round(brotliCompressSync(file).length / 1000);
  await page.goto('/demo/');
  await expect(page.locator('.facts')).toContainText(`${kilobytes} kB`);
  await page.goto('/demo/guide/install/');
  await expect(page.locator('#sizes tr').first()).toContainText(`${kilobytes} kB`);
});

test('a listing opens in the playground with its model', async ({ page }) => {
  await page.goto('/demo/guide/models/');
  await allReady(page);
  await page.locator('#bunny .source summary').click();
  await page
    .locator('#bunny')
    .getByRole('button', { name: /Edit in the playground/ })
    .click();
  await page.waitForURL(/playground\/#scene=/);
  await expect(page.locator('phong-mesh[src]')).toHaveAttribute(
    'src',
    '../assets/models/bunny.glb',
  );
  await allReady(page);
  await expect(page.locator('#messages')).toBeEmpty();
});

test('the search finds names and words of all pages, and Enter leads there', async ({ page }) => {
  await page.goto('/demo/lesson/');
  const field = page.getByRole('searchbox', { name: 'Search all pages' });
  await field.fill('attenuation');
  const found = page.getByRole('list', { name: 'Found' }).getByRole('link');
  await expect(found.first()).toHaveText('attenuation');
  await expect(found.and(page.locator('[href*="/es/"]'))).toHaveCount(0);
  await page.keyboard.press('Escape');
  await expect(found).toHaveCount(0);
  await field.fill('linked camera');
  await expect(found.first()).toHaveText('Linked cameras');
  await page.keyboard.press('Enter');
  await page.waitForURL('**/guide/see/#linked-cameras');
});

test('the lesson leads to the same lesson in other languages, with viewers in them', async ({
  page,
}) => {
  await page.goto('/demo/lesson/');
  const menu = page.getByRole('navigation', { name: 'Languages' });
  await expect(menu.getByRole('link')).toHaveText(['English', 'Deutsch', 'Español', 'Português']);
  await expect(menu.locator('[aria-current=page]')).toHaveText('English');
  const alternates = page.locator('link[rel=alternate][hreflang]');
  for (const { language, heading, sum } of [
    { language: 'Deutsch', heading: 'Beleuchtung in zwanzig Minuten', sum: /Anteile/ },
    { language: 'Español', heading: 'Iluminación en veinte minutos', sum: /términos/ },
    { language: 'Português', heading: 'Iluminação em vinte minutos', sum: /termos/ },
  ]) {
    await menu.getByRole('link', { name: language }).click();
    await expect(page.getByRole('heading', { level: 1 })).toHaveText(heading);
    await expect(menu.locator('[aria-current=page]')).toHaveText(language);
    const lang = await page.locator('html').getAttribute('lang');
    await expect(menu.locator('[aria-current=page]')).toHaveAttribute('hreflang', lang!);
    await expect(alternates).toHaveCount(4);
    await expect(page.locator('.topics a')).toHaveCount(10);
    await expect(page.locator('#sum + phong-control')).toBeVisible();
    expect(
      await page.locator('#sum').evaluate((viewer: PhongViewer) => viewer.texts?.terms),
    ).toMatch(sum);
  }
  await menu.getByRole('link', { name: 'English' }).click();
  await expect(page).toHaveURL(/\/lesson\/$/);
});

test('pages at earlier addresses lead to the new ones', async ({ page, request }) => {
  for (const [path, to] of Object.entries(moved)) {
    expect(await (await request.get(`/demo/${path}`)).text()).toContain('http-equiv="refresh"');
    expect(sitePages).toContain(to.split('#')[0]);
  }
  await page.goto('/demo/guide/spots/');
  await page.waitForURL('**/guide/light/#spots');
});

test('the contents open at the page that is read, and Escape closes them', async ({ page }) => {
  for (const size of [PHONE, { width: 1280, height: 260 }]) {
    await page.setViewportSize(size);
    await page.goto('/demo/guide/vectors/');
    const contents = page.getByRole('navigation', { name: 'Guide', exact: true });
    const current = contents.getByRole('link', { name: 'Test vectors', exact: true });
    const button = contents.getByRole('button', { name: 'Contents' });
    if (size === PHONE) {
      await expect(current).toBeHidden();
      await button.click();
      const heights = await page
        .locator('.head li a, .topics a')
        .evaluateAll((links) => links.map((link) => link.getBoundingClientRect().height));
      expect(Math.min(...heights), 'high enough for a finger').toBeGreaterThanOrEqual(30);
    }
    await expect(current).toBeInViewport({ ratio: 1 });
    expect(await page.evaluate(() => scrollY)).toBe(0);
    if (size === PHONE) {
      await current.focus();
      await page.keyboard.press('Escape');
      await expect(current).toBeHidden();
      await expect(button).toBeFocused();
    }
  }
});

test('the contents of the guide stay in view, behind a button on a phone', async ({ page }) => {
  await page.setViewportSize(PHONE);
  await page.goto('/demo/guide/reliability/');
  const contents = page.getByRole('navigation', { name: 'Guide', exact: true });
  await page.mouse.wheel(0, 3000);
  await contents.getByRole('button', { name: 'Contents' }).click();
  await contents.getByRole('link', { name: 'Speed' }).click();
  await expect(page).toHaveURL(/#speed$/);
  await page.setViewportSize({ width: 1280, height: 900 });
  await page.mouse.wheel(0, 3000);
  await expect(contents.getByRole('link', { name: 'Shapes and models' })).toBeInViewport();
  await expect(page.getByRole('link', { name: '← Install' })).toHaveCount(1);
});

for (const [i, address] of [
  'guide/light/#spots',
  'examples/#compare',
  'bench/',
  'guide/see/#comparisons',
  'guide/install/#frameworks',
  'lesson/#lambert',
].entries()) {
  test(`${i < 3 ? '' : '@release '}nothing jumps while ${address} loads`, async ({ page }) => {
    await countJumps(page);
    for (const size of [PHONE, { width: 1280, height: 800 }]) {
      await page.setViewportSize(size);
      await page.goto('/demo/guide/vectors/'); // so that the anchor loads its page anew
      await open(page, address);
      await expect(page.locator('.listing:has(pre):not(:has(.caption))')).toHaveCount(0);
      expect(await jumpsOf(page), `${size.width} pixels`).toBeLessThan(0.1);
    }
  });
}
