// Where do the pictures of one frame lie on the canvas that they are drawn on together? Whole pixels from the canvas's
// bottom left corner, as WebGL counts. Knows nothing of what is drawn.

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** A part of the sheet: pixels from its bottom left corner. */
export interface Place extends Size {
  readonly x: number;
  readonly y: number;
}

export interface AtlasLayout extends Size {
  /** Of the first pictures, as many as the sheet holds: at least one. */
  readonly places: readonly Place[];
}

export interface AtlasLimit {
  /** Of width and height. */
  readonly side: number;
  /** Of their product; one picture alone may be larger. */
  readonly area: number;
}

/** In rows, in the given order, on a sheet about as wide as high. Sizes are at least 1 and within `limit.side`. */
export function layOutAtlas(sizes: readonly Size[], limit: AtlasLimit): AtlasLayout {
  const wanted = sizes.reduce((sum, { width, height }) => sum + width * height, 0);
  const widest = sizes.reduce((most, { width }) => Math.max(most, width), 0);
  const rowWidth = Math.max(widest, Math.ceil(Math.sqrt(Math.min(wanted, limit.area, limit.side ** 2))));
  const places: Place[] = [];
  let x = 0;
  let y = 0;
  let right = 0;
  let top = 0;
  for (const { width, height } of sizes) {
    if (x + width > rowWidth) {
      x = 0;
      y = top;
    }
    const sheetWidth = Math.max(right, x + width);
    const sheetHeight = Math.max(top, y + height);
    if (places.length > 0 && (sheetHeight > limit.side || sheetWidth * sheetHeight > limit.area)) break;
    places.push({ x, y, width, height });
    x += width;
    right = sheetWidth;
    top = sheetHeight;
  }
  return { width: right, height: top, places };
}
