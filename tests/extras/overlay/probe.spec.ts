// Does the probe explain the point chosen by mouse, finger, keyboard or markup, and rest otherwise?
// Compared with shadeAt. Places are CSS pixels of the viewer, which lies at the page's top left.

import type { Page } from '@playwright/test';
import { patch, type Texel } from '../../support/gltf.js';
import { type ViewerLocator, expect, test } from '../../support/test.js';
import { countEverything, NOTHING, spentIn } from '../../element/support/counting.js';
import {
  assign,
  drag,
  Fingers,
  nextFrame,
  type PhongViewer,
  pointerAway,
  settled,
  htmlOf,
  cameraOf,
  statsOf,
} from '../../element/support/viewer.js';

const LIGHTS = `
  <phong-light name="sun" position="-1 1.4 1.2 0" ambient="26 28 36" diffuse="110 112 118" specular="150"></phong-light>
  <phong-light name="lamp" position="0.9 0.5 0.6 1" diffuse="#d98c46" specular="#c8aa8a" attenuation="1 0.2 0.6"></phong-light>
  <phong-light name="off" active="false"></phong-light>`;

/** A sphere that fills most of 600 × 400. */
const scene = (attributes = 'probe', lights = LIGHTS) =>
  `<phong-viewer geometry="sphere" segments="64" theta="0" phi="90" radius="1.6" target="0 0 0" ${attributes}>${lights}</phong-viewer>`;

const box = (viewer: ViewerLocator) => viewer.locator('[part=probe]');
const codes = (viewer: ViewerLocator) => viewer.locator('[part=probe] .codes');
const cursor = (viewer: ViewerLocator) => viewer.locator('.probe > .cursor');
const labels = (viewer: ViewerLocator) => viewer.locator('.probe > svg text').allTextContents();

/** The red, green and blue that shadeAt gives for this place. */
const colorAt = (viewer: ViewerLocator, x: number, y: number): Promise<readonly number[]> =>
  viewer.evaluate(async (element, at) => (await element.shadeAt(...at))!.color, [x, y] as const);

/** The expected codes of the box for this place. */
const expected = async (viewer: ViewerLocator, x: number, y: number) =>
  (await colorAt(viewer, x, y)).map((c) => (255 * c).toFixed(0)).join(' ');

/** The box has the codes of this place. */
const expectShown = async (viewer: ViewerLocator, x: number, y: number) =>
  expect(codes(viewer)).toHaveText(await expected(viewer, x, y));

/** The middle of the cross-hair. */
async function cursorPlace(viewer: ViewerLocator): Promise<readonly [x: number, y: number]> {
  const { x, width, y, height } = (await cursor(viewer).boundingBox())!;
  return [x + width / 2, y + height / 2];
}

const unpin = (viewer: ViewerLocator) => box(viewer).getByRole('button', { name: 'Unpin' });

const escape = (page: Page) => page.keyboard.press('Escape');

test.describe('a mouse over a viewer with a probe', () => {
  test('shows the colour of the fragment below it, live, and nothing beside the shape', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene());
    await expect(box(viewer)).toBeHidden();
    await page.mouse.move(250, 150);
    await expect(box(viewer)).toBeVisible();
    expect(await codes(viewer).textContent()).toBe(await expected(viewer, 250, 150));
    await page.mouse.move(330.5, 260);
    await expectShown(viewer, 330.5, 260);
    const before = await codes(viewer).textContent();
    await assign(viewer.locator('phong-light').first(), { diffuse: [10, 200, 10] });
    await expect(codes(viewer)).not.toHaveText(before!);
    await expectShown(viewer, 330.5, 260);
    await viewer.evaluate((element) => element.lights[0]!.remove());
    await expect(box(viewer).locator('tbody tr')).toHaveCount(1);
    await page.mouse.move(5, 5);
    await expect(box(viewer)).toBeHidden();
    expect(await labels(viewer)).toEqual([]);
  });

  test('gets a table of the active lights’ terms, and sees N, V, an L for each, and R of the one that adds most', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene());
    await page.mouse.move(280, 130);
    await expect(box(viewer).locator('tbody tr')).toHaveCount(2);
    const cells = await box(viewer)
      .locator('tbody tr')
      .last()
      .locator('td:not([data-column="…"]) bdi')
      .allTextContents();
    const { ambient, diffuse, specular, att } = await viewer.evaluate(
      async (element) => (await element.shadeAt(280, 130))!.shares[1]!,
    );
    const triple = (color: readonly number[]) =>
      color.every((c) => c === 0) ? '0' : color.map((c) => (255 * c).toFixed(0)).join(' ');
    expect(cells.slice(0, -1)).toEqual([
      ...[ambient, diffuse, specular].map(triple),
      att.toFixed(2),
      '1',
    ]);
    await expect
      .poll(async () => (await labels(viewer)).sort().join())
      .toMatch(/^[\d.]+°,L lamp,L sun,N,R ∠V [\d.]+°,V$/);
    await assign(viewer, { reflection: 'blinn-phong' });
    await expect.poll(() => labels(viewer)).toContain('H');
    expect(await labels(viewer)).not.toContainEqual(expect.stringMatching(/^R/));
  });
});

test.describe('a click', () => {
  test('pins the point, which stays in its place in the scene, until Escape or without `probe`', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene());
    await page.mouse.click(280, 130);
    await expect(box(viewer)).toHaveClass(/pinned/);
    const pinned = await codes(viewer).textContent();
    await page.mouse.move(320, 220);
    await nextFrame(page);
    await expect(codes(viewer)).toHaveText(pinned!);
    const [before] = await cursorPlace(viewer);
    await assign(viewer, { theta: 20 });
    await expect.poll(async () => (await cursorPlace(viewer))[0]).toBeLessThan(before - 20);
    await expectShown(viewer, ...(await cursorPlace(viewer)));
    await escape(page);
    await expect(box(viewer)).toBeHidden();
    await page.mouse.move(321, 220);
    const shown = await expected(viewer, 321, 220);
    await expect(codes(viewer)).toHaveText(shown);
    await page.mouse.click(321, 220);
    await expect(box(viewer)).toHaveClass(/pinned/);
    await viewer.evaluate((element) => {
      const section = document.createElement('section');
      element.before(section);
      section.append(element);
    });
    await expect(box(viewer)).toHaveClass(/pinned/);
    await expect(codes(viewer)).toHaveText(shown);
    await assign(viewer, { probe: false });
    await expect(box(viewer)).toHaveCount(0);
    await assign(viewer, { probe: true });
    await expect(box(viewer)).toBeAttached();
    await settled(viewer);
    await expect(box(viewer)).not.toHaveClass(/pinned/);
  });

  test('elsewhere moves the pin; beside the shape or on its button removes it; so does a tap', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene());
    await drag(page, [280, 130], [40, 0]);
    await nextFrame(page);
    await expect(box(viewer)).not.toHaveClass(/pinned/);
    expect((await cameraOf(viewer)).theta).not.toBe(0);
    await page.mouse.click(280, 130);
    await page.mouse.click(330, 150);
    await expectShown(viewer, 330, 150);
    await page.mouse.click(5, 5);
    await expect(box(viewer)).toBeHidden();
    await page.mouse.click(280, 130);
    await unpin(viewer).click();
    await expect(box(viewer)).not.toHaveClass(/pinned/);
    const fingers = await Fingers.on(page);
    const tap = async (x: number, y: number) => {
      await fingers.down([x, y]);
      await fingers.up();
    };
    await tap(330, 150);
    await expect(box(viewer)).toHaveClass(/pinned/);
    await expectShown(viewer, 330, 150);
    await tap(5, 5);
    await expect(box(viewer)).toBeHidden();
  });
});

test.describe('`probe-at`', () => {
  test('is explained while the mouse is not on the shape, and follows the attribute', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene('probe probe-at="0 0 0.5"'));
    await expectShown(viewer, 300, 200);
    await expect(box(viewer)).toHaveClass(/pinned/);
    await page.mouse.move(350, 150);
    await expectShown(viewer, 350, 150);
    await expect(box(viewer)).not.toHaveClass(/pinned/);
    await page.mouse.move(5, 5);
    await expectShown(viewer, 300, 200);
    await expect(unpin(viewer)).toBeHidden();
    await viewer.evaluate((element) => element.setAttribute('probe-at', '0 0.25 0.4330127'));
    await expect(codes(viewer)).not.toHaveText(await expected(viewer, 300, 200));
    const [x, y] = await cursorPlace(viewer);
    expect(x).toBeCloseTo(300, 0);
    await expectShown(viewer, 300, y);
    await viewer.evaluate((element) => element.removeAttribute('probe-at'));
    await expect(box(viewer)).toBeHidden();
  });

  test('is reported as hidden behind another surface, or as missing', async ({ mount }) => {
    const viewer = await mount(scene('probe probe-at="0 0 -0.5"'));
    await expect(box(viewer)).toHaveText(/Another surface hides the point\./);
    expect(await labels(viewer)).toEqual([]);
    await assign(viewer, { theta: 180 });
    await expectShown(viewer, 300, 200);
    await assign(viewer, { probeAt: [2, 0.5, 0] });
    await expect(box(viewer)).toHaveText(/The point is outside the picture\./);
    await assign(viewer, { probeAt: [0, 0, 9], theta: 0 }); // behind the eye
    await expect(box(viewer)).toHaveText(/The point is outside the picture\./);
    await assign(viewer, { probeAt: [0.7, 0, 0] });
    await expect(box(viewer)).toHaveText(/No surface there\./);
    // Few pixels, and a surface that leans away: the pixel's centre is nearer than the point.
    const small = { width: 300, height: 150 };
    const floor = await mount(
      '<phong-viewer geometry="plane" probe probe-at="0 0 0"></phong-viewer>',
      small,
    );
    await expect(codes(floor)).toHaveText(/^\d/);
  });

  test('is not changed by a click, and Escape returns to it; toHTML writes it, or the pin of the user', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene('probe probe-at="0 0 0.5"'));
    const declared = await expected(viewer, 300, 200);
    await expect(codes(viewer)).toHaveText(declared);
    const html = () => htmlOf(viewer);
    const pointIn = (markup: string) => /probe-at="([^"]*)"/.exec(markup)?.[1];
    expect(pointIn(await html())).toBe('0 0 0.5');
    await page.mouse.click(330, 150);
    await expectShown(viewer, 330, 150);
    const shown = await codes(viewer).textContent();
    const p = await viewer.evaluate(async (element) => (await element.shadeAt(330, 150))!.p);
    const written = await html();
    const numbers = pointIn(written)!.split(' ').map(Number);
    p.forEach((x, i) => expect(numbers[i]).toBeCloseTo(x, 6));
    await expect(viewer).toHaveJSProperty('probeAt', [0, 0, 0.5]);
    expect(await viewer.getAttribute('probe-at')).toBe('0 0 0.5');
    await escape(page);
    await expect(codes(viewer)).toHaveText(declared);
    await page.mouse.click(330, 150);
    await expect(unpin(viewer)).toBeVisible();
    await assign(viewer, { probeAt: [0, 0.25, 0.4330127] });
    await expect(
      unpin(viewer),
      'what is assigned takes the place of what was clicked',
    ).toBeHidden();
    await expect(box(viewer)).toHaveClass(/pinned/);
    await expect(codes(viewer)).not.toHaveText(declared);
    await page.mouse.click(330, 150);
    await expect(unpin(viewer)).toBeVisible();
    await assign(viewer, { probe: false });
    expect(pointIn(await html()), 'without a probe nothing is pinned but what is declared').toBe(
      '0 0.25 0.4330127',
    );
    await mount(written);
    await expect(codes(viewer)).toHaveText(shown!);
  });
});

test.describe('the cross-hair', () => {
  test('is a Tab stop that arrow keys move by one or ten pixels, and Enter pins', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene());
    await pointerAway(page);
    await page.keyboard.press('Tab');
    await page.keyboard.press('Tab');
    await expect(cursor(viewer)).toBeFocused();
    await expectShown(viewer, 300, 200);
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+ArrowUp');
    await expectShown(viewer, 301, 190);
    await expect(box(viewer)).not.toHaveClass(/pinned/);
    await page.keyboard.press('Enter');
    await expect(box(viewer)).toHaveClass(/pinned/);
    await page.keyboard.press('ArrowLeft');
    await expectShown(viewer, 300, 190);
    await expect(box(viewer)).not.toHaveClass(/pinned/);
    expect((await cameraOf(viewer)).theta, 'the camera stays').toBe(0);
    for (let i = 0; i < 45; i++) {
      await page.keyboard.press('Shift+ArrowLeft');
    }
    await expect(box(viewer)).toHaveText(/No surface there\./);
    await expect.poll(async () => (await cursorPlace(viewer))[0]).toBe(0.5);
    await viewer.locator('.surface').focus();
    await expect(box(viewer)).toBeHidden();
  });

  test('selects a light by its button in the table: only its vectors are drawn', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene());
    await pointerAway(page);
    await cursor(viewer).focus();
    for (const key of ['Shift+ArrowUp', 'Shift+ArrowUp', 'Enter']) {
      await page.keyboard.press(key);
    }
    await expect(box(viewer)).toHaveClass(/pinned/);
    await page.keyboard.press('Tab');
    await expect(unpin(viewer)).toBeFocused();
    await page.keyboard.press('Tab');
    await expect
      .poll(async () => (await labels(viewer)).filter((text) => text.startsWith('L')))
      .toHaveLength(1);
    const before = await labels(viewer);
    await page.keyboard.press(before.includes('L sun') ? 'ArrowDown' : 'ArrowUp');
    await expect
      .poll(() => labels(viewer))
      .toContain(before.includes('L sun') ? 'L lamp' : 'L sun');
    await page.keyboard.press('Enter');
    await cursor(viewer).focus();
    expect(
      (await labels(viewer)).filter((text) => text.startsWith('L')),
      'a press keeps it',
    ).toHaveLength(1);
    await expect(box(viewer).locator('[aria-pressed=true]')).toHaveCount(1);
  });
});

test.describe('the box', () => {
  test('never covers the point, at any size', async ({ page, mount }) => {
    for (const [width, height] of [
      [390, 320],
      [300, 150],
      [120, 90],
    ] as const) {
      const viewer = await mount(scene('probe', LIGHTS.repeat(4)), { width, height });
      for (const down of [0.2, 0.5, 0.8]) {
        // Before the first one: a pinned box takes the pointer itself.
        await escape(page);
        const [x, y] = [Math.round(width / 2), Math.round(height * down)];
        await page.mouse.click(x, y);
        await expect(box(viewer)).toHaveClass(/pinned/);
        await nextFrame(page);
        const covered = (await box(viewer).boundingBox())!;
        const [right, bottom] = [covered.x + covered.width, covered.y + covered.height];
        const isBeside = covered.x >= x || right <= x || covered.y >= y || bottom <= y;
        const isInside = covered.x >= 0 && covered.y >= 0 && right <= width && bottom <= height;
        expect([isBeside, isInside], `${width}: ${down}`).toEqual([true, true]);
        // Small ones show the colour alone.
        expect(await box(viewer).getByRole('table').isVisible()).toBe(height > 150);
        await expectShown(viewer, x, y);
      }
    }
  });

  test('shows the whole table from 240 pixels on, with three digits in every colour', async ({
    page,
    mount,
  }) => {
    const light = (name: string) =>
      `<phong-light name="${name}" position="1 1 0 0" ambient="120" diffuse="190" specular="150"></phong-light>`;
    const viewer = await mount(
      `<phong-viewer probe probe-at="0 0 0" geometry="plane" theta="-90" phi="26.565" radius="20" fov="4.2" target="0 0 0" ka="255" kd="255" ks="255" shininess="1">
         ${light('light')}${light('a light with a long name')}
         <phong-light name="back" position="-1 -1 0 0" ambient="111"></phong-light></phong-viewer>`,
      { width: 240, height: 400 },
    );
    for (const width of [
      240, 269, 270, 294, 344, 345, 355, 389, 390, 420, 479, 480, 599, 600, 690,
    ]) {
      await viewer.evaluate((element, px) => (element.style.width = `${px}px`), width);
      await nextFrame(page);
      await expect(box(viewer).getByRole('table')).toBeVisible();
      const { hidden, right, edge, name } = await box(viewer).evaluate((element) => {
        const last = [...element.querySelectorAll(':is(tbody, tfoot) > tr > :last-child')].filter(
          (cell) => cell.checkVisibility(),
        );
        return {
          hidden:
            element.scrollWidth - element.clientWidth + element.scrollHeight - element.clientHeight,
          right: last.map((cell) => Math.round(cell.getBoundingClientRect().right)),
          edge: Math.round(element.getBoundingClientRect().right),
          name: element.querySelectorAll('tbody button')[1]!.getBoundingClientRect().width,
        };
      });
      expect(hidden, `${width}`).toBe(0);
      expect(new Set(right).size, `${width}: the sums share a column`).toBe(1);
      expect(right[0], `${width}`).toBeLessThanOrEqual(edge);
      expect(name, `${width}: the name`).toBeGreaterThan(20);
    }
    // Lights that share a row are counted in it, in long words too.
    await viewer.evaluate(async (element, texts) => {
      element.texts = (await import(texts)).default;
      element.insertAdjacentHTML('beforeend', element.innerHTML + element.innerHTML);
      element.style.height = '300px';
    }, '/dist/texts/pt.js');
    for (const width of [320, 400, 600, 900]) {
      await viewer.evaluate((element, px) => (element.style.width = `${px}px`), width);
      await nextFrame(page);
      const cut = await box(viewer)
        .locator('.others button')
        .or(box(viewer))
        .evaluateAll((all) => all.map((one) => one.scrollWidth - one.clientWidth));
      expect(cut, `${width}`).toEqual([0, 0]);
    }
  });

  test('lists fifty lights, all in reach, in rows that add up to the sum, or to ≈', async ({
    page,
    mount,
  }) => {
    const lights = Array.from(
      { length: 50 },
      (_, i) =>
        `<phong-light name="n${i}" position="${(i % 7) - 3} ${(i % 5) - 1} 3 0" diffuse="${2 * i}" specular="0"></phong-light>`,
    ).join('');
    const viewer = await mount(scene('probe', lights));
    await page.mouse.click(300, 150);
    await expect(box(viewer).locator('tbody tr')).toHaveCount(51);
    const seen = new Set<string>();
    const rows = box(viewer).locator('tbody tr').filter({ visible: true });
    for (let i = 0; i < 50 && seen.size < 50; i++) {
      const names = await rows.locator('button').allTextContents();
      expect(names.at(-1)).toBe(`+ ${50 - (names.length - 1)} lights`);
      for (const name of names.slice(0, -1)) {
        seen.add(name);
      }
      await rows.last().locator('button').click();
    }
    expect(seen.size, 'all are in reach').toBe(50);
    const sums = await rows.locator('td:last-child').allInnerTexts();
    const sum = await box(viewer).locator('tfoot td').first().innerText();
    const red = (text: string) => Number.parseFloat(text.replace('≈', ''));
    const added = sums.reduce((total, text) => total + red(text), 0);
    expect(sum.startsWith('≈'), sum).toBe(added !== red(sum));
  });

  test('explains Gouraud and flat shading and linear light', async ({ page, mount }) => {
    const viewer = await mount(scene('probe shading="gouraud"'));
    await page.mouse.click(280, 130);
    await expect(box(viewer)).toHaveText(/Gouraud: the terms are those of the triangle’s corners/);
    await assign(viewer, { shading: 'flat' });
    await expect(box(viewer)).not.toHaveText(/Gouraud/);
    await expectShown(viewer, 280, 130);
    await assign(viewer, { colorInterpolation: 'linear' });
    await expect(box(viewer).getByRole('rowheader')).toHaveText([
      /^sun/,
      /^lamp/,
      'sum',
      'encoded',
    ]);
    const row = box(viewer).locator('tfoot tr').last().locator('td');
    await expect(row).toContainText((await codes(viewer).textContent())!);
  });

  test('says where the picture averages a texture', async ({ mount }) => {
    const columns = Array.from({ length: 64 * 64 }, (_, i): Texel =>
      i % 2 === 0 ? [255, 255, 255] : [0, 0, 0],
    );
    const material = { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } };
    const src = patch({ material, textures: [columns], mipmaps: true });
    const viewer = await mount(
      scene(`probe probe-at="0 0 0.3" src="${src}"`)
        .replace('geometry="sphere"', '')
        .replace('1.6', '30'),
    );
    const note = box(viewer).locator('.note');
    await expect(note).toHaveText(/^The picture averages the texture here;/);
    await expect(codes(viewer)).toHaveText(/^≈ /);
    await assign(viewer, { radius: 2 });
    await expect(codes(viewer)).not.toHaveText(/≈/);
    await expect(note).toHaveText('');
  });

  test('is not there before the first picture', async ({ page, mount }) => {
    const later = scene('probe probe-at="0 0 0.5" id="later"')
      .replace('radius="1.6"', '')
      .replace('geometry="sphere"', 'geometry="box"');
    const first = await mount(scene('probe probe-at="0 0 0.5"') + later, {
      css: '#later { margin-top: 4000px }',
      waitForReady: false,
    });
    await expect(box(first)).toBeVisible();
    const viewer = page.locator('#later');
    await expect(box(viewer)).toBeAttached();
    await assign(viewer, { fov: 40 });
    for (let i = 0; i < 5; i++) {
      await nextFrame(page);
    }
    expect((await statsOf(viewer)).frames).toBe(0);
    await expect(box(viewer)).toBeHidden();
    await viewer.scrollIntoViewIfNeeded();
    await expect(codes(viewer)).toHaveText(/^\d/);
  });
});

test('`probe-change` has the fragment, whether it is pinned, and null when there is none', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene());
  const events = await viewer.evaluateHandle((element: PhongViewer) => {
    const list: (number | boolean | null)[][] = [];
    element.addEventListener('probe-change', ({ detail: { fragment, x, y, pinned } }) =>
      list.push([fragment === null ? null : fragment.color[0], x, y, pinned]),
    );
    return list;
  });
  const last = () => events.evaluate((list) => list.at(-1));
  const [red] = await colorAt(viewer, 280, 130);
  await page.mouse.move(280, 130);
  await expect.poll(last).toEqual([red, 280, 130, false]);
  await page.mouse.click(280, 130);
  // Where it was pressed, then the pixel's centre.
  const near = (x: number): unknown => expect.closeTo(x + 0.25, 0);
  await expect.poll(last).toEqual([red, near(280), near(130), true]);
  await escape(page);
  await expect.poll(last).toEqual([null, null, null, false]);
  const count = await events.evaluate((list) => list.length);
  await assign(viewer, { kd: [9, 9, 9] });
  await nextFrame(page);
  expect(await events.evaluate((list) => list.length), 'nothing is shown').toBe(count);
  // A listener that changes the viewer causes one event a frame.
  const changes = viewer.evaluate(async (element) => {
    let changed = 0;
    element.addEventListener('probe-change', () => (element.alt = String((changed += 1))));
    element.probeAt = [0, 0, 0.5];
    for (let i = 0; i < 5; i++) {
      await new Promise(requestAnimationFrame);
    }
    return changed;
  });
  expect(await changes).toBeGreaterThan(0);
  expect(await changes).toBeLessThan(10);
});

test('the arrows are in a picture file on request, at its size and for the scene at that time', async ({
  mount,
}) => {
  const viewer = await mount(scene('probe probe-at="0 0 0.5"'));
  await expect(box(viewer)).toBeVisible();
  const [without, inside] = await viewer.evaluate(async (element) => {
    const size = { width: 300, height: 200 };
    const pixels = async (helpers: boolean): Promise<Uint8ClampedArray> => {
      const context = new OffscreenCanvas(300, 200).getContext('2d')!;
      context.drawImage(await createImageBitmap(await element.toBlob({ ...size, helpers })), 0, 0);
      return context.getImageData(0, 0, 300, 200).data;
    };
    /** Pixels that the probe draws: all, and those around this place. */
    const drawn = async (x: number, y: number): Promise<readonly [number, number]> => {
      const [over, plain] = [await pixels(true), await pixels(false)];
      const places = Array.from({ length: 60000 }, (_, i) => i).filter((i) =>
        [0, 1, 2].some((c) => plain[4 * i + c] !== over[4 * i + c]),
      );
      const near = places.filter((i) => Math.hypot((i % 300) - x, Math.floor(i / 300) - y) < 5);
      return [places.length, near.length];
    };
    element.probeAt = null;
    const without = await drawn(150, 100);
    // Half way between the middle and the outline; drawn in the task of the assignment.
    const x = 150 + (100 * 0.25) / (Math.tan((element.fov * Math.PI) / 360) * (1.6 - 0.433));
    element.probeAt = [0.25, 0, 0.4330127];
    return [without, await drawn(x, 100)] as const;
  });
  expect(without).toEqual([0, 0]);
  expect(inside[0]).toBeGreaterThan(200);
  expect(inside[1]).toBeGreaterThan(30);
});

test('explains the first and the last of many events at a time, and draws no picture', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene());
  await page.mouse.move(280, 130);
  await expect(box(viewer)).toBeVisible();
  const { shown, expected, times, frames } = await viewer.evaluate(async (element) => {
    const { shadeAt, stats } = element;
    let times = 0;
    element.shadeAt = (x, y) => {
      times += 1;
      return shadeAt.call(element, x, y);
    };
    const surface = element.shadowRoot!.querySelector('.surface')!;
    for (let i = 0; i < 60; i++) {
      const place = { clientX: 250 + i, clientY: 150, bubbles: true };
      surface.dispatchEvent(new PointerEvent('pointermove', { ...place, pointerType: 'mouse' }));
      if (i % 10 === 9) {
        await new Promise(requestAnimationFrame);
      }
    }
    await new Promise(requestAnimationFrame);
    await new Promise(requestAnimationFrame);
    const shown = element.shadowRoot!.querySelector('[part=probe] .codes')!.textContent;
    const { color } = (await shadeAt.call(element, 309, 150))!;
    const expected = color.map((c) => (255 * c).toFixed(0)).join(' ');
    return { shown, expected, times, frames: element.stats.frames - stats.frames };
  });
  expect(shown).toBe(expected);
  expect(times).toBeGreaterThan(0);
  expect(times, 'two of each ten').toBeLessThan(14);
  expect(frames).toBe(0);
});

test('rests: no frame and no timer while nothing happens', async ({ page, mount }) => {
  await countEverything(page);
  const viewer = await mount(scene('probe probe-at="0 0 0.5"'));
  await page.mouse.move(280, 130);
  await page.mouse.click(280, 130);
  await expect(box(viewer)).toHaveClass(/pinned/);
  await expect // once the announcement has been cleared
    .poll(() => spentIn(page, 500), { timeout: 10_000 })
    .toEqual(NOTHING);
});

test('never throws when lights, meshes and the viewer are removed under the mouse', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`${scene()}${scene('probe probe-at="0 0 0.5"')}`);
  await page.mouse.move(280, 130);
  await expect(box(viewer)).toBeVisible();
  await viewer.evaluate((element) => element.replaceChildren());
  await page.mouse.move(281, 130);
  await expect(box(viewer).locator('tbody th')).toHaveText(['head-light']);
  await assign(viewer, { geometry: null });
  await expect(box(viewer)).toBeHidden();
  await page.mouse.move(282, 130);
  await assign(viewer, { geometry: 'box', radius: 0.1 });
  await page.mouse.move(283, 130);
  await viewer.evaluate((element) => {
    element.probeAt = [0, 0, 0];
    element.remove();
  });
  await nextFrame(page);
  await expect(page.locator('[part=probe]'), 'the other viewer has its own').toHaveCount(1);
});

test('follows the mouse on a mesh of 100,000 triangles without sorting it again', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene('probe').replace('segments="64"', 'segments="320"'));
  await page.mouse.move(280, 130);
  await expect(box(viewer)).toBeVisible();
  const read = await viewer.evaluate(async (element) => {
    const mesh = element.scene.getObjectByProperty('isMesh', true) as unknown as {
      geometry: { index: { count: number; getX(i: number): number } };
    };
    const { index } = mesh.geometry;
    const { getX } = index;
    let corners = 0;
    index.getX = (i) => {
      corners += 1;
      return getX.call(index, i);
    };
    await element.shadeAt(300, 150);
    return [index.count / 3, corners] as const;
  });
  expect(read[0]).toBeGreaterThan(100_000);
  // Of the runs of triangles that the ray meets.
  expect(read[1]).toBeGreaterThan(0);
  expect(read[1]).toBeLessThan(5000);
});
