// Places the pictures of one frame on the canvas that they share. Pixels.
import type { Region, Size } from '../../../phong/math/region.js';

export interface AtlasLayout extends Size {
  /** Places of the first pictures: as many as fit, at least one. */
  readonly places: readonly Region[];
}

export interface AtlasLimit {
  /** Largest width and largest height. */
  readonly side: number;
  /** Largest product of the two. A single picture may exceed it. */
  readonly area: number;
}

/**
 * Places the pictures in rows, in their order, about as wide as high. Sizes are 1 to `limit.side`.
 */
export function layOutAtlas(sizes: readonly Size[], limit: AtlasLimit): AtlasLayout {
  const total = sizes.reduce((sum, { width, height }) => sum + width * height, 0);
  const widest = sizes.reduce((most, { width }) => Math.max(most, width), 0);
  const rowWidth = Math.max(
    widest,
    Math.ceil(Math.sqrt(Math.min(total, limit.area, limit.side ** 2))),
  );
  const places: Region[] = [];
  let x = 0;
  let y = 0;
  let right = 0;
  let top = 0;
  for (const { width, height } of sizes) {
    if (x + width > rowWidth) {
      x = 0;
      y = top;
    }
    const atlasWidth = Math.max(right, x + width);
    const atlasHeight = Math.max(top, y + height);
    if (places.length > 0 && (atlasHeight > limit.side || atlasWidth * atlasHeight > limit.area)) {
      break;
    }
    places.push({ x, y, width, height });
    x += width;
    right = atlasWidth;
    top = atlasHeight;
  }
  return { width: right, height: top, places };
}
