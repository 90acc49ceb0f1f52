// Changes a light by moving one of its handles. From the values at the start of the move and the whole travel since
// then, so that nothing accumulates and going back restores. Travel in CSS pixels of the layer, right and down.
import { LIMITS, type LightValues } from '../../light/light-state.js';
import { radians } from '../../math/angle.js';
import { add, cross, dot, length, map, normalize, scale, subtract, type Vec3 } from '../../math/vector.js';
import type { Point, Projection, Ray } from '../drawing/projection.js';
import type { Handle, HandlePart } from './light-marks.js';
import { coneOf, DIRECTIONAL_AT, type PlacedLight, type SceneBall } from './placed-light.js';

/** The start of a move. */
export interface Anchor {
  readonly part: HandlePart;
  readonly values: Readonly<LightValues>;
  readonly placed: PlacedLight;
  readonly handle: Handle;
  /** Where the depth and the side of the handle were measured. */
  readonly view: Projection;
  readonly scene: SceneBall;
}

export interface HandleMove {
  readonly dx: number;
  readonly dy: number;
  /** Toward the eye and away from it, by `dy`, instead of in the plane of the view. */
  readonly along: boolean;
  /** By keys: the handle starts where it is rather than where it is drawn. */
  readonly byKeys: boolean;
}

export type Change = Partial<Pick<LightValues, 'position' | 'axis' | 'aperture'>>;

/** The light's values after the move. No change where the travel would give no finite value. */
export function moved(anchor: Anchor, view: Projection, travel: HandleMove): Change {
  const { part, values, placed, scene } = anchor;
  const inCamera = values.space === 'camera';
  const turned = (v: Vec3): Vec3 => (inCamera ? view.turnToCamera(v) : v);
  if (part === 'aperture') return { aperture: apertureAfter(anchor, view, travel) };
  if (part === 'axis') {
    const ball = { center: placed.place, radius: placed.spot?.arrow ?? 1 };
    const axis = scale(turned(directionAfter(anchor, ball, view, travel)), length(values.axis));
    return isUsable(axis) ? { axis } : {};
  }
  const [x, y, z] = values.position;
  if (placed.directional) {
    const ball = { center: scene.center, radius: DIRECTIONAL_AT * scene.radius };
    // Without a direction it has no length that it could keep.
    const vector = scale(turned(directionAfter(anchor, ball, view, travel)), length([x, y, z]) || 1);
    return isUsable(vector) ? { position: [...vector, 0] } : {};
  }
  const place = placeAfter(anchor, view, travel);
  const position = map(inCamera ? view.toCamera(place) : place, (v) => rounded(v, scene.radius));
  return isUsable(position) ? { position: [...position, 1] } : {};
}

const isUsable = (v: Vec3): boolean => v.every((x) => Math.abs(x) <= LIMITS.coordinate);

/** To a ten-thousandth of the scene's size: markup stays short, and no step can be seen. */
function rounded(value: number, radius: number): number {
  const step = 10 ** (Math.floor(Math.log10(radius)) - 4);
  // By division where the step is below 1: it has no exact binary form, its inverse has.
  return (
    (step < 1 ? Math.round(value * Math.round(1 / step)) / Math.round(1 / step) : Math.round(value / step) * step) + 0
  );
}

/** Pixels along the view that change the distance by a factor of e. */
const ALONG_PIXELS = 150;

/** Nearest and farthest distance from the eye that a move along the view reaches, in radii of the scene. */
const DISTANCES = { least: 1e-3, most: 1e3 } as const;

/** Share of the orbit's radius at which a pixel's worth is measured for places beside or behind the eye. */
const LEAST_DEPTH = 0.1;

function placeAfter({ placed, handle, scene, view: start }: Anchor, view: Projection, travel: HandleMove): Vec3 {
  const { dx, dy } = travel;
  const { place } = placed;
  const depth = start.depthOf(place);
  const isAhead = start.point(place) !== null;
  const { right, up, back } = view.basis;
  const perPixel = 1 / view.pixelsPerUnit(Math.max(Math.abs(depth), LEAST_DEPTH * view.pose.radius));
  if (travel.along) {
    if (!isAhead) return add(place, scale(back, dy * perPixel));
    const sightline = subtract(place, view.eye);
    const distance = length(sightline);
    const [least, most] = [DISTANCES.least * scene.radius, DISTANCES.most * scene.radius];
    const wanted = distance * Math.exp(-dy / ALONG_PIXELS);
    const reached = Math.min(Math.max(wanted, Math.min(least, distance)), Math.max(most, distance));
    return add(view.eye, scale(sightline, reached / distance));
  }
  if (isAhead && !travel.byKeys) return view.placeAt({ x: handle.at.x + dx, y: handle.at.y + dy }, depth);
  return add(place, add(scale(right, dx * perPixel), scale(up, -dy * perPixel)));
}

/** Unit vector in world space, from the ball's centre to the handle, which stays on the ball. */
function directionAfter(anchor: Anchor, ball: SceneBall, view: Projection, travel: HandleMove): Vec3 {
  const { handle, view: start } = anchor;
  const offset = subtract(handle.place, ball.center);
  const from = length(offset) > 0 ? normalize(offset) : start.basis.back;
  const isOutside = length(subtract(view.eye, ball.center)) > ball.radius;
  const nearSide = isNearSide(handle.place, ball, start);
  if (!travel.along && !travel.byKeys && isOutside && start.point(handle.place) !== null) {
    const to = { x: handle.at.x + travel.dx, y: handle.at.y + travel.dy };
    return onBall(view.ray(to), ball, nearSide);
  }
  // One height of the picture is half a turn.
  const perPixel = Math.PI / view.height;
  const { right, up, back } = view.basis;
  if (travel.along) {
    const across = cross(from, back);
    const hinge = length(across) > 1e-9 ? normalize(across) : right;
    return rotated(from, hinge, travel.dy * perPixel);
  }
  const side = nearSide ? 1 : -1;
  const spin = add(scale(up, travel.dx * side), scale(right, travel.dy * side));
  return length(spin) > 0 ? rotated(from, normalize(spin), length(spin) * perPixel) : from;
}

/** Nearer to the eye than the ball's outline. */
function isNearSide(place: Vec3, { center }: SceneBall, { eye }: Projection): boolean {
  const sightline = normalize(subtract(place, eye));
  return length(subtract(place, eye)) <= dot(subtract(center, eye), sightline);
}

/**
 * Where a ray from outside meets a ball, on the near or far side, as a unit vector from its centre. A ray that misses
 * the ball goes on around it: from the outline, which it touches at one radius from the centre, to the middle of the
 * other side at two radii.
 */
function onBall({ origin, direction }: Ray, { center, radius }: SceneBall, nearSide: boolean): Vec3 {
  const toCenter = subtract(center, origin);
  const aside = subtract(scale(direction, dot(toCenter, direction)), toCenter);
  const passed = length(aside) / radius;
  if (passed <= 1) {
    const depth = Math.sqrt(1 - passed * passed) * radius;
    return normalize(add(aside, scale(direction, nearSide ? -depth : depth)));
  }
  const inward = normalize(toCenter);
  const outward = normalize(subtract(aside, scale(inward, dot(aside, inward))));
  // Angles from the point that is nearest to the eye.
  const outline = Math.acos(radius / length(toCenter));
  const end = nearSide ? Math.PI : 0;
  // As fast as a point on the ball is, seen from the side: the same on both sides of the outline.
  const share = Math.acos(1 - Math.min(passed - 1, 1)) / (Math.PI / 2);
  const angle = outline + (end - outline) * share;
  return normalize(add(scale(inward, -Math.cos(angle)), scale(outward, Math.sin(angle))));
}

/** Rodrigues' rotation of `v` about a unit axis, in radians. */
function rotated(v: Vec3, axis: Vec3, angle: number): Vec3 {
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  const turned = add(scale(v, cos), scale(cross(axis, v), sin));
  return normalize(add(turned, scale(axis, dot(axis, v) * (1 - cos))));
}

/** Pixels of keys' travel that are a degree of aperture. */
const PIXELS_PER_DEGREE = 8;

/** Degrees between the cones that are compared at first. */
const COARSE = 2;

/** Degrees. At 180 there is no cone, and the handle would disappear during the move. */
const WIDEST = 179;

/** In degrees, to a tenth: the cone whose edge passes nearest to the pointer. */
function apertureAfter({ placed, handle, values, view: start }: Anchor, view: Projection, travel: HandleMove): number {
  const { place, spot } = placed;
  const clamped = (degrees: number): number => Math.min(Math.max(Math.round(10 * degrees) / 10, 0), WIDEST);
  if (spot === null) return values.aperture;
  if (travel.byKeys) return clamped(values.aperture + (travel.dx - travel.dy) / PIXELS_PER_DEGREE);
  const onCone = coneOf(place, spot, start);
  const pointer = { x: handle.at.x + travel.dx, y: handle.at.y + travel.dy };
  const distanceAt = (degrees: number): number => distance(view.point(onCone(spot.grip, degrees)), pointer);
  const nearest = (from: number, to: number, step: number): number => {
    let best = from;
    for (let degrees = from; degrees <= to; degrees += step) if (distanceAt(degrees) < distanceAt(best)) best = degrees;
    return best;
  };
  const coarse = nearest(0, WIDEST, COARSE);
  return clamped(nearest(Math.max(coarse - COARSE, 0), Math.min(coarse + COARSE, WIDEST), 0.1));
}

const distance = (point: Point | null, { x, y }: Point): number =>
  point === null ? Infinity : Math.hypot(point.x - x, point.y - y);

/** Degrees to the travel that turns by as much. */
export const travelOfTurn = (degrees: number, view: Projection): number => (radians(degrees) * view.height) / Math.PI;
