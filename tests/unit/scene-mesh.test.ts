// What happens to a mesh without memory for its content, and with thousands of materials?
import { BoxGeometry, Matrix4, Scene } from 'three';
import { expect, it, vi } from 'vitest';
import { PLAIN_LOOK } from '../../src/material/file-surface.js';
import type { Content } from '../../src/model/model.js';
import { meshHost, meshOf } from './scene-host.js';

/** A content of as many parts, which look different. */
const content = (parts: number) => ({
  parts: Array.from({ length: parts }, (_, i) => ({
    ...{
      name: '',
      geometry: new BoxGeometry(),
      matrix: new Matrix4(),
      surface: {},
      sides: 'single' as const,
    },
    look: { ...PLAIN_LOOK, opacity: 1 - i / parts },
  })),
  motion: null,
  dispose: vi.fn<Content['dispose']>(),
});

const url = new URL('https://shop.example/a.glb');

it.each([1, 2])('without memory for material %i of its content, keeps what it shows and its load fails', (nth) => {
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
});

it('makes the materials of 2,000 looks before the model arrives, in more than one task', async () => {
  const host = meshHost();
  const { materials } = host.picture;
  const { mesh } = meshOf(host, new Scene());
  let tasks = 0;
  const counting = setInterval(() => (tasks += 1));
  let made = 0;
  const acquire = materials.acquire.bind(materials);
  vi.spyOn(materials, 'acquire').mockImplementation((appearance) => {
    // As slow as on a phone.
    for (const end = performance.now() + 0.05; performance.now() < end;);
    made += 1;
    return acquire(appearance);
  });
  const model = content(2000);
  await mesh.prepare(model, new AbortController().signal);
  clearInterval(counting);
  expect(made).toBe(2000);
  expect(tasks).toBeGreaterThan(2);
  const release = vi.spyOn(materials, 'release');
  mesh.arrived(model, host.picture.budget.claim(mesh), url, true);
  expect(release).toHaveBeenCalledTimes(2000);
  mesh.dispose();
  expect(release).toHaveBeenCalledTimes(4000);
});
