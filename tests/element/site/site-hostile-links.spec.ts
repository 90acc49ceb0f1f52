// Can a link to the playground do more than show a scene? Links made by someone who wants to run
// script, restyle the page, reach another host or freeze the tab.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { outputFolder } from '../../../.ci/output-folder.mjs';
import { startSite } from '../../support/site.js';
import { allReady, expect, test } from '../../support/test.js';
import { firstOf, RELEASE } from '../../support/repeats.js';
import { linkTo } from '../../support/site-pages.js';
import type { PhongViewer } from '../support/viewer.js';

const HOST = 'https://models.example';
const hack = 'window.hacked = 1';

/** Each is given `alt`, so that the test knows when it is shown. */
const HOSTILE: Readonly<Record<string, (alt: string) => string>> = {
  'a script inside': (alt) => `<phong-viewer ${alt}><script>${hack}</script></phong-viewer>`,
  'scripts around': (alt) =>
    `<script>${hack}</script><script src="${HOST}/x.js"></script><phong-viewer ${alt}></phong-viewer>`,
  'event attributes': (alt) =>
    `<phong-viewer ${alt} onload="${hack}" onrender="${hack}" onfocus="${hack}" autofocus tabindex="1"><phong-light onclick="${hack}"></phong-light></phong-viewer>`,
  'an image that fails': (alt) =>
    `<img src="x:" onerror="${hack}"><phong-viewer ${alt}><img src="${HOST}/p.png" onerror="${hack}"></phong-viewer>`,
  styles: (alt) =>
    `<style>body{display:none}</style><link rel="stylesheet" href="${HOST}/x.css"><phong-viewer ${alt} style="position:fixed;inset:0" class="easel" id="gate" hidden slot="error" part="x"></phong-viewer>`,
  'javascript: sources': (alt) =>
    `<phong-viewer ${alt} src="javascript:${hack}" poster="JaVaScRiPt:${hack}"><phong-mesh src=" javascript:${hack}"></phong-mesh></phong-viewer>`,
  'data: and blob: sources': (alt) =>
    `<phong-viewer ${alt} src="data:model/gltf+json,{}" poster="data:image/svg+xml,<svg onload='${hack}'/>"><phong-mesh src="blob:http://localhost/1"></phong-mesh><phong-mesh src="file:///etc/passwd"></phong-mesh></phong-viewer>`,
  'other hosts, spelled oddly': (alt) =>
    `<phong-viewer ${alt} src="${HOST}/a.glb" poster="//models.example/b.png"><phong-mesh src="https:\\\\models.example/c.glb"></phong-mesh><phong-mesh src="\\\\models.example\\d.glb"></phong-mesh><phong-mesh src="https://localhost@models.example/e.glb"></phong-mesh><phong-mesh src="\thtt\nps://models.example/f.glb"></phong-mesh></phong-viewer>`,
  'a base for relative sources': (alt) =>
    `<base href="${HOST}/"><phong-viewer ${alt}><phong-mesh src="../assets/models/bunny.glb"></phong-mesh></phong-viewer>`,
  'a refresh': (alt) =>
    `<meta http-equiv="refresh" content="0;url=${HOST}"><phong-viewer ${alt}></phong-viewer>`,
  'frames, forms and objects': (alt) =>
    `<phong-viewer ${alt}><iframe src="${HOST}" srcdoc="<script>parent.hacked=1</script>"></iframe><object data="${HOST}"></object><embed src="${HOST}"><form action="${HOST}"><button id="share">x</button></form></phong-viewer>`,
  svg: (alt) =>
    `<svg onload="${hack}"><use href="${HOST}/x.svg#a"/><phong-viewer src="${HOST}/a.glb"></phong-viewer><foreignObject><phong-viewer ${alt}><phong-light></phong-light></phong-viewer></foreignObject></svg>`,
  'mathml that breaks out': (alt) =>
    `<math><mtext><table><mglyph><style><!--</style><img title="--&gt;&lt;img src=1 onerror=${hack}&gt;"></table></mtext></math><phong-viewer ${alt}></phong-viewer>`,
  'nested viewers': (alt) =>
    `<phong-viewer ${alt}><phong-viewer src="${HOST}/a.glb"><phong-light></phong-light></phong-viewer><phong-light></phong-light></phong-viewer><phong-viewer></phong-viewer>`,
  'a template and a shadow root': (alt) =>
    `<phong-viewer ${alt}><template shadowrootmode="open"><script>${hack}</script></template><template><phong-mesh src="${HOST}/a.glb"></phong-mesh></template></phong-viewer>`,
  'prototype names': (alt) =>
    `<phong-viewer ${alt} __proto__="1" constructor="1" prototype="1" tostring="1"><__proto__></__proto__><constructor onclick="${hack}"></constructor><phong-light __proto__="1" hasownproperty="1" valueof="1"></phong-light></phong-viewer>`,
  'custom built-in elements': (alt) =>
    `<phong-viewer ${alt} is="phong-light"><button is="phong-light" onclick="${hack}"></button></phong-viewer>`,
  'deep nesting': (alt) =>
    `<phong-viewer ${alt}>${'<div>'.repeat(590)}<phong-light></phong-light>${'<phong-light>'.repeat(400)}</phong-viewer>`,
};

/**
 * Chromium applies the page's policy to documents that DOMParser makes, though nothing in them can
 * run, and reports what it refuses there.
 */
const REPORTED = /\son\w+="|<style|\sstyle=|<base/;
const REPORTS =
  /violates the following Content Security Policy directive|CSP report: (script|style|base)-/;

/** Descriptions of everything that must not happen. */
async function harm(page: Page) {
  return page.evaluate(() => {
    const found: string[] = [];
    if ('hacked' in window) {
      found.push('a script ran');
    }
    const allowed = new Set(['phong-light', 'phong-mesh']);
    const viewer = document.querySelector('phong-viewer')!;
    for (const element of viewer.querySelectorAll('*')) {
      if (!allowed.has(element.localName)) {
        found.push(`a <${element.localName}> was copied`);
      }
    }
    for (const element of [viewer, ...viewer.children]) {
      for (const name of element.getAttributeNames()) {
        // The viewer sets tabindex, role and aria-label itself.
        if (
          /^on|^style$|^class$|^is$|^slot$|^part$|^hidden$|^autofocus$|proto|constructor/.test(name)
        ) {
          found.push(`${name} was copied to <${element.localName}>`);
        }
      }
    }
    if (document.querySelectorAll('phong-viewer').length !== 1) {
      found.push('a viewer was copied');
    }
    if (document.querySelectorAll('style, iframe, object, embed, base').length > 0) {
      found.push('markup leaked');
    }
    if (getComputedStyle(document.body).display === 'none') {
      found.push('the page was restyled');
    }
    const [place, own] = [viewer.parentElement!.clientWidth, viewer.clientWidth];
    if (place !== own || getComputedStyle(viewer).position === 'fixed') {
      found.push('the picture was restyled');
    }
    return found;
  });
}

/**
 * On a new page in a release run; otherwise the open playground follows the changed address, as it
 * does for a link in a message.
 */
async function openLink(page: Page, link: string) {
  if (RELEASE) {
    await page.goto('about:blank');
  }
  await page.goto(`/demo/${link}`);
}

for (const [where, count] of [
  ['playground/', Infinity],
  ['embed.html', 6], // the page for frames, which reads links alike
] as const) {
  test(`links to ${where} only show a scene, whatever they contain`, async ({
    page,
    site,
    consoleGuard,
  }) => {
    test.setTimeout(120_000);
    const reports = consoleGuard.allow(REPORTS);
    const elsewhere: string[] = [];
    page.on('request', (request) => {
      if (!request.url().startsWith(site.origin)) {
        elsewhere.push(request.url());
      }
    });
    page.on('dialog', (dialog) => elsewhere.push(dialog.message()));
    for (const [i, [name, text]] of firstOf(Object.entries(HOSTILE), count).entries()) {
      const before = reports.length;
      const alt = `hostile-${String(i)}`;
      await openLink(page, linkTo(text(`alt="${alt}"`)).replace('playground/', where));
      await expect(page.locator(`phong-viewer[alt=${alt}]`), name).toBeVisible();
      await allReady(page);
      if (where === 'playground/') {
        await expect(page.locator('.cm-content'), name).toBeVisible();
      }
      expect.soft(await harm(page), name).toEqual([]);
      expect.soft(elsewhere.splice(0), name).toEqual([]);
      await expect.soft(page, name).toHaveURL(/#scene=/);
      expect.soft(reports.length > before, `${name}: reports`).toBe(REPORTED.test(text('')));
    }
  });
}

test('the page for frames says that it loads nothing from other sites, and that a link is broken', async ({
  page,
}) => {
  await openLink(
    page,
    linkTo(HOSTILE['other hosts, spelled oddly']!('')).replace('playground/', 'embed.html'),
  );
  const status = page.getByRole('status');
  await expect(status).toContainText('Files of other sites are not loaded here');
  await expect(status, 'legible over any picture').toHaveCSS(
    'background-color',
    'rgb(255, 255, 255)',
  );
  await openLink(page, 'embed.html#scene=AAAAAAAA____');
  await expect(status).toContainText('This link is broken');
});
for (const where of ['playground/', 'embed.html']) {
  test(`the viewers of a link to ${where} hold together what one viewer may`, async ({ page }) => {
    const limitsOf = async (count: number) => {
      const viewers = '<phong-viewer alt="part"></phong-viewer>'.repeat(count);
      const link = linkTo(`<phong-compare>${viewers}</phong-compare>`);
      await openLink(page, link.replace('playground/', where));
      await expect(page.locator('phong-viewer[alt=part]')).toHaveCount(count);
      return page.evaluate(() => {
        const all = [...document.querySelectorAll('phong-viewer')];
        const sum = (values: readonly number[]) => values.reduce((a, b) => a + b, 0);
        return [
          sum(all.map(({ maxMemory }) => maxMemory)),
          sum(all.map(({ maxTriangles }) => maxTriangles)),
        ];
      });
    };
    const single = await limitsOf(1);
    expect(single).toEqual([950_000_000, 2 ** 22]);
    expect(await limitsOf(4)).toEqual(single);
  });
}

test('the removed parts and bad values are named, briefly, without scrolling', async ({
  page,
  consoleGuard,
}) => {
  consoleGuard.allow(REPORTS);
  consoleGuard.allow(/expected/, 4);
  const many = Array.from({ length: 30 }, (_, i) => `<x-${i}-${'long'.repeat(50)}></x->`).join('');
  await page.goto(
    `/demo/${linkTo(`<phong-viewer style="x" foov="9" theta="x" phi="x" radius="x" fov="x"><script></script>${many}</phong-viewer>`)}`,
  );
  const messages = page.locator('#messages li');
  await expect(messages).toHaveCount(10);
  await expect(messages.last()).toBeInViewport();
  await expect(messages.nth(0)).toHaveText('Left out: style of <phong-viewer>.');
  await expect(messages.nth(1)).toHaveText('Left out: foov of <phong-viewer>. Did you mean "fov"?');
  await expect(messages.nth(2)).toHaveText('Left out: <script>.');
  for (const message of await messages.allTextContents()) {
    expect(message.length).toBeLessThan(110);
  }
});

const broken = /This link is broken|no example of this name|Write a <phong-viewer>/;

/**
 * Addresses, and what the page says of them. unit/site-address.test.ts has more that are broken.
 */
const REFUSED: readonly (readonly [address: string, message: RegExp])[] = [
  ['playground/#scene=<img src=x onerror=alert(1)>', broken],
  ['playground/#example=__proto__', broken],
  // Short in the link.
  [linkTo(`<phong-viewer>${' '.repeat(200_000_000)}</phong-viewer>`), /too long to show/],
  [linkTo(`<phong-viewer alt="hostile">${'<b>'.repeat(1000)}`), /too many elements/],
];

test('links that are broken or too large show an example and an error', async ({ page }) => {
  test.setTimeout(120_000);
  for (const [address, message] of REFUSED) {
    await page
      .locator('#messages li')
      .evaluateAll((items) => items.forEach((item) => item.remove()));
    await openLink(page, address);
    await expect(page.locator('#messages')).toHaveText(message);
    await expect(page.locator('#scene:not([alt=hostile])')).toBeVisible();
  }
});

test('files of another host are fetched after a click, and only from the host that was named', async ({
  page,
}) => {
  const bunny = readFileSync(
    join(fileURLToPath(new URL('../../..', import.meta.url)), 'demo/assets/models/bunny.glb'),
  );
  const fetched: string[] = [];
  await page.route(/\.example\//, async (route) => {
    fetched.push(route.request().url());
    await route.fulfill({ body: bunny, headers: { 'access-control-allow-origin': '*' } });
  });
  // Without the server's own policy: the page's allows https: here.
  const site = await startSite({ '/': outputFolder('site') }, '');
  try {
    const scene = `<phong-viewer theta="5"><phong-mesh src="${HOST}/a.glb"></phong-mesh><phong-light></phong-light></phong-viewer>`;
    await page.goto(`${site.origin}/${linkTo(scene)}`);
    await expect(page.locator('.cm-content')).toBeVisible();
    await expect(page.locator('#gate')).toContainText(`files from ${HOST}.`);
    await page.locator('phong-viewer').press('ArrowLeft');
    await expect
      .poll(() => page.locator('phong-viewer').evaluate((v: PhongViewer) => v.camera.theta))
      .not.toBe(5);
    expect(await page.locator('.cm-content').textContent(), 'the source is not lost').toContain(
      HOST,
    );
    expect(fetched).toEqual([]);
    await page.getByRole('button', { name: 'Load them' }).click();
    await expect(page.locator('#gate')).toBeHidden();
    await allReady(page);
    expect(fetched).toEqual([`${HOST}/a.glb`]);
    await page.goto(
      `${site.origin}/${linkTo(scene.replace('</phong-viewer>', '<phong-mesh src="https://second.example/b.glb"></phong-mesh></phong-viewer>'))}`,
    );
    await expect(page.locator('#gate')).toContainText('files from https://second.example.');
    expect(fetched.filter((url) => url.includes('second'))).toEqual([]);
  } finally {
    // Ends what the page is still fetching.
    await page.goto('about:blank');
    await site.close();
  }
});
