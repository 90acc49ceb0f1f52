// What `toBlob({ samples })` draws while the scene changes under it.

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
