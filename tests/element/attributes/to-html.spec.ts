// Does toHTML write the camera that the user has moved? unit/elements/to-html.test.ts has the rest of
// the markup, and histories/histories.spec.ts that it gives the same picture.

import { expect, test } from '../../support/test.js';
import { drag, nextFrame } from '../support/viewer.js';

test('what the user moved is where toHTML says, to the last bit', async ({ page, mount }) => {
  const viewer = await mount(
    '<phong-viewer geometry="torus" fov="37" gui="radius"></phong-viewer>',
    {
      width: 713,
      height: 407,
    },
  );
  const moves = [
    () => drag(page, [300, 200], [37, 11]),
    () => drag(page, [300, 200], [-401, 53]),
    () => drag(page, [200, 200], [29, -67]),
    () => page.mouse.wheel(0, 137),
    () => page.keyboard.press('ArrowLeft'),
    () => page.keyboard.press('+'),
    () => viewer.getByRole('textbox', { name: 'radius', exact: true }).fill('3.123456789123'),
  ];
  for (const move of moves) {
    await move();
    await nextFrame(page); // events that wait for one
    const { written, camera } = await viewer.evaluate((element) => {
      const parsed = new DOMParser().parseFromString(element.toHTML(), 'text/html');
      const text = (name: string) => parsed.body.firstElementChild!.getAttribute(name)!;
      return {
        written: ['theta', 'phi', 'radius', 'target'].map((name) =>
          text(name).split(' ').map(Number),
        ),
        camera: [
          element.camera.theta,
          element.camera.phi,
          element.camera.radius,
          element.camera.target,
        ].flat(),
      };
    });
    expect(camera).toEqual(written.flat());
  }
});
