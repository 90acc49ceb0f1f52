// When does a material request another program from three.js? Only when it needs other code.

import {
  BoxGeometry,
  DoubleSide,
  FrontSide,
  Mesh,
  PerspectiveCamera,
  Scene,
  SphereGeometry,
  Texture,
} from 'three';
import { describe, expect, it } from 'vitest';
import { LightSet, LightState, PhongLighting, PhongMaterial } from '../../src/core.js';
import { type LightValues } from '../../src/light/light-state.js';
import { PLAIN_LOOK } from '../../src/material/file-surface.js';
import { FakeRenderer } from './fake-renderer.js';

/** A material on a mesh before a camera, under lights that bring every term. */
function lit(values: readonly Partial<LightValues>[] = [{ ambient: [9, 9, 9] }], gpu = new FakeRenderer()) {
  const lights = new LightSet();
  lights.assign(values.map((one) => new LightState(one)));
  const lighting = new PhongLighting(lights);
  const material = new PhongMaterial(lighting);
  const mesh: Mesh = new Mesh(new BoxGeometry(), material);
  const camera = new PerspectiveCamera();
  camera.position.z = 5;
  const draw = (frames = 1, meshes: readonly Mesh[] = [mesh]): number => {
    for (let i = 0; i < frames; i++) {
      camera.updateMatrixWorld();
      lighting.update(camera);
      for (const one of meshes) {
        one.updateMatrixWorld();
        const own = one.material as PhongMaterial;
        own.onBeforeRender(gpu.renderer, new Scene(), camera, one.geometry, one, null as never);
      }
    }
    return material.version;
  };
  return { lights, lighting, material, mesh, camera, gpu, draw };
}

describe('another program', () => {
  it('is requested when code is needed for the first time', () => {
    const { lights, lighting, material, draw } = lit();
    const [light] = lights.lights;
    const changes: [string, () => void, number][] = [
      ['gouraud shading', () => material.setStyle({ shading: 'gouraud' }), 1],
      ['Blinn’s lobe', () => material.setStyle({ reflection: 'blinn-phong' }), 1],
      ['a point light', () => light!.set('position', [0, 1, 0, 1]), 1],
      ['linear light', () => (lighting.linear = true), 1],
      ['a kind that was there before', () => light!.set('position', [0, 1, 0, 0]), 0],
      ['an inactive light', () => light!.set('active', false), 0],
      ['the same light again', () => light!.set('active', true), 0],
      ['fewer terms', () => material.setStyle({ terms: ['diffuse'] }), 0],
      ['no specular colour', () => material.setSurface({ ks: [0, 0, 0] }), 0],
      ['other colours and exponents to 200', () => material.setSurface({ shininess: 7, ka: [1, 2, 3] }), 0],
      ['an exponent above 200', () => material.setSurface({ shininess: 201 }), 1],
      ['an exponent to 200 again', () => material.setSurface({ shininess: 8 }), 0],
    ];
    let before = draw();
    for (const [which, change, programs] of changes) {
      change();
      const after = draw();
      expect(after - before, which).toBe(programs);
      before = after;
    }
  });

  it.each<[string, Partial<ConstructorParameters<typeof FakeRenderer>[0]>, number, number]>([
    ['16 lights in software', { name: 'llvmpipe' }, 16, 1],
    ['17 lights in software', { name: 'Google SwiftShader' }, 17, 0],
    ['16 lights on a GPU', {}, 16, 1],
    ['200 lights on a GPU', {}, 200, 1],
    ['400 lights on a GPU, which reads a texture,', {}, 400, 0],
  ])('is specialised or not for %s', (_, device, lights, programs) => {
    const { gpu, draw } = lit(
      Array.from({ length: lights }, () => ({ position: [1, 2, 3, 1] as const })),
      new FakeRenderer(device),
    );
    draw(60);
    expect(gpu.compiled).toHaveLength(programs);
  });
});

describe('the sides', () => {
  it('are chosen in each draw, without another program', () => {
    const { material, mesh, camera, draw } = lit();
    mesh.geometry = new SphereGeometry(1);
    material.sides = 'closed';
    const version = draw();
    expect(material.side).toBe(FrontSide);
    camera.position.z = 0;
    expect(draw()).toBe(version);
    expect(material.side).toBe(DoubleSide);
    camera.position.z = 5;
    draw();
    expect(material.side).toBe(FrontSide);
    material.sides = 'double';
    draw();
    expect(material.side).toBe(DoubleSide);
  });
});

describe('a clone', () => {
  it('has the same look, surface, style and sides, and changes independently', () => {
    const { lighting } = lit();
    const map = new Texture();
    const material = new PhongMaterial(lighting, { ...PLAIN_LOOK, map, alphaMode: 'blend' });
    material.setSurface({ ka: [1, 2, 3], kd: [4, 5, 6], ks: [7, 8, 9], shininess: 70 });
    material.setStyle({ shading: 'flat', terms: ['diffuse'] });
    material.sides = 'single';
    material.name = 'a';
    const clone = material.clone();
    expect(clone).toBeInstanceOf(PhongMaterial);
    expect(clone.surface).toStrictEqual(material.surface);
    expect(clone.style).toStrictEqual(material.style);
    expect(clone).toMatchObject({ sides: 'single', name: 'a', transparent: true, premultipliedAlpha: true });
    expect(clone.look.map).toBe(map);
    clone.setSurface({ shininess: 1 });
    clone.setStyle({ shading: 'gouraud' });
    expect(material.surface.shininess).toBe(70);
    expect(material.style.shading).toBe('flat');
    expect(material.uniforms['uShininess']!.value).toBe(70);
  });
});

it('keeps its surface when a value is outside its domain', () => {
  const { material } = lit();
  const before = material.surface;
  expect(() => {
    material.setSurface({ ka: [1, 2, 3], shininess: -1 });
  }).toThrow(RangeError);
  expect(material.surface).toBe(before);
});
