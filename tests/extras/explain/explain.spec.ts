// Does `explain` say what `shadeAt` says, and `probe-change` the same with and without a probe?

import { expect, test } from '../../support/test.js';
import type { PhongViewerEventMap } from '../../../src/viewer/index.js';

/** A floor below a lamp at 60 degrees, 2 away, seen from above. */
const scene = (attributes: string) =>
  `<phong-viewer alt="A floor" geometry="plane" theta="0" phi="30" radius="4" target="0 0 0" ka="255" kd="200" ks="255" probe-at="0 0 0" ${attributes}>
     <phong-light name="lamp" position="1.7320508 1 0 1" ambient="51" diffuse="204" specular="128" attenuation="1 0 0.75"></phong-light></phong-viewer>`;

test('`explain` says what `shadeAt` says, of hidden points and outside the picture too', async ({
  mount,
}) => {
  const viewer = await mount(scene(''));
  const [drawn, pixel, hidden, away, none] = await viewer.evaluate(async (element) => {
    const red = async (point: [number, number, number]) =>
      (await element.explain(point))?.sum[0] ?? null;
    const [x, y] = [element.clientWidth / 2, element.clientHeight / 2];
    const drawn = await red([0, 0, 0]);
    const pixel = (await element.shadeAt(x, y, { exact: true }))?.sum[0] ?? null;
    element.insertAdjacentHTML(
      'beforeend',
      '<phong-mesh geometry="box" position="0 1 0" scale="0.2"></phong-mesh>',
    );
    await element.ready;
    const hidden = await red([0, 0, 0]);
    element.target = [30, 0, 0];
    return [drawn, pixel, hidden, await red([0, 0, 0]), await red([0, 5, 0])];
  });
  expect(drawn).toBeCloseTo(pixel!, 9);
  expect(hidden).toBe(drawn);
  expect(away, 'from another eye').not.toBeNull();
  expect(none).toBeNull();
  for (const [point, name] of [
    [[0, 0], 'TypeError'],
    [[0, NaN, 0], 'RangeError'],
  ] as const) {
    expect(
      await viewer.evaluate(
        (element, wrong) => element.explain(wrong as never).catch((error: Error) => error.name),
        point,
      ),
    ).toBe(name);
  }
});

test('`probe-change` is the same with and without `probe`, and inside CSS zoom', async ({
  mount,
}) => {
  const viewer = await mount(scene(''), { css: 'phong-viewer { zoom: 2 }' });
  const { without, boxes, probed, gone } = await viewer.evaluate(async (element) => {
    type Detail = PhongViewerEventMap['probe-change']['detail'];
    // A point that was being explained before the change is told first.
    const next = (change: { kd?: readonly number[]; probe?: boolean }): Promise<Detail> =>
      new Promise((resolve) => {
        const heard = ({ detail }: PhongViewerEventMap['probe-change']) => {
          const kd = detail.fragment?.kd[0];
          if (change.kd && kd !== undefined && Math.abs(255 * kd - change.kd[0]!) > 1) return;
          element.removeEventListener('probe-change', heard);
          resolve(detail);
        };
        element.addEventListener('probe-change', heard);
        Object.assign(element, change);
      });
    const told = ({ fragment, x, y }: Detail): readonly number[] => [
      fragment!.kd[0],
      Math.round(x!),
      Math.round(y!),
    ];
    const without = told(await next({ kd: [100, 100, 100] }));
    const boxes = element.shadowRoot!.querySelectorAll('[part=probe]').length;
    const probed = told(await next({ probe: true }));
    element.probe = false;
    element.style.display = 'none';
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    return { without, boxes, probed, gone: await next({ kd: [90, 90, 90] }) };
  });
  expect(without[0]).toBeCloseTo(100 / 255, 6);
  expect(without).toEqual(probed);
  expect(boxes).toBe(0);
  expect(gone).toEqual({ fragment: null, x: null, y: null, pinned: true });
});
