// Which levels do the meshes of a picture show under `segments="auto"`: after moves, under other shadings, within a
// limit of triangles, and while a finer level is being built?
import { Scene } from 'three';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { basisOf } from '../../src/camera/orbit.js';
import { FieldStore } from '../../src/fields/field-store.js';
import { PhongLighting } from '../../src/material/lighting.js';
import { DEFAULT_STYLE } from '../../src/material/material-values.js';
import { Animations } from '../../src/scene/mesh/animation.js';
import { measure } from '../../src/scene/bounds.js';
import { Levels, type SharedLevels } from '../../src/scene/mesh/levels.js';
import { MESH_FIELDS, type MeshValues } from '../../src/scene/mesh/mesh-fields.js';
import { type MeshHost, SceneMesh } from '../../src/scene/mesh/scene-mesh.js';
import { trianglesOf } from '../../src/scene/mesh/shapes/shapes.js';
import { SharedMaterials } from '../../src/scene/mesh/shared-materials.js';
import { Budget } from '../../src/model/budget.js';

const pictures: Picture[] = [];

class Picture {
  readonly budget = new Budget();
  readonly materials = new SharedMaterials(new PhongLighting());
  readonly scene = new Scene();
  readonly meshes = new Set<SceneMesh>();
  readonly built = vi.fn(() => this.draw());
  readonly levels = new Levels(this.meshes, this.budget, this.materials, this.built);
  readonly failed = new Map<SceneMesh, unknown>();
  distance = 3;
  height = 400;
  atOnce = false;

  constructor() {
    pictures.push(this);
  }

  add(values: Partial<MeshValues> = {}) {
    const store = new FieldStore(MESH_FIELDS);
    const quiet = (): void => undefined;
    const host: MeshHost = {
      ...{ materials: this.materials, animations: new Animations(), budget: this.budget },
      ...{ crossOrigin: null, mayLoad: true, changing: quiet, changed: quiet, began: quiet },
      ...{ progress: quiet, removed: quiet },
      ...{ shown: () => false, dropped: (mesh) => void this.failed.delete(mesh) },
      reshaped: () => this.levels.changed(),
      ended: (mesh, _, error) => {
        if (error !== null) this.failed.set(mesh, error);
      },
    };
    const mesh = new SceneMesh(store, host);
    const set = (more: Partial<MeshValues>): void => {
      for (const [key, value] of Object.entries(more)) store.set(key as 'name', value);
      mesh.update();
    };
    mesh.attach(this.scene);
    this.meshes.add(mesh);
    set({ geometry: 'sphere', ...values });
    this.levels.changed();
    return { mesh, set };
  }

  draw(): void {
    this.scene.updateMatrixWorld();
    const { right, up, back } = basisOf({ theta: 0, phi: 90 });
    const slopeY = Math.tan(Math.PI / 8);
    const frame = { origin: [0, 0, 0] as const, eye: [0, 0, this.distance] as const, right, up, back };
    const view = { frame, slopeX: slopeY, slopeY, radius: this.distance };
    this.levels.choose(view, this.height, this.atOnce, this.distance, 0);
  }

  async settle(): Promise<void> {
    this.draw();
    await vi.waitFor(() => expect(this.levels.pending).toBe(false));
  }
}

afterEach(() => {
  for (const { meshes } of pictures.splice(0)) for (const mesh of meshes) mesh.dispose();
});

const shownTriangles = ({ parts }: SceneMesh): number => parts[0]!.mesh.geometry.index!.count / 3;

describe('the levels of a picture', () => {
  it('are those of its size and its camera, whatever was shown before', async () => {
    const picture = new Picture();
    const { mesh } = picture.add();
    const seen = new Map<number, number>();
    for (const distance of [3, 300, 1, 30, 0.501, 0.3, 0.501, 30, 1, 300, 3]) {
      picture.distance = distance;
      await picture.settle();
      expect(seen.get(distance) ?? mesh.level).toBe(mesh.level);
      seen.set(distance, mesh.level);
      expect(mesh.segments).toBe(mesh.level);
      expect(shownTriangles(mesh)).toBe(trianglesOf('sphere', mesh.level));
    }
    expect([...seen.values()]).toEqual([64, 16, 128, 24, 360, 96]); // from inside there is no outline
    picture.height = 4000;
    picture.distance = 3;
    await picture.settle();
    expect(mesh.level).toBe(192);
  });

  it('do not change the measure of the scene', async () => {
    const picture = new Picture();
    const { mesh } = picture.add({ geometry: 'cone', rotation: [20, 30, 40] });
    await vi.waitFor(() => expect(mesh.round).toBe('cone'));
    const measures = [];
    for (const distance of [100, 3, 0.8]) {
      picture.distance = distance;
      await picture.settle();
      const { center, radiusAbout } = measure(picture.scene);
      measures.push([center, radiusAbout(center)]);
    }
    expect(mesh.level).toBeGreaterThan(64);
    expect(measures[1]).toEqual(measures[0]);
    expect(measures[2]).toEqual(measures[0]);
  });

  it('are built in slices where they are fine, and a coarser one is shown meanwhile', async () => {
    const picture = new Picture();
    const { mesh } = picture.add();
    picture.distance = 0.55;
    picture.height = 2000;
    picture.draw();
    expect(mesh.level).toBe(256);
    expect(picture.levels.pending).toBe(true);
    await picture.settle();
    expect(mesh.level).toBe(360);
    expect(picture.built).toHaveBeenCalledTimes(1);
  });

  it('are built at once for a picture that is not shown', () => {
    const picture = new Picture();
    const { mesh } = picture.add();
    picture.distance = 0.55;
    picture.height = 2000;
    picture.atOnce = true;
    picture.draw();
    expect(mesh.level).toBe(360);
    expect(picture.levels.pending).toBe(false);
  });

  it('are not chosen again while nothing changes', () => {
    const picture = new Picture();
    const { mesh } = picture.add();
    picture.draw();
    const reads = vi.spyOn(mesh, 'round', 'get');
    picture.draw();
    expect(reads).not.toHaveBeenCalled();
    picture.distance = 4;
    picture.draw();
    expect(reads).toHaveBeenCalled();
  });

  it('leave out of view what it is, and give shapes with flat faces and written numbers none', async () => {
    const picture = new Picture();
    const { mesh, set } = picture.add({ position: [0, 0, 50] });
    const box = picture.add({ geometry: 'box' });
    const written = picture.add({ segments: 20 });
    await picture.settle();
    expect([mesh.level, box.mesh.segments, written.mesh.segments]).toEqual([16, 1, 20]);
    expect([box.mesh.round, written.mesh.round]).toEqual([null, null]);
    set({ position: [0, 0, 0] });
    await picture.settle();
    expect(mesh.level).toBe(64);
    written.set({ segments: 'auto' });
    await picture.settle();
    expect(written.mesh.segments).toBe(64);
  });
});

describe('the fixed number of segments', () => {
  it('is shown under Gouraud and flat shading, of the mesh or of the picture', async () => {
    const picture = new Picture();
    const { mesh, set } = picture.add();
    picture.height = 100;
    await picture.settle();
    const auto = mesh.segments!;
    expect(auto).toBeLessThan(64);
    for (const shading of ['gouraud', 'flat'] as const) {
      set({ shading });
      await picture.settle();
      expect(mesh.segments, shading).toBe(64);
      const corners =
        mesh.parts[0]!.mesh.geometry.index ?? mesh.parts[0]!.mesh.geometry.getAttribute('position');
      expect(corners.count).toBe(3 * 3968);
      set({ shading: 'phong' });
      await picture.settle();
      expect(mesh.segments, shading).toBe(auto);
    }
    set({ shading: null });
    picture.materials.style = { ...DEFAULT_STYLE, shading: 'flat' };
    mesh.restyle();
    picture.levels.changed();
    await picture.settle();
    expect(mesh.segments).toBe(64);
  });

  it('is shown by all pictures that are shared, if one of them needs it', async () => {
    const [a, b] = [new Picture(), new Picture()];
    const [first, second] = [a.add(), b.add()];
    const shared: SharedLevels = {
      get isFixed() {
        return a.levels.isFixed || b.levels.isFixed;
      },
      reshaded: vi.fn(),
    };
    a.height = b.height = 100;
    a.levels.shared = b.levels.shared = shared;
    await a.settle();
    expect(first.mesh.segments).toBeLessThan(64);
    expect(shared.reshaded).not.toHaveBeenCalled();
    second.set({ shading: 'gouraud' });
    expect(shared.reshaded).toHaveBeenCalledTimes(1);
    await a.settle();
    expect(first.mesh.segments).toBe(64);
    b.levels.shared = null;
    a.levels.shared = null;
    await a.settle();
    expect(first.mesh.segments).toBeLessThan(64);
  });
});

describe('the limit of triangles', () => {
  it('is kept by coarser levels, the same in any order, and the finer ones come back', async () => {
    const pictures = [
      [0.7, 1.4],
      [1.4, 0.7],
    ].map((sizes) => {
      const picture = new Picture();
      picture.budget.limit = 9000;
      picture.height = 1200;
      const meshes = sizes.map((size) => picture.add({ scale: [size, size, size] }).mesh);
      return { picture, meshes: size(meshes, sizes) };
    });
    const levels = [];
    for (const { picture, meshes } of pictures) {
      await picture.settle();
      const [small, large] = meshes;
      levels.push([small.level, large.level]);
      expect(trianglesOf('sphere', small.level) + trianglesOf('sphere', large.level)).toBeLessThanOrEqual(
        9000,
      );
      expect(picture.failed.size).toBe(0);
      picture.budget.limit = 100_000;
      await picture.settle();
      expect(large.level).toBeGreaterThan(levels[0]![1]!);
    }
    expect(levels[1]).toEqual(levels[0]);
  });

  it('leaves room for what is added later', async () => {
    const picture = new Picture();
    picture.budget.limit = 8000;
    const { mesh } = picture.add();
    await picture.settle();
    expect(mesh.level).toBe(64);
    const other = picture.add({ segments: 80 });
    await picture.settle();
    expect([other.mesh.segments, picture.failed.size]).toEqual([80, 0]);
    expect(mesh.level).toBe(32);
    other.mesh.dispose();
    picture.meshes.delete(other.mesh);
    await picture.settle();
    expect(mesh.level).toBe(64);
  });
});

/** The smaller one first. */
const size = (meshes: readonly SceneMesh[], sizes: readonly number[]): [SceneMesh, SceneMesh] =>
  sizes[0]! < sizes[1]! ? [meshes[0]!, meshes[1]!] : [meshes[1]!, meshes[0]!];
