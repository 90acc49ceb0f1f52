// Do texts hold for a whole page, by markup and by `PhongViewer.texts`, and do numbers follow its
// language? unit/elements/page-texts.test.ts has which texts go before which, and mistakes in them.

import type { Locator, Page } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import { readyTexts } from '../../support/texts.js';

const de = readyTexts('de');

type ViewerClass = { texts: Readonly<Record<string, string>> | null };

// `mount` would take a <phong-viewer> in a text for one.
const script = (texts: string) =>
  `<script type="application/json" data-phong-viewer-texts>${texts.replaceAll('<', '\\u003c')}</script>`;
const viewer = '<phong-viewer geometry="box" view="normals"></phong-viewer>';
const size = { width: 200, height: 120 };

const legend = (of: Locator) => of.locator('[part=legend]');

const assignToPage = (page: Page, texts: Readonly<Record<string, string>> | null) =>
  page.evaluate((value) => {
    (customElements.get('phong-viewer') as unknown as ViewerClass).texts = value;
  }, texts);

test('a script of texts holds for all viewers, later ones too, under a strict policy', async ({
  mount,
  page,
}) => {
  const compared = `<phong-compare>${viewer}${viewer}</phong-compare>`;
  // Of two scripts the later one has the last word.
  const first = await mount(
    `${viewer}${compared}${script(JSON.stringify(de))}${script('{"Legend": "Farben"}')}`,
    size,
  );
  for (const each of [first, page.locator('phong-compare phong-viewer').last()]) {
    await expect(legend(each)).toHaveAttribute('aria-label', 'Farben');
    await expect(legend(each)).toContainText('Normalen');
    await expect(each.locator('[part=surface]')).toHaveAttribute(
      'aria-description',
      /Pfeiltasten drehen/,
    );
  }
  await expect(page.locator('phong-compare [role=separator]')).toHaveAttribute(
    'aria-label',
    /^Trennlinie zwischen/,
  );
  await first.evaluate((element) => element.before(element.cloneNode()));
  await expect(legend(page.locator('phong-viewer').first())).toContainText('Normalen');
  // Changed by a script of the page: read with the next viewer.
  await page.evaluate(
    () =>
      (document.querySelector('[data-phong-viewer-texts]')!.textContent =
        '{"Normals": "normals!"}'),
  );
  await first.evaluate((element) => element.before(element.cloneNode()));
  for (const each of [first, page.locator('phong-compare phong-viewer').first()]) {
    await expect(legend(each)).toContainText('normals!');
  }
  await expect(page.locator('phong-compare [role=separator]')).toHaveAttribute(
    'aria-label',
    /^Divider between/,
  );
});

test('numbers that are only read follow the language of the words', async ({ mount, page }) => {
  const first = await mount(
    `<phong-viewer geometry="box" view="n-dot-l" radius="2.5" probe probe-at="0 0.5 0">
      <phong-light position="0.5 2 1 1" attenuation="1 0.25 0"></phong-light></phong-viewer>`,
    { width: 700, height: 400 },
  );
  const surface = first.locator('[part=surface]');
  await expect(surface).toHaveAttribute('aria-description', /distance 2\.5\./);
  await page.evaluate(() => (document.documentElement.lang = 'de'));
  await assignToPage(page, { Legend: 'Legende' });
  await expect(legend(first)).toContainText('0,5');
  await expect(surface).toHaveAttribute('aria-description', /distance 2,5\./);
  await expect(first.locator('[part=probe]')).toContainText(/0,\d\d/);
  expect(await first.locator('[part=probe]').innerText()).not.toMatch(/\d\.\d/);
});
