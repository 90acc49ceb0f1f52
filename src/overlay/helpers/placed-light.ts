// The place in the scene at which a light's helper shows it. World space and scene units, whatever the light's own
// space.
import { isSpot } from '../../light/light-features.js';
import type { LightValues } from '../../light/light-state.js';
import { radians } from '../../math/angle.js';
import { add, cross, dot, length, normalize, perpendicular, scale, subtract, type Vec3 } from '../../math/vector.js';
import type { Projection } from '../drawing/projection.js';

/** A sphere that contains the scene; its radius is above 0. */
export interface SceneBall {
  readonly center: Vec3;
  readonly radius: number;
}

export interface PlacedLight {
  readonly directional: boolean;
  /** A directional light is placed in its direction, at {@link DIRECTIONAL_AT} radii from the scene's centre. */
  readonly place: Vec3;
  /** Unit vector in which a directional light shines; null for others, and without a direction. */
  readonly shines: Vec3 | null;
  /** A spot's cone; null for other lights. */
  readonly spot: PlacedSpot | null;
  /** Distance at which attenuation halves the light, if it does so anywhere but at the light itself. */
  readonly halfDistance: number | null;
}

export interface PlacedSpot {
  /** Unit vector. */
  readonly axis: Vec3;
  /** Length of the axis's arrow. */
  readonly arrow: number;
  /** Distance along the axis of the circle that ends the cone: at the first surface. */
  readonly reach: number;
  /** As far as {@link reach}, and far enough from the light for a handle. */
  readonly grip: number;
  /** Radius of the largest circle that is drawn. */
  readonly widest: number;
  /** Half-angle of the cone in degrees; 180 for none. */
  readonly aperture: number;
  /** Angle from the axis at which decay halves the light, degrees; null without decay. */
  readonly halfAngle: number | null;
}

/** Distance of a directional light's helper from the scene's centre, in radii of the scene. */
export const DIRECTIONAL_AT = 1.2;

/**
 * Longest arrow of a spot's axis, and least distance of handles from the light, in radii of the scene: both can be
 * gripped in a scene of any size, at any surface.
 */
const LONGEST_ARROW = 0.6;
const LEAST_GRIP = 0.25;

/**
 * In radii of the scene: circles of wider cones than this are nearer to the light, so that they stay in the picture.
 */
const WIDEST = 2;

/**
 * `surface`: distance along a spot's axis to the first surface; Infinity if there is none, or while that is not known.
 */
export function placedLight(
  values: Readonly<LightValues>,
  view: Projection,
  scene: SceneBall,
  surface = Infinity,
): PlacedLight {
  const [x, y, z, w] = values.position;
  const inCamera = values.space === 'camera';
  const turned = (v: Vec3): Vec3 => (inCamera ? view.turnToWorld(v) : v);
  const directional = w === 0;
  const toward = normalize(turned([x, y, z]));
  const place = directional
    ? add(scene.center, scale(toward, DIRECTIONAL_AT * scene.radius))
    : inCamera
      ? view.toWorld([x, y, z])
      : ([x, y, z] as const);
  return {
    directional,
    place,
    shines: directional && length(toward) > 0 ? scale(toward, -1) : null,
    spot: isSpot(values) ? placedSpot(values, place, normalize(turned(values.axis)), scene, surface) : null,
    halfDistance: directional ? null : halfDistance(values.attenuation),
  };
}

function placedSpot(
  values: Readonly<LightValues>,
  place: Vec3,
  axis: Vec3,
  scene: SceneBall,
  surface: number,
): PlacedSpot {
  const least = LEAST_GRIP * scene.radius;
  const reach = Number.isFinite(surface) ? surface : Math.max(reachOf(place, axis, scene), least);
  const grip = Math.max(reach, least);
  return {
    axis,
    arrow: Math.min(grip, LONGEST_ARROW * scene.radius),
    reach,
    grip,
    widest: WIDEST * scene.radius,
    aperture: values.aperture,
    halfAngle: halfAngle(values.cutoff),
  };
}

/** Distance along the axis to where it leaves the scene's ball. Beside it, the distance to its centre. */
function reachOf(place: Vec3, axis: Vec3, { center, radius }: SceneBall): number {
  const toCenter = subtract(center, place);
  const along = dot(toCenter, axis);
  const aside = Math.hypot(...subtract(toCenter, scale(axis, along)));
  const half = Math.sqrt(Math.max(radius * radius - aside * aside, 0));
  if (aside < radius && along + half > 0) return along + half;
  return Math.hypot(along, aside);
}

/** Where kc + kl·d + kq·d² = 2; null where attenuation is constant or 1/2 at the light already. */
export function halfDistance([kc, kl, kq]: Vec3): number | null {
  if (kc >= 2 || (kl === 0 && kq === 0)) return null;
  const missing = 2 - kc;
  // The form without cancellation, which holds for kq = 0 too.
  return (2 * missing) / (kl + Math.sqrt(kl * kl + 4 * kq * missing));
}

/** Where ((c + 1) / 2)^cutoff = 1/2, in degrees; null where that is nowhere. */
export function halfAngle(cutoff: number): number | null {
  const cosine = 2 * 0.5 ** (1 / cutoff) - 1;
  return cutoff > 0 && cosine > -1 ? (Math.acos(cosine) * 180) / Math.PI : null;
}

/**
 * Places on a spot's cones: at an angle of `degrees` from the axis, on the circle across the axis at `reach`, which over
 * a level floor is the edge of the lit pool. Nearer to the light where that circle would be too wide, as it always is
 * from 90 degrees on. By 0 and π `around` the axis is the outline as the eye sees it.
 */
export function coneOf(
  place: Vec3,
  { axis, widest }: PlacedSpot,
  view: Projection,
): (reach: number, degrees: number, around?: number) => Vec3 {
  const sightline = subtract(view.eye, place);
  const facing = cross(axis, sightline);
  // Along the axis the outline is a circle, and any direction will do.
  const across = length(facing) > 1e-6 * length(sightline) ? normalize(facing) : perpendicular(axis);
  const aside = cross(axis, across);
  return (reach, degrees, around = 0) => {
    const angle = radians(degrees);
    const distance = degrees < 90 ? Math.min(reach / Math.cos(angle), widest / Math.sin(angle)) : widest;
    const side = add(scale(across, Math.cos(around)), scale(aside, Math.sin(around)));
    return add(place, scale(add(scale(axis, Math.cos(angle)), scale(side, Math.sin(angle))), distance));
  };
}
