// The pictures of a run: the learner's and the exact one.
import { srgbEncode } from '../../phong/math/color.js';
import { add, map } from '../../phong/math/vector.js';
import {
  colorAt,
  type Colors,
  exactAt,
  shownValue,
  type Work,
} from '../../phong/mistakes/judge.js';
import type { PicturePoints } from './picture.js';

/** By the classes of their canvases. */
export type Images = Readonly<Record<'own' | 'exact', ImageData>>;

export function* imagesOf(picture: PicturePoints, colors: Colors): Work<Images> {
  const { width, height, cases, pixels, emissive, linear } = picture;
  const empty = () => new ImageData(width, height);
  const images = { own: empty(), exact: empty() };
  const shown = (sum: number) => (linear ? srgbEncode(shownValue(sum)) : shownValue(sum));
  for (const [i, pixel] of pixels.entries()) {
    const sums = { own: colorAt(colors, i), exact: exactAt(cases[i]!) };
    for (const name of ['own', 'exact'] as const) {
      const color = map(add(sums[name], emissive[i]!), shown);
      images[name].data.set([...color.map((x) => 255 * x), 255], 4 * pixel);
    }
    yield;
  }
  return images;
}

export function paint(root: ShadowRoot, images: Partial<Images>): void {
  for (const [name, image] of Object.entries(images)) {
    for (const canvas of root.querySelectorAll<HTMLCanvasElement>(`.${name}`)) {
      canvas.getContext('2d')?.putImageData(image, 0, 0);
    }
  }
}
