// Do toBlob and toHTML give the picture and the scene as they are now? Sizes in pixels; pictures
// are decoded PNGs or, for JPEG, what the browser reads back.

import type { Mesh } from 'three';
import { compare, expect, pixelAt, pixels, same, test, type Picture } from '../../support/test.js';
import { cameraOf, drag, nextFrame, type PhongViewer, record, settled } from '../support/viewer.js';

const size = { width: 120, height: 80 };
const light = '<phong-light position="1 2 3 0" ambient="60"></phong-light>';
const box = `<phong-viewer geometry="box" kd="200 40 40">${light}</phong-viewer>`;

test.describe('toBlob', () => {
  test('gives the requested pixels, or those of the canvas; JPEG over white; RangeErrors', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(box, { ...size, deviceScaleFactor: 2 });
    const before = await pixels(viewer);
    const of = (options: object) =>
      viewer.evaluate(async (element, given) => {
        try {
          const blob = await element.toBlob(given);
          const { width, height } = await createImageBitmap(blob);
          return [blob.type, width, height];
        } catch (error) {
          return (error as Error).name;
        }
      }, options);
    for (const [options, ...expected] of [
      [{}, 'image/png', 240, 160],
      [{ width: 37, height: 91 }, 'image/png', 37, 91],
      [{ width: 50 }, 'image/png', 50, 160],
      [{ width: 1, height: 1 }, 'image/png', 1, 1],
      [{ width: 8, height: 8, type: 'image/webp' }, 'image/webp', 8, 8],
    ] as const) {
      expect(await of(options), JSON.stringify(options)).toEqual(expected);
    }
    for (const bad of [0, -1, 1.5, NaN, Infinity, 1e5, 1e9]) {
      expect(await of({ width: bad, height: 10 }), `width ${bad}`).toBe('RangeError');
    }
    expect(await of({ width: 100_000, height: 100_000 })).toBe('RangeError');
    expect(await of({ width: 10, height: '10' })).toMatch(/^(Range|Type)Error$/);
    expect(await of({ quality: 7 })).toBe('RangeError');
    await viewer.evaluate((element) => (element.style.display = 'none'));
    await nextFrame(page);
    expect(await of({}), 'hidden').toEqual(['image/png', 300, 150]);
    await viewer.evaluate((element) => (element.style.display = ''));
    await settled(viewer);
    same(await pixels(viewer), before);
    const corner = await viewer.evaluate(async (element) => {
      const blob = await element.toBlob({ type: 'image/jpeg', quality: 1 });
      const context = new OffscreenCanvas(1, 1).getContext('2d')!;
      context.drawImage(await createImageBitmap(blob), 0, 0);
      return [blob.type, ...context.getImageData(0, 0, 1, 1).data];
    });
    expect(corner).toEqual(['image/jpeg', 255, 255, 255, 255]);
  });

  test('keeps the camera at any aspect, without seams where the GPU needs tiles', async ({
    page,
    mount,
  }) => {
    test.slow();
    const viewer = await mount(box.replace('geometry', 'radius="2" geometry'), size);
    await drag(page, [60, 40], [20, 9]);
    for (const [width, part, height] of [
      [200, 100, 100],
      [9000, 400, 100], // 4,500 is in the first tile's neighbour
    ] as const) {
      const wide = await pixels(viewer, { width, height });
      expect([wide.width, wide.height]).toEqual([width, height]);
      const narrow = await pixels(viewer, { width: part, height });
      // The vertical field is the same: the middle of the wide picture is the narrow one.
      const middle = crop(wide, (width - part) / 2, 0, part, height);
      expect(compare(middle, narrow, 2).share, `${width} × ${height}`).toBeLessThan(0.002);
    }
  });

  test('has straight alpha: an edge half covered keeps the colour of the inside', async ({
    mount,
  }) => {
    const flat = `<phong-viewer geometry="plane" ka="255" theta="20" phi="50" terms="ambient"><phong-light ambient="200 100 50"></phong-light></phong-viewer>`;
    const viewer = await mount(flat, size);
    const picture = await pixels(viewer);
    let edges = 0;
    const wrong: number[][] = [];
    for (let i = 0; i < picture.data.length; i += 4) {
      const [r, g, b, alpha] = picture.data.subarray(i, i + 4) as unknown as [
        number,
        number,
        number,
        number,
      ];
      if (alpha > 60 && alpha < 255) {
        edges += 1;
      }
      // Eight bits that were multiplied by alpha and divided again leave this much.
      const slack = Math.ceil(255 / alpha) + 1;
      const off = Math.max(Math.abs(r - 200), Math.abs(g - 100), Math.abs(b - 50));
      if (alpha === 0 ? r + g + b > 0 : off > slack) {
        wrong.push([r, g, b, alpha]);
      }
    }
    expect(wrong).toEqual([]);
    expect(edges).toBeGreaterThan(20);
  });

  test('shows changes of the same task, off screen, hidden and outside the document too', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(box, size);
    const red = await pixels(viewer, size);
    const outside = [
      [
        'off screen',
        (element: HTMLElement) => (element.style.cssText = 'position: absolute; top: 9000px'),
      ],
      ['not displayed', (element: HTMLElement) => (element.style.cssText = 'display: none')],
      ['out of the document', (element: HTMLElement) => (element.remove(), '')],
    ] as const;
    const handle = await viewer.evaluateHandle((element: PhongViewer) => element);
    const onScreen = await viewer.screenshot();
    for (const [what, hide] of outside) {
      await handle.evaluate(hide);
      await nextFrame(page);
      const equal = await handle.evaluate(async (element: PhongViewer, { width, height }) => {
        const bytes = async () => {
          const blob = await element.toBlob({ width, height });
          return String(new Uint8Array(await blob.arrayBuffer()));
        };
        const hidden = await bytes();
        element.kd = [1, 2, 3];
        const other = await bytes();
        element.kd = [200, 40, 40];
        element.style.cssText = '';
        document.body.prepend(element);
        await element.ready;
        return [hidden === (await bytes()), hidden === other];
      }, size);
      expect(equal, what).toEqual([true, false]);
      same(await pixels(viewer, size), red, what);
      await nextFrame(page);
      expect(Buffer.compare(await viewer.screenshot(), onScreen), what).toBe(0);
    }
  });
});

test('requestRender shows changes of own objects, with the same camera until refit', async ({
  mount,
}) => {
  const viewer = await mount(box, size);
  const before = await cameraOf(viewer);
  const picture = await pixels(viewer);
  const changes = await record(viewer, 'camera-change', 'render');
  await viewer.evaluate((element) => {
    const shape = element.scene.getObjectByProperty('isMesh', true) as Mesh;
    const own = shape.clone();
    own.matrixAutoUpdate = true;
    own.position.set(1, 0, 0);
    element.scene.add(own);
    element.requestRender();
  });
  await settled(viewer);
  expect(compare(await pixels(viewer), picture).max).toBeGreaterThan(20);
  expect(await cameraOf(viewer)).toEqual(before);
  expect(await changes.take()).toEqual([{ type: 'render', detail: null }]);
  await viewer.evaluate((element) => element.refit());
  await settled(viewer);
  const { target, radius } = await cameraOf(viewer);
  expect(target).toEqual([0.5, 0, 0]);
  expect(radius / before.radius).toBeCloseTo(
    Math.hypot(1, 0.5, 0.5) / Math.hypot(0.5, 0.5, 0.5),
    5,
  );
  expect(await changes.take()).toContainEqual({
    type: 'camera-change',
    detail: { source: 'auto' },
  });
  // Vertices that were written in place.
  await viewer.evaluate((element) => {
    (element.scene.getObjectByProperty('isMesh', true) as Mesh).geometry.scale(2, 2, 2);
    element.refit();
  });
  expect((await cameraOf(viewer)).radius / before.radius).toBeCloseTo(
    Math.hypot(1.5, 1, 1) / Math.hypot(0.5, 0.5, 0.5),
    5,
  );
});

test('an own object that moves far behind the scene or close to the eye is not clipped', async ({
  mount,
}) => {
  const dark =
    '<phong-viewer geometry="box" theta="0" phi="90" ka="0" kd="0" ks="0"></phong-viewer>';
  for (const [z, scale] of [
    [-300, 150],
    [2.1, 0.2],
  ] as const) {
    const viewer = await mount(dark, { width: 100, height: 100 });
    await viewer.evaluate(
      async (element, [z, scale]) => {
        const shape = element.scene.getObjectByProperty('isMesh', true) as Mesh;
        const own = shape.clone();
        own.matrixAutoUpdate = true;
        element.scene.add(own);
        shape.visible = false;
        own.position.set(0, 0, z);
        own.scale.setScalar(scale);
        element.requestRender();
        await element.ready;
      },
      [z, scale] as const,
    );
    expect(pixelAt(await pixels(viewer), 50, 50)[3], String(z)).toBe(255);
  }
});

/** A rectangle out of a picture. */
function crop(picture: Picture, x: number, y: number, width: number, height: number): Picture {
  const data = new Uint8Array(4 * width * height);
  for (let row = 0; row < height; row++) {
    const from = 4 * ((y + row) * picture.width + x);
    data.set(picture.data.subarray(from, from + 4 * width), 4 * row * width);
  }
  return { width, height, data };
}
