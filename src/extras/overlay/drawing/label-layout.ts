// Places names one after the other so that none covers another and all stay inside. CSS pixels of
// the layer.
import { type DrawnItem, type Label, labelFont } from './display-list.js';
import type { Point } from './projection.js';

export interface Name {
  readonly text: string;
  /** What the name belongs to. */
  readonly center: Point;
  /** Pixels around the centre that the name keeps free. */
  readonly gap: number;
  readonly color?: string;
  /** Its part on the page. */
  readonly part?: string;
  readonly opacity?: number;
}

/** What some helpers, or the probe, draw. */
export interface Drawing {
  readonly list: readonly DrawnItem[];
  readonly names: readonly Name[];
  /** What names do not cover if they can go elsewhere. */
  readonly covered: readonly Rect[];
}

export const NO_DRAWING: Drawing = { list: [], names: [], covered: [] };

export interface Rect {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/**
 * One list of several drawings, the first ones lowest, with their names on top, and what these
 * cover. Names stay inside `room` and avoid each other, `boxes` and, if they can, what is covered;
 * those without a place are left out.
 */
export function listOf(
  drawings: readonly Drawing[],
  room: Rect,
  fontSize: number,
  boxes: readonly Rect[] = [],
): { readonly list: readonly DrawnItem[]; readonly placed: readonly Rect[] } {
  const covered = drawings.flatMap((each) => each.covered);
  const taken = [...boxes];
  const placed: Rect[] = [];
  const labels: Label[] = [];
  for (const name of [...drawings].reverse().flatMap(({ names }) => names)) {
    const text = shortened(name.text);
    const box = bestBox(name, textWidth(text, fontSize), room, taken, covered, fontSize);
    if (box === null) continue;
    taken.push(box);
    placed.push(box);
    const { color = '#fff', opacity = 1, part } = name;
    const at = { x: box.left, y: box.bottom - LINE.descent * fontSize };
    labels.push({ kind: 'label', at, text, color, opacity, part });
  }
  return { list: [...drawings.flatMap(({ list }) => list), ...labels], placed };
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

/**
 * Font sizes by which a label moves away from its centre if something is in its way, in the order
 * tried.
 */
const FARTHER = [0, 0.7];

/** The first place of those that cover least of `avoided`; null where there is none. */
function bestBox(
  name: Name,
  width: number,
  room: Rect,
  taken: readonly Rect[],
  avoided: readonly Rect[],
  fontSize: number,
): Rect | null {
  let [best, least]: [Rect | null, number] = [null, Infinity];
  const height = LINE.height * fontSize;
  for (const by of FARTHER) {
    for (const [across, down] of SIDES) {
      const gap = name.gap + by * fontSize;
      const left = name.center.x + across * gap - ((1 - across) / 2) * width;
      const top = name.center.y + down * gap - ((1 - down) / 2) * height;
      const box = { left, top, right: left + width, bottom: top + height };
      if (!isInside(box, room) || overlap(box, taken) > 0) continue;
      const covered = overlap(box, avoided);
      if (covered === 0) return box;
      if (covered < least) {
        [best, least] = [box, covered];
      }
    }
  }
  return best;
}

const isInside = ({ left, top, right, bottom }: Rect, room: Rect): boolean =>
  left >= room.left + MARGIN &&
  top >= room.top &&
  right <= room.right - MARGIN &&
  bottom <= room.bottom;

/** Square pixels that a box shares with others. */
function overlap(box: Rect, others: readonly Rect[]): number {
  let sum = 0;
  for (const other of others) {
    const width = Math.min(box.right, other.right) - Math.max(box.left, other.left);
    const height = Math.min(box.bottom, other.bottom) - Math.max(box.top, other.top);
    if (width > 0 && height > 0) {
      sum += width * height;
    }
  }
  return sum;
}

export const boxAround = ({ x, y }: Point, half: number): Rect => ({
  left: x - half,
  top: y - half,
  right: x + half,
  bottom: y + half,
});

/** Squares along a line, so close that no label fits between them. */
export function boxesAlong(points: readonly Point[], half: number): Rect[] {
  return points.flatMap((to, i) => {
    const from = points[i - 1] ?? to;
    const count = Math.max(Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / (2 * half)), 1);
    return Array.from({ length: count }, (_, k) => {
      const share = (k + 1) / count;
      return boxAround(
        { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) },
        half,
      );
    });
  });
}

let context: CanvasRenderingContext2D | null = null;

/** Measured by a canvas, which costs no layout. CSS pixels. */
function textWidth(text: string, fontSize: number): number {
  context ??= document.createElement('canvas').getContext('2d');
  // Without a canvas: 0.6 em a letter is wider than most text.
  if (context === null) return 0.6 * fontSize * text.length;
  context.font = labelFont(`${String(fontSize)}px`);
  return context.measureText(text).width;
}

/** Characters of the longest name. */
const LONGEST = 24;

/** The first characters of a text, with an ellipsis in place of the rest. */
function shortened(text: string): string {
  const characters = Array.from(text);
  return characters.length <= LONGEST ? text : `${characters.slice(0, LONGEST - 1).join('')}…`;
}
