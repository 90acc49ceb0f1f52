// When does a material request another program from three.js? Only when it needs other code.

import {
  BoxGeometry,
  type BufferGeometry,
  DoubleSide,
  FrontSide,
  Mesh,
  PerspectiveCamera,
  Scene,
  SphereGeometry,
  Texture,
} from 'three';
import { describe, expect, it } from 'vitest';
import { LightSet, LightState, PhongLighting, PhongMaterial } from '../../../src/phong/core.js';
import { type LightValues } from '../../../src/phong/light/light-state.js';
import { PLAIN_LOOK } from '../../../src/phong/material/file-surface.js';
import { FakeRenderer } from '../fake-renderer.js';

/** A material on a mesh before a camera, under lights that bring every term. */
function lit(
  values: readonly Partial<LightValues>[] = [{ ambient: [9, 9, 9] }],
  gpu = new FakeRenderer(),
) {
  const lights = new LightSet();
  lights.assign(values.map((one) => new LightState(one)));
  const lighting = new PhongLighting(lights);
  const material = new PhongMaterial(lighting);
  const mesh = new Mesh(new BoxGeometry(), material) as Mesh<BufferGeometry, PhongMaterial>;
  const camera = new PerspectiveCamera();
  camera.position.z = 5;
  /** Whether rows of lights are sent for it. */
  const render = (one: typeof mesh) => {
    const { geometry } = one;
    one.material.onBeforeRender(gpu.renderer, new Scene(), camera, geometry, one, null as never);
    return (one.material.uniforms['uLightRows'] as { needsUpdate?: boolean }).needsUpdate;
  };
  const draw = (frames = 1) => {
    for (let i = 0; i < frames; i++) {
      camera.updateMatrixWorld();
      lighting.update(camera);
      mesh.updateMatrixWorld();
      render(mesh);
    }
    return material.version;
  };
  return { lights, lighting, material, mesh, camera, gpu, draw, render };
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
      [
        'other colours and exponents to 150',
        () => material.setSurface({ shininess: 150, ka: [1, 2, 3] }),
        0,
      ],
      ['an exponent above 150', () => material.setSurface({ shininess: 151 }), 1],
      ['an exponent to 150 again', () => material.setSurface({ shininess: 8 }), 0],
    ];
    let before = draw();
    for (const [which, change, programs] of changes) {
      change();
      const after = draw();
      expect(after - before, which).toBe(programs);
      before = after;
    }
  });

  it.each([
    ['16 lights in software', { name: 'llvmpipe' }, 16, 1],
    ['17 lights in software', { name: 'Google SwiftShader' }, 17, 0],
    ['16 lights on a GPU', {}, 16, 1],
    ['200 lights on a GPU', {}, 200, 1],
    ['400 lights on a GPU, which reads a texture,', {}, 400, 0],
  ])('is specialised or not for %s', (_, device, lights, programs) => {
    const lamps = new Array<Partial<LightValues>>(lights).fill({ position: [1, 2, 3, 1] });
    const { gpu, draw } = lit(lamps, new FakeRenderer(device));
    draw(60);
    expect(gpu.compiled).toHaveLength(programs);
  });
});

it('sends again in the frame what another material or a change of its own has replaced', () => {
  const { mesh, draw, render } = lit([{ position: [0, 3, 0, 1], axis: [0, -1, 0], aperture: 20 }]);
  const far = mesh.clone();
  far.position.x = 50;
  far.updateMatrixWorld();
  const other = mesh.clone();
  other.material = mesh.material.clone();
  draw();
  expect([far, far, other, far].map(render)).toEqual([true, false, true, true]);
  mesh.material.setStyle({ shading: 'gouraud' });
  render(far);
  expect(mesh.material.uniformsNeedUpdate).toBe(true);
});

it('chooses the sides in each draw, without another program', () => {
  const { material, mesh, camera, draw } = lit();
  mesh.geometry = new SphereGeometry(1);
  const version = draw();
  for (const [sides, z, side] of [
    ['closed', 5, FrontSide],
    ['closed', 0, DoubleSide],
    ['closed', 5, FrontSide],
    ['double', 5, DoubleSide],
  ] as const) {
    material.sides = sides;
    camera.position.z = z;
    expect(draw()).toBe(version);
    expect(material.side).toBe(side);
  }
});

it('a clone has the same look, surface, style and sides, and changes independently', () => {
  const { lighting } = lit();
  const map = new Texture();
  const material = new PhongMaterial(lighting, { ...PLAIN_LOOK, map, alphaMode: 'blend' });
  material.setSurface({ ka: [1, 2, 3], kd: [4, 5, 6], ks: [7, 8, 9], shininess: 70 });
  material.setStyle({ shading: 'flat', terms: ['diffuse'] });
  Object.assign(material, { sides: 'single', name: 'a' });
  const clone = material.clone();
  const { surface, style } = material;
  expect(clone).toBeInstanceOf(PhongMaterial);
  expect(clone).toMatchObject({ surface, style, sides: 'single', name: 'a' });
  expect(clone).toMatchObject({ transparent: true, premultipliedAlpha: true });
  expect(clone.look.map).toBe(map);
  clone.setSurface({ shininess: 1 });
  clone.setStyle({ shading: 'gouraud' });
  expect(material).toMatchObject({ surface: { shininess: 70 }, style: { shading: 'flat' } });
  expect(material.uniforms['uShininess']!.value).toBe(70);
});

it('keeps its surface when a value is outside its domain', () => {
  const { material } = lit();
  const before = material.surface;
  expect(() => material.setSurface({ ka: [1, 2, 3], shininess: -1 })).toThrow(RangeError);
  expect(material.surface).toBe(before);
});
