// Are back faces culled exactly where they cannot be seen?

import type { Vec3 } from '../../../src/phong/math/vector.js';
import {
  BoxGeometry,
  BufferGeometry,
  Euler,
  Matrix4,
  OrthographicCamera,
  PerspectiveCamera,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';
import { describe, expect, it } from 'vitest';
import { cullsBackFaces, type Sides } from '../../../src/phong/material/back-faces.js';

const sphere = new SphereGeometry(0.5, 16, 8);
const box = new BoxGeometry();

const place = ({
  position = [0, 0, 0],
  rotation = [0, 0, 0],
  scale = [1, 1, 1],
}: Partial<Record<'position' | 'rotation' | 'scale', Vec3>> = {}) =>
  new Matrix4().compose(
    new Vector3(...position),
    new Quaternion().setFromEuler(new Euler(...rotation)),
    new Vector3(...scale),
  );

/** Looks along −z from z. */
function eyeAt(z: number, near = 0.1) {
  const camera = new PerspectiveCamera(45, 1, near, 100);
  camera.position.z = z;
  camera.updateMatrixWorld();
  return camera;
}

const culls = (
  sides: Sides,
  matrix = place(),
  camera = eyeAt(5),
  geometry: BufferGeometry = sphere,
) => cullsBackFaces(sides, geometry, matrix, camera);

describe('back faces of a closed shape', () => {
  it.each([
    ['outside', 5, 0.1, true],
    ['inside', 0.4, 0.1, false],
    ['in its middle', 0, 0.1, false],
    ['outside, with all of the near plane', 0.7, 0.1, true],
    ['outside, with a near plane that may be inside', 0.7, 0.25, false],
  ])('seen from %s (%d, near %d) are culled: %s', (_, z, near, culled) => {
    const camera = eyeAt(z, near);
    expect(culls('closed', place(), camera)).toBe(culled);
    // A projection matrix that is multiplied by a number is the same projection.
    camera.projectionMatrix.multiplyScalar(2 ** -40);
    expect(culls('closed', place(), camera)).toBe(culled);
  });

  it('are culled beside the eye as far as the distance to the corners of the near plane decides', () => {
    const [camera, scaled] = [eyeAt(0), eyeAt(0)];
    scaled.projectionMatrix.multiplyScalar(2 ** -40);
    for (const eye of [camera, scaled]) {
      expect(culls('closed', place({ position: [0.7, 0, 0] }), eye, box)).toBe(true);
      expect(culls('closed', place({ position: [0.55, 0, 0] }), eye, box)).toBe(false);
    }
  });

  it('are culled where the near plane cuts the box of a sphere but not the sphere', () => {
    const camera = eyeAt(0.7, 0.19);
    expect(culls('closed', place(), camera)).toBe(true);
    const turned = place({ rotation: [0.5, 0.6, 0.7] });
    expect(culls('closed', turned, camera)).toBe(true);
    expect(culls('closed', turned, camera, box)).toBe(false);
  });

  it('are culled beside each side of a long, turned box, and drawn in it', () => {
    const matrix = place({ position: [0, 0, 1], rotation: [0, Math.PI / 4, 0], scale: [20, 1, 1] });
    expect(culls('closed', matrix, eyeAt(2), box)).toBe(true);
    expect(culls('closed', matrix, eyeAt(1.2), box)).toBe(false);
    expect(culls('closed', place({ scale: [20, 1, 1] }), eyeAt(2), box)).toBe(true);
  });

  it.each([1e-9, 1e9])('are culled at any scale: %d', (size) => {
    const matrix = place({ scale: [size, size, size] });
    expect(culls('closed', matrix, eyeAt(5 * size, 0.1 * size))).toBe(true);
    expect(culls('closed', matrix, eyeAt(0, 0.1 * size))).toBe(false);
  });

  it.each([
    [5, true],
    [0.55, false],
  ])('are culled by an orthographic camera at %d, whose near plane is outside: %s', (z, culled) => {
    const camera = new OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
    camera.position.z = z;
    camera.updateMatrixWorld();
    expect(culls('closed', place(), camera as never)).toBe(culled);
  });

  it('are drawn where there are no bounds', () => {
    expect(culls('closed', place(), eyeAt(5), new BufferGeometry().setFromPoints([]))).toBe(false);
  });
});

describe('back faces', () => {
  it('of a single-sided surface are always culled, and of a double-sided one never', () => {
    for (const z of [0, 0.4, 5]) {
      expect(culls('single', place(), eyeAt(z))).toBe(true);
      expect(culls('double', place(), eyeAt(z))).toBe(false);
    }
  });

  it.each<[Vec3, boolean]>([
    [[-1, 1, 1], true],
    [[-1, -1, -1], true],
    [[1e-6, 1, 1], true],
    [[0, 1, 1], false],
    [[1, 0, 1], false],
    [[0, 0, 0], false],
  ])('at scale %j are culled: %s', (scale, expected) => {
    expect(culls('closed', place({ scale }))).toBe(expected);
    expect(culls('single', place({ scale }))).toBe(expected);
    expect(culls('single', place({ scale, rotation: [1, 2, 3] }))).toBe(expected);
  });
});
