// Is each mesh drawn with the lights that can reach it, and is culling repeated only where the result may have changed?

import { BoxGeometry, BufferGeometry, Matrix4, Mesh, Object3D, PlaneGeometry } from 'three';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import * as culling from '../../src/light/cull-lights.js';
import { HEADER } from '../../src/light/light-layout.js';
import type { LightValues } from '../../src/light/light-state.js';
import { packLights } from '../../src/light/pack-lights.js';
import type { Vec3 } from '../../src/math/vector.js';
import type { LightBuffer } from '../../src/material/light-buffer.js';
import { MeshLights } from '../../src/material/mesh-lights.js';
import { light } from './arbitraries.js';
import { FakeRenderer } from './fake-renderer.js';
import { read, WORLD } from './packed-reader.js';

vi.mock(import('../../src/light/cull-lights.js'), async (original) => {
  const module = await original();
  return { ...module, cullLights: vi.fn(module.cullLights) };
});

const culled = vi.mocked(culling.cullLights);
beforeEach(() => {
  culled.mockClear();
});

/** A unit box at x. */
function meshAt(x: number, geometry: BufferGeometry = new BoxGeometry()): Mesh {
  const mesh = new Mesh(geometry);
  moveTo(mesh, x);
  return mesh;
}

function moveTo(mesh: Object3D, x: number): void {
  mesh.position.x = x;
  mesh.updateMatrixWorld();
}

/** Straight down on x, as wide as a unit box. */
const spotOver = (x: number, values: Partial<LightValues> = {}): LightValues =>
  light({ position: [x, 3, 0, 1], axis: [0, -1, 0], aperture: 15, ...values });

function give(lights: MeshLights, ...list: LightValues[]): void {
  packLights(list, WORLD, lights.all.packed);
  lights.all.changed();
}

function lit(...list: LightValues[]): MeshLights {
  const lights = new MeshLights();
  lights.begin([0, 0, 0]);
  give(lights, ...list);
  return lights;
}

const spotsOf = ({ packed }: LightBuffer): number[] =>
  read(packed).spot.map((one) => one['position']!.xyz[0]);

describe('a mesh', () => {
  it('is drawn with the spots that reach it and with all other lights', () => {
    const lights = lit(spotOver(0), light(), spotOver(5), light({ position: [9, 9, 9, 1] }));
    const mesh = meshAt(5);
    const buffer = lights.of(mesh);
    expect(spotsOf(buffer)).toStrictEqual([5]);
    expect(read(buffer.packed).counts).toStrictEqual([1, 1, 1]);
    expect([0, 1, 2, 3].map((i) => lights.reaches(mesh, i))).toStrictEqual([true, true, false, true]);
  });

  it('shares a buffer with all meshes that the same lights reach', () => {
    const lights = lit(spotOver(0), spotOver(5), light());
    expect(lights.of(meshAt(2.5, new BoxGeometry(9, 1, 1)))).toBe(lights.all);
    const [a, b, c] = [meshAt(5), meshAt(5.1), meshAt(0)].map((mesh) => lights.of(mesh));
    expect(a).toBe(b);
    expect(a).not.toBe(c);
    expect(spotsOf(c!)).toStrictEqual([0]);
  });

  it('is culled by its bounds after rotation, scale and translation, relative to the origin', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const parent = new Object3D();
    const mesh = new Mesh(new BoxGeometry(0.1, 9, 0.1));
    parent.add(mesh);
    const reached = (origin: Vec3 = [0, 0, 0]): number[] => {
      parent.updateMatrixWorld();
      lights.begin(origin);
      return spotsOf(lights.of(mesh));
    };
    expect(reached()).toStrictEqual([0]);
    mesh.rotation.z = Math.PI / 2;
    mesh.scale.y = 0.9;
    expect(reached()).toStrictEqual([0]); // 4.05 to each side; the next cone is 0.8 wide there
    mesh.scale.y = 1;
    expect(reached()).toStrictEqual([0, 5]);
    parent.position.x = 50;
    expect(reached()).toStrictEqual([]);
    expect(reached([50, 0, 0])).toStrictEqual([0, 5]);
    mesh.scale.y = 0.2;
    expect(reached([50, 0, 0])).toStrictEqual([0]);
    mesh.scale.y = -0.9;
    expect(reached([45, 0, 0])).toStrictEqual([5]);
  });

  it.each<[string, () => Mesh]>([
    ['without vertices', () => meshAt(0, new BufferGeometry())],
    ['at NaN', () => meshAt(NaN)],
    ['at infinity', () => meshAt(Infinity)],
  ])('%s is drawn with all lights', (_, make) => {
    const lights = lit(spotOver(99), light());
    const warned = vi.spyOn(console, 'error').mockReturnValue();
    expect(lights.of(make())).toBe(lights.all);
    warned.mockRestore();
  });
});

describe('culling', () => {
  it('is done once while nothing changes, and never without spots', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const mesh = meshAt(5);
    const buffer = lights.of(mesh);
    for (let frame = 0; frame < 5; frame++) {
      lights.begin([0, 0, 0]);
      mesh.updateMatrixWorld(true);
      expect(lights.of(mesh)).toBe(buffer);
      expect(lights.gridOf(mesh)).toBeNull();
    }
    expect(culled).toHaveBeenCalledTimes(1);
    const plain = meshAt(0);
    const without = lit(light(), light({ position: [9, 9, 9, 1] }));
    expect(without.of(plain)).toBe(without.all);
    expect(plain.geometry.boundingBox).toBeNull();
    expect(culled).toHaveBeenCalledTimes(1);
  });

  it.each<[string, (lights: MeshLights, mesh: Mesh) => void]>([
    ['the mesh moves', (_, mesh) => moveTo(mesh, 1)],
    ['the mesh has another geometry', (_, mesh) => (mesh.geometry = new BoxGeometry(2, 2, 2))],
    ['the origin moves', (lights) => lights.begin([1, 0, 0])],
    ['the lights change', (lights) => give(lights, spotOver(0), spotOver(6))],
  ])('happens once more where %s', (_, change) => {
    const lights = lit(spotOver(0), spotOver(5));
    const mesh = meshAt(5);
    lights.of(mesh);
    culled.mockClear();
    change(lights, mesh);
    lights.of(mesh);
    lights.of(mesh);
    expect(culled).toHaveBeenCalledTimes(1);
  });

  it('does not happen again for lights that are packed with the same numbers', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const mesh = meshAt(5);
    lights.of(mesh);
    culled.mockClear();
    give(lights, spotOver(0), spotOver(5));
    lights.of(mesh);
    expect(culled).not.toHaveBeenCalled();
  });

  it('compares no matrix while the scene says that no mesh has moved', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const mesh = meshAt(5);
    const equals = vi.spyOn(Matrix4.prototype, 'equals');
    for (const places of [1, 1, 1, 2]) {
      lights.places = places;
      lights.begin([0, 0, 0]);
      expect(spotsOf(lights.of(mesh))).toStrictEqual([5]);
    }
    expect(equals).toHaveBeenCalledTimes(1);
    moveTo(mesh, 0);
    lights.places = 3;
    expect(spotsOf(lights.of(mesh))).toStrictEqual([0]);
  });

  it('keeps the buffer when a spot moves, and updates its numbers and features', () => {
    const lights = lit(spotOver(0), spotOver(5));
    const mesh = meshAt(5);
    const buffer = lights.of(mesh);
    const { revision, featureKey } = buffer;
    give(lights, spotOver(0), spotOver(5.1));
    expect(lights.of(mesh)).toBe(buffer);
    expect(spotsOf(buffer)[0]).toBeCloseTo(5.1, 6);
    expect(buffer.revision).toBeGreaterThan(revision);
    expect(buffer.featureKey).toBe(featureKey);
  });

  it('removes a spot that moves away from a mesh that all lights reached', () => {
    const lights = lit(spotOver(0));
    const mesh = meshAt(0);
    expect(lights.of(mesh)).toBe(lights.all);
    give(lights, spotOver(5));
    expect(spotsOf(lights.of(mesh))).toStrictEqual([]);
  });
});

describe('what the GPU holds', () => {
  /** Draws these meshes in a frame and returns the number of textures then. */
  function frame(lights: MeshLights, gpu: FakeRenderer, meshes: readonly Mesh[]): number {
    lights.begin([0, 0, 0]);
    for (const mesh of meshes) (lights.gridOf(mesh) ?? lights.of(mesh)).sendTexture(gpu.renderer);
    return gpu.textures;
  }

  it('is freed in the frame after its last use', () => {
    const gpu = new FakeRenderer();
    const lights = lit(...Array.from({ length: 20 }, (_, i) => spotOver(2 * i)));
    const mesh = meshAt(0);
    for (let x = 0; x < 40; x += 0.5) {
      moveTo(mesh, x);
      expect(frame(lights, gpu, [mesh])).toBeLessThanOrEqual(2);
    }
    frame(lights, gpu, []);
    expect(frame(lights, gpu, [])).toBe(0);
    expect(frame(lights, gpu, [mesh])).toBe(1);
  });

  /** Many narrow spots on a floor. */
  const overFloor = (): { lights: MeshLights; floor: Mesh } => {
    const floor = meshAt(0, new PlaneGeometry(20, 20).rotateX(-Math.PI / 2));
    const place = (i: number): number => 3 * i - 7.5;
    const spots = Array.from({ length: 36 }, (_, i) =>
      spotOver(place(i % 6), { position: [place(i % 6), 2, place(Math.floor(i / 6)), 1] }),
    );
    return { lights: lit(...spots), floor };
  };

  it('includes a grid for a mesh under many narrow spots, with the same lights', () => {
    const { lights, floor } = overFloor();
    const grid = lights.gridOf(floor)!;
    expect(grid.packed.counts).toStrictEqual(lights.of(floor).packed.counts);
    expect(grid.packed.data[HEADER.counts * 4 + 3]).toBeGreaterThan(0);
    expect(lights.gridOf(floor)).toBe(grid);
    give(lights, spotOver(0));
    expect(lights.gridOf(floor)).toBeNull();
  });

  it('loses a grid when its mesh is no longer drawn', () => {
    const gpu = new FakeRenderer();
    const { lights, floor } = overFloor();
    expect(frame(lights, gpu, [floor])).toBe(1);
    expect(frame(lights, gpu, [floor])).toBe(1);
    frame(lights, gpu, []);
    expect(frame(lights, gpu, [])).toBe(0);
    expect(frame(lights, gpu, [floor])).toBe(1);
  });

  it('is freed by disposal, grids included, and sent again with the next draw', () => {
    const gpu = new FakeRenderer();
    const { lights, floor } = overFloor();
    const small = meshAt(-7.5);
    const before = frame(lights, gpu, [floor, small]);
    lights.dispose();
    expect(gpu.textures).toBe(0);
    expect(frame(lights, gpu, [floor, small])).toBe(before);
  });
});
