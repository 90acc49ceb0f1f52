// When does a move of the mouse lay the page out? What moves with the picture is written after all
// sizes are read, so the layout at the end of the frame is enough: script never waits for one.

import { expect, test } from '../../support/test.js';
import { settled } from '../support/viewer.js';

const MOVES = 30;
const lights = `<phong-light position="1 2 1 0"></phong-light>
  <phong-light position="2 2 0 1" attenuation="1 0.2 0.05"></phong-light>
  <phong-light position="0 3 3 1" axis="0 -1 -1" aperture="20" cutoff="12"></phong-light>`;

const PROBE = '<phong-probe for="v" as="formula"></phong-probe>';

interface TraceEvent {
  readonly name: string;
  readonly args: { readonly beginData?: { readonly stackTrace?: object } };
}

for (const [what, attributes, layouts, beside = ''] of [
  ['a drag with a picture alone', '', 'never'],
  ['a drag with a legend', 'view="normals"', 'never'],
  ['a drag with a probe', 'probe', 'never'],
  ['a mouse around a shape with a probe', 'probe', 'once a frame'],
  ['a mouse over a probe beside a <phong-probe>', 'probe', 'once a frame', PROBE],
  [
    'a drag with all of these',
    'helpers="lights axes grid normals bounds" gui probe view="n-dot-l"',
    'once a frame',
    PROBE,
  ],
] as const) {
  test(`${what} lays the page out ${layouts}`, async ({ browser, page, mount }) => {
    const viewer = await mount(
      `<phong-viewer id="v" geometry="box" ${attributes}>${lights}</phong-viewer>${beside}`,
      { width: 500, height: 320 },
    );
    await settled(viewer);
    await viewer.focus();
    const radius = what.includes('around') ? 90 : 20;
    const move = async (count: number) => {
      for (let step = 0; step < count; step++) {
        await page.mouse.move(200 + radius * Math.sin(step), 130 - radius * Math.cos(step));
        await page.evaluate(() => new Promise(requestAnimationFrame));
      }
    };
    await move(1);
    if (what.startsWith('a drag')) {
      await page.mouse.down();
    }
    // The first moves show what a drag changes, such as the shape of the pointer.
    await move(5);
    await browser.startTracing(page, {
      categories: ['devtools.timeline', 'disabled-by-default-devtools.timeline.stack'],
    });
    await move(MOVES);
    const trace = JSON.parse(String(await browser.stopTracing())) as {
      readonly traceEvents: readonly TraceEvent[];
    };
    await page.mouse.up();
    const found = trace.traceEvents.filter(({ name }) => name === 'Layout');
    const forced = found.filter(({ args }) => args.beginData?.stackTrace !== undefined);
    expect(forced).toEqual([]);
    // Tracing itself is seen to work.
    expect(found.length > MOVES / 2).toBe(layouts !== 'never');
  });
}
