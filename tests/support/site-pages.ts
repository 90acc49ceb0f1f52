// What do the tests of the project's site share? The list of its pages and how a scene is written
// into a link. The pages are served from site/ under /demo/.

import { deflateRawSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { pagePaths } from '../../.ci/site/pages.js';
import { fullOr } from './repeats.js';

/** Paths such as `''` and `guide/light/`. */
export const sitePages = pagePaths();

/** The playground's address for a scene, from the site's root. */
export const linkTo = (text: string): string =>
  `playground/#scene=${deflateRawSync(Buffer.from(text)).toString('base64url')}`;

/**
 * But for a release run, pictures of later pages take no samples: software GL needs seconds for
 * those of one page.
 */
export async function takeNoSamples(page: Page): Promise<void> {
  if (fullOr(1, 0) === 1) return;
  await page.addInitScript(() => {
    new MutationObserver(() => {
      for (const viewer of document.querySelectorAll('phong-viewer[antialias=full]')) {
        viewer.setAttribute('antialias', 'edges');
      }
    }).observe(document, { childList: true, subtree: true });
  });
}
