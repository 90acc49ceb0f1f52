// Where each sample of a part of a picture lies.
import { pixelOffset } from '../../math/pixel-offsets.js';
import type { Region } from '../gpu/stage.js';

/** A part of a picture as sample `index` sees it. */
export function shifted(part: Region, index: number): Region {
  const { x, y } = pixelOffset(index);
  return { ...part, x: part.x + x, y: part.y + y };
}
