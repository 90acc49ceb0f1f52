// Does each mistake in the markup give one warning that names the cure, and correct markup none?

import type { Page } from '@playwright/test';
import type { ConsoleGuard } from '../../support/console-guard.js';
import { expect, test } from '../../support/test.js';
import type { Site } from '../../support/site.js';
import { nextFrame, settled, type PhongViewer } from '../support/viewer.js';

const size = { width: 60, height: 40 };
const scene = (inner: string, attributes = ''): string =>
  `<phong-viewer geometry="box"${attributes}>${inner}</phong-viewer>`;
const light = (attributes: string): string => `<phong-light ${attributes}></phong-light>`;
const mesh = (attributes: string): string => `<phong-mesh ${attributes}></phong-mesh>`;

/** Waits until what could be reported so far has been. */
async function reported(page: Page, warnings: readonly string[], count: number): Promise<string[]> {
  await expect.poll(() => warnings.length).toBeGreaterThanOrEqual(count);
  await nextFrame(page);
  await nextFrame(page);
  return warnings.map((text) => text.replace('warning: ', '')).sort();
}

const claim = (consoleGuard: ConsoleGuard, count: number): readonly string[] =>
  consoleGuard.allow(/^warning: <phong-/, count);

test.describe('an attribute that does not exist', () => {
  /** One of each kind of advice; unit/attribute-advice.test.ts has the others. */
  const rows: readonly (readonly [markup: string, warning: string])[] = [
    [scene(light('difuse="red"')), '<phong-light> has no attribute difuse. Did you mean diffuse?'],
    [scene(light('pos="1 2 3"')), '<phong-light> has no attribute pos. Write position="x y z w": w = 1 for a place, w = 0 for a direction to the light.'], // prettier-ignore
    [scene(mesh('diffuse="red"')), '<phong-mesh> has no attribute diffuse. Write kd="…".'],
    [scene('', ' width="300"'), '<phong-viewer> has no attribute width. CSS sets the size: write style="width: …; height: …".'], // prettier-ignore
    [scene(light('shininess="9"')), '<phong-light> has no attribute shininess. It belongs to <phong-mesh> and <phong-viewer>.'], // prettier-ignore
    [
      '<phong-compare lables="a"></phong-compare>',
      '<phong-compare> has no attribute lables. Did you mean labels?',
    ],
  ];

  test('is named with the correct one', async ({ page, mount, consoleGuard }) => {
    const warnings = claim(consoleGuard, rows.length);
    for (const [markup, warning] of rows) {
      const before = warnings.length;
      await mount(markup, size);
      await reported(page, warnings, before + 1);
      expect(warnings.slice(before)).toEqual([`warning: ${warning}`]);
    }
  });

  test('is named once a page', async ({ page, mount, consoleGuard }) => {
    const warnings = claim(consoleGuard, 1);
    const viewer = await mount(scene(light('shadng difuse=red').repeat(50).replaceAll('shadng', '')), size);
    await reported(page, warnings, 1);
    await viewer.evaluate((element) => {
      element.insertAdjacentHTML('beforeend', '<phong-light difuse="1"></phong-light>');
      document.body.append(element);
    });
    await reported(page, warnings, 1);
  });
});

test('attributes of HTML, ARIA and frameworks give no warning', async ({ page, mount }) => {
  const global =
    'accesskey autocapitalize autocorrect autofocus class contenteditable dir draggable enterkeyhint exportparts hidden id ' +
    'inert inputmode is itemid itemprop itemref itemscope itemtype lang nonce part popover role slot spellcheck style ' +
    'tabindex title translate virtualkeyboardpolicy writingsuggestions';
  const foreign =
    'data-difuse aria-label v-bind data-v-7ba5bd90 x-data auto-rotat :shadng @shadng shadng.prop onshadng onload _ngcontent _shadng xml:lang';
  const attributes = `${global} ${foreign}`.replace('hidden', '').replace('slot ', '');
  await mount(scene(`${light(attributes)}${mesh(attributes)}`, ` ${attributes}`), { ...size, csp: '' });
  await nextFrame(page);
  await nextFrame(page);
});

test('an unknown tag of this family is named, now and later, at any depth', async ({
  page,
  mount,
  consoleGuard,
}) => {
  const warnings = claim(consoleGuard, 3);
  const viewer = await mount(
    scene(
      '<phong-lite></phong-lite><x-foo></x-foo><div><phong-mehs></phong-mehs><phong-lite></phong-lite></div>',
    ),
    size,
  );
  expect(await reported(page, warnings, 2)).toEqual([
    '<phong-lite> inside a <phong-viewer>: there is no such element. Did you mean <phong-light> or <phong-mesh>?',
    '<phong-mehs> inside a <phong-viewer>: there is no such element. Did you mean <phong-mesh>?',
  ]);
  await viewer.evaluate((element) => element.append(document.createElement('phong-group')));
  expect(await reported(page, warnings, 3)).toContain(
    '<phong-group> inside a <phong-viewer>: there is no such element. Did you mean <phong-light> or <phong-mesh>?',
  );
});

test('an unknown word is named with the nearest one', async ({ mount, consoleGuard }) => {
  const warnings = claim(consoleGuard, 4);
  await mount(
    `<phong-viewer geometry="spere" shading="Gourad">${mesh('geometry="torus-not"')}${mesh('geometry="house"')}</phong-viewer>`,
    size,
  );
  const [first, ...others] = [...warnings].sort();
  expect(first).toMatch(/<phong-mesh> geometry="house": expected one of box, .* using none instead\.$/);
  expect(others.map((text) => /Did you mean "(.*)"\?$/.exec(text)?.[1])).toEqual([
    'torus-knot',
    'sphere',
    'gouraud',
  ]);
});

test.describe('a light or mesh without a viewer', () => {
  test('is named once the document is parsed', async ({ page, mount, consoleGuard }) => {
    const warnings = claim(consoleGuard, 2);
    await mount(`<p>${light('name="lamp"')}${mesh('')}</p>${scene(light(''))}`, size);
    expect(await reported(page, warnings, 2)).toEqual([
      '<phong-light name="lamp"> is not inside a <phong-viewer>, so it has no effect. Move it into one.',
      '<phong-mesh> is not inside a <phong-viewer>, so it has no effect. Move it into one.',
    ]);
  });

  test('gives no warning if it lacks a viewer only for part of a task, or is in no document', async ({
    page,
    mount,
  }) => {
    await mount(scene(''), size);
    await page.evaluate(() => {
      const lights = [1, 2, 3].map(() => document.createElement('phong-light'));
      document.body.append(lights[0]!, lights[1]!);
      document.createElement('div').append(lights[2]!);
      document.querySelector('phong-viewer')?.append(lights[0]!);
      lights[1]?.remove();
    });
    await nextFrame(page);
    await nextFrame(page);
  });
});

test.describe('a viewer whose end tag is missing', () => {
  const CURE =
    'HTML has no self-closed tags: write </phong-viewer> after the lights and meshes of each viewer.';

  test('is named if it swallowed text', async ({ page, mount, consoleGuard }) => {
    const warnings = claim(consoleGuard, 1);
    await mount(`<article><phong-viewer geometry="box" /><p>Text   after <b>it</b>.</p></article>`, size);
    expect(await reported(page, warnings, 1)).toEqual([
      `<phong-viewer> contains the text "Text after", which is not shown. ${CURE}`,
    ]);
  });

  test('is named if it swallowed another one, also with a classic script that runs during parsing', async ({
    page,
    site,
    consoleGuard,
  }) => {
    const warnings = claim(consoleGuard, 1);
    const head = '<script type="module" async src="/dist/phong-viewer.standalone.js"></script>';
    await page.goto(
      site.page('<phong-viewer geometry="box" /><p>Text</p><phong-viewer geometry="box" />', { head }),
    );
    expect(await reported(page, warnings, 1)).toEqual([
      `<phong-viewer> contains another <phong-viewer>, which is not shown. ${CURE}`,
    ]);
  });

  test('is put down to an empty line where Markdown made paragraphs or code of the lights', async ({
    page,
    mount,
    consoleGuard,
  }) => {
    const cure =
      'In Markdown an empty line ends the HTML: leave none between <phong-viewer> and </phong-viewer>.';
    const warnings = claim(consoleGuard, 3);
    // As markdown-it and Pandoc write it.
    const code = '<pre><code>&lt;phong-light name=&quot;sun&quot;&gt;&lt;/phong-light&gt;\n</code></pre>';
    const paragraph = `<phong-viewer alt="" geometry="box">\n<p>${light('')}\n</phong-viewer></p>\n<h2>Next</h2>\n`;
    const paragraphs = `<p><phong-viewer alt="" geometry="box">${light('')}</p><p>${light('name="lamp"')}</phong-viewer></p>`;
    await mount(`${scene(code)}<div>${paragraph}</div>${paragraphs}`, size);
    expect(await reported(page, warnings, 3)).toEqual([
      `<phong-light name="lamp"> is not inside a <phong-viewer>, so it has no effect. ${cure}`,
      `<phong-viewer> contains its lights and meshes as code, which is not shown. ${cure}`,
      `<phong-viewer> contains the text "Next", which is not shown. ${cure}`,
    ]);
  });

  test('is not assumed for wrappers, slots, scripts, or content before an end tag', async ({
    page,
    mount,
  }) => {
    const inner =
      `<!-- note --><div><p>${light('')}</p></div><template>Text</template><noscript>Text</noscript>` +
      '<div slot="error">Text<img alt=""></div><script type="text/plain">Text</script><style></style>';
    await mount(
      `${scene(inner)}<section>${scene('<p>Only where there are no scripts</p>')}<p>Text</p></section>`,
      { ...size, csp: '' },
    );
    await nextFrame(page);
    await nextFrame(page);
  });
});

test('a slot that a self-closed light swallowed is named', async ({ page, mount, consoleGuard }) => {
  const warnings = consoleGuard.allow(/^warning: <p slot/, 1);
  await mount(scene('<phong-light /><p slot="error">It failed.</p>'), size);
  expect(await reported(page, warnings, 1)).toEqual([
    '<p slot="error"> is inside a <phong-light>, so it is not shown. Write </phong-light> before it.',
  ]);
});

test.describe('the code that knows mistakes', () => {
  const mistake = scene(light('difuse="red"'));
  const chunkOf = (site: Site): RegExp => new RegExp(`${site.origin}/dist/chunks/diagnose.*\\.js`);

  test('is not fetched for a page without mistakes', async ({ page, site, mount }) => {
    const fetched: string[] = [];
    page.on('request', (request) => fetched.push(request.url()));
    const inner = `${light('class="a" id="b" data-c aria-hidden="true" position="1 2 3" /')}<div slot="error"><p>Text</p></div>`;
    const viewer = await mount(`${scene(inner, ' title="A box" role="img" tabindex="0"')}<p>Text</p>`, size);
    await viewer.evaluate((element) => element.append(document.createElement('phong-mesh')));
    await nextFrame(page);
    await nextFrame(page);
    expect(fetched.filter((url) => chunkOf(site).test(url))).toEqual([]);
  });

  test('may fail to load without consequences', async ({ page, site, mount, consoleGuard }) => {
    consoleGuard.allow(/error: Failed to load resource/, 1);
    await page.route(chunkOf(site), (route) => route.abort());
    const failed = page.waitForEvent('requestfailed');
    const viewer = await mount(mistake, size);
    await failed;
    await viewer.evaluate((element: PhongViewer) => (element.theta = 5));
    await settled(viewer);
  });
});

test('a viewer that is not a child of its <phong-compare> is named with the cure', async ({
  page,
  mount,
  consoleGuard,
}) => {
  const warnings = consoleGuard.allow(/^warning: A <phong-viewer> in a/, 1);
  await mount(`<phong-compare>${scene('')}<figure>${scene('')}</figure></phong-compare>`, size);
  expect(await reported(page, warnings, 1)).toEqual([
    'A <phong-viewer> in a <figure> inside a <phong-compare> is not shown. Make it a child of the <phong-compare>.',
  ]);
});
