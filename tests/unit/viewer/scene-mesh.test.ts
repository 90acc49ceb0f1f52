// Do meshes claim the triangles of what they show and free what they no longer show? What happens
// without memory, and with thousands of materials? In which order are a scene's objects drawn?
import { Mesh, Scene } from 'three';
import { describe, expect, it, vi } from 'vitest';
import type { MeshValues } from '../../../src/phong/model/mesh-fields.js';
import type { SceneMesh } from '../../../src/viewer/scene/mesh/scene-mesh.js';
import { content, meshHost, meshOf } from '../scene-host.js';

const url = new URL('https://shop.example/a.glb');

it.each([1, 2])(
  'without memory for material %i of its content, keeps what it shows and its load fails',
  (nth) => {
    const ended = vi.fn();
    const host = meshHost({ ended });
    const scene = new Scene();
    const { mesh } = meshOf(host, scene);
    const [first, second] = [content(2), content(2)];
    mesh.arrived(first, host.picture.budget.claim(mesh), url, true);
    expect(ended).toHaveBeenLastCalledWith(mesh, url, null);
    const [shown, ...others] = scene.children;
    expect(others).toEqual([]);
    const acquire = host.picture.materials.acquire.bind(host.picture.materials);
    let calls = 0;
    const release = vi.spyOn(host.picture.materials, 'release');
    vi.spyOn(host.picture.materials, 'acquire').mockImplementation((appearance) => {
      if (++calls === nth) throw new RangeError('Array buffer allocation failed');
      return acquire(appearance);
    });
    mesh.arrived(second, host.picture.budget.claim(mesh), url, true);
    expect(ended).toHaveBeenLastCalledWith(mesh, url, expect.any(RangeError));
    expect(scene.children).toEqual([shown]);
    expect(release).toHaveBeenCalledTimes(nth - 1);
    expect(second.dispose).toHaveBeenCalledTimes(1);
    expect(first.dispose).not.toHaveBeenCalled();
  },
);

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
    return {
      ...made,
      geometry: () => made.mesh.shown.parts[0]?.mesh.geometry,
    };
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
    for (const { mesh } of meshes.slice(2)) {
      mesh.dispose();
    }
    a.set({ shading: 'phong' });
    expect(budget.used).toBe(SMOOTH + FLAT);
    expect(disposed).not.toHaveBeenCalled();
    b.set({ shading: 'phong' });
    expect(budget.used).toBe(SMOOTH);
    expect(disposed).toHaveBeenCalledOnce();
    b.set({ shading: 'flat' });
    expect(b.geometry()!.index).toBeNull();
    expect(budget.used).toBe(SMOOTH + FLAT);
    for (const { mesh } of [a, b]) {
      mesh.dispose();
    }
    expect(budget.used).toBe(0);
  });

  it('is not built past the limit, and is shown on request once another one is gone', () => {
    const { budget, failed, add } = setUp(6000);
    const a = add(64, 'phong');
    const b = add(66, 'phong');
    expect(b.mesh.shown.root).toBeNull();
    expect(failed.get(b.mesh)).toBe('too-large');
    expect(budget.used).toBe(SMOOTH);
    a.mesh.dispose();
    b.mesh.retry();
    b.mesh.update();
    expect(b.mesh.shown.root).not.toBeNull();
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
    const c = add(12, 'phong');
    c.set({ segments: 64, shading: 'flat' });
    expect(failed.get(c.mesh)).toBe('too-large');
    c.mesh.dispose();
    expect(failed.has(c.mesh), 'a removed mesh').toBe(false);
    a.set({ shading: 'phong' });
    b.mesh.retry();
    b.mesh.update();
    expect(b.geometry()!.index).toBeNull();
    expect(failed.size).toBe(0);
  });
});

it('is measured alone when it moves', () => {
  const host = meshHost();
  const { picture } = host;
  const still = meshOf(host, picture.scene, { geometry: 'box' });
  const moving = meshOf(host, picture.scene, { geometry: 'box' });
  picture.measure();
  const visits = vi.fn();
  Object.defineProperty(still.mesh.shown.root, 'visible', { get: visits });
  moving.set({ position: [4, 0, 0] });
  expect(picture.measure()!.center[0]).toBe(2);
  expect(visits).not.toHaveBeenCalled();
});

it('draws meshes in document order, whenever added or changed, and own objects last, but none that is removed', () => {
  const host = meshHost();
  const { picture } = host;
  const meshes = ['0', '1', '2'].map((name) => {
    const one = meshOf(host, picture.scene, { geometry: 'box', name });
    picture.add(one.mesh);
    return one;
  });
  const [first, second, third] = meshes.map(({ mesh }) => mesh);
  const own = new Mesh();
  own.name = 'own';
  picture.scene.children.unshift(own);
  own.parent = picture.scene;
  const names = () => {
    picture.updateMatrices();
    return picture.scene.children.map(({ name }) => name).join(' ');
  };
  expect(names()).toBe('0 1 2 own');
  picture.arrange([third!, first!]); // 1 is no child, as a viewer's own mesh
  expect(names()).toBe('1 2 0 own');
  meshes[2]!.set({ geometry: 'sphere' });
  expect(names()).toBe('1 2 0 own');
  picture.remove(third!);
  expect(names()).toBe('1 0 own');
  picture.scene.remove(second!.shown.root!);
  expect(names()).toBe('0 own');
});
