// How large is a scene? Held against three.js's own places of all vertices.

import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Euler,
  Group,
  Matrix4,
  Mesh,
  type Object3D,
  Points,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';
import { describe, expect, it, vi } from 'vitest';
import { forgetBounds, measure, radiusOf } from '../../../src/phong/geometry/bounds.js';
import { fitTo } from '../../../src/phong/geometry/framing.js';
import { createGeometry, GEOMETRIES, roundOf } from '../../../src/phong/model/shapes/shapes.js';
import { Random } from '../../stress/random.js';

/** Of positions in float32, relative. */
const ROUNDING = 1e-6;

/** Centre of the box of all vertices, and the farthest of them from a point. */
function exact(root: Group): { center: Vector3; radiusAbout(point: Vector3): number } {
  const places: Vector3[] = [];
  root.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const position = (object.geometry as BufferGeometry).getAttribute('position');
    for (let i = 0; i < position.count; i++) {
      places.push(new Vector3().fromBufferAttribute(position, i).applyMatrix4(object.matrixWorld));
    }
  });
  return {
    center: new Box3().setFromPoints(places).getCenter(new Vector3()),
    radiusAbout: (point) =>
      places.reduce((most, place) => Math.max(most, place.distanceTo(point)), 0),
  };
}

/** `error` is relative to the radius. */
function expectExact(scene: Group, error: number) {
  const [{ bounds, radiusAbout }, truth] = [measure(scene), exact(scene)];
  const radius = truth.radiusAbout(truth.center);
  expect(new Vector3(...bounds!.center).distanceTo(truth.center)).toBeLessThan(error * radius);
  const beside = truth.center.clone().add(new Vector3(radius, 0, -3 * radius));
  for (const point of [truth.center, beside]) {
    const ratio = radiusAbout(point.toArray()) / truth.radiusAbout(point);
    expect(Math.abs(ratio - 1)).toBeLessThan(error);
  }
}

function sceneOf(...meshes: readonly Object3D[]) {
  const scene = new Group();
  scene.add(...meshes);
  scene.updateMatrixWorld();
  return scene;
}

/** Rotations, uneven scales and mirrored ones. */
function place(mesh: Mesh, random: Random) {
  mesh.position.set(...random.vector(-4, 4));
  mesh.rotation.set(...random.vector(-4, 4));
  mesh.scale.set(random.magnitude(0.1, 10), -random.magnitude(0.1, 10), random.magnitude(0.1, 10));
  return mesh;
}

describe('the measure of a scene', () => {
  it.each(GEOMETRIES)(
    'finds centre and radius of two of a %s exactly, however they are turned and stretched',
    async (name) => {
      const geometry = await createGeometry(name, undefined);
      const random = new Random(name.length);
      for (let i = 0; i < 25; i++) {
        const meshes = [new Mesh(geometry), new Mesh(geometry)];
        expectExact(sceneOf(...meshes.map((mesh) => place(mesh, random))), ROUNDING);
      }
      const still = new Mesh(geometry);
      still.scale.set(3, 1, 2);
      still.position.set(0.1, 5, -7);
      // Its box is that of the round shape, which a few triangles do not reach.
      expectExact(sceneOf(still), 2e-4);
    },
  );

  it('leaves out what is hidden, and is empty where nothing is shown', async () => {
    const hidden = new Mesh(await createGeometry('box', undefined));
    hidden.visible = false;
    expect(measure(sceneOf(hidden)).bounds).toBeNull();
    expect(measure(sceneOf(new Mesh(new BufferGeometry()))).bounds).toBeNull();
  });

  it('ignores vertices with NaN coordinates', async () => {
    const box = await createGeometry('box', undefined);
    const broken = box.clone();
    const positions = [...box.getAttribute('position').array, NaN, 1, 1];
    broken.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
    expect(measure(sceneOf(new Mesh(broken)))).toMatchObject({ bounds: { center: [0, 0, 0] } });
  });

  it('is not measured about a given target with a given radius', () => {
    const radiusAbout = vi.fn();
    const extent = measure(sceneOf(new Mesh(new SphereGeometry())));
    fitTo({ ...extent, radiusAbout }, { target: [0, 0, 0], radius: 2 }, 45, 1);
    expect(radiusAbout).not.toHaveBeenCalled();
  });

  it.each(GEOMETRIES.filter((name) => roundOf(name) === undefined))(
    'gives a %s the bounds that three.js would compute for its own culling',
    async (name) => {
      const geometry = await createGeometry(name, undefined);
      measure(sceneOf(new Mesh(geometry)));
      const { boundingBox, boundingSphere } = geometry;
      geometry.boundingBox = geometry.boundingSphere = null;
      geometry.computeBoundingBox();
      geometry.computeBoundingSphere();
      expect(boundingBox).toEqual(geometry.boundingBox);
      expect(boundingSphere!.radius).toBeCloseTo(geometry.boundingSphere!.radius, 12);
      expect(boundingSphere!.center.distanceTo(geometry.boundingSphere!.center)).toBeLessThan(
        1e-12,
      );
    },
  );

  it.each(GEOMETRIES.filter((name) => roundOf(name) !== undefined))(
    'gives a %s of any number of segments the bounds of the round shape, until its vertices are written to',
    async (name) => {
      const { half, radius } = roundOf(name)!;
      for (const segments of [3, 12, undefined]) {
        const geometry = await createGeometry(name, segments);
        const scene = sceneOf(new Mesh(geometry));
        // On a new page, and after refit().
        for (let time = 0; time < 2; time++) {
          const { bounds, radiusAbout } = measure(scene);
          expect([bounds!.center, radiusAbout([0, 0, 0])]).toEqual([[0, 0, 0], radius]);
          // Faces and lights are culled by these.
          expect(geometry.boundingBox?.max.toArray()).toEqual(half);
          expect(geometry.boundingSphere?.radius).toBe(radius);
          forgetBounds(scene);
        }
        const position = geometry.getAttribute('position');
        position.setX(0, 7);
        position.needsUpdate = true;
        forgetBounds(scene);
        expect(measure(scene).radiusAbout([0, 0, 0])).toBeGreaterThan(3);
        expect(geometry.boundingBox?.max.x).toBe(7);
      }
    },
  );

  it('reads the vertices of a geometry once, and again when it is forgotten', () => {
    const geometry = new SphereGeometry();
    const scene = sceneOf(new Mesh(geometry));
    measure(scene);
    const reads = vi.spyOn(geometry, 'getAttribute');
    measure(scene);
    expect(reads).not.toHaveBeenCalled();
    geometry.scale(2, 2, 2);
    forgetBounds(scene);
    expect(measure(scene).radiusAbout([4, 0, 0])).toBeCloseTo(6, 9);
  });
});

describe('the radius that holds all of a scene', () => {
  it('is never too small, under any matrix', async () => {
    const random = new Random(11);
    for (const name of GEOMETRIES) {
      const geometry = await createGeometry(name, undefined);
      for (let i = 0; i < 10; i++) {
        const parent = new Group().add(place(new Mesh(geometry), random));
        // Scaled after the rotation, which shears.
        const turned = new Quaternion().setFromEuler(new Euler(1, 2, 3));
        parent.applyMatrix4(new Matrix4().compose(new Vector3(), turned, new Vector3(1, 5, 0.1)));
        const scene = sceneOf(parent);
        const point = random.vector(-1, 1);
        const least = exact(scene).radiusAbout(new Vector3(...point)) * (1 - 1e-12);
        expect(radiusOf(scene, point)).toBeGreaterThanOrEqual(least);
      }
    }
  });

  it('counts points and lines as well, and nothing that is hidden', async () => {
    const geometry = await createGeometry('box', undefined);
    const points = new Points(geometry);
    points.position.x = 10;
    const scene = sceneOf(points);
    expect(radiusOf(scene, [0, 0, 0])).toBeGreaterThan(10.5);
    points.visible = false;
    expect(radiusOf(scene, [0, 0, 0])).toBe(0);
  });
});
