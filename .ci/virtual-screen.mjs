// @ts-check
// A screen in memory, for browsers that draw with WebGL only in a window: Xvfb on a display of its
// own. Installs Debian's packages when run by root.

import { execFileSync, spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { setTimeout as pause } from 'node:timers/promises';

let screens = 0;

/**
 * Starts a screen of 1200 × 900 pixels.
 * @returns {Promise<{ display: string, close: () => void }>} `display` as in the variable DISPLAY
 */
export async function startScreen() {
  install({ Xvfb: 'xvfb' });
  // Derived from the process id, so that two runs do not share a display.
  const number = 100 + (process.pid % 800) + 1000 * screens++;
  const screen = spawn('Xvfb', [`:${number}`, '-screen', '0', '1200x900x24'], { stdio: 'ignore' });
  for (let tries = 0; !existsSync(`/tmp/.X11-unix/X${number}`); tries++) {
    if (tries > 100) throw new Error('Xvfb gave no display within 10 s');
    await pause(100);
  }
  return { display: `:${number}`, close: () => void screen.kill() };
}

/**
 * Installs the packages whose command is missing.
 * @param {Readonly<Record<string, string>>} packages Debian's package names, separated by spaces,
 * by command
 */
export function install(packages) {
  const missing = Object.entries(packages).flatMap(([command, names]) =>
    has(command) ? [] : names.split(' '),
  );
  if (missing.length === 0) return;
  if (process.getuid?.() !== 0 || !has('apt-get')) {
    throw new Error(`This needs ${missing.join(', ')} (Debian's names).`);
  }
  execFileSync('apt-get', ['update', '-qq']);
  execFileSync('apt-get', ['install', '-y', '-qq', '--no-install-recommends', ...missing]);
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
