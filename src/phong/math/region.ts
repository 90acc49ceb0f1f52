// Parts of pictures and canvases, in pixels.

export interface Size {
  readonly width: number;
  readonly height: number;
}

/**
 * A part of a picture, from its top left; or of the atlas, from its bottom left, as WebGL counts.
 */
export interface Region extends Size {
  readonly x: number;
  readonly y: number;
}

/** Tiles of a picture of at most `area` pixels and `side` on each side, row by row from the top. */
export function tilesOf({ width, height }: Size, area: number, side = Infinity): readonly Region[] {
  const tileWidth = Math.min(width, side, area);
  const tileHeight = Math.max(1, Math.min(height, side, Math.floor(area / tileWidth)));
  const tiles: Region[] = [];
  for (let y = 0; y < height; y += tileHeight) {
    for (let x = 0; x < width; x += tileWidth) {
      tiles.push({
        x,
        y,
        width: Math.min(tileWidth, width - x),
        height: Math.min(tileHeight, height - y),
      });
    }
  }
  return tiles;
}

/**
 * Pixels of the longest side of a drawing that any GPU has memory for, with 4 samples per pixel.
 * Tiles of a capture and the canvas of a new context are not larger.
 */
export const SAFE_SIDE = 4096;
