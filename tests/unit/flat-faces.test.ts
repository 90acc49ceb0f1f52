// Do the uniforms of flat faces say where each pixel's ray meets each face? Against rays and planes in float64, with
// the uniforms rounded to float32 as a GPU gets them.
import {
  type BufferGeometry,
  Euler,
  Matrix3,
  Matrix4,
  PerspectiveCamera,
  Quaternion,
  Vector3,
  Vector4,
} from 'three';
import { describe, expect, it } from 'vitest';
import { facesOf, faceUniforms, isNear, writeFaces } from '../../src/material/flat-faces.js';
import { flatGeometry } from '../../src/material/flat-geometry.js';
import { normalMatrix } from '../../src/material/normal-matrix.js';
import { add, cross, dot, normalize, scale, subtract, type Vec3 } from '../../src/math/vector.js';
import { createGeometry } from '../../src/scene/mesh/shapes/shapes.js';
import { Random } from '../stress/random.js';

const FLAT = ['box', 'plane', 'pyramid'] as const;
const ROUND = ['sphere', 'cylinder', 'cone', 'torus', 'teapot'] as const;

/** As in phong.vert. */
function rowOf(normal: readonly number[]): number {
  const [x, y, z] = normal.map(Math.abs) as [number, number, number];
  const axis = x > Math.max(y, z) ? 0 : y >= z ? 1 : 2;
  return 2 * axis + Number(normal[axis]! < 0);
}

const vec3 = (values: ArrayLike<number>, at: number): Vec3 => [values[at]!, values[at + 1]!, values[at + 2]!];

/** The vertices of a geometry with their normals. */
function vertices(geometry: BufferGeometry): { at: Vec3; normal: Vec3 }[] {
  const { array, count } = geometry.getAttribute('position');
  const normals = geometry.getAttribute('normal').array;
  return Array.from({ length: count }, (_, i) => ({ at: vec3(array, 3 * i), normal: vec3(normals, 3 * i) }));
}

describe('the faces of a shape', () => {
  for (const name of FLAT) {
    for (const segments of [1, 4]) {
      it(`are those of all triangles of a ${name} of ${segments} segments, smooth and flat`, async () => {
        const geometry = await createGeometry(name, segments);
        const faces = facesOf(geometry)!;
        const byRow = new Map(faces.map((face) => [rowOf(face.normal), face]));
        expect(byRow.size).toBe(faces.length);
        for (const one of [geometry, flatGeometry(geometry)]) {
          expect(facesOf(one)).toBe(faces);
          for (const { at, normal } of vertices(one)) {
            const face = byRow.get(rowOf(normal))!;
            expect(Math.abs(dot(face.normal, subtract(at, face.point)))).toBeLessThan(1e-7);
            expect(dot(face.normal, normal)).toBeGreaterThan(1 - 1e-6);
          }
        }
      });
    }
  }

  it('are not all flat on round shapes', async () => {
    for (const name of ROUND) expect(facesOf(await createGeometry(name, undefined)), name).toBeUndefined();
  });
});

/** A mesh before a camera, both anywhere, with what the material gives. */
function scene(random: Random) {
  const size = random.magnitude(1e-3, 1e6);
  const side = (): number => size * random.pick([1, -1, random.from(0.5, 2), random.magnitude(1e-3, 1)]);
  const turn = new Quaternion().setFromEuler(
    new Euler(random.from(-3, 3), random.from(-3, 3), random.from(-3, 3)),
  );
  const place = new Vector3(...scale(random.unit(), random.from(0, 3)));
  const model = new Matrix4().compose(place, turn, new Vector3(side(), side(), side()));
  const normals = new Matrix3();
  normalMatrix(model, normals);
  const camera = new PerspectiveCamera(random.from(10, 90), random.from(0.5, 2), 0.1, 100);
  if (random.pick([true, false]))
    camera.setViewOffset(900, 700, random.from(0, 500), random.from(0, 400), 300, 200);
  camera.updateProjectionMatrix();
  // As for scenes of size 1e9 and more.
  if (random.pick([true, false])) camera.projectionMatrix.multiplyScalar(2 ** -30);
  const back = random.unit();
  const right = normalize(cross(random.unit(), back));
  const up = cross(back, right);
  const eye = new Vector3(...scale(back, random.magnitude(0.1, 10)));
  const view = new Matrix4().makeBasis(new Vector3(...right), new Vector3(...up), new Vector3(...back));
  view.setPosition(eye).invert();
  const viewport = new Vector4(random.pick([0, 3, 512]), random.pick([0, 7, 400]), 300, 201);
  return { model, normals, camera, eye, view, viewport };
}

/** The point that the shader finds, with numbers rounded to float32. */
function found(
  { uFaces, uRays, uViewportCenter }: ReturnType<typeof faceUniforms>,
  row: number,
  eye: Vector3,
  pixel: readonly [number, number],
): Vec3 {
  const at: Vec3 = [pixel[0] - uViewportCenter.value.x, pixel[1] - uViewportCenter.value.y, 1];
  const r = uRays.value.elements.map(Math.fround);
  const depth = 1 / Math.max(dot(vec3(uFaces.value, 4 * row), at), 1e-17);
  const ray = (i: number): number => r[i]! * at[0] + r[3 + i]! * at[1] + r[6 + i]! * at[2];
  return add(eye.toArray(), scale([ray(0), ray(1), ray(2)], depth));
}

describe('the planes of faces as pixels see them', () => {
  it('meet rays where planes do, to a thousandth of a pixel', async () => {
    const seed = Number(process.env['PHONG_VIEWER_SEED'] ?? 11);
    const random = new Random(seed);
    const geometries: BufferGeometry[] = [];
    for (const name of FLAT) geometries.push(await createGeometry(name, undefined));
    let met = 0;
    for (let i = 0; i < 400; i++) {
      const { model, normals, camera, eye, view, viewport } = scene(random);
      const uniforms = faceUniforms();
      const faces = facesOf(random.pick(geometries))!;
      const projection = camera.projectionMatrix;
      writeFaces(uniforms, faces, model, normals, { eye, view, projection, viewport });
      const pixel = [
        viewport.x + 0.5 + Math.floor(random.from(0, 300)),
        viewport.y + 0.5 + Math.floor(random.from(0, 201)),
      ] as const;
      for (const face of faces) {
        const row = rowOf(face.normal);
        const p = found(uniforms, row, eye, pixel);
        const outside = new Vector3(...face.normal).applyMatrix3(normals).normalize();
        const off = new Vector3(...face.point).applyMatrix4(model).sub(eye);
        const height = outside.dot(off);
        expect(uniforms.uFaces.value[4 * row + 3], `seed ${seed}, case ${i}`).toBe(height <= 0 ? 1 : -1);
        const depth = -new Vector3(...p).applyMatrix4(view).z;
        if (depth > 1e6) continue; // beyond the horizon, or near it
        met += 1;
        // Back through the projection: the pixel that it was found for. And in the plane.
        const clip = new Vector4(...p, 1).applyMatrix4(view).applyMatrix4(projection);
        const seen = [
          viewport.x + (0.5 + clip.x / clip.w / 2) * 300,
          viewport.y + (0.5 + clip.y / clip.w / 2) * 201,
        ];
        expect(Math.abs(seen[0]! - pixel[0]), `seed ${seed}, case ${i}`).toBeLessThan(1e-3);
        expect(Math.abs(seen[1]! - pixel[1]), `seed ${seed}, case ${i}`).toBeLessThan(1e-3);
        const v = new Vector3(...p).sub(eye);
        expect(Math.abs(outside.dot(v) - height), `seed ${seed}, case ${i}`).toBeLessThan(
          1e-6 * (v.length() + Math.abs(height)),
        );
      }
    }
    expect(met).toBeGreaterThan(300);
  });

  it('are finite for flattened meshes and for an eye in the plane', async () => {
    const box = facesOf(await createGeometry('box', undefined))!;
    const { camera, view, viewport } = scene(new Random(3));
    const uniforms = faceUniforms();
    const sizes = [[1, 0, 1], [0, 0, 1], [0, 0, 0], [1, 1, 1]] as const; // prettier-ignore
    for (const [x, y, z] of sizes) {
      for (const eye of [new Vector3(3, 0.5, 0), new Vector3()]) {
        const model = new Matrix4().makeScale(x, y, z);
        const normals = new Matrix3();
        normalMatrix(model, normals);
        writeFaces(uniforms, box, model, normals, {
          eye,
          view,
          projection: camera.projectionMatrix,
          viewport,
        });
        expect(
          [...uniforms.uFaces.value].every(Number.isFinite),
          `${[x, y, z].join()} ${eye.toArray().join()}`,
        ).toBe(true);
      }
    }
  });
});

describe('an eye', () => {
  const isNearFloor = async (name: 'plane' | 'box', size: Vec3, eye: Vec3): Promise<boolean> => {
    const model = new Matrix4().compose(
      new Vector3(),
      new Quaternion().setFromEuler(new Euler(1, 2, 3)),
      new Vector3(...size),
    );
    const normals = new Matrix3();
    normalMatrix(model, normals);
    const turned = new Vector3(...eye).applyQuaternion(new Quaternion().setFromEuler(new Euler(1, 2, 3)));
    return isNear(await createGeometry(name, undefined), model, normals, turned);
  };

  it('is near a floor if its distance is less than a quarter of the side', async () => {
    for (const size of [
      [80, 1, 80],
      [80, 0, -20],
    ] as const) {
      expect(await isNearFloor('plane', size, [5, 20.01, 5])).toBe(false);
      expect(await isNearFloor('plane', size, [5, 19.99, 5])).toBe(true);
      expect(await isNearFloor('plane', size, [5, -19.99, 5])).toBe(true);
    }
  });

  it('is not near what it sees edge-on from afar', async () => {
    expect(await isNearFloor('box', [1, 1, 1], [4, 0.5, 0])).toBe(false);
    expect(await isNearFloor('plane', [1, 1, 1], [4, 1e-9, 0])).toBe(false);
  });

  it('is near the walls of a room that it is in only where it is close to one', async () => {
    expect(await isNearFloor('box', [10, 6, 10], [0, 0, 0])).toBe(false);
    expect(await isNearFloor('box', [10, 6, 10], [0, -1, 0])).toBe(true);
  });
});
