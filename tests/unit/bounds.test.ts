// How large is a scene? Held against three.js's own places of all vertices.

import {
  BufferAttribute,
  BufferGeometry,
  Euler,
  Group,
  Matrix4,
  Mesh,
  Points,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';
import { describe, expect, it, vi } from 'vitest';
import { forgetBounds, measure, radiusOf } from '../../src/scene/bounds.js';
import { createGeometry, GEOMETRIES, roundOf } from '../../src/scene/mesh/shapes/shapes.js';
import { Random } from '../stress/random.js';

type Triple = [number, number, number];

/** Of positions in float32, relative. */
const ROUNDING = 1e-6;

/** Centre of the box of all vertices, and the farthest of them from a point. */
function exact(root: Group): { center: Triple; radiusAbout(point: readonly number[]): number } {
  const places: Vector3[] = [];
  root.traverseVisible((object) => {
    if (!(object instanceof Mesh)) return;
    const position = (object.geometry as BufferGeometry).getAttribute('position');
    for (let i = 0; i < position.count; i++)
      places.push(new Vector3().fromBufferAttribute(position, i).applyMatrix4(object.matrixWorld));
  });
  const middle = (axis: 'x' | 'y' | 'z'): number => {
    let [low, high] = [Infinity, -Infinity];
    for (const place of places) {
      low = Math.min(low, place[axis]);
      high = Math.max(high, place[axis]);
    }
    return (low + high) / 2;
  };
  return {
    center: [middle('x'), middle('y'), middle('z')],
    radiusAbout: ([x = 0, y = 0, z = 0]) => {
      const point = new Vector3(x, y, z);
      return places.reduce((most, place) => Math.max(most, place.distanceTo(point)), 0);
    },
  };
}

function sceneOf(...meshes: readonly Mesh[]): Group {
  const scene = new Group();
  scene.add(...meshes);
  scene.updateMatrixWorld();
  return scene;
}

/** Rotations, uneven scales and mirrored ones. */
function place(mesh: Mesh, random: Random): Mesh {
  mesh.position.set(...random.vector(-4, 4));
  mesh.rotation.set(...random.vector(-4, 4));
  mesh.scale.set(random.magnitude(0.1, 10), -random.magnitude(0.1, 10), random.magnitude(0.1, 10));
  return mesh;
}

describe('the measure of a scene', () => {
  it('stays as it is when a mesh moves that it holds at both places', async () => {
    const [box, sphere] = [await createGeometry('box', undefined), await createGeometry('sphere', undefined)];
    const random = new Random(7);
    let held = 0;
    for (let i = 0; i < 200; i++) {
      const meshes = Array.from({ length: 9 }, (_, k) => place(new Mesh(k % 2 === 0 ? box : sphere), random));
      const scene = sceneOf(...meshes);
      const before = measure(scene);
      const radius = before.radiusAbout(before.center);
      const [moved] = meshes as [Mesh];
      const wasHeld = before.holds(moved.geometry, moved.matrixWorld.elements, radius);
      place(moved, random).updateMatrixWorld();
      if (!wasHeld || !before.holds(moved.geometry, moved.matrixWorld.elements, radius)) continue;
      held += 1;
      const after = measure(scene);
      expect([...after.center, after.radiusAbout(after.center)]).toEqual([...before.center, radius]);
    }
    expect(held).toBeGreaterThan(5);
  });

  for (const name of GEOMETRIES) {
    it(`finds centre and radius of a ${name} exactly, however it is turned and stretched`, async () => {
      const geometry = await createGeometry(name, undefined);
      const random = new Random(name.length);
      const still = new Mesh(geometry);
      still.scale.set(3, 1, 2);
      still.position.set(0.1, 5, -7);
      for (const mesh of [still, ...Array.from({ length: 25 }, () => place(new Mesh(geometry), random))]) {
        const scene = sceneOf(mesh);
        const [{ center, radiusAbout }, truth] = [measure(scene), exact(scene)];
        const radius = truth.radiusAbout(truth.center);
        // Its box is that of the round shape, which a few triangles do not reach.
        const error = mesh === still ? 2e-4 : ROUNDING;
        expect(new Vector3(...center).distanceTo(new Vector3(...truth.center))).toBeLessThan(error * radius);
        expect(Math.abs(radiusAbout(center) / radius - 1)).toBeLessThan(error);
        const beside = [truth.center[0] + radius, truth.center[1], truth.center[2] - 3 * radius] as const;
        expect(Math.abs(radiusAbout(beside) / truth.radiusAbout(beside) - 1)).toBeLessThan(error);
      }
    });
  }

  it('covers several meshes together', async () => {
    const shapes: BufferGeometry[] = [];
    for (const name of GEOMETRIES) shapes.push(await createGeometry(name, undefined));
    const random = new Random(3);
    const meshes = Array.from({ length: 60 }, (_, i) => place(new Mesh(shapes[i % shapes.length]), random));
    const scene = sceneOf(...meshes);
    const [{ center, radiusAbout }, truth] = [measure(scene), exact(scene)];
    const radius = truth.radiusAbout(truth.center);
    expect(new Vector3(...center).distanceTo(new Vector3(...truth.center))).toBeLessThan(2e-4 * radius);
    expect(Math.abs(radiusAbout(center) / radius - 1)).toBeLessThan(2e-4);
  });

  it('leaves out what is hidden, and is empty where nothing is shown', async () => {
    const hidden: Mesh = new Mesh(await createGeometry('box', undefined));
    hidden.visible = false;
    expect(measure(sceneOf(hidden)).empty).toBe(true);
    expect(measure(sceneOf(new Mesh(new BufferGeometry()))).empty).toBe(true);
    expect(measure(new Group()).empty).toBe(true);
  });

  it('ignores vertices with NaN coordinates', async () => {
    const box = await createGeometry('box', undefined);
    const broken = box.clone();
    broken.setAttribute(
      'position',
      new BufferAttribute(
        Float32Array.from([...(box.getAttribute('position').array as Float32Array), NaN, 1, 1]),
        3,
      ),
    );
    expect(measure(sceneOf(new Mesh(broken)))).toMatchObject({ empty: false, center: [0, 0, 0] });
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
      expect(boundingSphere!.center.distanceTo(geometry.boundingSphere!.center)).toBeLessThan(1e-12);
    },
  );

  it.each(GEOMETRIES.filter((name) => roundOf(name) !== undefined))(
    'gives a %s of any number of segments the bounds of the round shape, until its vertices are written to',
    async (name) => {
      const { half, radius } = roundOf(name)!;
      for (const segments of [3, 12, undefined]) {
        const geometry = await createGeometry(name, segments);
        const scene = sceneOf(new Mesh(geometry));
        const extent = measure(scene);
        expect([extent.center, extent.radiusAbout([0, 0, 0])]).toEqual([[0, 0, 0], radius]);
        expect(geometry.boundingBox!.max.toArray()).toEqual(half);
        expect(geometry.boundingSphere!.radius).toBe(radius);
        forgetBounds(scene);
        expect(measure(scene).radiusAbout([0, 0, 0])).toBe(radius);
        // Faces and lights are culled by these: after refit() as on a new page.
        expect(geometry.boundingBox?.max.toArray()).toEqual(half);
        expect(geometry.boundingSphere?.radius).toBe(radius);
        const position = geometry.getAttribute('position');
        position.setX(0, 7);
        position.needsUpdate = true;
        forgetBounds(scene);
        expect(measure(scene).radiusAbout([0, 0, 0])).toBeGreaterThan(3);
        expect(geometry.boundingBox?.max.x).toBe(7);
      }
    },
  );

  it('reads the vertices of a geometry once, wherever its meshes go, and again when it is forgotten', () => {
    const geometry = new SphereGeometry(0.5, 512, 256);
    const reads = vi.spyOn(geometry, 'getAttribute');
    const [a, b] = [new Mesh(geometry), new Mesh(geometry)];
    const scene = sceneOf(a, b);
    measure(scene);
    const once = reads.mock.calls.length;
    expect(once).toBeGreaterThan(0);
    for (let i = 1; i < 5; i++) {
      b.position.x = i;
      scene.updateMatrixWorld();
      expect(measure(scene).center[0]).toBeCloseTo(i / 2, 12);
      expect(radiusOf(scene, [0, 0, 0])).toBeGreaterThan(i);
    }
    expect(reads.mock.calls).toHaveLength(once);
    geometry.scale(2, 2, 2);
    expect(measure(scene).center[0]).toBeCloseTo(2, 12);
    forgetBounds(scene);
    expect(measure(scene).radiusAbout([4, 0, 0])).toBeCloseTo(5, 9);
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
        parent.applyMatrix4(
          new Matrix4().compose(
            new Vector3(),
            new Quaternion().setFromEuler(new Euler(1, 2, 3)),
            new Vector3(1, 5, 0.1),
          ),
        );
        const scene = new Group().add(parent);
        scene.updateMatrixWorld();
        const point = random.vector(-1, 1);
        const { radiusAbout } = exact(scene);
        expect(radiusOf(scene, point)).toBeGreaterThanOrEqual(radiusAbout(point) * (1 - 1e-12));
      }
    }
  });

  it('counts points and lines as well, and nothing that is hidden', async () => {
    const geometry = await createGeometry('box', undefined);
    const points = new Points(geometry);
    points.position.x = 10;
    const scene = new Group().add(points);
    scene.updateMatrixWorld();
    expect(radiusOf(scene, [0, 0, 0])).toBeGreaterThan(10.5);
    points.visible = false;
    expect(radiusOf(scene, [0, 0, 0])).toBe(0);
  });
});
