// The pictures of a run on their canvases: the learner's, the exact one, and the difference.
import { srgbEncode } from '../../phong/math/color.js';
import { add, clamp, type Vec3 } from '../../phong/math/vector.js';
import { colorAt, exactAt } from '../../phong/mistakes/judge.js';
import type { PicturePoints } from './picture.js';

export function paint(root: ShadowRoot, colors: Float32Array, picture: PicturePoints | null): void {
  if (picture === null) return;
  const { width, height, cases, pixels, emissive } = picture;
  const draw = (id: string, colorOf: (i: number) => readonly number[]): void => {
    const canvas = root.querySelector<HTMLCanvasElement>(`#${id}`);
    const context = canvas?.getContext('2d') ?? null;
    if (context === null) return;
    const image = context.createImageData(width, height);
    for (const [i, pixel] of pixels.entries()) {
      image.data.set([...colorOf(i).map((x) => 255 * x), 255], 4 * pixel);
    }
    context.putImageData(image, 0, 0);
  };
  const shown = picture.linear ? srgbEncode : (x: number) => x;
  const sum = (i: number, light: Vec3): readonly number[] =>
    add(light, emissive[i]!).map((x) => shown(clamp(x, 0, 1)));
  const own = (i: number): readonly number[] => sum(i, colorAt(colors, i));
  const exact = (i: number): readonly number[] => sum(i, exactAt(cases[i]!));
  draw('own', own);
  draw('exact', exact);
  draw('difference', (i) => {
    const right = exact(i);
    // Four steps can be seen, and full is a quarter off.
    return own(i).map((x, k) => (Number.isNaN(x) ? 1 : Math.min(4 * Math.abs(x - right[k]!), 1)));
  });
}
