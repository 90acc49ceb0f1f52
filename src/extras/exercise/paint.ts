// The pictures of a run on their canvases: the learner's, the exact one, and the difference.
import { srgbEncode } from '../../phong/math/color.js';
import { type Case, exactAt } from '../../phong/mistakes/judge.js';
import type { PicturePoints } from './picture.js';

export function paint(root: ShadowRoot, colors: Float32Array, picture: PicturePoints | null): void {
  if (picture === null) return;
  const { width, height, cases, pixels } = picture;
  const draw = (id: string, colorOf: (i: number, at: Case) => readonly number[]): void => {
    const canvas = root.querySelector<HTMLCanvasElement>(`#${id}`);
    const context = canvas?.getContext('2d') ?? null;
    if (context === null) return;
    const image = context.createImageData(width, height);
    for (const [i, at] of cases.entries()) {
      image.data.set([...colorOf(i, at).map((x) => 255 * x), 255], 4 * pixels[i]!);
    }
    context.putImageData(image, 0, 0);
  };
  const shown = picture.linear ? srgbEncode : (x: number) => x;
  const own = (i: number): readonly number[] =>
    [0, 1, 2].map((k) => shown(Math.min(Math.max(colors[3 * i + k]!, 0), 1)));
  const exact = (at: Case): readonly number[] =>
    exactAt(at).map((x) => shown(Math.min(Math.max(x, 0), 1)));
  draw('own', own);
  draw('exact', (_, at) => exact(at));
  draw('difference', (i, at) => {
    const right = exact(at);
    // Four steps can be seen, and full is a quarter off.
    return own(i).map((x, k) => (Number.isNaN(x) ? 1 : Math.min(4 * Math.abs(x - right[k]!), 1)));
  });
}
