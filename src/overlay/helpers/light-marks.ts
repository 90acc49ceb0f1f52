// The marks of a light: its place in its own colour, the direction in which it shines, its cone, and where it has
// halved. From placed lights to a display list, with the places of the handles. CSS pixels of the layer.
import type { LightValues } from '../../light/light-state.js';
import { add, scale, type Vec3 } from '../../math/vector.js';
import {
  arrow,
  arrowHead,
  coreColor,
  cssRgb,
  type Disc,
  type DrawnItem,
  type Stroke,
} from '../drawing/display-list.js';
import { inside, type Point, type Projection } from '../drawing/projection.js';
import { coneOf, placedLight, type PlacedLight, type SceneBall } from './placed-light.js';

/** The part of a light that a handle moves. */
export type HandlePart = 'place' | 'axis' | 'aperture';

export interface Handle {
  readonly part: HandlePart;
  /** Where it is drawn: inside the layer. */
  readonly at: Point;
  /** Where it is in the scene. */
  readonly place: Vec3;
  /** It is drawn elsewhere than where it is, because that is outside the layer or behind the eye. */
  readonly outside: boolean;
}

export interface LightMarks {
  readonly placed: PlacedLight;
  readonly list: readonly DrawnItem[];
  readonly handles: readonly Handle[];
}

/** Pixels from the layer's edge to the handle of a light outside. */
export const EDGE = 14;

/** Radii in CSS pixels. */
const RADIUS = { place: 7, outside: 5, part: 4 } as const;

/** Points of a circle around a light; enough for a smooth one that fills the picture. */
const SEGMENTS = 48;

/** A light that is off. */
const DIMMED = 0.55;

/** Colours of 255 are full. */
const FULL = 255;

/**
 * `hidden`: a shape is in front of it. `surface`: distance along a spot's axis to the first surface; Infinity for none.
 */
export function lightMarks(
  values: Readonly<LightValues>,
  view: Projection,
  scene: SceneBall,
  hidden: boolean,
  surface: number,
): LightMarks {
  const placed = placedLight(values, view, scene, surface);
  const { place, spot, shines, halfDistance } = placed;
  const own = scale(values.diffuse, 1 / FULL);
  const look = {
    color: cssRgb(coreColor(own)),
    dashed: hidden,
    opacity: values.active ? 1 : DIMMED,
  };
  const list: DrawnItem[] = [];
  const handles: Handle[] = [];
  const stroke = (lines: Stroke['lines'], width: number, dashed = hidden): void => {
    if (lines.length > 0) list.push({ ...look, kind: 'stroke', lines, width, dashed });
  };
  const arrowTo = (tip: Vec3): void => {
    const ends = view.segment(place, tip);
    if (ends !== null) list.push(...arrow(...ends, { ...look, width: 2 }));
  };
  if (halfDistance !== null) stroke(view.line(facingCircle(place, halfDistance, view)), 1, true);
  if (shines !== null) arrowTo(add(place, scale(shines, ARROW * scene.radius)));
  if (spot !== null) {
    const { aperture, halfAngle, reach } = spot;
    const onCone = coneOf(place, spot, view);
    const rim = (degrees: number): Stroke['lines'] => view.line(circle((around) => onCone(reach, degrees, around)));
    if (halfAngle !== null && halfAngle < aperture) stroke(rim(halfAngle), 1, true);
    const sides = [0, Math.PI].flatMap((around) => view.line([place, onCone(reach, aperture, around)]));
    if (aperture < 180) stroke([...sides, ...rim(aperture)], 1.5);
    const tip = add(place, scale(spot.axis, spot.arrow));
    handles.push(handleAt('axis', tip, view));
    if (aperture < 180) handles.push(handleAt('aperture', onCone(spot.grip, aperture), view));
    for (const { at, outside } of handles) if (!outside) list.push(disc(at, RADIUS.part, '#fff', look));
    // Over its handle, which would hide the head.
    arrowTo(tip);
  }
  const handle = handleAt('place', place, view);
  handles.unshift(handle);
  const fill = values.active ? cssRgb(own) : null;
  if (handle.outside) list.push(...pointerTo(handle.at, view, look));
  list.push(disc(handle.at, handle.outside ? RADIUS.outside : RADIUS.place, fill, look));
  return { placed, list, handles };
}

/** Length of a directional light's arrow, in radii of the scene: it ends before the scene begins. */
const ARROW = 0.35;

type Look = Pick<Disc, 'color' | 'dashed' | 'opacity'>;

const disc = (center: Point, radius: number, fill: string | null, look: Look): Disc => ({
  ...{ kind: 'disc', center, radius, fill, width: 2 },
  ...look,
});

/** A circle that faces the eye: the outline of a sphere without perspective. */
function facingCircle(center: Vec3, radius: number, { basis }: Projection): Vec3[] {
  const { right, up } = basis;
  return circle((t) => add(center, add(scale(right, radius * Math.cos(t)), scale(up, radius * Math.sin(t)))));
}

const circle = (at: (around: number) => Vec3): Vec3[] =>
  Array.from({ length: SEGMENTS + 1 }, (_, i) => at((2 * Math.PI * (i % SEGMENTS)) / SEGMENTS));

function handleAt(part: HandlePart, place: Vec3, view: Projection): Handle {
  const point = view.point(place);
  const shown = point === null ? null : inside(point, view, EDGE);
  if (point !== null && shown !== null && shown.x === point.x && shown.y === point.y)
    return { part, at: point, place, outside: false };
  return { part, at: onEdge(place, view), place, outside: true };
}

/**
 * Where the line from the picture's middle toward the place crosses the edge. Behind the eye: to the side on which the
 * place is.
 */
function onEdge(place: Vec3, view: Projection): Point {
  const { width, height } = view;
  const point = view.point(place);
  const [x, y] = view.toCamera(place);
  const [dx, dy] = point === null ? [x, -y] : [point.x - width / 2, point.y - height / 2];
  const [roomX, roomY] = [Math.max(width / 2 - EDGE, 0), Math.max(height / 2 - EDGE, 0)];
  const share = Math.min(roomX / Math.abs(dx), roomY / Math.abs(dy));
  // Exactly behind the eye there is no direction: below.
  if (!Number.isFinite(share)) return { x: width / 2, y: height / 2 + roomY };
  return { x: width / 2 + share * dx, y: height / 2 + share * dy };
}

/** A small arrow head outside the disc, away from the picture's middle. */
function pointerTo(at: Point, { width, height }: Projection, look: Look): DrawnItem[] {
  const [dx, dy] = [at.x - width / 2, at.y - height / 2];
  const length = Math.hypot(dx, dy);
  if (length === 0) return [];
  const tip = { x: at.x + (POINTER * dx) / length, y: at.y + (POINTER * dy) / length };
  const head = arrowHead(at, tip);
  return head === null ? [] : [{ ...look, kind: 'stroke', lines: [head], filled: true, width: 1, dashed: false }];
}

/** From the disc's centre to the tip, CSS pixels; less than {@link EDGE}. */
const POINTER = 12;
