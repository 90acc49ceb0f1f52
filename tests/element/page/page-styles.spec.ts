// Do the page's text styles leave alone what an element shows over its picture, and do those that
// people set in order to read reach it?

import { expect, test } from '../../support/test.js';
import { nextFrame } from '../support/viewer.js';

/** Inherited properties, with a value that a page may have. */
const STYLES: Readonly<Record<string, string>> = {
  'writing-mode': 'vertical-rl',
  'text-orientation': 'upright',
  'white-space': 'nowrap',
  'word-break': 'break-all',
  'overflow-wrap': 'anywhere',
  'line-break': 'anywhere',
  hyphens: 'auto',
  'text-align': 'right',
  'text-align-last': 'center',
  'text-indent': '3em',
  'text-transform': 'uppercase',
  'text-shadow': '1px 1px red',
  '-webkit-text-fill-color': 'transparent',
  '-webkit-text-stroke': '1px red',
  'list-style': 'square inside',
  'line-height': '0',
  'font-size': '0',
  'font-style': 'italic',
  'font-weight': '900',
  'font-variant': 'small-caps',
  'font-family': 'monospace',
  'border-collapse': 'collapse',
  'border-spacing': '9px',
  'caption-side': 'bottom',
  'empty-cells': 'hide',
};

const SCENE = '<phong-light name="sun" position="-1 1 1 0" ambient="26 28 36" diffuse="150"></phong-light>'; // oxfmt-ignore

/** Legend, probe, marks of lights, panel and a notice; a comparison; a control on a line. */
const PAGE = `<style>
    phong-viewer, phong-compare, #c { position: absolute !important; left: 0 }
    #a { top: 0; width: 900px; height: 440px }
    #b { top: 450px; width: 400px; height: 120px }
    #d { left: 410px; top: 450px; width: 400px; height: 200px }
    #c > * { width: 400px } /* otherwise it is as wide as its content, at the right of vertical lines */
    #c { top: 580px; width: 400px; height: 60px; font: 14px/1.5 sans-serif; color: black }
  </style>
  <main lang="en">
    <phong-viewer id="a" geometry="sphere" gui probe probe-at="0.2 0.3 0.346" view="n-dot-l" helpers="lights">${SCENE}</phong-viewer>
    <phong-compare id="b" labels="one long name, two" layout="side"><phong-viewer geometry="box">${SCENE}</phong-viewer><phong-viewer geometry="box" shading="flat">${SCENE}</phong-viewer></phong-compare>
    <phong-viewer id="d" src="/fixtures/no-such-model-of-a-long-name.glb"></phong-viewer>
    <div id="c"><phong-control for="a" attribute="theta"></phong-control></div>
  </main>`;

test('no inherited style of the page changes what lies over a picture, in a panel, a comparison or a control', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/no-such-model|404/);
  await mount(PAGE, { csp: '' });
  await expect(page.locator('phong-viewer [part=probe]').first()).toBeVisible();
  await expect(page.locator('#d [part=notice]')).toBeVisible();
  await expect(page.locator('#b [part=label]').first()).toBeVisible();
  await expect(page.locator('#c input').first()).toBeVisible();
  /** Every text: where it is, and how it is drawn. */
  const read = async (): Promise<readonly string[]> => {
    await nextFrame(page);
    await nextFrame(page);
    return page.evaluate(() => {
      const texts: string[] = [];
      const walk = (root: ParentNode) => {
        for (const element of root.querySelectorAll('*')) {
          const own = [...element.childNodes].some(
            (node) => node.nodeType === Node.TEXT_NODE && node.nodeValue?.trim() !== '',
          );
          const { x, y, width, height } = element.getBoundingClientRect();
          if (own && !element.matches('style, script, option') && width > 1) {
            const drawn = getComputedStyle(element);
            const place = [x, y, width, height].map(Math.round).join(' ');
            texts.push(
              `${element.localName} ${element.textContent.trim().slice(0, 20)} ${place} ${drawn.color} ${drawn.font} ` +
                `${drawn.textTransform} ${drawn.textShadow} ${drawn.webkitTextFillColor} ${drawn.webkitTextStrokeWidth}`,
            );
          }
          if (element.shadowRoot !== null) {
            walk(element.shadowRoot);
          }
        }
      };
      walk(document);
      return texts;
    });
  };
  const style = (name: string, value: string) =>
    page
      .locator('main')
      .evaluate((main, [key, text]) => main.style.setProperty(key, text), [name, value] as const);
  const plain = await read();
  expect(plain.length).toBeGreaterThan(40);
  const changed: string[] = [];
  for (const [name, value] of Object.entries(STYLES)) {
    await style(name, value);
    const now = await read();
    const first = now.findIndex((text, i) => text !== plain[i]);
    if (first >= 0) {
      changed.push(`${name}: ${plain[first]} becomes ${now[first]}`);
    }
    await style(name, '');
  }
  expect(await read(), 'without them it is as before').toEqual(plain);
  expect(changed).toEqual([]);
  for (const name of ['letter-spacing', 'word-spacing']) {
    await style(name, '3px');
    expect(await read(), `${name} is inherited`).not.toEqual(plain);
    await style(name, '');
  }
});

test('a style sheet that resets all elements of the page leaves pictures in their boxes', async ({
  page,
  mount,
}) => {
  const box = '<phong-viewer geometry="box"></phong-viewer>';
  await mount(
    `<style>
      * { all: unset }
      div { display: block; height: 100px }
      phong-viewer, phong-compare { display: block; width: 120px; height: 80px }
    </style><div></div>${box}<phong-compare layout="side">${box}${box}</phong-compare>`,
    { csp: '' },
  );
  await expect(page.locator('phong-compare canvas')).toHaveCount(2);
  await nextFrame(page);
  const boxes = await page.evaluate(() =>
    Array.from(document.querySelectorAll('phong-viewer'), (viewer) => {
      const [own, canvas] = [viewer, viewer.shadowRoot!.querySelector('canvas')!].map((element) => {
        const { x, y, width, height } = element.getBoundingClientRect();
        return [x, y, width, height].map(Math.round).join(' ');
      });
      return { own, canvas };
    }),
  );
  expect(boxes.map(({ canvas }) => canvas)).toEqual(boxes.map(({ own }) => own));
  expect(boxes[0]!.own).toMatch(/ 120 80$/);
});
