// What happens to a mesh when there is no memory to show its content?
import { BoxGeometry, Matrix4, Scene } from 'three';
import { describe, expect, it, vi } from 'vitest';
import { FieldStore } from '../../src/fields/field-store.js';
import { PhongLighting } from '../../src/material/lighting.js';
import { PLAIN_LOOK } from '../../src/material/file-surface.js';
import type { Content } from '../../src/model/model.js';
import { SHAPE_FIELDS } from '../../src/scene/mesh/mesh-fields.js';
import { type MeshHost, SceneMesh } from '../../src/scene/mesh/scene-mesh.js';
import { Budget } from '../../src/model/budget.js';
import { SharedMaterials } from '../../src/scene/mesh/shared-materials.js';

const noMemory = (): never => {
  throw new RangeError('Array buffer allocation failed');
};

/** A content of two parts that look different. */
function content(red: number) {
  const dispose = vi.fn();
  const parts: Content['parts'] = [0, 1].map((i) => ({
    name: '',
    geometry: new BoxGeometry(),
    matrix: new Matrix4(),
    look: { ...PLAIN_LOOK, opacity: 1 - i / 2 },
    sides: 'single',
    surface: { ka: [red, i, 0] },
  }));
  return { parts, motion: null, dispose };
}

function setUp() {
  const materials = new SharedMaterials(new PhongLighting());
  const ended = vi.fn();
  const host: MeshHost = {
    ...{ materials, ended, animations: new Set() as unknown as MeshHost['animations'] },
    ...{ crossOrigin: null, mayLoad: true, began: vi.fn(), progress: vi.fn(), dropped: vi.fn() },
    budget: new Budget(),
    ...{ changed: vi.fn(), reshaped: vi.fn(), moved: vi.fn(), shown: () => false, removed: vi.fn() },
  };
  const state = new FieldStore(SHAPE_FIELDS);
  const mesh = new SceneMesh(state, host);
  const scene = new Scene();
  mesh.attach(scene);
  return { materials, ended, host, state, mesh, scene };
}

const url = new URL('https://shop.example/a.glb');

describe('a mesh without memory', () => {
  it.each([1, 2])('for material %i of its content keeps what it shows, and its load fails', (nth) => {
    const { materials, ended, host, mesh, scene } = setUp();
    const [first, second] = [content(1), content(2)];
    mesh.arrived(first, host.budget.claim(mesh), url, true);
    expect(ended).toHaveBeenLastCalledWith(mesh, url, null);
    const [shown, ...others] = scene.children;
    expect(others).toEqual([]);
    const acquire = materials.acquire.bind(materials);
    let calls = 0;
    const release = vi.spyOn(materials, 'release');
    vi.spyOn(materials, 'acquire').mockImplementation((appearance) =>
      ++calls === nth ? noMemory() : acquire(appearance),
    );
    mesh.arrived(second, host.budget.claim(mesh), url, true);
    expect(ended).toHaveBeenLastCalledWith(mesh, url, expect.any(RangeError));
    expect(scene.children).toEqual([shown]);
    expect(release).toHaveBeenCalledTimes(nth - 1);
    expect(second.dispose).toHaveBeenCalledTimes(1);
    expect(first.dispose).not.toHaveBeenCalled();
  });
});

describe('a model with thousands of looks', () => {
  const parts = Array.from({ length: 2000 }, (_, i) => ({
    name: '',
    geometry: new BoxGeometry(),
    matrix: new Matrix4(),
    look: { ...PLAIN_LOOK, opacity: i / 2000 },
    sides: 'single' as const,
    surface: {},
  }));
  const model = (): Content => ({ parts, motion: null, dispose: vi.fn() });
  const never = new AbortController().signal;

  it('finds its materials made when it arrives, in more than one task', async () => {
    const { materials, host, mesh } = setUp();
    let tasks = 0;
    const counting = setInterval(() => (tasks += 1));
    let made = 0;
    const original = materials.acquire.bind(materials);
    vi.spyOn(materials, 'acquire').mockImplementation((appearance) => {
      // As slow as on a phone.
      for (const end = performance.now() + 0.05; performance.now() < end;);
      made += 1;
      return original(appearance);
    });
    await mesh.prepare(model(), never);
    clearInterval(counting);
    expect(made).toBe(parts.length);
    expect(tasks).toBeGreaterThan(2);
    const release = vi.spyOn(materials, 'release');
    mesh.arrived(model(), host.budget.claim(mesh), url, true);
    expect(release).toHaveBeenCalledTimes(parts.length);
    mesh.dispose();
    expect(release).toHaveBeenCalledTimes(2 * parts.length);
  });
});
