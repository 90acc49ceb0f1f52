// Where is the camera, and what moves it apart from drags: wheel, keys, properties, `auto`, time? Numbers are held against
// float64 formulas worked out here. Viewers are 600 × 400 CSS pixels unless a test says otherwise.

import { expect, test } from '../support/test.js';
import { assign, cameraOf, drag, nextFrame, type PhongViewer, record, settled } from './support.js';

const near = '<phong-viewer geometry="box" theta="30" phi="70" radius="5"></phong-viewer>';
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

test.describe('the wheel', () => {
  test('scrolls the page until a press gives focus, and then zooms', async ({ page, mount }) => {
    const viewer = await mount(`${near}<div class="tall"></div>`, { css: '.tall { height: 3000px }' });
    await page.mouse.move(300, 200);
    await page.mouse.wheel(0, 50);
    await expect.poll(() => page.evaluate(() => scrollY)).toBe(50);
    expect((await cameraOf(viewer)).radius).toBe(5);

    await page.mouse.down();
    await page.mouse.up();
    await page.mouse.wheel(0, 100);
    await expect.poll(async () => (await cameraOf(viewer)).radius).toBeCloseTo(5 * Math.exp(0.1), 12);
    await page.mouse.wheel(0, -250);
    await expect.poll(async () => (await cameraOf(viewer)).radius).toBeCloseTo(5 * Math.exp(-0.15), 12);
    expect(await page.evaluate(() => scrollY)).toBe(50);

    await assign(viewer, { zoom: false });
    await page.mouse.wheel(0, 100);
    await expect.poll(() => page.evaluate(() => scrollY)).toBe(150);
    expect((await cameraOf(viewer)).radius).toBeCloseTo(5 * Math.exp(-0.15), 12);
  });

  test('counts a line as 16 pixels and a page as the height, and stays within 1e-3 to 1e3 of the scene', async ({
    mount,
  }) => {
    const viewer = await mount(near);
    await viewer.focus();
    const turn = (deltaY: number, deltaMode: number): Promise<number> =>
      viewer.evaluate(
        (element: PhongViewer, wheel) => {
          const surface = element.shadowRoot?.querySelector('[part=surface]');
          surface?.dispatchEvent(new WheelEvent('wheel', { ...wheel, bubbles: true, cancelable: true }));
          return element.camera.radius;
        },
        { deltaY, deltaMode },
      );
    expect(await turn(3, 1)).toBeCloseTo(5 * Math.exp(0.048), 12);
    expect(await turn(-3, 1)).toBeCloseTo(5, 12);
    expect(await turn(1, 2)).toBeCloseTo(5 * Math.exp(0.4), 12);
    const sceneRadius = Math.sqrt(3) / 2;
    expect(await turn(1e5, 0)).toBeCloseTo(1e3 * sceneRadius, 9);
    expect(await turn(-1e6, 0)).toBeCloseTo(1e-3 * sceneRadius, 12);
  });
});

test.describe('keys', () => {
  test('turn by 5°, with Shift by 1°, the way a drag would', async ({ page, mount }) => {
    const viewer = await mount(near);
    await page.keyboard.press('Tab');
    for (const [key, theta, phi] of [
      ['ArrowRight', 25, 70],
      ['ArrowLeft', 30, 70],
      ['Shift+ArrowLeft', 31, 70],
      ['Shift+ArrowRight', 30, 70],
      ['ArrowDown', 30, 65],
      ['Shift+ArrowDown', 30, 64],
      ['ArrowUp', 30, 69],
      ['Shift+ArrowUp', 30, 70],
    ] as const) {
      await page.keyboard.press(key);
      expect(await cameraOf(viewer), key).toMatchObject({ theta, phi, radius: 5 });
    }
  });

  test('zoom by 1.1, and Home goes back to the declared camera', async ({ page, mount }) => {
    const viewer = await mount(near);
    await page.keyboard.press('Tab');
    for (const [key, radius] of [
      ['+', 5 / 1.1],
      ['PageDown', 5],
      ['-', 5.5],
      ['PageUp', 5],
    ] as const) {
      await page.keyboard.press(key);
      expect((await cameraOf(viewer)).radius, key).toBeCloseTo(radius, 12);
    }
    await page.keyboard.press('PageUp');
    await drag(page, [300, 200], [60, 40]);
    await drag(page, [300, 200], [60, 40], { button: 'right' });
    await page.keyboard.press('Home');
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70, radius: 5, target: [0, 0, 0] });
  });

  test('do nothing where orbit or zoom is false, without focus, and with Ctrl', async ({ page, mount }) => {
    const viewer = await mount(near);
    const start = await cameraOf(viewer);
    await page.keyboard.press('ArrowRight');
    await viewer.focus();
    await page.keyboard.press('Control+ArrowRight');
    await assign(viewer, { orbit: false, zoom: false });
    for (const key of ['ArrowRight', 'ArrowUp', '+', 'PageDown']) await page.keyboard.press(key);
    expect(await cameraOf(viewer)).toEqual(start);
  });

  test('turn over the poles no further, and turn the azimuth smoothly there', async ({ page, mount }) => {
    const viewer = await mount('<phong-viewer geometry="box" theta="0" phi="4" radius="5"></phong-viewer>');
    await viewer.focus();
    await page.keyboard.press('ArrowDown');
    expect(await cameraOf(viewer)).toMatchObject({ phi: 0, eye: [0, 5, 0], up: [0, 0, -1] });
    for (let i = 0; i < 18; i++) await page.keyboard.press('ArrowLeft');
    expect(await cameraOf(viewer)).toMatchObject({ theta: 90, phi: 0, eye: [0, 5, 0], up: [-1, 0, 0] });
    await settled(viewer);
  });
});

test.describe('camera', () => {
  test('tells eye, target and up of the angles, and wraps θ into [-180, 180)', async ({ mount }) => {
    const viewer = await mount(near);
    for (const [given, theta] of [
      [180, -180],
      [190, -170],
      [-180, -180],
      [-181, 179],
      [750, 30],
      [1e20, null],
    ] as const) // prettier-ignore
    {
      await assign(viewer, { theta: given, phi: 50, target: [1, 2, 3] });
      const camera = await cameraOf(viewer);
      if (theta !== null) expect(camera.theta).toBe(theta);
      expect(camera.theta).toBeGreaterThanOrEqual(-180);
      expect(camera.theta).toBeLessThan(180);
      const t = radians(camera.theta);
      const p = radians(50);
      const back = [Math.sin(p) * Math.sin(t), Math.cos(p), Math.sin(p) * Math.cos(t)];
      const up = [-Math.cos(p) * Math.sin(t), Math.sin(p), -Math.cos(p) * Math.cos(t)];
      for (const i of [0, 1, 2] as const) {
        expect(camera.eye[i]).toBeCloseTo([1, 2, 3][i]! + 5 * back[i]!, 12);
        expect(camera.up[i]).toBeCloseTo(up[i]!, 12);
      }
      expect(camera.target).toEqual([1, 2, 3]);
    }
  });

  test('is a frozen snapshot that later moves do not touch', async ({ mount }) => {
    const viewer = await mount(near);
    const facts = await viewer.evaluate((element: PhongViewer) => {
      const { camera } = element;
      element.theta = 90;
      const parts = [camera, camera.eye, camera.target, camera.up];
      return { frozen: parts.every((part) => Object.isFrozen(part)), theta: camera.theta };
    });
    expect(facts).toEqual({ frozen: true, theta: 30 });
  });

  test('follows properties at once, in the same task', async ({ mount }) => {
    const viewer = await mount(near);
    const cameras = await viewer.evaluate((element: PhongViewer) => {
      element.theta = 10;
      element.phi = 20;
      element.radius = 7;
      element.target = [1, 0, 0];
      const moved = element.camera;
      element.setAttribute('theta', '11');
      element.removeAttribute('phi');
      return [moved, element.camera];
    });
    expect(cameras[0]).toMatchObject({ theta: 10, phi: 20, radius: 7, target: [1, 0, 0] });
    expect(cameras[1]).toMatchObject({ theta: 11, phi: 70 });
  });

  test('resetCamera goes back to the last declared camera, not to the first', async ({ page, mount }) => {
    const viewer = await mount('<phong-viewer geometry="box" theta="30"></phong-viewer>');
    await assign(viewer, { theta: 45 });
    const declared = await cameraOf(viewer);
    await drag(page, [300, 200], [60, 40]);
    await page.mouse.wheel(0, 200);
    await drag(page, [300, 200], [60, 40], { button: 'right' });
    await viewer.evaluate((element: PhongViewer) => element.resetCamera());
    expect(await cameraOf(viewer)).toEqual(declared);
  });
});

test.describe('auto', () => {
  /** 1.05 R / sin(half the smaller field). */
  const fitted = (reach: number, width: number, height: number, fov = 45): number => {
    const vertical = radians(fov / 2);
    const horizontal = Math.atan((Math.tan(vertical) * width) / height);
    return (1.05 * reach) / Math.sin(Math.min(vertical, horizontal));
  };

  for (const [what, width, height] of [
    ['wide', 600, 300],
    ['square', 300, 300],
    ['tall', 200, 600],
  ] as const) {
    test(`fits the farthest vertex of the scene into a ${what} viewer`, async ({ mount }) => {
      const scenes = [
        ['<phong-viewer geometry="box"></phong-viewer>', [0, 0, 0], Math.sqrt(0.75), 45],
        ['<phong-viewer geometry="plane" fov="100"></phong-viewer>', [0, 0, 0], Math.sqrt(0.5), 100],
        // Boxes from (0.5, 1.5, -0.5) to (1.5, 2.5, 0.5) and, twice as large, from (-4, -1, -1) to (-2, 1, 1).
        [
          `<phong-viewer><phong-mesh geometry="box" position="1 2 0"></phong-mesh>
            <phong-mesh geometry="box" position="-3 0 0" scale="2"></phong-mesh></phong-viewer>`,
          [-1.25, 0.75, 0],
          Math.hypot(2.75, 1.75, 1),
          45,
        ],
        ['<phong-viewer></phong-viewer>', [0, 0, 0], null, 45],
      ] as const;
      for (const [markup, target, reach, fov] of scenes) {
        const viewer = await mount(markup, { width, height });
        const camera = await cameraOf(viewer);
        for (const i of [0, 1, 2] as const) expect(camera.target[i]).toBeCloseTo(target[i], 6);
        expect(camera.radius).toBeCloseTo(reach === null ? 4 : fitted(reach, width, height, fov), 5);
      }
    });
  }

  test('reaches the farthest vertex from a target that is given', async ({ mount }) => {
    const viewer = await mount('<phong-viewer geometry="box" target="2 0 0"></phong-viewer>');
    const camera = await cameraOf(viewer);
    expect(camera.target).toEqual([2, 0, 0]);
    expect(camera.radius).toBeCloseTo(fitted(Math.hypot(2.5, 0.5, 0.5), 600, 400), 6);
  });

  test('fits anew to meshes, size and field of view until the user moves the camera', async ({
    page,
    mount,
  }) => {
    const viewer = await mount('<phong-viewer geometry="box"></phong-viewer>');
    const reach = Math.sqrt(0.75);
    const radius = async (): Promise<number> => (await cameraOf(viewer)).radius;
    await assign(viewer, { theta: 90, fov: 60 });
    expect(await radius()).toBeCloseTo(fitted(reach, 600, 400, 60), 6);
    await viewer.evaluate((element) => Object.assign(element.style, { width: '200px' }));
    await expect.poll(radius).toBeCloseTo(fitted(reach, 200, 400, 60), 6);
    await viewer.evaluate((element) => {
      const mesh = Object.assign(document.createElement('phong-mesh'), {
        geometry: 'box',
        position: [2, 0, 0],
      });
      element.append(mesh);
    });
    expect((await cameraOf(viewer)).target).toEqual([1, 0, 0]);
    expect(await radius()).toBeCloseTo(fitted(Math.hypot(1.5, 0.5, 0.5), 200, 400, 60), 6);

    await drag(page, [100, 200], [10, 0]);
    const kept = await cameraOf(viewer);
    await assign(viewer, { fov: 30, geometry: null });
    await viewer.evaluate((element) => Object.assign(element.style, { width: '600px' }));
    await nextFrame(page);
    expect(await cameraOf(viewer)).toMatchObject({ radius: kept.radius, target: kept.target });
    await assign(viewer, { radius: 'auto' });
    expect(await radius()).not.toBe(kept.radius);
  });

  test('a radius that is given stays, whatever comes', async ({ mount }) => {
    const viewer = await mount(near);
    await assign(viewer, { geometry: 'torus', fov: 20 });
    expect((await cameraOf(viewer)).radius).toBe(5);
  });
});

test.describe('camera-change', () => {
  test('names its source, once a task', async ({ page, mount }) => {
    const viewer = await mount(near);
    const events = await record(viewer, 'camera-change');
    const sources = async (): Promise<unknown[]> =>
      (await events.take()).map(({ detail }) => (detail as { source: string }).source);
    await assign(viewer, { theta: 1, phi: 2, radius: 3, target: [4, 5, 6] });
    expect(await sources()).toEqual(['script']);
    await assign(viewer, { theta: 1 });
    expect(await sources()).toEqual([]);
    await viewer.focus();
    await page.keyboard.press('ArrowLeft');
    expect(await sources()).toEqual(['key']);
    await page.keyboard.press('Home');
    expect(await sources()).toEqual(['key']);
    await page.mouse.move(300, 200);
    await page.mouse.wheel(0, 100);
    await expect.poll(sources).toEqual(['wheel']);
    await drag(page, [300, 200], [30, 0], { steps: 3 });
    expect(await sources()).toEqual(['pointer', 'pointer', 'pointer']);
    await viewer.evaluate((element: PhongViewer) => element.resetCamera());
    expect(await sources()).toEqual(['script']);
    await assign(viewer, { radius: 'auto', target: 'auto' });
    await sources();
    await assign(viewer, { geometry: 'torus' });
    await nextFrame(page);
    expect(await sources()).toEqual(['auto']);
  });

  test('does not bubble and says nothing of where a camera begins', async ({ page, mount }) => {
    await mount('<main></main>');
    const heard = await page.evaluate(async () => {
      const sources: string[] = [];
      let bubbled = 0;
      document.addEventListener('camera-change', () => (bubbled += 1));
      const element = document.createElement('phong-viewer');
      element.addEventListener('camera-change', (event) =>
        sources.push((event as CustomEvent<{ source: string }>).detail.source),
      );
      element.setAttribute('theta', '12');
      document.querySelector('main')?.append(element);
      await element.ready;
      const first = [...sources];
      element.theta = 40;
      await element.ready;
      return { first, after: sources, bubbled };
    });
    expect(heard).toEqual({ first: [], after: ['script'], bubbled: 0 });
  });
});

test.describe('auto-rotate', () => {
  const turning = '<phong-viewer geometry="box" theta="0" auto-rotate="90"></phong-viewer>';

  test('turns by elapsed time, and rests while a hand holds the scene', async ({ page, mount }) => {
    const viewer = await mount(turning);
    const shown = await viewer.evaluate(async (element: PhongViewer) => {
      const places: { time: number; theta: number }[] = [];
      await new Promise<void>((resolve) => {
        element.addEventListener('render', () => {
          places.push({ time: Number(document.timeline.currentTime), theta: element.camera.theta });
          if (places.length === 10) resolve();
        });
      });
      return places;
    });
    const first = shown[1]!;
    for (const { time, theta } of shown.slice(2)) {
      const turned = (theta - first.theta + 360) % 360;
      expect(turned).toBeCloseTo((0.09 * (time - first.time)) % 360, 6);
    }
    await page.mouse.move(300, 200);
    await page.mouse.down();
    const { theta } = await cameraOf(viewer);
    await nextFrame(page);
    expect((await cameraOf(viewer)).theta).toBe(theta);
    await page.mouse.up();
    await expect.poll(async () => (await cameraOf(viewer)).theta).not.toBe(theta);
  });

  test('stands still for readers who prefer reduced motion, and starts when they no longer do', async ({
    page,
    mount,
  }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    const viewer = await mount(turning);
    await nextFrame(page);
    expect((await cameraOf(viewer)).theta).toBe(0);
    await drag(page, [300, 200], [-60, 0]);
    expect((await cameraOf(viewer)).theta).toBe(36);
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    await expect.poll(async () => (await cameraOf(viewer)).theta).not.toBe(36);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await nextFrame(page);
    const { theta } = await cameraOf(viewer);
    await nextFrame(page);
    expect((await cameraOf(viewer)).theta).toBe(theta);
  });
});
