// @ts-check
// Starts Firefox with Mesa's software GL on a virtual screen: Debian's firefox-esr under Xvfb, driven by puppeteer, because
// Playwright's Firefox is a modified build. Installs both when run by root.

import { execFileSync, spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { setTimeout as pause } from 'node:timers/promises';
import puppeteer from 'puppeteer-core';

const needed = ['firefox-esr', 'xvfb', 'libegl1', 'libgl1-mesa-dri'];

/** Starts both; `close` ends both. */
export async function startFirefox() {
  if (!has('firefox-esr') || !has('Xvfb')) {
    if (process.getuid?.() !== 0 || !has('apt-get'))
      throw new Error(`This needs ${needed.join(', ')} (Debian's names).`);
    execFileSync('apt-get', ['update', '-qq']);
    execFileSync('apt-get', ['install', '-y', '-qq', '--no-install-recommends', ...needed]);
  }
  // Derived from the process id, so that two runs do not share a display.
  const display = 100 + (process.pid % 800);
  const screen = spawn('Xvfb', [`:${display}`, '-screen', '0', '1000x700x24'], { stdio: 'ignore' });
  for (let tries = 0; !existsSync(`/tmp/.X11-unix/X${display}`); tries++) {
    if (tries > 100) throw new Error('Xvfb gave no display within 10 s');
    await pause(100);
  }
  const browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath: execFileSync('which', ['firefox-esr'], { encoding: 'utf8' }).trim(),
    headless: false,
    env: { ...process.env, DISPLAY: `:${display}` },
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
      screen.kill();
    },
  };
}

/** @param {string} command */
function has(command) {
  try {
    execFileSync('which', [command], { stdio: 'ignore' });
    return true;
  } catch {
    return false;
  }
}
