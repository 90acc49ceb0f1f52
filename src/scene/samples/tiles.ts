// Divides a picture whose samples are too many pixels for one sum, and shifts parts by a sample's place in the pixel.
import { pixelOffset } from '../../math/pixel-offsets.js';
import type { Size } from '../gpu/atlas.js';
import type { Region } from '../gpu/stage.js';

/** Tiles of at most `area` pixels and `side` on each side, row by row from the top. */
export function tilesOf({ width, height }: Size, area: number, side = Infinity): readonly Region[] {
  const tileWidth = Math.min(width, side, area);
  const tileHeight = Math.max(1, Math.min(height, side, Math.floor(area / tileWidth)));
  const tiles: Region[] = [];
  for (let y = 0; y < height; y += tileHeight) {
    for (let x = 0; x < width; x += tileWidth)
      tiles.push({ x, y, width: Math.min(tileWidth, width - x), height: Math.min(tileHeight, height - y) });
  }
  return tiles;
}

/** A part of a picture as sample `index` sees it. */
export function shifted(part: Region, index: number): Region {
  const { x, y } = pixelOffset(index);
  return { ...part, x: part.x + x, y: part.y + y };
}
