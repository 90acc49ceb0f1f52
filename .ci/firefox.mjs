// @ts-check
// Starts Firefox with Mesa's software GL on a virtual screen: Debian's firefox-esr under Xvfb,
// driven by puppeteer, because Playwright's Firefox is a modified build. Installs both when run by
// root.

import { execFileSync } from 'node:child_process';
import puppeteer from 'puppeteer-core';
import { install, startScreen } from './virtual-screen.mjs';

/** Starts both; `close` ends both. */
export async function startFirefox() {
  install({ 'firefox-esr': 'firefox-esr libegl1 libgl1-mesa-dri' });
  const screen = await startScreen();
  const browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath: execFileSync('which', ['firefox-esr'], { encoding: 'utf8' }).trim(),
    headless: false,
    env: { ...process.env, DISPLAY: screen.display },
    extraPrefsFirefox: {
      'webgl.force-enabled': true,
      // As for users; puppeteer lets pages opened from disk read files.
      'security.fileuri.strict_origin_policy': true,
    },
    protocolTimeout: 3_600_000,
  });
  return {
    browser,
    async close() {
      await browser.close();
      screen.close();
    },
  };
}
