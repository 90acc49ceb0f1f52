// Do texts hold for a whole page, by markup and by `PhongViewer.texts`, and do numbers follow its
// language?

import type { Locator, Page } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import { assign, type PhongViewer } from '../support/viewer.js';
import { readyTexts } from '../../support/texts.js';

const de = readyTexts('de');

type ViewerClass = { texts: Readonly<Record<string, string>> | null };

// `mount` would take a <phong-viewer> in a text for one.
const script = (texts: string): string =>
  `<script type="application/json" data-phong-viewer-texts>${texts.replaceAll('<', '\\u003c')}</script>`;
const viewer = '<phong-viewer geometry="box" view="normals"></phong-viewer>';
const size = { width: 200, height: 120 };

const legend = (of: Locator): Locator => of.locator('[part=legend]');

const assignToPage = (page: Page, texts: Readonly<Record<string, string>> | null): Promise<void> =>
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

test('PhongViewer.texts goes before the script, and a viewer’s own texts before both', async ({
  mount,
  page,
}) => {
  const first = await mount(
    `${script('{"Legend": "S", "Normals": "S", "Probe": "S"}')}${viewer}${viewer}`,
    size,
  );
  const second = page.locator('phong-viewer').last();
  await assign(first, { texts: { Normals: 'V' } });
  await assignToPage(page, { Normals: 'P', Legend: 'P' });
  const textsOf = (of: Locator) => of.evaluate((element: PhongViewer) => element.texts);
  expect(await textsOf(first)).toEqual({ Normals: 'V', Legend: 'P', Probe: 'S' });
  expect(await textsOf(second)).toEqual({ Normals: 'P', Legend: 'P', Probe: 'S' });
  await expect(legend(first)).toContainText('V');
  await expect(legend(second)).toContainText('P');
  // Read again, it is the same object until something changes.
  expect(await first.evaluate((element: PhongViewer) => element.texts === element.texts)).toBe(
    true,
  );
  const refused = () => assignToPage(page, ['no'] as unknown as Record<string, string>);
  await expect(refused()).rejects.toThrow('expected an object of texts');
  await assignToPage(page, null);
  expect(await textsOf(second)).toEqual({ Legend: 'S', Normals: 'S', Probe: 'S' });
  await assign(first, { texts: null });
  await expect(legend(first)).toContainText('S');
});

test('each mistake in the scripts gives one warning; other texts are used', async ({
  mount,
  page,
  consoleGuard,
}) => {
  const warnings = consoleGuard.allow(/^warning: <script data-phong-viewer-texts>/, 3);
  const scripts = ['{"Legend": "A",}', '["Legend"]', '{"Legende": "B", "Normals": "C"}']
    .map(script)
    .join('');
  const first = await mount(scripts + viewer + viewer, size);
  await expect(legend(first)).toContainText('C');
  await expect(legend(first)).toHaveAttribute('aria-label', 'Legend');
  await first.evaluate((element) => element.before(element.cloneNode()));
  await expect(legend(page.locator('phong-viewer').first())).toContainText('C');
  expect(
    warnings.map((text) => text.replace('warning: <script data-phong-viewer-texts> ', '')),
  ).toEqual([
    expect.stringMatching(/^is not JSON, so it is not used: .*JSON/),
    'must be an object of texts by English text, so it is not used. Write {"Try again": "…"}.',
    'has texts that no viewer shows: "Legende" (did you mean "Legend"?). phong-viewer/texts/de.json has all keys.',
  ]);
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
