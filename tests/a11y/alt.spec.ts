// Does a viewer without a name give one warning that names the cure, and no other viewer any?

import type { Page } from '@playwright/test';
import { expect, test } from '../support/test.js';
import { nextFrame, type PhongViewer } from '../element/support/viewer.js';
import { requestsOf } from '../support/requests.js';

const WARNING =
  'warning: A <phong-viewer> has no alt. Write alt="…", the picture in words for people who do not see it, or alt="" if it is decoration.';
const size = { width: 60, height: 40, nameless: true };

const viewer = (attributes = '') => `<phong-viewer geometry="box" ${attributes}></phong-viewer>`;

/** Waits until all warnings so far have been printed. */
async function reported(page: Page) {
  for (let i = 0; i < 4; i++) {
    await nextFrame(page);
  }
}

test('viewers without an alt are reported once, after the first picture', async ({
  page,
  mount,
  consoleGuard,
}) => {
  const warnings = consoleGuard.allow(/has no alt/, 2);
  await page.addInitScript(() => {
    addEventListener('render', () => performance.mark('picture'), { capture: true, once: true });
  });
  const startOf = (part: string) =>
    page.evaluate(
      (words) => performance.getEntries().find(({ name }) => name.includes(words))!.startTime,
      part,
    );
  await mount(viewer() + viewer() + viewer('alt="A box"'), size);
  await expect.poll(() => warnings).toEqual([WARNING]);
  expect(await startOf('/diagnose.')).toBeGreaterThan(await startOf('picture'));
  await page.evaluate(() => document.body.append(document.createElement('phong-viewer')));
  await reported(page);
  expect(warnings).toHaveLength(1);
  await mount(viewer(), { ...size, css: 'phong-viewer { display: none }' });
  await expect.poll(() => warnings).toHaveLength(2);
});

test('viewers that have a name, need none or are hidden are not reported', async ({
  page,
  mount,
}) => {
  const fetched = requestsOf(page);
  const element = await mount(
    [
      viewer('alt="A box"'),
      viewer('alt=""'),
      viewer('alt'),
      viewer('aria-label="A box"'),
      `<h1 id="heading">A box</h1>${viewer('aria-labelledby="heading"')}`,
      viewer('role="presentation"'),
      viewer('role="none"'),
      viewer('aria-hidden="true"'),
      `<div aria-hidden="true">${viewer()}</div>`,
    ].join(''),
    size,
  );
  await element.evaluate(() => {
    for (const alt of ['By a script', '']) {
      const made: PhongViewer = document.createElement('phong-viewer');
      document.body.append(made);
      made.alt = alt; // in the same task
    }
  });
  await reported(page);
  // A warning would need it.
  expect(fetched.filter((url) => /chunks\/diagnose/.test(url))).toEqual([]);
});
