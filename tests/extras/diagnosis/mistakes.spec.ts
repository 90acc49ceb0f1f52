// Does each mistake in the markup give one warning that names the cure, and correct markup none?

import type { Page } from '@playwright/test';
import type { ConsoleGuard } from '../../support/console-guard.js';
import { expect, test } from '../../support/test.js';
import type { Site } from '../../support/site.js';
import { nextFrame, settled, assign } from '../../element/support/viewer.js';
import { requestsOf } from '../../support/requests.js';

const size = { width: 60, height: 40 };
const scene = (inner: string, attributes = '') =>
  `<phong-viewer geometry="box"${attributes}>${inner}</phong-viewer>`;
const light = (attributes: string) => `<phong-light ${attributes}></phong-light>`;
const mesh = (attributes: string) => `<phong-mesh ${attributes}></phong-mesh>`;

/** Waits until what could be reported so far has been. */
async function reported(page: Page, warnings: readonly string[], count: number) {
  await expect.poll(() => warnings.length).toBeGreaterThanOrEqual(count);
  await nextFrame(page);
  await nextFrame(page);
  return warnings.map((text) => text.replace('warning: ', '')).sort();
}

const claim = (consoleGuard: ConsoleGuard, count: number) =>
  consoleGuard.allow(/^warning: (<p|A <phong-viewer>)/, count);

const LITE =
  '<phong-lite> inside a <phong-viewer>: there is no such element. Did you mean <phong-light> or <phong-mesh>?';
const ALONE = 'is not inside a <phong-viewer>, so it has no effect.';
const NO_END =
  'HTML has no self-closed tags: write </phong-viewer> after the lights and meshes of each viewer.';
const MARKDOWN =
  'In Markdown an empty line ends the HTML: leave none between <phong-viewer> and </phong-viewer>.';

/** Pages, each with all of its warnings in alphabetical order. */
const pages: readonly (readonly [markup: string, ...warnings: string[]])[] = [
  // Unknown attributes, one of each kind of advice; unit/attribute-advice.test.ts has the others.
  [
    scene(light('difuse="red"').repeat(50)),
    '<phong-light> has no attribute difuse. Did you mean diffuse?',
  ],
  [scene(light('pos="1 2 3"')), '<phong-light> has no attribute pos. Write position="x y z w": w = 1 for a place, w = 0 for a direction to the light.'], // oxfmt-ignore
  [scene(mesh('diffuse="red"')), '<phong-mesh> has no attribute diffuse. Write kd="…".'],
  [scene('', ' width="300"'), '<phong-viewer> has no attribute width. CSS sets the size: write style="width: …; height: …".'], // oxfmt-ignore
  [scene(light('shininess="9"')), '<phong-light> has no attribute shininess. It belongs to <phong-mesh> and <phong-viewer>.'], // oxfmt-ignore
  [`<phong-compare lables="a"></phong-compare>`, '<phong-compare> has no attribute lables. Did you mean labels?'], // oxfmt-ignore
  [
    scene('', ' camera-orbit="30deg 60deg 3m" data-camera-orbit v-fov'),
    '<phong-viewer> has no attribute camera-orbit. Write theta="…" and phi="…" in degrees, and radius="…", which place the eye.',
  ],
  [scene('', ' auto-rotat="9"'), '<phong-viewer> has no attribute auto-rotat. Did you mean auto-rotate?'], // oxfmt-ignore
  // Curly quotes, which end no value.
  [
    `<phong-viewer alt=“A box under a lamp” geometry="box">${light('name=„lamp“')}</phong-viewer>`,
    '<phong-light name=„lamp“> has curly quotes, which HTML takes for letters. Write straight ones: name="…".',
    '<phong-viewer alt=“A> has curly quotes, which HTML takes for letters. Write straight ones: alt="…".',
  ],
  // Values of another unit.
  [
    scene(light('diffuse="1 0.5 0.2" specular="0"') + light('specular="#010101"')),
    '<phong-light diffuse="1 0.5 0.2" specular="0"> is nearly black, as 255 is full. For colours from 0 to 1 write diffuse="255 128 51" specular="0".',
  ],
  [
    scene(mesh('geometry="box" ks="1"') + mesh('kd="1" ks="2"'), ' kd="0.8, 0.8, 0.8" ka=".2"'),
    '<phong-mesh ks="1"> is nearly black, as 255 is full. For colours from 0 to 1 write ks="255".',
    '<phong-viewer ka=".2" kd="0.8, 0.8, 0.8"> is nearly black, as 255 is full. For colours from 0 to 1 write ka="51" kd="204".',
  ],
  [
    scene(light('aperture="0.35"') + light('aperture="0.5"') + light('aperture="0"')),
    '<phong-light aperture="0.35"> is a cone narrower than a degree. Angles are in degrees: for radians write aperture="20.05".',
  ],
  // Elements at the wrong place.
  [
    `<p>${light('name="lamp"')}${mesh('')}</p>${scene(light(''))}`,
    `<phong-light name="lamp"> ${ALONE} Move it into one.`,
    `<phong-mesh> ${ALONE} Move it into one.`,
  ],
  [
    scene('<phong-light /><p slot="error">It failed.</p>'),
    '<p slot="error"> is inside a <phong-light>, so it is not shown. Write </phong-light> before it.',
  ],
  [
    `<phong-compare>${scene('')}<figure>${scene('')}</figure></phong-compare>`,
    'A <phong-viewer> in a <figure> inside a <phong-compare> is not shown. Make it a child of the <phong-compare>.',
  ],
  // A viewer without an end tag, and what markdown-it and Pandoc make of an empty line.
  [
    '<article><phong-viewer geometry="box" /><p>Text   after <b>it</b>.</p></article>',
    `<phong-viewer> contains the text "Text after", which is not shown. ${NO_END}`,
  ],
  [
    `${scene('<pre><code>&lt;phong-light name=&quot;sun&quot;&gt;&lt;/phong-light&gt;\n</code></pre>')}
      <div><phong-viewer alt="" geometry="box">\n<p>${light('')}\n</phong-viewer></p>\n<h2>Next</h2>\n</div>
      <p><phong-viewer alt="" geometry="box">${light('')}</p><p>${light('name="lamp"')}</phong-viewer></p>`,
    `<phong-light name="lamp"> ${ALONE} ${MARKDOWN}`,
    `<phong-viewer> contains its lights and meshes as code, which is not shown. ${MARKDOWN}`,
    `<phong-viewer> contains the text "Next", which is not shown. ${MARKDOWN}`,
  ],
];

test('each mistake in the markup is named once a page, with its cure', async ({
  page,
  mount,
  consoleGuard,
}) => {
  const warnings = claim(consoleGuard, pages.flatMap(([, ...texts]) => texts).length);
  for (const [markup, ...wanted] of pages) {
    const before = warnings.length;
    await mount(markup, size);
    await reported(page, warnings, before + wanted.length);
    const found = warnings.slice(before).map((text) => text.replace('warning: ', ''));
    expect(found.sort()).toEqual(wanted);
  }
});

test('a viewer without a size is named with the cause, unless something around it is closed', async ({
  page,
  mount,
  consoleGuard,
}) => {
  const box = (style: string) =>
    `<phong-viewer alt="" geometry="box" style="${style}"></phong-viewer>`;
  const hint = (side: string) => `Set a ${side} in CSS, such as ${side}: 300px.`;
  const flat = (side: string) => `<phong-viewer> has the ${side} 0, so nothing is seen.`;
  const openAndClose = `customElements.whenDefined('phong-viewer').then(async () => {
    await lid.ready;
    lid.style.height = '40px';
    lid.addEventListener('render', () => (lid.style.height = 0), { once: true });
  })`;
  const boxes: readonly (readonly [markup: string, warning?: string])[] = [
    [box('aspect-ratio: auto; height: 100%'), `${flat('height')} height: 100% is 0, as the element around it has no height. ${hint('height')}`], // oxfmt-ignore
    [box('aspect-ratio: auto; height: auto'), `${flat('height')} height: auto is 0, as it has no content. ${hint('height')}`], // oxfmt-ignore
    [box('aspect-ratio: auto; display: inline-block; width: auto'), `${flat('width')} width: auto is 0, as it has no content. ${hint('width')}`], // oxfmt-ignore
    [
      `<div style="display: flex; flex-direction: column">${box('aspect-ratio: auto; flex: 1')}</div>`,
      `${flat('height')} The flex container around it leaves it none. ${hint('height')}`,
    ],
    [box('display: inline'), '<phong-viewer> has display: inline, which has no size. Write display: block.'], // oxfmt-ignore
    [box('display: contents'), '<phong-viewer> has display: contents, which has no size. Write display: block.'], // oxfmt-ignore
    [box('display: none')],
    [`<div style="display: none">${box('height: 100%')}</div>`],
    [`<div style="height: 0; overflow: hidden">${box('height: 100%')}</div>`],
    [`<details><summary>More</summary>${box('height: 100%')}</details>`],
    [`<div style="content-visibility: hidden">${box('height: 100%')}</div>`],
    [box('height: 100%')],
    [`${box('height: 0" id="lid')}<script>${openAndClose}</script>`],
  ];
  const wanted = boxes.flatMap(([, warning]) => warning ?? []).sort();
  const warnings = claim(consoleGuard, wanted.length);
  await mount(`<div>${boxes.map(([markup]) => markup).join('')}</div>`, { csp: '' });
  expect(await reported(page, warnings, wanted.length)).toEqual(wanted);
  await page.waitForTimeout(700); // the others would have been named by now
});

test('later mistakes are named too, at any depth, but no attribute twice', async ({
  page,
  mount,
  consoleGuard,
}) => {
  const warnings = claim(consoleGuard, 4);
  const viewer = await mount(
    scene(
      `<phong-lite></phong-lite><x-foo></x-foo><div><phong-mehs></phong-mehs></div>${light('difuse="1"')}`,
    ),
    size,
  );
  expect(await reported(page, warnings, 3)).toEqual([
    '<phong-light> has no attribute difuse. Did you mean diffuse?',
    LITE,
    '<phong-mehs> inside a <phong-viewer>: there is no such element. Did you mean <phong-mesh>?',
  ]);
  await viewer.evaluate((element) => {
    const inner =
      '<p><phong-lite></phong-lite><phong-group></phong-group></p><phong-light difuse="1"></phong-light>';
    element.insertAdjacentHTML('beforeend', inner);
    document.body.append(element);
  });
  expect(await reported(page, warnings, 4)).toContain(LITE.replace('lite', 'group'));
});

test('correct markup gives no warning, and does not fetch the code for mistakes', async ({
  page,
  site,
  mount,
}) => {
  const fetched = requestsOf(page);
  const own = 'class="a" id="b" data-c aria-hidden="true" title="A box" role="img" tabindex="0"';
  const viewer = await mount(
    `${scene(`${light(own)}${mesh('')}<p slot="error">Text</p>`, ` ${own}`)}<p>Text</p>`,
    size,
  );
  // In no viewer for a part of the task, or in no document.
  await viewer.evaluate((element) => {
    const lights = [1, 2, 3].map(() => document.createElement('phong-light'));
    document.body.append(lights[0]!, lights[1]!);
    document.createElement('div').append(lights[2]!);
    element.append(lights[0]!);
    lights[1]?.remove();
  });
  await nextFrame(page);
  await nextFrame(page);
  expect(fetched.filter((url) => chunkOf(site).test(url))).toEqual([]);
  const foreign =
    'accesskey autocapitalize autocorrect autofocus class contenteditable dir draggable enterkeyhint exportparts id ' +
    'inert inputmode is itemid itemprop itemref itemscope itemtype lang nonce part popover role spellcheck style ' +
    'tabindex title translate virtualkeyboardpolicy writingsuggestions data-difuse aria-label v-bind x-data ' +
    'data-v-7ba5bd90 hx-get client-load astro-cid-mbfjk2xy :shadng @shadng shadng.prop onshadng onload _ngcontent _shadng xml:lang';
  const inner =
    `<!-- note --><div><p>${light(foreign)}${mesh(foreign)}</p></div><template>Text</template><noscript>Text</noscript>` +
    '<div slot="error">Text<img alt=""></div><script type="text/plain">Text</script><style></style>';
  const code = page.waitForResponse(chunkOf(site));
  await mount(
    `${scene(inner, ` ${foreign}`)}<section>${scene('<p>Only where there are no scripts</p>')}<p>Text</p></section>`,
    { ...size, csp: '' },
  );
  await (await code).finished();
  await nextFrame(page);
  await nextFrame(page);
});

const chunkOf = (site: Site) => new RegExp(`${site.origin}/dist/chunks/diagnose.*\\.js`);

test('the code that knows mistakes may fail without consequences', async ({
  page,
  site,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/error: Failed to load resource/, 1);
  await page.route(chunkOf(site), (route) => route.abort());
  const failed = page.waitForEvent('requestfailed');
  const viewer = await mount(scene(light('difuse="red"')), size);
  await failed;
  await assign(viewer, { theta: 5 });
  await settled(viewer);
});

test('an unknown word is named with the nearest one', async ({ mount, consoleGuard }) => {
  const warnings = claim(consoleGuard, 4);
  await mount(
    `<phong-viewer geometry="spere" shading="Gourad">${mesh('geometry="torus-not"')}${mesh('geometry="house"')}</phong-viewer>`,
    size,
  );
  const [first, ...others] = [...warnings].sort();
  expect(first).toMatch(
    /<phong-mesh> geometry="house": expected one of box, .* using none instead\.$/,
  );
  expect(others.map((text) => /Did you mean "(.*)"\?$/.exec(text)?.[1])).toEqual([
    'torus-knot',
    'sphere',
    'gouraud',
  ]);
});

test('a viewer that swallowed another one is named, also during parsing', async ({
  page,
  site,
  consoleGuard,
}) => {
  const warnings = claim(consoleGuard, 1);
  const head = '<script type="module" async src="/dist/phong-viewer.standalone.js"></script>';
  await page.goto(
    site.page('<phong-viewer geometry="box" /><p>Text</p><phong-viewer geometry="box" />', {
      head,
    }),
  );
  expect(await reported(page, warnings, 1)).toEqual([
    `<phong-viewer> contains another <phong-viewer>, which is not shown. ${NO_END}`,
  ]);
});
