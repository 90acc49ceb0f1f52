// Are vertex colours mixed in the light that they are stored in, as in the picture of the viewer?
import { expect, it } from 'vitest';
import { srgbEncode } from '../../../src/phong/math/color.js';
import { Hit } from '../../../src/extras/still/hit.js';
import { ObjectSurface } from '../../../src/extras/still/surfaces.js';

it.each([
  ['encoded ones in sRGB', false, false, 0.5],
  ['encoded ones decoded under linear', false, true, 0.5],
  ['linear ones, and encoded after', true, false, srgbEncode(0.5)],
  ['linear ones under linear', true, true, 0.5],
])('mixes %s', (_, linearColors, linear, half) => {
  const shape = {
    positions: [0, 0, 0, 1, 0, 0, 0, 1, 0],
    normals: [0, 0, 1, 0, 0, 1, 0, 0, 1],
    colors: [1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 1],
    linearColors,
  } as const;
  const white = [255, 255, 255] as const;
  const material = { ka: white, kd: white, ks: white, shininess: 1, unlit: true };
  const options = { linear } as ConstructorParameters<typeof ObjectSurface>[2];
  const surface = new ObjectSurface({ shape, material }, [0, 0, 0], options);
  const { base } = surface.at({ ...new Hit(), triangle: 0, a: 0.5, b: 0.5 });
  expect(base.map((c) => c.toFixed(12))).toEqual([half, half, 0].map((c) => c.toFixed(12)));
});
