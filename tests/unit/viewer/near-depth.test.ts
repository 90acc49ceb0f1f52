// The near plane lies before everything in view, and no nearer to the eye than it has to.
import {
  BoxGeometry,
  BufferGeometry,
  Euler,
  InstancedMesh,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  PlaneGeometry,
  Points,
  Scene,
  ShaderMaterial,
  Sprite,
  Vector3,
} from 'three';
import { describe, expect, it, vi } from 'vitest';
import { Orbit, type Pose } from '../../../src/phong/camera/orbit.js';
import { radians } from '../../../src/phong/math/angle.js';
import { radiusOf } from '../../../src/phong/geometry/bounds.js';
import { Frame } from '../../../src/viewer/scene/frame.js';
import { createGeometry } from '../../../src/phong/model/shapes/shapes.js';
import { repeats } from '../../support/repeats.js';
import type { CoverageScene } from '../../visual/coverage.js';
import { LOW_EYES, randomLowEye } from '../../visual/low-eyes.js';
import { BLACK, caster } from '../../visual/ray-cast.js';

const WIDTH = 24;
const HEIGHT = 18;

function nearOf(scene: Object3D, pose: Pose, fov = 45) {
  const frame = new Frame(new Orbit(pose));
  scene.updateMatrixWorld();
  const center = [0, 0, 0] as const;
  frame.update(fov, { width: WIDTH, height: HEIGHT });
  frame.aim(scene, { center, radius: radiusOf(scene, center) });
  return frame.camera.near;
}

const ZERO = [0, 0, 0] as const;
const ONE = [1, 1, 1] as const;

function built({ meshes }: CoverageScene) {
  const scene = new Scene();
  for (const { geometry, position = ZERO, rotation = ZERO, scale = ONE } of meshes) {
    const mesh = new Mesh(createGeometry(geometry, undefined) as BufferGeometry);
    mesh.position.set(...position);
    mesh.setRotationFromEuler(
      new Euler(radians(rotation[0]), radians(rotation[1]), radians(rotation[2])),
    );
    mesh.scale.set(...scale);
    scene.add(mesh);
  }
  return scene;
}

/** The least depth at the centres of the pixels. */
function leastSeen({ meshes, fov, ...pose }: CoverageScene) {
  const placed = meshes.map((mesh) => ({
    ...BLACK,
    position: ZERO,
    rotation: ZERO,
    scale: ONE,
    ...mesh,
  }));
  const cast = caster({ pose, fov, meshes: placed, lights: [], options: {} }, WIDTH, HEIGHT);
  let least = Infinity;
  for (let y = 0; y < HEIGHT; y++) {
    for (let x = 0; x < WIDTH; x++) {
      least = Math.min(least, cast(x, y)?.t ?? Infinity);
    }
  }
  return least;
}

const FRONT: Pose = { theta: 0, phi: 90, radius: 3, target: [0, 0, 0] };
/** Distance of the view's lower edge from its middle, at depth 1. */
const LOW = Math.tan(Math.PI / 8);

const plain = (geometry: BufferGeometry, z = 0) => {
  const mesh = new Mesh(geometry, new MeshBasicMaterial());
  mesh.position.z = z;
  return mesh;
};

/** A large box far away, so that the eye is inside the scene's sphere. */
function inside(...objects: Object3D[]) {
  const scene = new Scene();
  scene.add(plain(new BoxGeometry(100, 100, 100), -500), ...objects);
  return scene;
}

/** Where nothing is near. */
const USUAL = nearOf(inside(), FRONT);

describe('the near plane', () => {
  it('cuts nothing that is seen, in random rooms too (seeds from 1)', () => {
    const rooms = Array.from({ length: repeats(600) }, (_, i) => randomLowEye(i + 1));
    for (const scene of [...LOW_EYES, ...rooms]) {
      const { name, fov, ...pose } = scene;
      expect(nearOf(built(scene), pose, fov), name).toBeLessThanOrEqual(leastSeen(scene));
    }
  });

  it('lies just before the nearest point of a floor that is in view', () => {
    for (const height of [0.1, 1e-2, 1e-4]) {
      const floor = plain(new PlaneGeometry(300, 300).rotateX(-Math.PI / 2));
      floor.position.y = -height;
      const near = nearOf(inside(floor), FRONT);
      expect(near).toBeLessThanOrEqual(height / LOW);
      expect(near).toBeGreaterThan((0.85 * height) / LOW);
    }
  });

  it('stays where it is while what is near is out of view, behind the eye, hidden or seen edge-on', () => {
    const beside = plain(new BoxGeometry(1, 1, 1), 3);
    beside.position.x = 1;
    const behind = plain(new BoxGeometry(1, 1, 1), 3.6);
    const hidden = plain(new BoxGeometry(1, 1, 1), 3);
    hidden.visible = false;
    const edgeOn = plain(new PlaneGeometry(300, 300).rotateX(-Math.PI / 2));
    expect(nearOf(inside(beside, behind, hidden, edgeOn), FRONT)).toBe(USUAL);
    beside.position.x = 0.6;
    expect(nearOf(inside(beside, behind, hidden, edgeOn), FRONT)).toBeLessThan(USUAL);
  });

  it('is found from single triangles of a large geometry', async () => {
    const room = plain(await createGeometry('torus-knot', 256));
    room.scale.setScalar(20);
    const points = room.geometry.getAttribute('position');
    const at = new Vector3().fromBufferAttribute(points, 1000).multiplyScalar(20);
    const pose = { ...FRONT, target: [at.x, at.y, at.z - 3 + 0.01] as const };
    const near = nearOf(inside(room), pose);
    expect(near).toBeLessThanOrEqual(0.01);
    expect(near).toBeGreaterThan(1e-4);
    // The same with the code that skips triangles.
    await vi.dynamicImportSettled();
    expect(nearOf(inside(room), pose)).toBe(near);
  });

  it('never comes nearer than a float32 position relative to the target can tell from the eye', () => {
    const wall = plain(new PlaneGeometry(300, 300), 3 - 2e-6);
    expect(nearOf(inside(wall), FRONT)).toBeGreaterThan(3e-7);
  });

  it('is found from instances, lines, points and sprites one by one', () => {
    const instanced = new InstancedMesh(new BoxGeometry(1, 1, 1), new MeshBasicMaterial(), 2);
    instanced.setMatrixAt(0, new Matrix4().makeTranslation(0, 0, 2.4));
    instanced.setMatrixAt(1, new Matrix4().makeTranslation(0, 0, 9));
    const line = new BufferGeometry().setFromPoints([
      new Vector3(-50, 0, 2.9),
      new Vector3(50, 0, 2.9),
    ]);
    const points = new BufferGeometry().setFromPoints([
      new Vector3(0, 0, 2.9),
      new Vector3(50, 0, 2.99),
    ]);
    const sprite = new Sprite();
    sprite.position.z = 2.9;
    for (const object of [instanced, new LineSegments(line), new Points(points), sprite]) {
      expect(nearOf(inside(object), FRONT), object.type).toBeCloseTo(0.09, 6);
    }
  });

  it('lies 1e-5 of the radius before an eye inside an object whose vertices only its shader knows', () => {
    const waves = new Mesh(new PlaneGeometry(300, 300), new ShaderMaterial());
    const corner = Math.hypot(1, LOW, (LOW * WIDTH) / HEIGHT);
    expect(nearOf(inside(waves), FRONT)).toBeCloseTo((0.9 * 3e-5) / corner, 12);
  });
});
