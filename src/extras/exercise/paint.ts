// The pictures of a run: the learner's, the exact one, and the difference.
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

/** By the ids of their canvases. */
export type Images = Readonly<Record<'own' | 'exact' | 'difference', ImageData>>;

export function* imagesOf(picture: PicturePoints, colors: Colors): Work<Images> {
  const { width, height, cases, pixels, emissive, linear } = picture;
  const empty = () => new ImageData(width, height);
  const images = { own: empty(), exact: empty(), difference: empty() };
  const shown = (sum: number) => (linear ? srgbEncode(shownValue(sum)) : shownValue(sum));
  for (const [i, pixel] of pixels.entries()) {
    const draw = (name: keyof Images, color: readonly number[]) =>
      images[name].data.set([...color.map((x) => 255 * x), 255], 4 * pixel);
    const own = map(add(colorAt(colors, i), emissive[i]!), shown);
    const exact = map(add(exactAt(cases[i]!), emissive[i]!), shown);
    draw('own', own);
    draw('exact', exact);
    // Four steps can be seen, and full is a quarter off.
    draw(
      'difference',
      own.map((x, k) => (Number.isNaN(x) ? 1 : 4 * Math.abs(x - exact[k]!))),
    );
    yield;
  }
  return images;
}

export function paint(root: ShadowRoot, images: Partial<Images>): void {
  for (const [name, image] of Object.entries(images)) {
    root.querySelector<HTMLCanvasElement>(`#${name}`)?.getContext('2d')?.putImageData(image, 0, 0);
  }
}
