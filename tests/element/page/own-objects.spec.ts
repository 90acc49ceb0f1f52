// When are objects that a page adds to `scene` measured, and are they ever clipped?

import type { Mesh } from 'three';
import { expect, test } from '../../support/test.js';
import { pixels } from '../../support/picture.js';
import { cameraOf, type PhongViewer } from '../support/viewer.js';

const box =
  '<phong-viewer geometry="box" theta="0" phi="90"><phong-light ambient="99"></phong-light></phong-viewer>';
const size = { width: 100, height: 100 };

/** In the page: a copy of the viewer's own box, put beside it. */
const addOwn = (element: PhongViewer): void => {
  const own = (element.scene.getObjectByProperty('isMesh', true) as Mesh).clone();
  own.name = 'own';
  own.matrixAutoUpdate = true;
  own.position.x = 4;
  element.scene.add(own);
};

test('refit reads vertices that were written in place', async ({ mount }) => {
  const viewer = await mount(box, size);
  const before = await cameraOf(viewer);
  await viewer.evaluate((element: PhongViewer) => {
    const { geometry } = element.scene.getObjectByProperty('isMesh', true) as Mesh;
    geometry.scale(2, 2, 2);
    element.requestRender();
  });
  expect((await cameraOf(viewer)).radius).toBe(before.radius);
  await viewer.evaluate((element: PhongViewer) => {
    element.refit();
  });
  expect((await cameraOf(viewer)).radius / before.radius).toBeCloseTo(2, 5);
});

for (const [where, z, scale] of [
  ['far behind the scene', -300, 150],
  ['close to the eye', 2.1, 0.2],
] as const) {
  test(`an own object that moves ${where} is not clipped`, async ({ mount }) => {
    const viewer = await mount(box.replace('geometry="box"', 'geometry="box" ka="0" kd="0" ks="0"'), size);
    await viewer.evaluate(addOwn);
    await viewer.evaluate(
      async (element: PhongViewer, [z, scale]) => {
        const own = element.scene.getObjectByName('own')!;
        element.scene.getObjectByProperty('isMesh', true)!.visible = false;
        own.position.set(0, 0, z);
        own.scale.setScalar(scale);
        element.requestRender();
        await element.ready;
      },
      [z, scale] as const,
    );
    const { data } = await pixels(viewer);
    expect(data[4 * (50 * 100 + 50) + 3]).toBe(255);
  });
}
