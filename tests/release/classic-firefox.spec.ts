// Does a page opened from disk work in Firefox too? The classic script on file://, and what a model beside the page
// gives.
import { cpSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { expect, test } from '@playwright/test';
import { startFirefox } from '../../.ci/firefox.mjs';
import { outputFolder } from '../../.ci/output-folder.mjs';
import type { PhongViewer } from '../../src/index.js';
import { decodePng } from '../support/picture.js';

const model = fileURLToPath(new URL('../fixtures/models/textured.glb', import.meta.url));
const page = `<!doctype html>
<title>Handout</title>
<script src="phong-viewer.classic.js"></script>
<phong-viewer alt="A teapot" geometry="teapot" ka="255" gui>
  <phong-light ambient="200 100 50" diffuse="0" specular="0"></phong-light>
</phong-viewer>
<phong-viewer alt="A file" src="textured.glb"></phong-viewer>
`;

test('@release a page opened from disk shows picture and panel in Firefox', async () => {
  test.setTimeout(300_000);
  const folder = mkdtempSync(join(tmpdir(), 'phong-viewer-disk-'));
  cpSync(join(outputFolder('dist'), 'phong-viewer.classic.js'), join(folder, 'phong-viewer.classic.js'));
  cpSync(model, join(folder, 'textured.glb'));
  writeFileSync(join(folder, 'handout.html'), page);
  const firefox = await startFirefox();
  try {
    const tab = await firefox.browser.newPage();
    const said: string[] = [];
    tab.on('console', (message) => said.push(message.text()));
    tab.on('pageerror', (error) => said.push(String(error)));
    await tab.goto(pathToFileURL(join(folder, 'handout.html')).href);
    const { png, text, notice } = await tab.evaluate(async () => {
      const [shape, file] = document.querySelectorAll<PhongViewer>('phong-viewer');
      await Promise.all([shape!.ready, file!.ready]);
      const blob = await shape!.toBlob({ width: 60, height: 40 });
      const bytes = new Uint8Array(await blob.arrayBuffer());
      return {
        png: btoa(String.fromCharCode(...bytes)),
        text: shape!.shadowRoot!.textContent,
        notice: file!.shadowRoot!.querySelector('[part=notice]')?.textContent,
      };
    });
    const { data } = decodePng(Buffer.from(png, 'base64'));
    const middle = 4 * (20 * 60 + 30);
    expect([...data.slice(middle, middle + 4)]).toEqual([200, 100, 50, 255]);
    expect(text).toContain('Controls');
    expect(notice).toContain('python3 -m http.server');
    // The browser's own words about the model.
    expect(said.filter((line) => !/Same Origin Policy .*textured\.glb/.test(line))).toEqual([]);
  } finally {
    await firefox.close();
    rmSync(folder, { recursive: true, force: true });
  }
});
