// What can be drawn over a picture: a list of strokes, discs and labels in CSS pixels, which SVG
// shows on the page and a canvas in a file. Their colours can be seen on any picture: a light core
// with a black outline. One of the two always has a contrast of 3:1 with what lies behind (WCAG
// 2.2, success criterion 1.4.11). Channels from 0 to 1.
import { srgbDecode } from '../../../phong/math/color.js';
import { dot, map, type Vec3 } from '../../../phong/math/vector.js';
import type { Point } from './projection.js';

interface Shape {
  readonly color: string;
  /** Width of the core, CSS pixels. */
  readonly width: number;
  readonly dashed?: boolean;
  /** Width of the outline on either side, CSS pixels. Default 1.5. */
  readonly outline?: number;
  /** 0–1, default 1. */
  readonly opacity?: number;
}

export interface Stroke extends Shape {
  readonly kind: 'stroke';
  /** Lines in one colour; they share their dashes and outline. */
  readonly lines: readonly (readonly Point[])[];
  /** Fills the lines as polygons instead of drawing them. */
  readonly filled?: boolean;
}

export interface Disc extends Shape {
  readonly kind: 'disc';
  readonly center: Point;
  /** To the middle of the ring, CSS pixels. */
  readonly radius: number;
  /** Colour inside the ring; null shows the picture there. */
  readonly fill: string | null;
}

export interface Label {
  readonly kind: 'label';
  /** Left end of the baseline. */
  readonly at: Point;
  readonly text: string;
  readonly color: string;
  /** Its part on the page. */
  readonly part?: string | undefined;
  readonly opacity?: number;
}

export type DrawnItem = Stroke | Disc | Label;

export const HALO = '#000';

/** Width of the stroke in {@link HALO} below the core. */
export const haloWidth = ({ width, outline = 1.5 }: Stroke | Disc): number => width + 2 * outline;

/** What the core is filled with and drawn in; null for nothing. */
export function coreOf(shape: Stroke | Disc): {
  readonly fill: string | null;
  readonly stroke: string | null;
} {
  if (shape.kind === 'disc') return { fill: shape.fill, stroke: shape.color };
  return shape.filled === true
    ? { fill: shape.color, stroke: null }
    : { fill: null, stroke: shape.color };
}

/** On and off, CSS pixels. */
export const DASHES = [5, 4] as const;

/**
 * The font of labels. The line's height is what label-layout.ts keeps free. `size`: a length in
 * CSS.
 */
export const labelFont = (size: string): string => `600 ${size} system-ui, sans-serif`;

/** Length and half the width of an arrow's head, CSS pixels. */
const HEAD = { length: 9, half: 4 };

/** As one item; none where there are no lines. */
export const strokes = (
  lines: Stroke['lines'],
  style: Omit<Stroke, 'kind' | 'lines'>,
): readonly Stroke[] => (lines.length > 0 ? [{ kind: 'stroke', lines, ...style }] : []);

/**
 * The outline of an arrow's head, `size` pixels long; none where its line is too short to have a
 * direction.
 */
export function arrowHead(from: Point, tip: Point, size: number = HEAD.length): Stroke['lines'] {
  const length = Math.hypot(tip.x - from.x, tip.y - from.y);
  if (!(length > 1)) return [];
  const [ux, uy] = [(tip.x - from.x) / length, (tip.y - from.y) / length];
  const reach = Math.min(size, length);
  const half = (HEAD.half * reach) / HEAD.length;
  const base = { x: tip.x - reach * ux, y: tip.y - reach * uy };
  return [
    [
      tip,
      { x: base.x - half * uy, y: base.y + half * ux },
      { x: base.x + half * uy, y: base.y - half * ux },
    ],
  ];
}

/** A line with a head at its end. */
export const arrow = (from: Point, tip: Point, style: Shape): readonly Stroke[] => [
  ...strokes([[from, tip]], style),
  ...strokes(arrowHead(from, tip), { ...style, filled: true, dashed: false }),
];

/**
 * Relative luminance of a core. Backgrounds from 0.1 on have 3:1 with the black outline, darker
 * ones with a core of at least 3 · (0.1 + 0.05) − 0.05 = 0.4, and a little for rounding to 8 bits.
 */
const CORE = 0.41;

/** WCAG's weights of the linear channels. */
const LUMINANCE: Vec3 = [0.2126, 0.7152, 0.0722];

export const luminance = (color: Vec3): number => dot(LUMINANCE, map(color, srgbDecode));

/**
 * The colour itself if it is light enough to be a core, else its mixture with as little white as
 * that takes.
 */
export function coreColor(color: Vec3): Vec3 {
  const shown = withinOne(color);
  const whitened = (share: number) => map(shown, (c) => c + (1 - c) * share);
  if (luminance(shown) >= CORE) return shown;
  let [dark, light] = [0, 1];
  // Ten halvings are finer than a code of 8 bits.
  for (let i = 0; i < 10; i++) {
    const middle = (dark + light) / 2;
    if (luminance(whitened(middle)) >= CORE) {
      light = middle;
    } else {
      dark = middle;
    }
  }
  return whitened(light);
}

/** `rgb(…)` of channels from 0 to 1; larger ones keep their ratios. */
export const cssRgb = (color: Vec3): string =>
  `rgb(${map(withinOne(color), (c) => Math.round(255 * c)).join(' ')})`;

function withinOne(color: Vec3): Vec3 {
  const largest = Math.max(...color, 1);
  return map(color, (c) => c / largest);
}
