// A viewer's picture, and what shadeAt explains of it. Runs inside the page. Positions are device pixels from the top
// left.
import type { PhongViewer } from '../index.js';

/** What shadeAt gives for a point of a surface. */
export type Explained = NonNullable<Awaited<ReturnType<PhongViewer['shadeAt']>>> & {
  readonly filtered?: boolean;
};

/** Explains the point at x, y; null where no Phong-lit surface is drawn. */
export type Explain = (x: number, y: number) => Promise<Explained | null>;

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

export function explainer(viewer: PhongViewer, width: number, height: number): Explain {
  const surface = viewer.shadowRoot?.querySelector('[part=surface]');
  if (!surface) throw new Error('the viewer cannot be drawn here');
  // shadeAt takes CSS pixels of the picture before any transform; inside CSS zoom, those of pointer events.
  const style = getComputedStyle(surface);
  const zoom = (surface as { currentCSSZoom?: number }).currentCSSZoom ?? 1;
  const cssX = (parseFloat(style.width) * zoom) / width;
  const cssY = (parseFloat(style.height) * zoom) / height;
  return (x, y) => viewer.shadeAt(x * cssX, y * cssY, { exact: true });
}
