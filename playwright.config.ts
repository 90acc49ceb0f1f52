// How the browser tests run: which folders, in which browser, with software WebGL so that every
// machine draws alike. Slow tests are in tests/release, tagged @release, and run with
// PHONG_VIEWER_RELEASE set.

import { defineConfig } from '@playwright/test';
import { findTestBrowser, softwareGl } from './.ci/browser.mjs';
import { outputFolder } from './.ci/output-folder.mjs';

const release = process.env['PHONG_VIEWER_RELEASE'] !== undefined;
const executablePath = await findTestBrowser();

export default defineConfig({
  testDir: 'tests',
  testMatch: '{element,extras,visual,a11y,glsl,package,release}/**/*.spec.ts',
  outputDir: outputFolder('test-results'),
  snapshotPathTemplate: '{testDir}/visual/baselines/{arg}{ext}',
  reporter: 'list',
  workers: 2,
  fullyParallel: true,
  forbidOnly: process.env['CI'] !== undefined,
  // On shared cores a frame can come late. A test that passes only at its second attempt is listed
  // as flaky.
  retries: process.env['CI'] === undefined ? 0 : 1,
  timeout: 60_000,
  expect: { timeout: 10_000 },
  ...(release ? {} : { grepInvert: /@release/ }),
  use: {
    browserName: 'chromium',
    viewport: { width: 1000, height: 700 },
    locale: 'en-GB',
    timezoneId: 'UTC',
    launchOptions: {
      ...(executablePath === undefined ? {} : { executablePath }),
      // WebGL stays what it is. Where the page around it is composed without WebGL, tests take a
      // fifth less CPU time, and pages with several pictures a third less: software GL is slow at
      // copying layers.
      args: [...softwareGl, '--disable-gpu-compositing'],
    },
  },
});
