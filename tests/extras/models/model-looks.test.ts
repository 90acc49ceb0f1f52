// Are the materials of a model with many looks made in slices?
import { Scene } from 'three';
import { expect, it, vi } from 'vitest';
import { content, meshHost, meshOf } from '../../unit/scene-host.js';

it('makes the materials of 400 looks before the model arrives, in more than one task', async () => {
  const host = meshHost();
  const { materials } = host.picture;
  const { mesh } = meshOf(host, new Scene());
  let tasks = 0;
  const counting = setInterval(() => (tasks += 1));
  let made = 0;
  const acquire = materials.acquire.bind(materials);
  vi.spyOn(materials, 'acquire').mockImplementation((appearance) => {
    // As slow as on a phone.
    for (const end = performance.now() + 0.25; performance.now() < end;) {}
    made += 1;
    return acquire(appearance);
  });
  const model = content(400);
  await mesh.prepare(model, new AbortController().signal);
  clearInterval(counting);
  expect(made).toBe(400);
  expect(tasks).toBeGreaterThan(2);
  const release = vi.spyOn(materials, 'release');
  mesh.arrived(model, host.picture.budget.claim(mesh), new URL('https://shop.example/a.glb'), true);
  expect(release).toHaveBeenCalledTimes(400);
  mesh.dispose();
  expect(release).toHaveBeenCalledTimes(800);
});
