// How far is a viewer's picture from the mean of the true round shape that its geometry stands for?
import type { Locator } from '@playwright/test';
import { basisOf } from '../../../src/camera/orbit.js';
import { LightState } from '../../../src/reference/index.js';
import type { PhongViewer } from '../../../src/index.js';
import { pixels } from '../picture.js';
import { castPicture } from './cast.mjs';
import type { TrueShape } from './scene.js';

/** What a viewer without lights has: its camera's. */
const HEAD_LIGHT = new LightState({ space: 'camera', position: [0, 0, 1, 0] }).values;

/**
 * Root of the mean squared error in codes, over red, green and blue on a white page. The viewer has one mesh, its own,
 * and no lights or materials but the default ones. `samples`: see `CastOptions`.
 */
export async function errorAgainstRound(
  viewer: Locator,
  size: { readonly width: number; readonly height: number },
  samples: number,
): Promise<number> {
  const { width, height } = size;
  const seen = await viewer.evaluate((element: PhongViewer) => {
    const { eye, theta, phi } = element.camera;
    const { geometry, fov, ka, kd, ks, shininess } = element;
    return { eye, theta, phi, geometry, fov, ka, kd, ks, shininess };
  });
  const { eye, theta, phi, geometry, fov, ka, kd, ks, shininess } = seen;
  const scene = {
    camera: { eye, ...basisOf({ theta, phi }), fov },
    lights: [HEAD_LIGHT],
    objects: [{ shape: { kind: geometry as TrueShape['kind'] }, material: { ka, kd, ks, shininess } }],
  };
  const truth = await castPicture(scene, { width, height, samples });
  const { data } = await pixels(viewer, size);
  let squares = 0;
  for (let i = 0; i < data.length; i++) {
    if (i % 4 === 3) continue;
    const alpha = data[i | 3]!;
    const drawn = (data[i]! * alpha) / 255 + 255 - alpha;
    squares += (drawn - (truth[i]! + 255 - truth[i | 3]!)) ** 2;
  }
  return Math.sqrt(squares / (3 * width * height));
}
