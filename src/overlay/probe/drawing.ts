// Turns a fragment's figure into lines over the picture: arrows, arcs and labels in CSS pixels of the layer, as a
// display list.
import { type Vec3, add, scale } from '../../math/vector.js';
import type { PlacedName } from '../../element/viewer/extra.js';
import { coreColor, cssRgb } from '../drawing/contrast.js';
import { arrow, type DrawnItem } from '../drawing/display-list.js';
import {
  type Rect,
  boxAround,
  boxesAlong,
  type LabelWish,
  placeLabels,
  shortened,
  textWidth,
} from '../drawing/label-layout.js';
import type { Point, Projection } from '../drawing/projection.js';
import type { Figure } from './figure.js';

const WHITE: Vec3 = [1, 1, 1];

/** Length of a vector across the line of sight: a share of the layer's smaller side, within limits in CSS pixels. */
const ARROW = { share: 0.24, least: 22, most: 110 };

/** Radius of the mark, CSS pixels. Shorter arrows point at the eye or away from it and have no line. */
const MARK = 6;

/** Half the width that labels keep clear of an arrow, CSS pixels. */
const LINE_HALF = 3;

/** Distance from an arrow's tip to its light's name, in font sizes. */
const BESIDE = 6;

/** Layers smaller than this have room for arrows but not for their names. CSS pixels. */
const NAMED = { width: 140, height: 110 };

interface Labelled {
  readonly text: string;
  readonly color: string;
  readonly wish: LabelWish;
}

/** The mark alone. `dashed`: hidden, or on no surface. */
export const markOf = (at: Point, dashed: boolean): DrawnItem[] => [
  { kind: 'disc', center: at, radius: MARK, fill: null, color: '#fff', width: 2, dashed },
];

export interface Surroundings {
  /** A triangle around the point, if any. */
  readonly outline: readonly Vec3[];
  /** Labels stay inside. */
  readonly room: Rect;
  /** By the box, and by the names of lights and axes. */
  readonly boxes: readonly Rect[];
  readonly names: readonly PlacedName[];
  readonly fontSize: number;
}

/** `p` is the point in world space, `at` its place on the layer. */
export function drawingOf(
  projection: Projection,
  p: Vec3,
  at: Point,
  { vectors, arcs }: Figure,
  { outline, room, boxes, names, fontSize }: Surroundings,
): DrawnItem[] {
  const unit = arrowLength(projection) / projection.pixelsPerUnit(projection.depthOf(p));
  const placeOf = (vector: Vec3): Point | null => projection.point(add(p, scale(vector, unit)));
  const list: DrawnItem[] = [];
  const label = labelsOf(fontSize);
  const labels: Labelled[] = [label('V', at, MARK + 4)];
  const avoided = [boxAround(at, MARK)];
  if (outline.length > 0)
    list.push({
      kind: 'stroke',
      lines: projection.line([...outline, outline[0]!]),
      color: '#fff',
      width: 1,
      dashed: true,
    });
  for (const { points, label: text } of arcs) {
    const line = points.map(placeOf).filter((point) => point !== null);
    if (line.length < 2) continue;
    list.push({ kind: 'stroke', lines: [line], color: '#fff', width: 1.5 });
    avoided.push(...boxesAlong(line, 1));
    labels.push(label(text, line[Math.floor(line.length / 2)]!, 8));
  }
  for (const { name, of, direction, color, dashed } of vectors) {
    const tip = placeOf(direction);
    if (tip === null) continue;
    const css = cssRgb(coreColor(color ?? WHITE));
    avoided.push(...boxesAlong([at, tip], LINE_HALF));
    if (Math.hypot(tip.x - at.x, tip.y - at.y) > MARK)
      list.push(...arrow([at, tip], { color: css, width: 2.5, dashed }));
    const isNamed = names.some((each) => each.text === shortened(of ?? '') && isBeside(tip, each, fontSize));
    labels.push(label(isNamed ? 'L' : shortened(name), tip, 7, css));
  }
  list.push(...markOf(at, false), dot(at));
  if (projection.width < NAMED.width || projection.height < NAMED.height) return list;
  // The names of vectors come before those of angles.
  labels.sort((a, b) => Number(a.text.endsWith('°')) - Number(b.text.endsWith('°')));
  const places = placeLabels(
    labels.map(({ wish }) => wish),
    room,
    avoided,
    fontSize,
    [...boxes, ...names],
  );
  labels.forEach(({ text, color }, i) => {
    const place = places[i];
    if (place) list.push({ kind: 'label', at: place, text, color });
  });
  return list;
}

/** An arrow's name here would be read together with the other one. */
const isBeside = ({ x, y }: Point, { left, right, top, bottom }: Rect, fontSize: number): boolean =>
  Math.hypot(Math.max(left - x, x - right, 0), Math.max(top - y, y - bottom, 0)) < BESIDE * fontSize;

/** The tip of V, which points at the eye. */
const dot = (center: Point): DrawnItem => ({
  kind: 'disc',
  center,
  radius: 1,
  fill: '#fff',
  color: '#fff',
  width: 1,
});

const labelsOf =
  (fontSize: number) =>
  (text: string, center: Point, gap: number, color = '#fff'): Labelled => ({
    text,
    color,
    wish: { center, gap, width: textWidth(text, fontSize) },
  });

const arrowLength = ({ width, height }: Projection): number =>
  Math.min(Math.max(ARROW.share * Math.min(width, height), ARROW.least), ARROW.most);
