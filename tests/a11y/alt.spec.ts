// Is an author told of a viewer without a name, once and with the cure, and of no other?

import type { Page } from '@playwright/test';
import { expect, test } from '../support/test.js';
import { nextFrame, type PhongViewer } from '../element/support.js';

const WARNING =
  'warning: A <phong-viewer> has no alt. Write alt="…", the picture in words for people who do not see it, or alt="" if it is decoration.';
const size = { width: 60, height: 40, nameless: true };
const viewer = (attributes = ''): string => `<phong-viewer geometry="box" ${attributes}></phong-viewer>`;

/** What could be reported so far has been. */
async function reported(page: Page): Promise<void> {
  for (let i = 0; i < 4; i++) await nextFrame(page);
}

test('viewers without an alt are reported once a page', async ({ page, mount, consoleGuard }) => {
  const warnings = consoleGuard.allow(/has no alt/, 1);
  await mount(viewer() + viewer() + viewer('alt="A box"'), size);
  await expect.poll(() => warnings).toEqual([WARNING]);
  await page.evaluate(() => document.body.append(document.createElement('phong-viewer')));
  await reported(page);
});

test('viewers with a name, without need of one, or hidden are not', async ({ page, mount, consoleGuard }) => {
  consoleGuard.allow(/has no alt/, 0);
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
});
