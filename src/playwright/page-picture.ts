// A viewer's picture, and what shadeAt explains of it. Runs inside the page. Positions are device pixels from the top left.
import type { PhongViewer } from '../index.js';
import type { Explained } from './texture-fault.js';
import type { Tile } from './tiles.js';

/** What shadeAt explains of pixels in a row; null where no Phong-lit surface is drawn. */
export type Row = readonly (Explained | null)[];

/** Explains the fragment at the centre of pixel x, y; or with `exact` the point at x, y. */
export type Explain = (x: number, y: number, exact?: boolean) => Promise<Explained | null>;

/** The picture's pixels, without premultiplication or a colour conversion. */
export async function pictureOf(viewer: PhongViewer): Promise<ImageData> {
  const bitmap = await createImageBitmap(await viewer.toBlob(), {
    premultiplyAlpha: 'none',
    colorSpaceConversion: 'none',
  });
  const { width, height } = bitmap;
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (context === null) throw new Error('the viewer cannot be drawn here');
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, width, height);
}

/** Bits of the grid that the device moves vertices to. */
export function deviceSubpixelBits(): number {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (gl === null) throw new Error('the viewer cannot be drawn here');
  const bits = Number(gl.getParameter(gl.SUBPIXEL_BITS));
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return bits;
}

export function explainer(viewer: PhongViewer, width: number, height: number): Explain {
  const surface = viewer.shadowRoot?.querySelector('[part=surface]');
  if (!surface) throw new Error('the viewer cannot be drawn here');
  // shadeAt takes CSS pixels of the picture before any transform; inside CSS zoom, those of pointer events.
  const style = getComputedStyle(surface);
  const zoom = (surface as { currentCSSZoom?: number }).currentCSSZoom ?? 1;
  const cssX = (parseFloat(style.width) * zoom) / width;
  const cssY = (parseFloat(style.height) * zoom) / height;
  return (x, y, exact = false) => {
    const centre = exact ? 0 : 0.5;
    return viewer.shadeAt((x + centre) * cssX, (y + centre) * cssY, { exact });
  };
}

/** The pixels of a tile and those around it. */
export const rowsOf = (explain: Explain, { left, top, right, bottom }: Tile): Promise<Row[]> =>
  Promise.all(
    Array.from({ length: bottom - top + 2 }, (_, i) =>
      Promise.all(Array.from({ length: right - left + 2 }, (_, k) => explain(left - 1 + k, top - 1 + i))),
    ),
  );
