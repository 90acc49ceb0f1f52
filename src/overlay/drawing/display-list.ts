// What can be drawn over a picture: a list of strokes, discs and labels in CSS pixels, which SVG shows on the page and
// a canvas in a file. Every core has a black outline (contrast.ts).
import type { Point } from './projection.js';

export interface Stroke {
  readonly kind: 'stroke';
  /** Lines in one colour; they share their dashes and outline. */
  readonly lines: readonly (readonly Point[])[];
  readonly color: string;
  /** Width of the core, CSS pixels. */
  readonly width: number;
  readonly dashed?: boolean;
  /** Fills the lines as polygons instead of drawing them. */
  readonly filled?: boolean;
  /** Width of the outline on either side, CSS pixels. Default 1.5. */
  readonly outline?: number;
  /** 0–1, default 1. */
  readonly opacity?: number;
}

export interface Disc {
  readonly kind: 'disc';
  readonly center: Point;
  /** To the middle of the ring, CSS pixels. */
  readonly radius: number;
  /** Colour inside the ring; null shows the picture there. */
  readonly fill: string | null;
  readonly color: string;
  readonly width: number;
  readonly dashed?: boolean;
  readonly opacity?: number;
}

export interface Label {
  readonly kind: 'label';
  /** Left end of the baseline. */
  readonly at: Point;
  readonly text: string;
  readonly color: string;
  /** Its part on the page. */
  readonly part?: string;
  readonly opacity?: number;
}

export type DrawnItem = Stroke | Disc | Label;

/** The outline on either side of a core, CSS pixels. */
const OUTLINE = 1.5;

export const outlineOf = (shape: Stroke | Disc): number =>
  shape.kind === 'stroke' ? (shape.outline ?? OUTLINE) : OUTLINE;

/** On and off, CSS pixels. */
export const DASHES = [5, 4] as const;

/** The font of labels. The line's height is what `placeLabels` keeps free. `size`: a length in CSS. */
export const labelFont = (size: string): string => `600 ${size} system-ui, sans-serif`;

/** Length and half the width of an arrow's head, CSS pixels. */
const HEAD = { length: 9, half: 4 };

/**
 * The head of an arrow whose line ends at `tip`, `size` pixels long; null where the line is too short to have a
 * direction.
 */
export function arrowHead(from: Point, tip: Point, size: number = HEAD.length): readonly Point[] | null {
  const length = Math.hypot(tip.x - from.x, tip.y - from.y);
  if (!(length > 1)) return null;
  const [ux, uy] = [(tip.x - from.x) / length, (tip.y - from.y) / length];
  const reach = Math.min(size, length);
  const half = (HEAD.half * reach) / HEAD.length;
  const base = { x: tip.x - reach * ux, y: tip.y - reach * uy };
  return [tip, { x: base.x - half * uy, y: base.y + half * ux }, { x: base.x + half * uy, y: base.y - half * ux }];
}

/** A line through `points` with a head at its end. */
export function arrow(
  points: readonly Point[],
  look: Pick<Stroke, 'color' | 'width' | 'dashed' | 'opacity'>,
): DrawnItem[] {
  const [from, tip] = [points.at(-2), points.at(-1)];
  const head = from === undefined || tip === undefined ? null : arrowHead(from, tip);
  const line: Stroke = { kind: 'stroke', lines: [points], ...look };
  return head === null ? [line] : [line, { ...look, kind: 'stroke', lines: [head], filled: true, dashed: false }];
}
