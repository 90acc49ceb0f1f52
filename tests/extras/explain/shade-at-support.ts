// Fragments that shadeAt explains, held against the pixels that toBlob draws: both asked for inside
// the page. Positions are device pixels, colours 8-bit codes.

import type { ViewerLocator } from '../../support/test.js';
import type { PhongViewer } from '../../element/support/viewer.js';

export interface Compared {
  readonly column: number;
  readonly row: number;
  /** The drawn r, g, b, a. */
  readonly drawn: readonly number[];
  /** 255 times the explained colour, not rounded. */
  readonly explained: readonly number[];
  readonly opacity: number;
  /** The picture averages a texture there. */
  readonly filtered: boolean;
  /** Angle in radians to the nearest edge of a cone or horizon of a light. */
  readonly edgeMargin: number;
  /** Largest difference of a channel from the eight neighbours. */
  readonly steepness: number;
}

/** Replaces the viewer and waits until this one is ready. */
export const show = (viewer: ViewerLocator, markup: string): Promise<void> =>
  viewer.evaluate((element, text) => {
    element.outerHTML = text;
    return document.querySelector<PhongViewer>('phong-viewer')!.ready;
  }, markup);

/**
 * Whether the pixel can be compared. The rasteriser snaps vertices to sixteenths of a pixel: so
 * near a cone's edge or a light's horizon the pixel may be on either side, and where colours change
 * faster it may be another one's. NaN is judged, and fails.
 */
export const isClear = ({ edgeMargin, steepness }: Compared): boolean =>
  !(edgeMargin < 3e-3) && !(steepness > 8);

/** Largest difference of a channel, in codes. */
export const errorOf = ({ drawn, explained }: Compared): number =>
  Math.max(
    ...[0, 1, 2].map((channel) => Math.abs(Math.round(explained[channel]!) - drawn[channel]!)),
  );

/**
 * Every `step`-th pixel across and down whose eight neighbours show the same triangle: there the
 * pixel is one fragment, and no mixture of several at an edge.
 */
export const comparedWithPicture = (viewer: ViewerLocator, step: number): Promise<Compared[]> =>
  viewer.evaluate(async (element, stride) => {
    const bitmap = await createImageBitmap(await element.toBlob(), { premultiplyAlpha: 'none' });
    const { width, height } = bitmap;
    const context = new OffscreenCanvas(width, height).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const box = element.shadowRoot!.querySelector('.surface')!.getBoundingClientRect();
    const at = (column: number, row: number) =>
      element.shadeAt(((column + 0.5) * box.width) / width, ((row + 0.5) * box.height) / height);
    const compared: Compared[] = [];
    for (let row = stride; row < height - 1; row += stride) {
      for (let column = stride; column < width - 1; column += stride) {
        const here = await at(column, row);
        if (here === null) continue;
        let inside = true;
        let steepness = 0;
        for (let neighbour = 0; inside && neighbour < 9; neighbour++) {
          if (neighbour === 4) continue; // itself
          const there = await at(column + (neighbour % 3) - 1, row + Math.floor(neighbour / 3) - 1);
          inside = there?.object === here.object && there.triangle === here.triangle;
          for (const channel of [0, 1, 2] as const) {
            steepness = Math.max(
              steepness,
              255 * Math.abs((there?.color[channel] ?? 0) - here.color[channel]),
            );
          }
        }
        if (!inside) continue;
        let edgeMargin = Infinity;
        for (const share of here.shares) {
          if (!share?.light) continue;
          edgeMargin = Math.min(edgeMargin, Math.abs(share.NoL));
          if (share.light.aperture >= 180) continue;
          const angle = Math.acos(Math.min(Math.max(share.c, -1), 1));
          edgeMargin = Math.min(
            edgeMargin,
            Math.abs(angle - (share.light.aperture * Math.PI) / 180),
          );
        }
        const pixel = 4 * (row * width + column);
        compared.push({
          column,
          row,
          drawn: [...data.subarray(pixel, pixel + 4)],
          explained: here.color.map((x) => x * 255),
          opacity: here.opacity,
          filtered: here.filtered,
          edgeMargin,
          steepness,
        });
      }
    }
    return compared;
  }, step);
