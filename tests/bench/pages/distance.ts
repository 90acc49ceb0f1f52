// Judges a screenshot of any peer's sphere.
import type { ReferenceOptions } from '../../../src/reference/equation.js';
import { SIZE } from './distance-scene.js';
import { type Distance, distanceOf } from './distance-truth.js';

declare global {
  interface Window {
    /** Of a PNG in base64. */
    distanceOfPicture: (picture: string, options: ReferenceOptions) => Promise<Distance>;
  }
}

window.distanceOfPicture = async (picture, options) => {
  const blob = await (await fetch(`data:image/png;base64,${picture}`)).blob();
  const bitmap = await createImageBitmap(blob, { colorSpaceConversion: 'none' });
  const context = new OffscreenCanvas(SIZE, SIZE).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return distanceOf(context.getImageData(0, 0, SIZE, SIZE).data, options);
};
