// Which meshes share a material, and what happens to it when its users change?

import { Texture } from 'three';
import { describe, expect, it, vi } from 'vitest';
import { PhongLighting } from '../../src/material/lighting.js';
import { PLAIN_LOOK } from '../../src/material/file-surface.js';
import { DEFAULT_STYLE } from '../../src/material/material-values.js';
import { type Appearance, SharedMaterials } from '../../src/scene/mesh/shared-materials.js';

const surface: Appearance['surface'] = { ka: [255, 0, 0], kd: [9, 9, 9], ks: [0, 0, 0], shininess: 4 };
const plain: Appearance = { look: PLAIN_LOOK, sides: 'closed', surface, shading: null, reflection: null };
const shiny: Appearance = { ...plain, surface: { ...surface, shininess: 100 } };

const materials = (): SharedMaterials => new SharedMaterials(new PhongLighting());

describe('meshes that look alike', () => {
  it('share a material, also when files describe equal looks separately', () => {
    const shared = materials();
    const material = shared.acquire(plain);
    expect(shared.acquire({ ...plain, look: { ...PLAIN_LOOK }, surface: { ...surface } })).toBe(material);
    expect(material.surface).toEqual(surface);
    expect(material).toMatchObject({ sides: 'closed' });
  });

  it('have different materials for each difference', () => {
    const shared = materials();
    const different = new Set([
      shared.acquire(plain),
      shared.acquire(shiny),
      shared.acquire({ ...plain, sides: 'double' }),
      shared.acquire({ ...plain, shading: 'flat' }),
      shared.acquire({ ...plain, reflection: 'blinn-phong' }),
      shared.acquire({ ...plain, look: { ...PLAIN_LOOK, opacity: 0.5 } }),
      shared.acquire({ ...plain, look: { ...PLAIN_LOOK, map: new Texture() } }),
      shared.acquire({ ...plain, look: { ...PLAIN_LOOK, map: new Texture() } }),
    ]);
    expect(different.size).toBe(8);
  });

  it('follow the style of their picture, except for what they say themselves', () => {
    const shared = materials();
    const [own, other] = [shared.acquire({ ...plain, shading: 'gouraud' }), shared.acquire(plain)];
    shared.style = { ...DEFAULT_STYLE, shading: 'flat', terms: ['diffuse'] };
    expect(own.style).toMatchObject({ shading: 'gouraud', terms: ['diffuse'] });
    expect(other.style).toMatchObject({ shading: 'flat', terms: ['diffuse'] });
    expect(shared.acquire(shiny).style.shading).toBe('flat');
  });
});

describe('a mesh that changes', () => {
  it('gets another material and leaves the shared one alone', () => {
    const shared = materials();
    const material = shared.acquire(plain);
    shared.acquire(plain);
    const changed = shared.exchange(material, shiny);
    expect(changed).not.toBe(material);
    expect(material.surface.shininess).toBe(4);
    expect(changed.surface.shininess).toBe(100);
    expect(shared.exchange(changed, plain)).toBe(material);
  });

  it('keeps a material that no other mesh uses', () => {
    const shared = materials();
    const material = shared.acquire(plain);
    expect(shared.exchange(material, shiny)).toBe(material);
    expect(material.surface.shininess).toBe(100);
    expect(shared.acquire(shiny)).toBe(material);
    expect(shared.acquire(plain)).not.toBe(material);
  });
});

describe('a material without users', () => {
  it('is freed after the next drawing, unless it is used again by then', () => {
    const shared = materials();
    const material = shared.acquire(plain);
    const freed = vi.fn();
    material.addEventListener('dispose', freed);
    shared.release(material);
    expect(shared.acquire(plain)).toBe(material);
    shared.sweep();
    expect(freed).not.toHaveBeenCalled();
    shared.release(material);
    shared.sweep();
    expect(freed).toHaveBeenCalledTimes(1);
    expect(shared.acquire(plain)).not.toBe(material);
  });
});
