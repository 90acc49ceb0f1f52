// What `toBlob({ samples })` draws while the scene changes under it.

import type * as Three from 'three';
import { expect, test } from '../../support/test.js';
import type { PhongMesh, PhongViewer } from '../support/viewer.js';

const light = '<phong-light position="1 2 3 0"></phong-light>';

test('toBlob({ samples }) shows the scene at the call, whatever changes while it is drawn', async ({
  mount,
}) => {
  const viewer = await mount(
    `<phong-viewer alt="">${light}<phong-mesh geometry="sphere"></phong-mesh>
      <phong-mesh geometry="box" position=".5 0 0"></phong-mesh></phong-viewer>`,
    { width: 24, height: 16 },
  );
  const changed = await viewer.evaluate(async (element: PhongViewer) => {
    const options = { width: 24, height: 16, samples: 64 };
    const bytesOf = async (blob: Promise<Blob>): Promise<string> =>
      new Uint8Array(await (await blob).arrayBuffer()).join();
    const mesh = (): PhongMesh => element.querySelector('phong-mesh')!;
    const changes: Record<string, () => void> = {
      'the camera': () => (element.radius = 4),
      'the reflection': () => (element.reflection = 'blinn-phong'),
      'the field of view': () => (element.fov = 60),
      'the colour of a mesh': () => (mesh().kd = [255, 0, 0]),
      'its exponent': () => (mesh().shininess = 3),
      'its shading': () => (mesh().shading = 'flat'),
      'its place': () => (mesh().position = [0.2, 0.3, 0]),
      'its shape': () => (mesh().geometry = 'cone'),
      'a mesh more': () => mesh().after(mesh().cloneNode()),
      'a mesh less': () => {
        mesh().remove();
      },
      'the terms': () => (element.terms = ['specular']),
      'the colour space': () => (element.colorInterpolation = 'linear'),
      'a light': () => (element.lights[0]!.specular = [255, 0, 0]),
      'the view': () => (element.view = 'normals'),
    };
    element.view = 'diffuse'; // its code is here from now on
    await element.ready;
    element.view = 'shaded';
    await element.ready;
    const found: string[] = [];
    let before = await bytesOf(element.toBlob(options));
    for (const [name, change] of Object.entries(changes)) {
      const blob = element.toBlob(options);
      await new Promise((resolve) => setTimeout(resolve, 5));
      change();
      if ((await bytesOf(blob)) !== before) found.push(name);
      await element.ready;
      const after = await bytesOf(element.toBlob(options));
      if (after === before) found.push(`${name} changes nothing`);
      before = after;
    }
    return found;
  });
  expect(changed).toEqual([]);
});

test('toBlob({ samples }) shows what was there at the call, whatever the page does to the viewer and to its own objects', async ({
  mount,
}) => {
  const viewer = await mount(`<phong-viewer alt="" geometry="sphere">${light}</phong-viewer>`, {
    width: 24,
    height: 16,
  });
  const changed = await viewer.evaluate(async (element: PhongViewer) => {
    const options = { width: 24, height: 16, samples: 64 };
    const address = '/node_modules/three/build/three.module.js';
    const three = (await import(address)) as typeof Three;
    const fragmentShader = 'void main() { gl_FragColor = vec4(0.2, 0.4, 0.6, 1.0); }';
    const own = new three.Mesh(new three.SphereGeometry(0.3), new three.ShaderMaterial({ fragmentShader }));
    const group = new three.Group().add(own);
    element.scene.add(group);
    element.refit();
    await element.ready;
    const bytesOf = async (blob: Promise<Blob>): Promise<string> =>
      new Uint8Array(await (await blob).arrayBuffer()).join();
    const parent = element.parentElement!;
    const changes: Record<string, () => void> = {
      'its place': () => own.position.set(0.3, 0, 0),
      "its group's place": () => group.scale.setScalar(2),
      'its visibility': () => (own.visible = false),
      'another object': () => element.scene.add(own.clone().translateY(0.4)),
      'no object': () => element.scene.remove(group),
      'another parent': () => {
        const section = document.createElement('section');
        parent.append(section);
        section.append(element);
      },
      'its removal': () => {
        element.remove();
      },
      'the angle': () => (element.theta = 90),
    };
    const found: string[] = [];
    let before = await bytesOf(element.toBlob(options));
    for (const [name, change] of Object.entries(changes)) {
      for (const wait of name === 'its removal' || name === 'the angle' ? [0, 5] : [5]) {
        const blob = element.toBlob(options);
        if (wait > 0) await new Promise((resolve) => setTimeout(resolve, wait));
        change();
        element.requestRender();
        const late = new Promise<string>((resolve) => setTimeout(resolve, 10_000, 'never'));
        if ((await Promise.race([bytesOf(blob), late])) !== before)
          found.push(`${name} ${String(wait)} ms later`);
        if (element.parentElement === null) parent.append(element);
        await element.ready;
        before = await bytesOf(element.toBlob(options));
      }
    }
    return found;
  });
  expect(changed).toEqual([]);
});
