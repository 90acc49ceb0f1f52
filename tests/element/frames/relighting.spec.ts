// Do frames in which only lights have changed cost little and still show the whole scene, whatever
// else changes before, with or after them? The oracle is `toBlob`, which always draws everything.

import type { Locator, Page } from '@playwright/test';
import {
  type ViewerLocator,
  compare,
  expect,
  pixels,
  test,
  type Picture,
} from '../../support/test.js';
import { drawFrames, moveFor } from './driving.js';
import { drawnWith, type GlProgram, logGl } from '../support/gl-log.js';
import { holdContext, loseAndRestore } from '../page/many-viewers.js';
import { type PhongViewer, settled } from '../support/viewer.js';
import { betweenPrograms } from '../../visual/between-programs.js';

const size = { width: 60, height: 44 };

interface Shown {
  /** The picture on the page. */
  readonly picture: Picture;
  /** WebGL calls of that frame. */
  readonly calls: number;
  /** Texts of the programs that it was drawn by. */
  readonly programs: string;
}

const programsOf = (drawn: readonly GlProgram[]) =>
  drawn
    .map(({ vertex, fragment }) => vertex + fragment)
    .sort()
    .join();

/** Runs `change` in one task and returns what the next frame shows. */
async function shownAfter(
  viewer: ViewerLocator,
  change: (element: PhongViewer) => void,
): Promise<Shown> {
  const waiting = viewer.evaluate(async (element) => {
    window.glLog.take();
    await new Promise((resolve) => element.addEventListener('render', resolve, { once: true }));
    // A microtask after the drawing: the canvas still has what the page will show.
    const drawn = window.glLog.drawnWith();
    const { calls } = window.glLog.take();
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    const { width, height } = canvas;
    const context = new OffscreenCanvas(width, height).getContext('2d')!;
    context.drawImage(canvas, 0, 0);
    return { calls, drawn, width, height, data: context.getImageData(0, 0, width, height).data };
  });
  await viewer.evaluate(change);
  const { calls, drawn, width, height, data } = await waiting;
  return {
    calls,
    programs: programsOf(drawn),
    picture: { width, height, data: new Uint8Array(data) },
  };
}

const moveLights = (element: PhongViewer) => {
  for (const light of element.lights) {
    const [x, y, z, w] = light.position;
    light.position = [x - 0.3 * z, y, z + 0.3 * x, w];
  }
};

/** Directional, point and spot lights in turn, on a sphere that fills the picture. */
// Whoever writes `pixel-ratio` gets all pixels, so no fence is among the calls.
const markup = (lights: number) =>
  `<phong-viewer pixel-ratio="1" geometry="sphere" segments="24" radius="0.9" target="0 0 0">${Array.from(
    { length: lights },
    (_, i) => {
      const place = `${Math.cos(i).toFixed(2)} 1 ${Math.sin(i).toFixed(2)}`;
      const colors = `diffuse="${(300 / lights + i).toFixed(1)} 30 20" ambient="1 2 3"`;
      const spot = i % 3 === 2 ? 'axis="0 -1 0" aperture="60" cutoff="2"' : '';
      return `<phong-light position="${place} ${Math.min(i % 3, 1)}" ${colors} ${spot}></phong-light>`;
    },
  ).join('')}</phong-viewer>`;

/** Beside or between moves of lights. */
const CHANGES: Readonly<Record<string, (element: PhongViewer) => void>> = {
  'a surface': (element) => (element.kd = [90, 200, 90]),
  'the eye': (element) => (element.theta += 20),
  'the field': (element) => (element.fov = 50),
  'the terms': (element) => (element.terms = ['diffuse', 'specular']),
  'the shading': (element) => (element.shading = 'flat'),
  'the colour space': (element) => (element.colorInterpolation = 'linear'),
  'one light less': (element) => (element.lights[1]!.active = false),
  'one light more': (element) => element.append(element.lights[0]!.cloneNode()),
  'another kind of light': (element) => (element.lights[0]!.position = [1, 1, 0.5, 1]),
  'a mesh': (element) =>
    (element.innerHTML +=
      '<phong-mesh geometry="box" position="0.3 0 0.3" scale="0.4"></phong-mesh>'),
  'its place': (element) => (element.meshes[0]!.position = [0.2, 0.3, 0.3]),
  'an object of one’s own': (element) => {
    element.scene.children[0]!.visible = false;
    element.requestRender();
  },
  'it again': (element) => {
    element.scene.children[0]!.visible = true;
    element.requestRender();
  },
  'the mesh away': (element) => element.meshes[0]!.remove(),
  'the geometry': (element) => (element.geometry = 'box'),
};

async function expectWhole(viewer: ViewerLocator, which: string, { picture, programs }: Shown) {
  const whole = await pixels(viewer);
  const same = programsOf(await drawnWith(viewer.page())) === programs;
  const isLit = picture.data.some((code) => code > 40 && code < 250);
  expect(isLit, which).toBe(true);
  // To the bit by the same programs; one that was compiled meanwhile may differ by a code.
  if (same) {
    expect(compare(picture, whole).max, which).toBe(0);
  } else {
    expect(betweenPrograms(picture, whole).max, which).toBeLessThanOrEqual(1);
  }
}

async function settle(page: Page, viewer: ViewerLocator) {
  await drawFrames(page, 30); // long enough for a specialised program
  await moveFor(viewer, 30);
}

// Few lights get a specialised program while they stand still, many never do in software.
for (const [lights, which, tag] of [
  [6, 'few lights', ''],
  [30, 'many lights', '@release '],
] as const) {
  test(`${which} that move cost three calls: one upload, one clear and one draw`, async ({
    page,
    mount,
  }) => {
    await logGl(page);
    const viewer = await mount(markup(lights), size);
    await settle(page, viewer);
    const before = await pixels(viewer);
    await shownAfter(viewer, moveLights); // after a drawing of another kind
    for (let frame = 0; frame < 3; frame++) {
      const shown = await shownAfter(viewer, moveLights);
      expect(shown.calls).toBe(3);
      expect(compare(shown.picture, before).max).toBeGreaterThan(5);
    }
    await expectWhole(viewer, which, await shownAfter(viewer, moveLights));
  });

  test(`${tag}${which} that move show the whole scene, whatever else changes`, async ({
    page,
    mount,
  }) => {
    await logGl(page);
    const viewer = await mount(markup(lights), size);
    await settle(page, viewer);
    for (const [name, change] of Object.entries(CHANGES)) {
      await shownAfter(viewer, moveLights);
      await shownAfter(viewer, change);
      await expectWhole(viewer, `lights after ${name}`, await shownAfter(viewer, moveLights));
      await expectWhole(viewer, `lights again after ${name}`, await shownAfter(viewer, moveLights));
    }
  });
}

test('lights that move beside another viewer, or after a restored context, show the scene', async ({
  page,
  mount,
}) => {
  await logGl(page);
  await holdContext(page);
  const viewer = await mount(markup(6), size);
  const expectWholeMoves = async (which: string, others: readonly Locator[] = []) => {
    for (let frame = 0; frame < 3; frame++) {
      for (const one of [viewer, ...others]) {
        await expectWhole(one, which, await shownAfter(one, moveLights));
      }
    }
  };
  await settle(page, viewer);
  await page.evaluate((html) => document.body.insertAdjacentHTML('beforeend', html), markup(3));
  const other = page.locator('phong-viewer').nth(1);
  await settled(other);
  await expectWholeMoves('beside', [other]);
  await other.evaluate((element) => element.remove());
  await expectWholeMoves('alone');
  await loseAndRestore(page, viewer, () =>
    viewer.evaluate((element) => (element.lights[0]!.position = [0, 2, 1, 0])),
  );
  await expectWholeMoves('restored');
});
