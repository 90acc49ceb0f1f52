// The marks of a light: its place in its own colour, the direction in which it shines, its cone,
// and where it has halved. From its values to places in world space, and to a display list in CSS
// pixels with the handles.
import { isSpot } from '../../../phong/light/light-features.js';
import type { LightValues } from '../../../phong/light/light-state.js';
import { radians } from '../../../phong/math/angle.js';
import {
  add,
  cross,
  dot,
  length,
  normalize,
  perpendicular,
  scale,
  subtract,
  type Vec3,
} from '../../../phong/math/vector.js';
import { arrow, arrowHead, coreColor, cssRgb, strokes } from '../drawing/display-list.js';
import type { Disc, DrawnItem, Stroke } from '../drawing/display-list.js';
import { isInside, type Point, type Projection } from '../drawing/projection.js';

/** A sphere that contains the scene; its radius is above 0. */
export interface SceneBall {
  readonly center: Vec3;
  readonly radius: number;
}

export interface PlacedLight {
  /**
   * A directional light is placed in its direction, at {@link DIRECTIONAL_AT} radii from the
   * scene's centre.
   */
  readonly place: Vec3;
  /** A spot's cone; null for other lights. */
  readonly spot: PlacedSpot | null;
}

interface PlacedSpot {
  /** Unit vector. */
  readonly axis: Vec3;
  /** Length of the axis's arrow. */
  readonly arrow: number;
  /** Distance along the axis of the circle that ends the cone: at the first surface. */
  readonly reach: number;
  /** As far as {@link reach}, and far enough from the light for a handle. */
  readonly grip: number;
  /**
   * The place at `degrees` from the axis, on the circle across it at `reach`; nearer to the light
   * where that circle would be too wide, as it is from 90 degrees on. By 0 and π `around` the axis
   * is the outline as the eye sees it.
   */
  readonly onCone: (reach: number, degrees: number, around?: number) => Vec3;
}

/** The part of a light that a handle moves. */
export type HandlePart = 'place' | 'axis' | 'aperture';

export interface Handle {
  readonly part: HandlePart;
  /** Where it is drawn: inside the layer. */
  readonly at: Point;
  /** Where it is in the scene. */
  readonly place: Vec3;
  /**
   * It is drawn elsewhere than where it is, because that is outside the layer or behind the eye.
   */
  readonly outside: boolean;
}

export interface LightMarks {
  readonly placed: PlacedLight;
  readonly list: readonly DrawnItem[];
  readonly handles: readonly Handle[];
}

/** Distance of a directional light's helper from the scene's centre, in radii of the scene. */
export const DIRECTIONAL_AT = 1.2;

/** Length of a directional light's arrow, in radii of the scene. */
const ARROW = 0.35;

/**
 * Longest arrow of a spot's axis, and least distance of handles from the light, in radii of the
 * scene: both can be gripped in a scene of any size, at any surface.
 */
const LONGEST_ARROW = 0.6;
const LEAST_GRIP = 0.25;

/**
 * In radii of the scene: circles of wider cones are nearer to the light, so that they stay in the
 * picture.
 */
const WIDEST = 2;

/** Pixels from the layer's edge to the handle of a light outside. */
export const EDGE = 14;

/**
 * From the disc of a light outside to the tip that points at it, CSS pixels; less than {@link
 * EDGE}.
 */
const POINTER = 12;

/** Radii in CSS pixels. */
const RADIUS = { place: 7, outside: 5, part: 4 } as const;

/** Points of a circle that fills the picture and is smooth. */
const SEGMENTS = 48;

/** Opacity of a light that is off. */
const DIMMED = 0.55;

/**
 * `hidden`: a shape is in front of it. `surface`: distance along a spot's axis to the first
 * surface; Infinity if there is none, or while that is not known.
 */
export function lightMarks(
  values: Readonly<LightValues>,
  view: Projection,
  scene: SceneBall,
  hidden: boolean,
  surface: number,
): LightMarks {
  const placed = placedLight(values, view, scene, surface);
  const { place, spot } = placed;
  const own = scale(values.diffuse, 1 / 255);
  const style = {
    color: cssRgb(coreColor(own)),
    dashed: hidden,
    opacity: values.active ? 1 : DIMMED,
  };
  const list: DrawnItem[] = [];
  const handles: Handle[] = [];
  const stroke = (lines: Stroke['lines'], width: number, dashed = hidden): unknown =>
    list.push(...strokes(lines, { ...style, width, dashed }));
  const arrowTo = (tip: Vec3): void => {
    const ends = view.segment(place, tip);
    if (ends !== null) {
      list.push(...arrow(...ends, { ...style, width: 2 }));
    }
  };
  if (isDirectional(values)) {
    // Without a direction its place is the centre.
    arrowTo(add(place, scale(subtract(scene.center, place), ARROW / DIRECTIONAL_AT)));
  } else {
    const distance = halfDistance(values.attenuation);
    if (distance !== null) {
      stroke(view.line(facingCircle(place, distance, view)), 1, true);
    }
  }
  if (spot !== null) {
    const { aperture } = values;
    const { onCone, reach, grip, axis } = spot;
    const rim = (degrees: number): Stroke['lines'] =>
      view.line(circle((around) => onCone(reach, degrees, around)));
    const half = halfAngle(values.cutoff);
    if (half !== null && half < aperture) {
      stroke(rim(half), 1, true);
    }
    const sides = [0, Math.PI].flatMap((around) =>
      view.line([place, onCone(reach, aperture, around)]),
    );
    if (aperture < 180) {
      stroke([...sides, ...rim(aperture)], 1.5);
    }
    const tip = add(place, scale(axis, spot.arrow));
    handles.push(handleAt('axis', tip, view));
    if (aperture < 180) {
      handles.push(handleAt('aperture', onCone(grip, aperture), view));
    }
    for (const { at, outside } of handles) {
      if (!outside) {
        list.push(disc(at, RADIUS.part, '#fff', style));
      }
    }
    // Over its handle, which would hide the head.
    arrowTo(tip);
  }
  const handle = handleAt('place', place, view);
  handles.unshift(handle);
  const fill = values.active ? cssRgb(own) : null;
  if (handle.outside) {
    list.push(...pointerTo(handle.at, view, style));
  }
  list.push(disc(handle.at, handle.outside ? RADIUS.outside : RADIUS.place, fill, style));
  return { placed, list, handles };
}

export const isDirectional = ({ position }: Readonly<LightValues>): boolean => position[3] === 0;

export function placedLight(
  values: Readonly<LightValues>,
  view: Projection,
  scene: SceneBall,
  surface = Infinity,
): PlacedLight {
  const [x, y, z] = values.position;
  const inCamera = values.space === 'camera';
  const turned = (v: Vec3) => (inCamera ? view.turnToWorld(v) : v);
  const given: Vec3 = inCamera ? view.toWorld([x, y, z]) : [x, y, z];
  const place = isDirectional(values)
    ? add(scene.center, scale(normalize(turned([x, y, z])), DIRECTIONAL_AT * scene.radius))
    : given;
  if (!isSpot(values)) return { place, spot: null };
  const axis = normalize(turned(values.axis));
  const least = LEAST_GRIP * scene.radius;
  const reach = Number.isFinite(surface) ? surface : Math.max(reachOf(place, axis, scene), least);
  const grip = Math.max(reach, least);
  const longest = LONGEST_ARROW * scene.radius;
  return {
    place,
    spot: {
      axis,
      arrow: Math.min(grip, longest),
      reach,
      grip,
      onCone: coneOf(place, axis, WIDEST * scene.radius, view),
    },
  };
}

/**
 * Distance along the axis to where it leaves the scene's ball. Beside it, the distance to its
 * centre.
 */
function reachOf(place: Vec3, axis: Vec3, { center, radius }: SceneBall): number {
  const toCenter = subtract(center, place);
  const along = dot(toCenter, axis);
  const aside = Math.hypot(...subtract(toCenter, scale(axis, along)));
  const half = Math.sqrt(Math.max(radius * radius - aside * aside, 0));
  if (aside < radius && along + half > 0) return along + half;
  return Math.hypot(along, aside);
}

/** `widest`: radius of the largest circle. */
function coneOf(place: Vec3, axis: Vec3, widest: number, view: Projection): PlacedSpot['onCone'] {
  const sightline = subtract(view.eye, place);
  const facing = cross(axis, sightline);
  // Along the axis the outline is a circle, and any direction will do.
  const across =
    length(facing) > 1e-6 * length(sightline) ? normalize(facing) : perpendicular(axis);
  const aside = cross(axis, across);
  return (reach, degrees, around = 0) => {
    const angle = radians(degrees);
    const distance =
      degrees < 90 ? Math.min(reach / Math.cos(angle), widest / Math.sin(angle)) : widest;
    const side = add(scale(across, Math.cos(around)), scale(aside, Math.sin(around)));
    return add(
      place,
      scale(add(scale(axis, Math.cos(angle)), scale(side, Math.sin(angle))), distance),
    );
  };
}

/** Where kc + kl·d + kq·d² = 2; null where attenuation is constant or 1/2 at the light already. */
function halfDistance([kc, kl, kq]: Vec3): number | null {
  if (kc >= 2 || (kl === 0 && kq === 0)) return null;
  const missing = 2 - kc;
  // The form without cancellation, which holds for kq = 0 too.
  return (2 * missing) / (kl + Math.sqrt(kl * kl + 4 * kq * missing));
}

/** Where ((c + 1) / 2)^cutoff = 1/2, in degrees; null where that is nowhere. */
function halfAngle(cutoff: number): number | null {
  const cosine = 2 * 0.5 ** (1 / cutoff) - 1;
  return cutoff > 0 && cosine > -1 ? (Math.acos(cosine) * 180) / Math.PI : null;
}

type ShapeStyle = Pick<Disc, 'color' | 'dashed' | 'opacity'>;

const disc = (center: Point, radius: number, fill: string | null, style: ShapeStyle): Disc => ({
  kind: 'disc',
  center,
  radius,
  fill,
  width: 2,
  ...style,
});

/** A circle that faces the eye: the outline of a sphere without perspective. */
function facingCircle(center: Vec3, radius: number, { basis }: Projection): Vec3[] {
  const { right, up } = basis;
  return circle((t) =>
    add(center, add(scale(right, radius * Math.cos(t)), scale(up, radius * Math.sin(t)))),
  );
}

const circle = (at: (around: number) => Vec3): Vec3[] =>
  Array.from({ length: SEGMENTS + 1 }, (_, i) => at((2 * Math.PI * (i % SEGMENTS)) / SEGMENTS));

function handleAt(part: HandlePart, place: Vec3, view: Projection): Handle {
  const point = view.point(place);
  const outside = point === null || !isInside(point, view, EDGE);
  return { part, at: outside ? onEdge(place, view) : point, place, outside };
}

/**
 * Where the line from the picture's middle toward the place crosses the edge. Behind the eye: to
 * the place's side.
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
function pointerTo(
  at: Point,
  { width, height }: Projection,
  style: ShapeStyle,
): readonly DrawnItem[] {
  const [dx, dy] = [at.x - width / 2, at.y - height / 2];
  const share = POINTER / Math.hypot(dx, dy);
  const head = arrowHead(at, { x: at.x + share * dx, y: at.y + share * dy });
  return strokes(head, { ...style, filled: true, width: 1, dashed: false });
}
