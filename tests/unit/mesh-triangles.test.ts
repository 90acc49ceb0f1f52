// Do meshes claim the triangles of what they show, and free what they no longer show?
import { type BufferGeometry, Scene } from 'three';
import { describe, expect, it, vi } from 'vitest';
import type { MeshValues } from '../../src/scene/mesh/mesh-fields.js';
import type { SceneMesh } from '../../src/scene/mesh/scene-mesh.js';
import { meshHost, meshOf } from './scene-host.js';

/** A sphere of 64 segments, and its flat copy. */
const SMOOTH = 3968;
const FLAT = 13_605;

function setUp(limit: number) {
  const failed = new Map<SceneMesh, string>();
  const host = meshHost({
    ended: (mesh, _, error) => error !== null && failed.set(mesh, (error as { code: string }).code),
    dropped: (mesh) => failed.delete(mesh),
  });
  const { budget } = host.picture;
  budget.limit = limit;
  const scene = new Scene();
  const add = (segments: number, shading: MeshValues['shading']) => {
    const made = meshOf(host, scene, { geometry: 'sphere', segments, shading });
    return { ...made, geometry: (): BufferGeometry | undefined => made.mesh.parts[0]?.mesh.geometry };
  };
  return { budget, failed, add };
}

describe('a mesh', () => {
  it('shares shape and flat copy with equal meshes, and frees each with its last user', () => {
    const { budget, add } = setUp(20_000);
    const meshes = Array.from({ length: 50 }, () => add(64, 'flat'));
    const [a, b] = meshes as [(typeof meshes)[0], (typeof meshes)[0]];
    expect(budget.used).toBe(SMOOTH + FLAT);
    expect(new Set(meshes.map(({ geometry }) => geometry())).size).toBe(1);
    const disposed = vi.fn();
    a.geometry()!.addEventListener('dispose', disposed);
    for (const { mesh } of meshes.slice(2)) mesh.dispose();
    a.set({ shading: 'phong' });
    expect(budget.used).toBe(SMOOTH + FLAT);
    expect(disposed).not.toHaveBeenCalled();
    b.set({ shading: 'phong' });
    expect(budget.used).toBe(SMOOTH);
    expect(disposed).toHaveBeenCalledOnce();
    b.set({ shading: 'flat' });
    expect(b.geometry()!.index).toBeNull();
    expect(budget.used).toBe(SMOOTH + FLAT);
    for (const { mesh } of [a, b]) mesh.dispose();
    expect(budget.used).toBe(0);
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
