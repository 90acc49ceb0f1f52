// What the element must draw, pixel by pixel, in float64: a camera ray through each pixel's centre,
// the first face of a declared mesh that it hits, and the equation there. World space; knows
// nothing of WebGL.
import { BoxGeometry, type BufferGeometry, Euler, Matrix4, Quaternion, Vector3 } from 'three';
import { basisOf, type Pose } from '../../src/phong/camera/orbit.js';
import type { LightValues } from '../../src/phong/light/light-state.js';
import { radians } from '../../src/phong/math/angle.js';
import { add, scale, type Vec3 } from '../../src/phong/math/vector.js';
import type { ReferenceOptions, Shaded, Surface } from '../../src/phong/reference/equation.js';
import { shadedAt } from '../support/shaded-at.js';
import { coneMargin } from '../stress/contract.js';
import { createGeometry } from '../../src/phong/model/shapes/shapes.js';
import type { CastCamera, CastScene, CastShape } from '../../src/extras/still/cast-scene.js';
import { Tracer } from '../../src/extras/still/tracer.js';

export interface CastMesh extends Surface {
  readonly geometry: 'plane' | 'box' | 'sphere';
  readonly position: Vec3;
  readonly rotation: Vec3;
  readonly scale: Vec3;
  /** As the attribute. The rays here hit the same shape for any value. */
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

/**
 * Casts the ray through pixel x, y of a picture of `width` × `height`; null where nothing is hit.
 */
export function caster(
  scene: DeclaredScene,
  width: number,
  height: number,
): (x: number, y: number) => Hit | null {
  const cast = castSceneOf(scene, idealShape);
  const tracer = new Tracer(cast, width, height);
  return (column, row) => {
    const [x, y] = [column + 0.5, row + 0.5];
    const { t, object: mesh, triangle } = tracer.hitAt(x, y);
    if (t === Infinity) return null;
    let known: Shaded | undefined;
    return {
      get shaded() {
        return (known ??= shadedAt(tracer, cast, x, y)!);
      },
      get coneMargin() {
        return Math.abs(coneMargin(scene.lights, this.shaded));
      },
      p: add(tracer.screen.camera.eye, scale(tracer.screen.direction(x, y), t)),
      t,
      mesh,
      // Two triangles are a face, and a sphere is one.
      face: `${mesh} ${scene.meshes[mesh]!.geometry === 'sphere' ? 0 : triangle >> 1}`,
    };
  };
}

export function cameraOf({ pose, fov }: DeclaredScene): CastCamera {
  const { right, up, back } = basisOf(pose);
  return { eye: add(pose.target, scale(back, pose.radius)), right, up, back, fov };
}

export const castSceneOf = (
  scene: DeclaredScene,
  shapeOf: (mesh: CastMesh) => CastShape,
): CastScene => ({
  ...scene.options,
  camera: cameraOf(scene),
  lights: scene.lights,
  objects: scene.meshes.map((mesh) => ({
    shape: shapeOf(mesh),
    matrix: matrixOf(mesh).elements,
    material: mesh,
  })),
});

/** Rotation order XYZ: the x rotation is applied last. */
export function matrixOf({ position, rotation, scale }: CastMesh): Matrix4 {
  const [x, y, z] = rotation.map(radians) as [number, number, number];
  const turn = new Quaternion().setFromEuler(new Euler(x, y, z, 'XYZ'));
  return new Matrix4().compose(new Vector3(...position), turn, new Vector3(...scale));
}

/** Where only the shape counts. */
export const BLACK = { ka: [0, 0, 0], kd: [0, 0, 0], ks: [0, 0, 0], shininess: 1 } as const;

export const trianglesOf = (geometry: BufferGeometry): CastShape => ({
  positions: geometry.getAttribute('position').array,
  normals: geometry.getAttribute('normal').array,
  uvs: [geometry.getAttribute('uv').array],
  ...(geometry.index && { index: geometry.index.array }),
});

const PLANE: CastShape = {
  positions: [-0.5, 0, -0.5, -0.5, 0, 0.5, 0.5, 0, 0.5, 0.5, 0, -0.5],
  normals: [0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0],
  index: [0, 1, 2, 0, 2, 3],
};
const SHAPES = {
  plane: PLANE,
  box: trianglesOf(new BoxGeometry()),
  // Its normals are 1e-4 off at most.
  sphere: trianglesOf(await createGeometry('sphere', 256)),
} as const;

const idealShape = ({ geometry }: CastMesh) => SHAPES[geometry];
