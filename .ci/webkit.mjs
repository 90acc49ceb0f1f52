// @ts-check
// Starts WebKitGTK, Safari's engine, with Mesa's software GL on a virtual screen: Debian's
// MiniBrowser under Xvfb, driven by WebDriver. Playwright's WebKit is a modified build. Installs
// both when run by root.

import { spawn } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import { install, startScreen } from './virtual-screen.mjs';

/**
 * Starts both; `close` ends both. `send` calls WebDriver below the session's address.
 * @returns {Promise<{ version: string, send: (method: string, path: string, body?: object) =>
 * Promise<any>, close: () => Promise<void> }>}
 */
export async function startWebkit() {
  install({ WebKitWebDriver: 'webkit2gtk-driver libegl1 libgl1-mesa-dri' });
  const screen = await startScreen();
  const port = await freePort();
  const driver = spawn('WebKitWebDriver', [`--port=${port}`], {
    env: { ...process.env, DISPLAY: screen.display },
    stdio: 'ignore',
  });
  const address = `http://127.0.0.1:${port}`;
  for (let tries = 0; !(await answers(`${address}/status`)); tries++) {
    if (tries > 100) throw new Error('WebKitWebDriver does not answer within 10 s');
    await pause(100);
  }
  const { sessionId, capabilities } = await call('POST', `${address}/session`, {
    capabilities: {
      alwaysMatch: {
        'webkitgtk:browserOptions': { binary: miniBrowser(), args: ['--automation'] },
      },
    },
  });
  const session = `${address}/session/${sessionId}`;
  await call('POST', `${session}/timeouts`, { script: 600_000, pageLoad: 60_000 });
  return {
    version: capabilities.browserVersion,
    send: (method, path, body) => call(method, session + path, body),
    async close() {
      await call('DELETE', session);
      driver.kill();
      screen.close();
    },
  };
}

/** @param {string} method @param {string} address @param {object} [body] */
async function call(method, address, body) {
  const answer = await fetch(address, {
    method,
    ...(body === undefined
      ? {}
      : { body: JSON.stringify(body), headers: { 'content-type': 'application/json' } }),
  });
  const { value } = /** @type {{ value: any }} */ (await answer.json());
  if (!answer.ok) throw new Error(`${method} ${address}: ${value.error}: ${value.message}`);
  return value;
}

/** @param {string} address */
async function answers(address) {
  try {
    return (await fetch(address)).ok;
  } catch {
    return false;
  }
}

/** Debian puts it beside the library, in a folder named by the machine's architecture. */
function miniBrowser() {
  const found = readdirSync('/usr/lib')
    .flatMap((folder) =>
      ['4.1', '4.0'].map((api) => join('/usr/lib', folder, `webkit2gtk-${api}`, 'MiniBrowser')),
    )
    .find((path) => existsSync(path));
  if (found === undefined) throw new Error('MiniBrowser is not beside the WebKitGTK library');
  return found;
}

/** @returns {Promise<number>} */
function freePort() {
  return new Promise((resolve, reject) => {
    const server = createServer();
    server.on('error', reject);
    server.listen(0, '127.0.0.1', () => {
      const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
      server.close(() => resolve(port));
    });
  });
}
