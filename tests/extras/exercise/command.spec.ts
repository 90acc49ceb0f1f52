// Does `npx phong-viewer check` mark what was handed in, with a line for each file?

import { spawn } from 'node:child_process';
import { cpSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { findTestBrowser } from '../../../.ci/browser.mjs';
import { expect, test } from '../../support/test.js';
import { RIGHT, STOPPED_ONES, UNUSUAL_ONES, WRONG_ONES } from './functions.js';

const dist = fileURLToPath(new URL('../../../dist', import.meta.url));

/** What the command writes, and its status. */
const run = async (folder: string, ...args: string[]) => {
  const executable = await findTestBrowser();
  const browser = executable === undefined ? [] : ['--browser', executable];
  const child = spawn(process.execPath, [join(dist, 'cli.js'), 'check', ...args, ...browser], {
    cwd: folder,
  });
  let said = '';
  child.stdout.on('data', (chunk) => (said += String(chunk)));
  child.stderr.on('data', (chunk) => (said += String(chunk)));
  const status = await new Promise((resolve) => child.on('close', resolve));
  return { status, lines: said.trim().split('\n') };
};

const PAGE = `<!doctype html><html lang="en"><title>Sheet</title>
<meta http-equiv="Content-Security-Policy" content="default-src 'self'; style-src 'self' 'unsafe-inline'">
<script type="module" src="phong-viewer.standalone.js"></script><img src="50%.png" alt="">
<phong-viewer id="v" alt="A torus" geometry="torus" style="display: block; width: 150px; height: 100px">
  <phong-light position="1 1 1" attenuation="1 0 0.5" ambient="90"></phong-light></phong-viewer>
<details><phong-exercise id="1" for="v" hint="none"></phong-exercise></details>`;

test('a line for each submission, in words and as CSV, and a status', async ({}, { outputDir }) => {
  test.setTimeout(180_000);
  cpSync(dist, outputDir, { recursive: true });
  mkdirSync(join(outputDir, 'in'));
  writeFileSync(join(outputDir, 'sheet.html'), PAGE);
  const files = {
    'ada.glsl': RIGHT,
    'ben.glsl': WRONG_ONES['no-attenuation']!['missing']!,
    'cy.glsl': STOPPED_ONES['a wrong name']![0],
    'dee.glsl': UNUSUAL_ONES['black']!,
  };
  for (const [name, source] of Object.entries(files)) {
    writeFileSync(join(outputDir, 'in', name), source);
  }
  const all = Object.keys(files).map((name) => `in/${name}`);
  const csv = await run(outputDir, 'sheet.html', ...all, '--csv');
  expect(csv.lines[0]).toBe('file,right,mistakes,share,x,y,found,exact,fault');
  expect(csv.lines[1]).toBe('in/ada.glsl,true,,1.0000,,,,,');
  expect(csv.lines[2]).toMatch(/^in\/ben\.glsl,false,no-attenuation,0\.\d+,\d+,\d+,\d+ \d+ \d+,/);
  expect(csv.lines[3]).toMatch(/^in\/cy\.glsl,false,,0\.0000,,,,,Line 19: /);
  expect(csv.lines[4]).toMatch(/^in\/dee\.glsl,false,,0\.\d+,\d+,\d+,0 0 0,/);
  expect(csv.status).toBe(1);
  const one = await run(outputDir, 'sheet.html', 'in/ada.glsl', '--exercise', '1');
  expect(one).toEqual({ status: 0, lines: ['in/ada.glsl: right; 100.0 % of the pixels'] });
  const wrong = await run(outputDir, 'sheet.html', 'in');
  expect(wrong).toEqual({
    status: 2,
    lines: ['There is no file in. See phong-viewer check --help.'],
  });
});

test('a page without its script names the missing file @release', async ({}, { outputDir }) => {
  mkdirSync(outputDir, { recursive: true });
  writeFileSync(join(outputDir, 'sheet.html'), PAGE);
  const { status, lines } = await run(outputDir, 'sheet.html', 'sheet.html');
  expect(status).toBe(2);
  expect(lines[0]).toMatch(/no phong-exercise\. There is no file .*phong-viewer\.standalone\.js\./);
});
