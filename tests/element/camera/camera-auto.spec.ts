// Where does the camera go by itself: `auto` radius and target, and `auto-rotate`? Radii are compared with the formula,
// computed here in float64. Viewers are 600 × 400 CSS pixels unless a test says otherwise.

import { expect, test } from '../../support/test.js';
import { assign, cameraOf, drag, nextFrame, type PhongViewer } from '../support/viewer.js';

const radians = (degrees: number): number => (degrees * Math.PI) / 180;

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

  test('refits to new meshes, size and field of view until the user moves the camera', async ({
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

  test('a declared radius stays, whatever changes', async ({ mount }) => {
    const viewer = await mount('<phong-viewer geometry="box" radius="5"></phong-viewer>');
    await assign(viewer, { geometry: 'torus', fov: 20 });
    expect((await cameraOf(viewer)).radius).toBe(5);
  });
});

test.describe('auto-rotate', () => {
  const turning = '<phong-viewer geometry="box" theta="0" auto-rotate="90"></phong-viewer>';

  test('turns by elapsed time, and pauses during a drag', async ({ page, mount }) => {
    const viewer = await mount(turning);
    const shown = await viewer.evaluate(async (element: PhongViewer) => {
      const places: { time: number; theta: number }[] = [];
      await new Promise<void>((resolve) =>
        element.addEventListener('render', () => {
          places.push({ time: Number(document.timeline.currentTime), theta: element.camera.theta });
          if (places.length === 10) resolve();
        }),
      );
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

  test('stops for users who prefer reduced motion, and starts when they no longer do', async ({
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
