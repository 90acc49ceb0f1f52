// What the element must draw, pixel by pixel, in float64: a camera ray through each pixel's centre, the first face of
// a declared mesh that it hits, and the equation there. World space; knows nothing of WebGL.
import { basisOf, type Pose } from '../../src/camera/orbit.js';
import type { LightValues } from '../../src/light/light-state.js';
import { radians } from '../../src/math/angle.js';
import { add, cross, dot, normalize, scale, subtract, type Vec3 } from '../../src/math/vector.js';
import { type ReferenceOptions, shade, type Shaded, type Surface } from '../../src/reference/equation.js';

export interface CastMesh extends Surface {
  readonly geometry: 'plane' | 'box' | 'sphere';
  readonly position: Vec3;
  readonly rotation: Vec3;
  readonly scale: Vec3;
  /** As the attribute. The rays here hit the ideal shape for any value. */
  readonly segments?: number;
}

export interface DeclaredScene {
  readonly pose: Pose;
  /** Vertical, degrees. */
  readonly fov: number;
  readonly meshes: readonly CastMesh[];
  readonly lights: readonly LightValues[];
  readonly options: Omit<ReferenceOptions, 'camera'>;
}

export interface Hit {
  /** Computed on demand, because often only the face of a neighbour is needed. */
  readonly shaded: Shaded;
  readonly p: Vec3;
  /** Distance from the eye along the view. */
  readonly t: number;
  readonly mesh: number;
  /** Identifies the face and the mesh: equal for all pixels of one face. */
  readonly face: string;
  /** Angle to the nearest cone's edge, radians; Infinity where no light has a cone. */
  readonly coneMargin: number;
}

/** Casts the ray through pixel x, y of a picture of `width` × `height`; null where nothing is hit. */
export function caster(scene: DeclaredScene, width: number, height: number): (x: number, y: number) => Hit | null {
  const { axes, eyeOffset, plane } = lens(scene, width, height);
  const placed = scene.meshes.map(placement);
  return (x, y) => {
    const [sx, sy] = plane(x, y);
    const ray = subtract(add(scale(axes.right, sx), scale(axes.up, sy)), axes.back);
    let nearest: Nearest | undefined;
    for (const [mesh, place] of placed.entries()) {
      // Relative to the mesh first: scenes far from the origin lose nothing.
      const fromMesh = add(subtract(scene.pose.target, place.position), eyeOffset);
      const hit = intersect(scene.meshes[mesh]!.geometry, place.inward(fromMesh), place.inward(ray));
      if (hit !== null && (nearest === undefined || hit.t < nearest.t)) {
        nearest = { t: hit.t, normal: place.normal(hit.normal), face: `${mesh} ${hit.face}`, mesh };
      }
    }
    if (nearest === undefined) return null;
    const { t, mesh, face } = nearest;
    const normal = dot(nearest.normal, ray) > 0 ? scale(nearest.normal, -1) : nearest.normal;
    const eye = add(scene.pose.target, eyeOffset);
    const p = add(add(scene.pose.target, eyeOffset), scale(ray, t));
    const surface = scene.meshes[mesh]!;
    let known: Shaded | undefined;
    return {
      get shaded() {
        return (known ??= shade({ p, normal, eye }, surface, scene.lights, {
          ...scene.options,
          camera: axes,
        }));
      },
      get coneMargin() {
        return coneMargin(scene.lights, this.shaded);
      },
      p,
      t,
      mesh,
      face,
    };
  };
}

/**
 * The camera's axes, the eye seen from the target, and where the plane at distance 1 is met through a pixel's centre.
 */
export function lens({ pose, fov }: DeclaredScene, width: number, height: number) {
  const { right, up, back } = basisOf(pose);
  const axes = { right: [...right] as Vec3, up: [...up] as Vec3, back: [...back] as Vec3 };
  const tan = Math.tan(radians(fov) / 2);
  return {
    axes,
    eyeOffset: scale(axes.back, pose.radius),
    /** What one pixel spans in that plane. */
    pixel: (2 * tan) / height,
    plane: (x: number, y: number): readonly [number, number] => [
      (((x + 0.5) / width) * 2 - 1) * tan * (width / height),
      (1 - ((y + 0.5) / height) * 2) * tan,
    ],
  };
}

export function coneMargin(lights: readonly LightValues[], { shares }: Shaded): number {
  let least = Infinity;
  shares.forEach((share, i) => {
    const light = lights[i]!;
    if (share === null || light.aperture >= 180 || light.axis.every((a) => a === 0)) return;
    const angle = Math.acos(Math.min(Math.max(share.c, -1), 1));
    least = Math.min(least, Math.abs(angle - radians(light.aperture)));
  });
  return least;
}

/** Rotation order XYZ: the x rotation is applied last. */
export function placement({ position, rotation, scale: s }: CastMesh) {
  const [rx, ry, rz] = rotation.map(radians) as [number, number, number];
  const turn = (v: Vec3): Vec3 => about(0, rx, about(1, ry, about(2, rz, v)));
  const back = (v: Vec3): Vec3 => about(2, -rz, about(1, -ry, about(0, -rx, v)));
  return {
    position,
    /** From the mesh's own space to the world's axes, about the mesh's place. */
    outward: (v: Vec3): Vec3 => turn([v[0] * s[0], v[1] * s[1], v[2] * s[2]]),
    inward: (v: Vec3): Vec3 => {
      const u = back(v);
      return [u[0] / s[0], u[1] / s[1], u[2] / s[2]];
    },
    normal: (n: Vec3): Vec3 => normalize(turn([n[0] / s[0], n[1] / s[1], n[2] / s[2]])),
  };
}

function about(axis: 0 | 1 | 2, angle: number, v: Vec3): Vec3 {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const i = (axis + 1) % 3;
  const j = (axis + 2) % 3;
  const out = [...v];
  out[i] = c * v[i]! - s * v[j]!;
  out[j] = s * v[i]! + c * v[j]!;
  return out as unknown as Vec3;
}

interface LocalHit {
  readonly t: number;
  readonly normal: Vec3;
  readonly face: string;
}

interface Nearest extends LocalHit {
  readonly mesh: number;
}

function intersect(geometry: CastMesh['geometry'], from: Vec3, along: Vec3): LocalHit | null {
  if (geometry === 'sphere') return sphere(from, along);
  const faces: LocalHit[] = [];
  for (const axis of geometry === 'plane' ? [1] : [0, 1, 2]) {
    for (const side of geometry === 'plane' ? [0] : [-0.5, 0.5]) {
      const t = (side - from[axis]!) / along[axis]!;
      const at = add(from, scale(along, t));
      const others = [0, 1, 2].filter((k) => k !== axis);
      const margin = Math.min(...others.map((k) => 0.5 - Math.abs(at[k]!)));
      const normal = [0, 0, 0];
      normal[axis] = side < 0 ? -1 : 1;
      if (t > 0 && margin >= 0) faces.push({ t, normal: normal as unknown as Vec3, face: `${axis} ${side}` });
    }
  }
  return faces.sort((a, b) => a.t - b.t)[0] ?? null;
}

function sphere(from: Vec3, along: Vec3): LocalHit | null {
  const a = dot(along, along);
  const b = dot(from, along);
  const q = dot(cross(from, along), cross(from, along)) / a;
  if (q > 0.25) return null;
  const half = Math.sqrt(a) * Math.sqrt(0.25 - q);
  const t = (half < -b ? -b - half : half - b) / a; // from inside it is seen from behind
  if (t <= 0) return null;
  return { t, normal: normalize(add(from, scale(along, t))), face: 'round' };
}
