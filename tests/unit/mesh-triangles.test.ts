// Do meshes claim the triangles of what they show, and free what they no longer show?
import { type BufferGeometry, Scene } from 'three';
import { describe, expect, it, vi } from 'vitest';
import { FieldStore } from '../../src/fields/field-store.js';
import { PhongLighting } from '../../src/material/lighting.js';
import { Animations } from '../../src/scene/mesh/animation.js';
import { MESH_FIELDS } from '../../src/scene/mesh/mesh-fields.js';
import { type MeshHost, SceneMesh } from '../../src/scene/mesh/scene-mesh.js';
import { SharedMaterials } from '../../src/scene/mesh/shared-materials.js';
import { Budget } from '../../src/model/budget.js';

/** A sphere of 64 segments, and its flat copy. */
const SMOOTH = 3968;
const FLAT = 13_605;

function setUp(limit: number) {
  const budget = new Budget();
  budget.limit = limit;
  const failed = new Map<SceneMesh, string>();
  const quiet = (): void => undefined;
  const host: MeshHost = {
    ...{ materials: new SharedMaterials(new PhongLighting()), animations: new Animations(), budget },
    ...{
      crossOrigin: null,
      mayLoad: true,
      changed: quiet,
      reshaped: quiet,
      moved: quiet,
      began: quiet,
      progress: quiet,
    },
    ...{ shown: () => false, removed: quiet },
    ended: (mesh, _, error) => error !== null && failed.set(mesh, (error as { code: string }).code),
    dropped: (mesh) => failed.delete(mesh),
  };
  const scene = new Scene();
  const add = (segments: number, shading: 'flat' | 'phong') => {
    const store = new FieldStore(MESH_FIELDS);
    store.set('geometry', 'sphere');
    store.set('segments', segments);
    store.set('shading', shading);
    const mesh = new SceneMesh(store, host);
    mesh.attach(scene);
    mesh.update();
    const set = (values: { segments?: number; shading?: 'flat' | 'phong' }): void => {
      for (const [key, value] of Object.entries(values)) store.set(key as 'segments', value);
      mesh.update();
    };
    const geometry = (): BufferGeometry | undefined => mesh.parts[0]?.mesh.geometry;
    return { mesh, set, geometry };
  };
  return { budget, failed, add };
}

describe('a mesh', () => {
  it('shares shape and flat copy with equal meshes, and gives both back', () => {
    const { budget, add } = setUp(20_000);
    const meshes = Array.from({ length: 50 }, () => add(64, 'flat'));
    expect(budget.used).toBe(SMOOTH + FLAT);
    expect(new Set(meshes.map(({ geometry }) => geometry())).size).toBe(1);
    for (const { mesh } of meshes) mesh.dispose();
    expect(budget.used).toBe(0);
  });

  it('frees the flat copy with its last user', () => {
    const { budget, add } = setUp(20_000);
    const [a, b] = [add(64, 'flat'), add(64, 'flat')];
    const disposed = vi.fn();
    a.geometry()!.addEventListener('dispose', disposed);
    a.set({ shading: 'phong' });
    expect(budget.used).toBe(SMOOTH + FLAT);
    expect(disposed).not.toHaveBeenCalled();
    b.set({ shading: 'phong' });
    expect(budget.used).toBe(SMOOTH);
    expect(disposed).toHaveBeenCalledOnce();
    b.set({ shading: 'flat' });
    expect(b.geometry()!.index).toBeNull();
    expect(budget.used).toBe(SMOOTH + FLAT);
  });

  it('is not built past the limit, and is shown on request once another one is gone', () => {
    const { budget, failed, add } = setUp(6000);
    const a = add(64, 'phong');
    const b = add(66, 'phong');
    expect(b.mesh.root).toBeNull();
    expect(failed.get(b.mesh)).toBe('too-large');
    expect(budget.used).toBe(SMOOTH);
    a.mesh.dispose();
    b.mesh.retry();
    b.mesh.update();
    expect(b.mesh.root).not.toBeNull();
    expect(failed.size).toBe(0);
  });

  it('keeps what it shows where the next is too large, and may take the room of what it replaces', () => {
    const { budget, failed, add } = setUp(5000);
    const { mesh, set, geometry } = add(64, 'phong');
    const before = geometry();
    set({ segments: 512 });
    expect(failed.get(mesh)).toBe('too-large');
    expect(geometry()).toBe(before);
    set({ segments: 66 });
    expect(failed.size).toBe(0);
    expect(geometry()).not.toBe(before);
    expect(budget.used).toBe(4224);
  });

  it('keeps its shading where a flat copy is too large, and takes it on request once there is room', () => {
    const { failed, add } = setUp(25_000);
    const a = add(66, 'flat');
    const b = add(64, 'phong');
    b.set({ shading: 'flat' });
    expect(failed.get(b.mesh)).toBe('too-large');
    expect(b.geometry()!.index).not.toBeNull();
    a.set({ shading: 'phong' });
    b.mesh.retry();
    b.mesh.update();
    expect(b.geometry()!.index).toBeNull();
    expect(failed.size).toBe(0);
  });

  it('that was refused as flat is shown once another shading is wanted', () => {
    const { failed, add } = setUp(10_000);
    const { mesh, set } = add(64, 'flat');
    expect(mesh.root).toBeNull();
    set({ shading: 'phong' });
    expect(mesh.root).not.toBeNull();
    expect(failed.size).toBe(0);
  });
});
