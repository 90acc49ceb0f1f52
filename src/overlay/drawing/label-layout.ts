// Measures labels and places them so that none covers another and all stay inside. One place after the other, the first
// ones first. CSS pixels of the layer.
import type { Point } from './projection.js';
import { FONT } from './display-list.js';

export interface LabelWish {
  /** What the label belongs to. */
  readonly center: Point;
  /** Pixels around the centre that the label keeps free. */
  readonly gap: number;
  /** Width of the text. */
  readonly width: number;
}

export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Height of a label's line, and how far above its lower edge the baseline is. For a font of 12 pixels. */
export const LINE = { height: 16, descent: 4 } as const;

/** Pixels to the layer's edge: the text's outline. */
const MARGIN = 2;

/** Right, left, above, below, then between them. */
const SIDES: readonly (readonly [across: -1 | 0 | 1, down: -1 | 0 | 1])[] = [
  [1, 0],
  [-1, 0],
  [0, -1],
  [0, 1],
  [1, -1],
  [-1, -1],
  [1, 1],
  [-1, 1],
];

/**
 * Left ends of the baselines, in the order of the wishes; null where there is no room. Labels avoid each other and, if
 * they can, `avoided`.
 */
export function placeLabels(
  wishes: readonly LabelWish[],
  size: { readonly width: number; readonly height: number },
  avoided: readonly Box[],
): (Point | null)[] {
  const taken: Box[] = [];
  return wishes.map((wish) => {
    const boxes = SIDES.map((side) => boxAt(wish, side)).filter(
      (box) => isInside(box, size) && isFree(box, taken),
    );
    const box = boxes.find((each) => isFree(each, avoided)) ?? boxes[0];
    if (box === undefined) return null;
    taken.push(box);
    return { x: box.left, y: box.bottom - LINE.descent };
  });
}

function boxAt({ center, gap, width }: LabelWish, [across, down]: (typeof SIDES)[number]): Box {
  const { height } = LINE;
  const left = center.x + across * gap - ((1 - across) / 2) * width;
  const top = center.y + down * gap - ((1 - down) / 2) * height;
  return { left, top, right: left + width, bottom: top + height };
}

const isInside = ({ left, top, right, bottom }: Box, size: { width: number; height: number }): boolean =>
  left >= MARGIN && top >= 0 && right <= size.width - MARGIN && bottom <= size.height;

const isFree = (box: Box, others: readonly Box[]): boolean =>
  others.every(
    (other) =>
      box.right <= other.left ||
      box.left >= other.right ||
      box.bottom <= other.top ||
      box.top >= other.bottom,
  );

/** A square around a point. */
export const boxAround = ({ x, y }: Point, half: number): Box => ({
  left: x - half,
  top: y - half,
  right: x + half,
  bottom: y + half,
});

/** Names are few; a page that writes new ones every frame must not keep them all. */
const MOST_WIDTHS = 1000;

const widths = new Map<string, number>();
let context: CanvasRenderingContext2D | null = null;

/** Measured by a canvas, which costs no layout. CSS pixels. */
export function textWidth(text: string): number {
  const known = widths.get(text);
  if (known !== undefined) return known;
  if (widths.size >= MOST_WIDTHS) widths.clear();
  context ??= document.createElement('canvas').getContext('2d');
  if (context !== null) context.font = FONT;
  // Without a canvas: seven pixels a letter is wider than most text.
  const width = context?.measureText(text).width ?? 7 * text.length;
  widths.set(text, width);
  return width;
}

/** The first `most` characters of a text, with an ellipsis in place of the rest. */
export function shortened(text: string, most = 24): string {
  const characters = Array.from(text);
  return characters.length <= most ? text : `${characters.slice(0, most - 1).join('')}…`;
}
