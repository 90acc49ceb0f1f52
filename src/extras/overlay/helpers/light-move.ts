// Moves a light by one of its handles, as one step that undo takes back. New values follow from
// those at the start and the whole travel since then, so that going back restores. Travel in CSS
// pixels of the layer, right and down.
import { Vector3 } from 'three';
import { LIMITS, type LightValues } from '../../../phong/light/light-state.js';
import {
  add,
  clamp,
  cross,
  dot,
  length,
  map,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../../../phong/math/vector.js';
import { sameValue } from '../../../phong/fields/field-store.js';
import { fieldsOf, historyOf, type PhongLight, type PhongViewer } from '../../../viewer/extra.js';
import { type Point, type Projection, type Ray } from '../drawing/projection.js';
import {
  DIRECTIONAL_AT,
  type Handle,
  type HandlePart,
  isDirectional,
  lightMarks,
  type PlacedLight,
  type SceneBall,
} from './light-marks.js';

/** What travel is measured from. */
export interface Anchor {
  readonly values: Readonly<LightValues>;
  readonly placed: PlacedLight;
  readonly handle: Handle;
  /** Where the depth and the side of the handle were measured. */
  readonly view: Projection;
  readonly scene: SceneBall;
}

interface Travel {
  readonly dx: number;
  readonly dy: number;
  /** Toward the eye and away from it, by `dy`, instead of in the plane of the view. */
  readonly along: boolean;
  /** By keys: the handle starts where it is rather than where it is drawn. */
  readonly byKeys: boolean;
}

const MOVED = ['position', 'axis', 'aperture'] as const;

type Change = Partial<Pick<LightValues, (typeof MOVED)[number]>>;

interface Move {
  readonly light: PhongLight;
  readonly byKeys: boolean;
  /** The step of undo that it will be. */
  readonly edit: ReturnType<ReturnType<typeof historyOf>['begin']>;
  anchor: Anchor;
  /** The light's values since the last step. */
  last: Readonly<LightValues>;
  along: boolean;
  /** Since the start. */
  travel: Point;
  /** Travel at the anchor. */
  from: Point;
}

/** Travel of one press of an arrow key: CSS pixels, and degrees where it turns a direction. */
const STEP = { pixels: 8, degrees: 5 } as const;

const START: Point = { x: 0, y: 0 };

export class LightMove {
  readonly #viewer: PhongViewer;
  readonly #surfaceOf: (light: PhongLight) => number;
  #move: Move | null = null;
  #seen: { readonly view: Projection; readonly scene: SceneBall } | null = null;

  /** `surfaceOf`: distance along a spot's axis to the first surface, as it is drawn. */
  constructor(viewer: PhongViewer, surfaceOf: (light: PhongLight) => number) {
    this.#viewer = viewer;
    this.#surfaceOf = surfaceOf;
  }

  get active(): boolean {
    return this.#move !== null;
  }

  get byKeys(): boolean {
    return this.#move?.byKeys === true;
  }

  /**
   * Call when the view changes: a dragged light stays under the pointer while something else moves
   * the camera.
   */
  see(view: Projection, scene: SceneBall): void {
    const isNew = view !== this.#seen?.view;
    this.#seen = { view, scene };
    const move = this.#move;
    if (isNew && move?.byKeys === false && move.travel !== START) {
      this.#go(move, move.travel, move.along);
    }
  }

  /** False if another move is in progress, or there is nothing to move. */
  start(light: PhongLight, part: HandlePart, byKeys: boolean): boolean {
    const anchor = this.#move === null ? this.#anchor(light, part) : null;
    if (anchor === null) return false;
    const { values: last } = anchor;
    this.#move = {
      light,
      byKeys,
      edit: historyOf(this.#viewer).begin(light),
      anchor,
      last,
      along: false,
      travel: START,
      from: START,
    };
    return true;
  }

  /** The pointer's whole travel since the start, CSS pixels of the layer. */
  to(x: number, y: number, along: boolean): void {
    if (this.#move !== null) {
      this.#go(this.#move, { x, y }, along);
    }
  }

  /** One press of a key: right and down are 1. */
  step(right: number, down: number, along: boolean): void {
    const move = this.#move;
    if (move === null) return;
    const { travel, anchor } = move;
    const { part } = anchor.handle;
    const turns = part === 'axis' || (part === 'place' && isDirectional(anchor.values));
    // One height of the picture is half a turn.
    const size = turns ? (STEP.degrees / 180) * anchor.view.height : STEP.pixels;
    this.#go(move, { x: travel.x + right * size, y: travel.y + down * size }, along);
  }

  restore(): void {
    this.#move?.edit.restore();
  }

  end(): void {
    const move = this.#move;
    this.#move = null;
    move?.edit.end();
  }

  #go(move: Move, travel: Point, along: boolean): void {
    const { light, byKeys } = move;
    const { view } = this.#seen ?? move.anchor;
    const { values } = fieldsOf(light).store;
    const isOther = MOVED.some((key) => !sameValue(values[key], move.last[key]));
    // Earlier travel was along other axes, or something else has written to the light.
    if (along !== move.along || isOther || (byKeys && move.anchor.view !== view)) {
      const anchor = this.#anchor(light, move.anchor.handle.part);
      if (anchor === null) return;
      Object.assign(move, { anchor, along, from: move.travel });
    }
    move.travel = travel;
    const { anchor, from } = move;
    const change = moved(anchor, view, {
      dx: travel.x - from.x,
      dy: travel.y - from.y,
      along,
      byKeys,
    });
    for (const [key, value] of Object.entries(change)) {
      fieldsOf(light).set(key as keyof Change, value);
    }
    move.last = { ...values };
  }

  /**
   * The light by its current values. What is drawn may be older, because keys can be faster than
   * frames.
   */
  #anchor(light: PhongLight, part: HandlePart): Anchor | null {
    if (this.#seen === null) return null;
    const { view, scene } = this.#seen;
    const values = { ...fieldsOf(light).store.values };
    const { placed, handles } = lightMarks(values, view, scene, false, this.#surfaceOf(light));
    const handle = handles.find((each) => each.part === part);
    return handle === undefined ? null : { values, placed, handle, view, scene };
  }
}

/** The light's values after the move. No change where the travel would give no finite value. */
export function moved(anchor: Anchor, view: Projection, travel: Travel): Change {
  const { handle, values, placed, scene } = anchor;
  const inCamera = values.space === 'camera';
  const turned = (v: Vec3) => (inCamera ? view.turnToCamera(v) : v);
  if (handle.part === 'aperture') return { aperture: apertureAfter(anchor, view, travel) };
  if (handle.part === 'axis') {
    const ball = { center: placed.place, radius: placed.spot?.arrow ?? 1 };
    const axis = scale(turned(directionAfter(anchor, ball, view, travel)), length(values.axis));
    return isUsable(axis) ? { axis } : {};
  }
  if (isDirectional(values)) {
    const [x, y, z] = values.position;
    const ball = { center: scene.center, radius: DIRECTIONAL_AT * scene.radius };
    // Without a direction it has no length that it could keep.
    const vector = scale(
      turned(directionAfter(anchor, ball, view, travel)),
      length([x, y, z]) || 1,
    );
    return isUsable(vector) ? { position: [...vector, 0] } : {};
  }
  const place = placeAfter(anchor, view, travel);
  const position = map(inCamera ? view.toCamera(place) : place, (v) => rounded(v, scene.radius));
  return isUsable(position) ? { position: [...position, 1] } : {};
}

const isUsable = (v: Vec3): boolean => v.every((x) => Math.abs(x) <= LIMITS.coordinate);

/**
 * To a ten-thousandth of the scene's size, or a whole number: markup stays short, and no step can
 * be seen.
 */
function rounded(value: number, radius: number): number {
  const decimals = clamp(4 - Math.floor(Math.log10(radius)), 0, 100);
  return Number(value.toFixed(decimals)) + 0;
}

/** Pixels along the view that change the distance by a factor of e. */
const ALONG_PIXELS = 150;

/**
 * Share of the orbit's radius at which a pixel's worth is measured for places beside or behind the
 * eye.
 */
const LEAST_DEPTH = 0.1;

function placeAfter(
  { placed: { place }, handle, view: start }: Anchor,
  view: Projection,
  travel: Travel,
): Vec3 {
  const { dx, dy } = travel;
  const depth = start.depthOf(place);
  const isAhead = start.point(place) !== null;
  const { right, up, back } = view.basis;
  const perPixel =
    1 / view.pixelsPerUnit(Math.max(Math.abs(depth), LEAST_DEPTH * view.pose.radius));
  if (travel.along) {
    if (!isAhead) return add(place, scale(back, dy * perPixel));
    return add(view.eye, scale(subtract(place, view.eye), Math.exp(-dy / ALONG_PIXELS)));
  }
  if (isAhead && !travel.byKeys) {
    return view.placeAt({ x: handle.at.x + dx, y: handle.at.y + dy }, depth);
  }
  return add(place, add(scale(right, dx * perPixel), scale(up, -dy * perPixel)));
}

/** Unit vector in world space, from the ball's centre to the handle, which stays on the ball. */
function directionAfter(
  { handle, view: start }: Anchor,
  ball: SceneBall,
  view: Projection,
  travel: Travel,
): Vec3 {
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
 * Where a ray from outside meets a ball, as a unit vector from its centre. A ray that misses the
 * ball goes on around it: from the outline, one radius from the centre, to the middle of the other
 * side at two radii.
 */
function onBall(
  { origin, direction }: Ray,
  { center, radius }: SceneBall,
  nearSide: boolean,
): Vec3 {
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

/** Unit vector; `axis` is one too, `angle` in radians. */
const rotated = (v: Vec3, axis: Vec3, angle: number): Vec3 =>
  normalize(new Vector3(...v).applyAxisAngle(new Vector3(...axis), angle).toArray());

/** Pixels of keys' travel that are a degree of aperture. */
const PIXELS_PER_DEGREE = 8;

/** Degrees between the cones that are compared at first. */
const COARSE = 2;

/** Degrees. At 180 there is no cone, and the handle would disappear during the move. */
const WIDEST = 179;

/** In degrees, to a tenth: the cone whose edge passes nearest to the pointer. */
function apertureAfter(
  { placed: { spot }, handle, values }: Anchor,
  view: Projection,
  travel: Travel,
): number {
  const allowed = (degrees: number) => clamp(Math.round(10 * degrees) / 10, 0, WIDEST);
  if (spot === null) return values.aperture;
  if (travel.byKeys) return allowed(values.aperture + (travel.dx - travel.dy) / PIXELS_PER_DEGREE);
  const pointer = { x: handle.at.x + travel.dx, y: handle.at.y + travel.dy };
  const distanceAt = (degrees: number): number => {
    const point = view.point(spot.onCone(spot.grip, degrees));
    return point === null ? Infinity : Math.hypot(point.x - pointer.x, point.y - pointer.y);
  };
  const nearest = (from: number, to: number, step: number): number => {
    let best = from;
    for (let degrees = from; degrees <= to; degrees += step) {
      if (distanceAt(degrees) < distanceAt(best)) {
        best = degrees;
      }
    }
    return best;
  };
  const coarse = nearest(0, WIDEST, COARSE);
  return allowed(nearest(Math.max(coarse - COARSE, 0), Math.min(coarse + COARSE, WIDEST), 0.1));
}
