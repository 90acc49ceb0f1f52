// Are lights drawn where they are in the scene, and do they follow pointer and keys? Handles are
// located by role and name, as a screen reader does.

import type { Locator, Page } from '@playwright/test';
import { type ViewerLocator, compare, expect, pixels, same, test } from '../../support/test.js';
import { field, opened } from '../panel/panel-rows.js';
import {
  assign,
  cameraOf,
  drag,
  Fingers,
  loseContext,
  nextFrame,
  type PhongLight,
  type PhongViewer,
  record,
  set,
  settled,
  htmlOf,
} from '../../element/support/viewer.js';

const scene = (lights: string, attributes = '', camera = 'theta="0" phi="90"') =>
  `<phong-viewer alt="A box" helpers geometry="box" ${camera} ${attributes}>${lights}</phong-viewer>`;

const lamp = '<phong-light name="lamp" position="0.5 0.4 0 1"></phong-light>';
const sun = '<phong-light name="sun" position="0 1 2 0"></phong-light>';
const spot =
  '<phong-light name="spot" position="-0.6 0.5 0 1" axis="1 0 0" aperture="20" cutoff="4"></phong-light>';

/** The handle whose name begins with this. */
const handle = (viewer: ViewerLocator, name: string) =>
  viewer.getByRole('option', { name: new RegExp(`^${name}`) });

const light = (
  viewer: ViewerLocator,
  index = 0,
): Promise<Pick<PhongLight, 'position' | 'axis' | 'aperture'>> =>
  viewer.evaluate((element, i) => {
    const { position, axis, aperture } = element.lights.at(i)!;
    return { position, axis, aperture };
  }, index);

const positionOf = async (viewer: ViewerLocator, index = 0) =>
  (await light(viewer, index)).position;
/** The lamp's. */
const START = [0.5, 0.4, 0, 1];

async function middleOf(target: Locator): Promise<{ readonly x: number; readonly y: number }> {
  const { x, y, width, height } = (await target.boundingBox())!;
  return { x: x + width / 2, y: y + height / 2 };
}

/**
 * Presses a handle and travels by so many pixels, with the button still down. Returns where it was
 * pressed.
 */
async function hold(
  page: Page,
  target: Locator,
  dx: number,
  dy: number,
): Promise<[x: number, y: number]> {
  const { x, y } = await middleOf(target);
  await drag(page, [x, y], [dx, dy], { release: false });
  return [x, y];
}

/** Drags a handle. Returns where it is afterwards, less where it was. */
async function dragged(
  page: Page,
  target: Locator,
  dx: number,
  dy: number,
): Promise<[x: number, y: number]> {
  const [x, y] = await hold(page, target, dx, dy);
  await page.mouse.up();
  await nextFrame(page);
  const after = await middleOf(target);
  return [after.x - x, after.y - y];
}

const lengthOf = (v: readonly number[]) => Math.hypot(v[0]!, v[1]!, v[2]!);

test.describe('a light in the picture', () => {
  test('is drawn at its place in the scene, with its name, and dashed behind a shape', async ({
    mount,
  }) => {
    const viewer = await mount(scene(lamp, 'radius="4" target="0 0 0" fov="90"'));
    const { x, y } = await middleOf(handle(viewer, 'lamp'));
    // 200 pixels are half the height, which is 4 units at the target.
    expect(x).toBeCloseTo(300 + 25, 0);
    expect(y).toBeCloseTo(200 - 20, 0);
    await expect(viewer.locator('svg text')).toHaveText('lamp');
    const dashed = viewer.locator('circle:not([stroke-dasharray=none])');
    for (const [z, count] of [
      [-2, 2],
      [2, 0],
    ] as const) {
      await assign(viewer.locator('phong-light'), { position: [0, 0, z, 1] });
      await expect(dashed).toHaveCount(count);
    }
  });

  test('follows the pointer in the plane of the view, as one step; the camera stays', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene(lamp, 'gui'), { width: 900 }); // beside the panel
    const events = await record(viewer, 'light-change', 'camera-change');
    const folder = await opened(viewer, 'lamp');
    const [x, y] = await dragged(page, handle(viewer, 'lamp'), -60, 30);
    expect(x).toBeCloseTo(-60, 0);
    expect(y).toBeCloseTo(30, 0);
    const position = await positionOf(viewer);
    expect(position[2]).toBeCloseTo(0, 3);
    expect(position[3]).toBe(1);
    await expect(field(folder, 'position x')).toHaveValue(String(position[0]));
    const types = new Set((await events.take()).map(({ type }) => type));
    expect([...types]).toEqual(['light-change']);
    expect(await htmlOf(viewer)).toContain(`position="${position.join(' ')}"`);
    await handle(viewer, 'lamp').press('Control+z');
    expect(await positionOf(viewer)).toEqual(START);
    await handle(viewer, 'lamp').press('Control+Shift+z');
    expect(await positionOf(viewer)).toEqual(position);
  });

  test('stays when the window loses the focus, and returns by Escape without an undo step', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene(lamp));
    const target = handle(viewer, 'lamp');
    let [x, y] = await hold(page, target, -30, 0);
    const position = await positionOf(viewer);
    expect(position[0]).toBeLessThan(0.5);
    await page.evaluate(() => dispatchEvent(new Event('blur')));
    await page.mouse.move(x - 60, y);
    expect(await positionOf(viewer)).toEqual(position);
    await page.mouse.up();
    await target.press('Control+z');
    expect(await positionOf(viewer)).toEqual(START);
    await nextFrame(page);

    [x, y] = await hold(page, target, 80, 10);
    expect((await positionOf(viewer))[0]).toBeGreaterThan(0.6);
    await page.keyboard.press('Escape');
    expect(await positionOf(viewer)).toEqual(START);
    await page.mouse.move(x + 120, y + 10);
    expect(await positionOf(viewer)).toEqual(START);
    await page.mouse.up();
    await assign(viewer.locator('phong-light'), { position: [1, 1, 1, 1] });
    await target.press('Control+z');
    expect(await positionOf(viewer)).toEqual([1, 1, 1, 1]);
  });

  test('stays under the pointer while something else turns the camera, and under CSS rotation and scale', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene(lamp));
    const [x, y] = await hold(page, handle(viewer, 'lamp'), -50, 0);
    await set(viewer, { theta: 30 });
    await nextFrame(page);
    const after = await middleOf(handle(viewer, 'lamp'));
    expect(after.x).toBeCloseTo(x - 50, 0);
    expect(after.y).toBeCloseTo(y, 0);
    await page.mouse.up();
    await viewer.evaluate(
      ({ style }) => (style.transform = 'translate(50px, 60px) rotate(90deg) scale(0.5)'),
    );
    const moved = await dragged(page, handle(viewer, 'lamp'), 20, 30);
    expect(moved[0]).toBeCloseTo(20, 0);
    expect(moved[1]).toBeCloseTo(30, 0);
  });

  test('has the edge of its cone on the floor that it lights, and follows the floor', async ({
    mount,
  }) => {
    const viewer = await mount(
      `<phong-viewer alt="" helpers fov="90" phi="0" theta="0" radius="4" target="0 0 0">
         <phong-mesh geometry="plane" scale="4"></phong-mesh>
         <phong-light name="spot" position="0 2 0 1" axis="0 -1 0" aperture="30"></phong-light></phong-viewer>`,
    );
    /**
     * From the middle of the picture, in pixels: 200 are as many units as the distance from the
     * eye.
     */
    const offset = async () => {
      const { x, y } = await middleOf(handle(viewer, 'spot: edge'));
      return Math.hypot(x - 300, y - 200);
    };
    const pool = Math.tan(Math.PI / 6);
    await expect.poll(offset).toBeCloseTo((200 * 2 * pool) / 4, 0);
    await viewer.evaluate((element) => (element.meshes[0]!.position = [0, 1, 0]));
    await expect.poll(offset).toBeCloseTo((200 * pool) / 3, 0);
  });

  test('has handles for the axis of a spot and the edge of its cone', async ({ page, mount }) => {
    const viewer = await mount(scene(spot));
    const tip = handle(viewer, 'spot: axis');
    // Rays find where the axis ends a while after the first frame.
    await expect
      .poll(async () => {
        const { x } = await middleOf(tip);
        await page.waitForTimeout(150);
        return (await middleOf(tip)).x - x;
      })
      .toBe(0);
    await dragged(page, tip, 0, 30);
    const { axis } = await light(viewer);
    expect(axis[1]).toBeLessThan(-0.1);
    expect(lengthOf(axis)).toBeCloseTo(1, 12);
    const edge = handle(viewer, 'spot: edge');
    const at = await middleOf(edge);
    const apex = await middleOf(handle(viewer, 'spot: spot'));
    // Away from the axis: across the line from the apex.
    await dragged(page, edge, 0, at.y < apex.y ? -30 : 30);
    expect((await light(viewer)).aperture).not.toBe(20);
  });
});

test.describe('helpers by keyboard', () => {
  test('all lights are one Tab stop, arrow keys choose, and Enter starts and ends moving', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(`${scene(lamp + sun + spot)}<a href="#next">Next</a>`);
    await page.keyboard.press('Tab');
    await page.keyboard.press('Tab');
    await expect(handle(viewer, 'lamp')).toBeFocused();
    await page.keyboard.press('ArrowRight');
    await expect(handle(viewer, 'sun')).toBeFocused();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('Enter');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Shift+ArrowDown');
    await expect(handle(viewer, 'lamp')).toBeFocused();
    const position = await positionOf(viewer);
    expect(position[0]).toBeGreaterThan(0.5);
    expect(position[1]).toBeGreaterThan(0.4);
    expect(position[2]).toBeGreaterThan(0);
    expect(await cameraOf(viewer)).toMatchObject({ theta: 0, phi: 90 });
    // Moved by something else meanwhile.
    await assign(viewer.locator('phong-light').first(), { position: [0.5, -0.6, 0, 1] });
    await page.keyboard.press('ArrowLeft');
    expect((await positionOf(viewer))[1]).toBeCloseTo(-0.6);
    await page.keyboard.press('Enter');
    await page.keyboard.press('End');
    await expect(handle(viewer, 'spot: edge')).toBeFocused();
    await page.keyboard.press('Control+z');
    expect(await positionOf(viewer)).toEqual(START);
    await page.keyboard.press('Tab');
    await expect(page.getByText('Next')).toBeFocused();
  });

  test('key presses between two frames all count', async ({ mount }) => {
    const viewer = await mount(scene(lamp));
    const positions = await handle(viewer, 'lamp').evaluate((element) => {
      const { lights } = (element.getRootNode() as ShadowRoot).host as PhongViewer;
      element.focus();
      return ['Enter', 'ArrowRight', 'Shift+ArrowDown', 'ArrowRight'].map((name) => {
        const key = name.replace('Shift+', '');
        element.dispatchEvent(
          new KeyboardEvent('keydown', { key, shiftKey: key !== name, bubbles: true }),
        );
        return lights[0]!.position;
      });
    });
    const [start, right, nearer, end] = positions.map(([x]) => x);
    expect(right).toBeGreaterThan(start!);
    expect(nearer! / right!).toBeCloseTo(Math.exp(-8 / 150), 3); // nearer to the axis of the view, on the same line
    expect(end).toBeGreaterThan(nearer!);
  });

  test('Escape restores, and moving there and back changes nothing', async ({ page, mount }) => {
    const viewer = await mount(scene(sun));
    await handle(viewer, 'sun').press('Enter');
    for (const key of ['ArrowLeft', 'ArrowUp', 'ArrowUp']) {
      await page.keyboard.press(key);
    }
    expect(await positionOf(viewer)).not.toEqual([0, 1, 2, 0]);
    for (const key of ['ArrowRight', 'ArrowDown', 'ArrowDown']) {
      await page.keyboard.press(key);
    }
    const position = await positionOf(viewer);
    expect(Math.hypot(position[0], position[1] - 1, position[2] - 2)).toBeLessThan(1e-12);
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Escape');
    expect(await positionOf(viewer)).toEqual([0, 1, 2, 0]);
  });
});

test.describe('helpers throw nothing and stay usable', () => {
  for (const [what, act] of [
    [
      'its light is removed',
      (viewer: ViewerLocator) => viewer.evaluate((element) => element.lights[0]!.remove()),
    ],
    [
      'the viewer is removed',
      (viewer: ViewerLocator) => viewer.evaluate((element) => element.remove()),
    ],
    ['the helpers are switched off', (viewer: ViewerLocator) => assign(viewer, { helpers: [] })],
  ] as const) {
    test(`where ${what} in the middle of a drag`, async ({ page, mount }) => {
      const viewer = await mount(scene(lamp + sun));
      const element = await viewer.elementHandle();
      const [x, y] = await hold(page, handle(viewer, 'lamp'), 20, 0);
      await act(viewer);
      await page.mouse.move(x + 60, y, { steps: 2 });
      await page.mouse.up();
      await nextFrame(page);
      // Back again, and dragged again.
      await page.evaluate((target) => {
        const shown = target as PhongViewer;
        document.body.append(shown);
        shown.helpers = ['lights'];
        return shown.ready;
      }, element);
      await expect(handle(viewer, 'sun')).toBeVisible();
      const before = await positionOf(viewer, -1);
      await dragged(page, handle(viewer, 'sun'), 20, 20);
      expect(await positionOf(viewer, -1)).not.toEqual(before);
    });
  }

  test('where the context is lost in the middle of a drag, and comes back', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene(lamp));
    await viewer.evaluate((element) =>
      element.addEventListener('error', (event) => event.preventDefault()),
    );
    const [x, y] = await hold(page, handle(viewer, 'lamp'), -20, 0);
    const restore = await loseContext(viewer);
    await nextFrame(page);
    await page.mouse.move(x - 40, y, { steps: 2 });
    await page.mouse.up();
    const position = await positionOf(viewer);
    expect(position[0]).toBeLessThan(0.35);
    await restore();
    await settled(viewer);
    await dragged(page, handle(viewer, 'lamp'), 0, 30);
    expect((await positionOf(viewer))[1]).toBeLessThan(position[1]);
  });

  test('where two viewers are on the page: each has its own lights, Tab stop and undo', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene(lamp) + scene(sun), { width: 300, height: 200 });
    const other = page.locator('phong-viewer').nth(1);
    await dragged(page, handle(viewer, 'lamp'), -20, 10);
    await dragged(page, handle(other, 'sun'), 20, 10);
    const [moved, turned] = [await positionOf(viewer), await positionOf(other)];
    await handle(viewer, 'lamp').press('Control+z');
    expect(await positionOf(viewer)).toEqual(START);
    expect(await positionOf(other)).toEqual(turned);
    expect(moved).not.toEqual(START);
    expect(turned).not.toEqual([0, 1, 2, 0]);
  });

  test('behind the eye, at it and at a pole: a viewer of 120 × 90 shows each handle whole', async ({
    mount,
  }) => {
    const places =
      '0 0 9 1, 0 0 4 1, 0 9 0 1, 0 -9 0 1, 0 0 0 0, 0 0 1 0, 0 1 0 0, 1e15 0 0 1'.split(', ');
    const lights = places.map(
      (place, i) => `<phong-light name="l${i}" position="${place}"></phong-light>`,
    );
    const viewer = await mount(scene(lights.join(''), 'radius="4"', 'phi="0"'), {
      width: 120,
      height: 90,
    });
    for (const [i, place] of places.entries()) {
      const { x, y } = await middleOf(handle(viewer, `l${i}:`));
      expect(x >= 10 && y >= 10 && x <= 110 && y <= 80, place).toBe(true);
    }
  });
});

test('helpers are in a picture file only on request', async ({ mount }) => {
  const viewer = await mount(scene(lamp));
  const size = { width: 300, height: 200 };
  const without = await pixels(viewer, { ...size, helpers: false });
  await assign(viewer, { helpers: [] });
  const plain = await pixels(viewer, size);
  await assign(viewer, { helpers: ['lights'] });
  const drawn = await pixels(viewer, { ...size, helpers: true });
  same(without, plain);
  expect(compare(drawn, plain).max).toBeGreaterThan(0);
});

test.describe('a viewer with helpers', () => {
  test('redraws nothing while nothing changes', async ({ mount }) => {
    const viewer = await mount(
      scene(lamp).replace(' helpers', ' helpers="lights axes grid normals bounds"'),
    );
    await expect(viewer.getByRole('listbox')).toBeVisible();
    const work = () =>
      viewer.evaluate(async (element) => {
        const { frames } = element.stats;
        const changes: MutationRecord[] = [];
        const observer = new MutationObserver((records) => changes.push(...records));
        observer.observe(element.shadowRoot!.querySelector('.layer')!, {
          subtree: true,
          attributes: true,
          childList: true,
          characterData: true,
        });
        await new Promise((resolve) => setTimeout(resolve, 300));
        return [element.stats.frames - frames, changes.length];
      });
    // The rays that find hidden parts are spread over several frames.
    await expect.poll(work).toEqual([0, 0]);
    expect(await work()).toEqual([0, 0]);
  });

  test('changes only the elements of the dragged light, of 64', async ({ page, mount }) => {
    const lights = Array.from(
      { length: 64 },
      (_, i) =>
        `<phong-light name="l${i}" position="${Math.cos(i)} ${Math.sin(i)} ${i / 64} 1"></phong-light>`,
    );
    const viewer = await mount(scene(lights.join('')));
    const [x, y] = await hold(page, handle(viewer, 'l0:'), -10, -5);
    const written = await viewer.evaluateHandle((element) => {
      const nodes = new Set<Node>();
      const observer = new MutationObserver((records) => {
        for (const { target } of records) {
          nodes.add(target);
        }
      });
      observer.observe(element.shadowRoot!.querySelector('.layer')!, {
        subtree: true,
        attributes: true,
        childList: true,
      });
      return nodes;
    });
    const names = () => written.evaluate((nodes) => [...nodes].map(String));
    do {
      await written.evaluate((nodes) => nodes.clear());
      await nextFrame(page);
      await nextFrame(page);
    } while ((await names()).length > 0);
    await page.mouse.move(x - 12, y - 6);
    await nextFrame(page);
    // Its handle, and the groups of its disc, its name and the names that make room for it, of more
    // than 250 elements. No text is laid out.
    const changed = await names();
    expect(changed.length).toBeLessThan(10);
    expect(changed).not.toContain('[object SVGTextElement]');
    await page.mouse.up();
  });

  test('lets the wheel zoom over a handle, and a finger drag a light, not the camera', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene(lamp));
    const fingers = await Fingers.on(page);
    const { x, y } = await middleOf(handle(viewer, 'lamp'));
    const { theta, radius } = await cameraOf(viewer);
    await fingers.down([x, y]);
    for (const step of [10, 20, 40]) {
      await fingers.move([x, y + step]);
    }
    await fingers.up();
    expect((await positionOf(viewer))[1]).toBeLessThan(0.35);
    expect((await cameraOf(viewer)).theta).toBe(theta);

    await handle(viewer, 'lamp').focus();
    const at = await middleOf(handle(viewer, 'lamp'));
    await page.mouse.move(at.x, at.y);
    await page.mouse.wheel(0, 100);
    await expect.poll(async () => (await cameraOf(viewer)).radius).toBeGreaterThan(radius);
  });

  test('moves the focus of a removed light to the next one, and then to the picture', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene(lamp + sun));
    await handle(viewer, 'lamp').focus();
    await viewer.evaluate((element) => element.lights[0]!.remove());
    await expect(handle(viewer, 'sun')).toBeFocused();
    await page.keyboard.press('Enter');
    await viewer.evaluate((element) => element.lights[0]!.remove());
    await expect(viewer).toBeFocused();
    await expect(viewer.getByRole('listbox')).toBeHidden();
  });

  test('goes on with a drag while the light before it is removed', async ({ page, mount }) => {
    const viewer = await mount(scene(lamp + sun));
    const [x, y] = await hold(page, handle(viewer, 'sun'), 5, 5);
    await viewer.evaluate((element) => element.lights[0]!.remove());
    await nextFrame(page);
    const before = await positionOf(viewer);
    await page.mouse.move(x + 20, y + 10);
    expect(await positionOf(viewer)).not.toEqual(before);
    await expect(handle(viewer, 'sun')).toBeFocused();
    await page.mouse.up();
  });

  test('draws axes, grid, bounds and normals, and takes them away', async ({ mount }) => {
    const viewer = await mount(scene(lamp).replace(' helpers', ' helpers="axes"'));
    await expect(viewer.locator('svg text')).toHaveText(['x', 'y', 'z']);
    await expect(viewer.getByRole('listbox')).toBeHidden();
    const paths = viewer.locator('svg path');
    for (const name of ['grid', 'bounds', 'normals']) {
      await assign(viewer, { helpers: name });
      await expect(viewer.locator('svg text')).toHaveCount(0);
      await expect(paths.first(), name).toBeAttached();
      expect(await htmlOf(viewer)).toContain(`helpers="${name}"`);
    }
    await assign(viewer, { helpers: [] });
    await expect(viewer.locator('svg')).toHaveCount(0);
  });

  test('draws the box of a flattened shape without hidden edges', async ({ mount }) => {
    const flat = '<phong-mesh geometry="box" scale="1 0 1"></phong-mesh>';
    const viewer = await mount(`<phong-viewer alt="" helpers="bounds">${flat}</phong-viewer>`);
    await expect(viewer.locator('svg path[stroke-dasharray=none]')).not.toHaveCount(0);
    await expect(viewer.locator('svg path:not([stroke-dasharray=none])')).toHaveCount(0);
  });
});
