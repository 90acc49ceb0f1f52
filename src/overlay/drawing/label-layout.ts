// Measures labels and places them so that none covers another and all stay inside. One place after the other, the first
// ones first. CSS pixels of the layer.
import type { Point } from './projection.js';
import { labelFont } from './display-list.js';

export interface LabelWish {
  /** What the label belongs to. */
  readonly center: Point;
  /** Pixels around the centre that the label keeps free. */
  readonly gap: number;
  /** Width of the text. */
  readonly width: number;
}

export interface Rect {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Height of a label's line, and how far above its lower edge the baseline is. In font sizes. */
const LINE = { height: 4 / 3, descent: 1 / 3 } as const;

/** Pixels to the room's edge: the text's outline. */
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

/** Font sizes by which a label moves away from its centre if something is in its way, in the order tried. */
const FARTHER = [0, 0.7];

/**
 * Left ends of the baselines, in the order of the wishes; null where there is no room. Labels avoid each other, `boxes`
 * and, as far as they can, `avoided`. `room`: they stay inside.
 */
export function placeLabels(
  wishes: readonly LabelWish[],
  room: Rect,
  avoided: readonly Rect[],
  fontSize: number,
  boxes: readonly Rect[] = [],
): (Point | null)[] {
  const taken: Rect[] = [...boxes];
  return wishes.map((wish) => {
    const box = bestBox(wish, room, taken, avoided, fontSize);
    if (box === null) return null;
    taken.push(box);
    return { x: box.left, y: box.bottom - LINE.descent * fontSize };
  });
}

/** What a label covers, by the left end of its baseline. */
export function labelBox({ x, y }: Point, width: number, fontSize: number): Rect {
  const bottom = y + LINE.descent * fontSize;
  return { left: x, top: bottom - LINE.height * fontSize, right: x + width, bottom };
}

/** The first place of those that cover least of `avoided`. */
function bestBox(
  wish: LabelWish,
  room: Rect,
  taken: readonly Rect[],
  avoided: readonly Rect[],
  fontSize: number,
): Rect | null {
  let [best, least]: [Rect | null, number] = [null, Infinity];
  for (const by of FARTHER)
    for (const side of SIDES) {
      const box = boxAt(wish, wish.gap + by * fontSize, side, fontSize);
      if (!isInside(box, room) || overlap(box, taken) > 0) continue;
      const covered = overlap(box, avoided);
      if (covered === 0) return box;
      if (covered < least) [best, least] = [box, covered];
    }
  return best;
}

function boxAt(
  { center, width }: LabelWish,
  gap: number,
  [across, down]: (typeof SIDES)[number],
  fontSize: number,
): Rect {
  const height = LINE.height * fontSize;
  const left = center.x + across * gap - ((1 - across) / 2) * width;
  const top = center.y + down * gap - ((1 - down) / 2) * height;
  return { left, top, right: left + width, bottom: top + height };
}

const isInside = ({ left, top, right, bottom }: Rect, room: Rect): boolean =>
  left >= room.left + MARGIN && top >= room.top && right <= room.right - MARGIN && bottom <= room.bottom;

/** Square pixels that a box shares with others. */
function overlap(box: Rect, others: readonly Rect[]): number {
  let sum = 0;
  for (const other of others) {
    const width = Math.min(box.right, other.right) - Math.max(box.left, other.left);
    const height = Math.min(box.bottom, other.bottom) - Math.max(box.top, other.top);
    if (width > 0 && height > 0) sum += width * height;
  }
  return sum;
}

/** A square around a point. */
export const boxAround = ({ x, y }: Point, half: number): Rect => ({
  left: x - half,
  top: y - half,
  right: x + half,
  bottom: y + half,
});

/** All of a layer or a picture. */
export const whole = ({ width, height }: { readonly width: number; readonly height: number }): Rect => ({
  left: 0,
  top: 0,
  right: width,
  bottom: height,
});

/** Squares along a line, so close that no label fits between them. */
export function boxesAlong(points: readonly Point[], half: number): Rect[] {
  return points.flatMap((to, i) => {
    const from = points[i - 1] ?? to;
    const count = Math.max(Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / (2 * half)), 1);
    return Array.from({ length: count }, (_, k) => {
      const share = (k + 1) / count;
      return boxAround({ x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) }, half);
    });
  });
}

/** Names are few; a page that writes new ones every frame must not keep them all. */
const MOST_WIDTHS = 1000;

/** Pixels at which texts are measured. Widths at other sizes are in proportion. */
const MEASURED = 12;

const widths = new Map<string, number>();
let context: CanvasRenderingContext2D | null = null;

/** Measured by a canvas, which costs no layout. CSS pixels. */
export const textWidth = (text: string, fontSize: number): number => (measured(text) * fontSize) / MEASURED;

function measured(text: string): number {
  const known = widths.get(text);
  if (known !== undefined) return known;
  if (widths.size >= MOST_WIDTHS) widths.clear();
  context ??= document.createElement('canvas').getContext('2d');
  if (context !== null) context.font = labelFont(`${String(MEASURED)}px`);
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
