// What `toBlob({ samples })` draws while the scene changes under it.

import type * as Three from 'three';
import { expect, test } from '../../support/test.js';

const light = '<phong-light position="1 2 3 0"></phong-light>';
const size = { width: 24, height: 16 };
const options = { ...size, samples: 32 };

test('toBlob({ samples }) begins again when the scene changes, whatever changes', async ({
  mount,
}) => {
  const viewer = await mount(
    `<phong-viewer alt="">${light}<phong-mesh geometry="sphere"></phong-mesh>
      <phong-mesh geometry="box" position=".5 0 0"></phong-mesh></phong-viewer>`,
    size,
  );
  const wrong = await viewer.evaluate(async (element, given) => {
    const address = '/node_modules/three/build/three.module.js';
    const three = (await import(address)) as typeof Three;
    const fragmentShader = 'void main() { gl_FragColor = vec4(0.2, 0.4, 0.6, 1.0); }';
    const own = new three.Mesh(
      new three.SphereGeometry(0.3),
      new three.ShaderMaterial({ fragmentShader }),
    );
    element.scene.add(own);
    element.refit();
    const bytesOf = async (blob: Promise<Blob>) =>
      new Uint8Array(await (await blob).arrayBuffer()).join();
    const mesh = () => element.querySelector('phong-mesh')!;
    const parent = element.parentElement!;
    const reported = (change: () => void) => () => {
      change();
      element.requestRender();
    };
    const changes: Record<string, () => void> = {
      'the camera': () => (element.radius = 4),
      'the colour of a mesh': () => (mesh().kd = [255, 0, 0]),
      'its place': () => (mesh().position = [0.2, 0.3, 0]),
      'its shape': () => (mesh().geometry = 'cone'),
      'a mesh less': () => mesh().remove(),
      'the terms': () => (element.terms = ['ambient', 'specular']),
      'a light': () => (element.lights[0]!.ambient = [90, 0, 0]),
      "the place of the page's own object": reported(() => own.position.set(0, 0.6, 0)),
      'its visibility': reported(() => (own.visible = false)),
      'the view': () => (element.view = 'normals'),
      'the view back': () => (element.view = 'shaded'),
    };
    const same: Record<string, () => void> = {
      'another parent': () => parent.append(document.createElement('section')),
      removal: () => element.remove(),
    };
    element.view = 'diffuse'; // its code is here from now on
    await element.ready;
    element.view = 'shaded';
    await element.ready;
    const found: string[] = [];
    let before = await bytesOf(element.toBlob(given));
    for (const [name, change] of Object.entries({ ...changes, ...same })) {
      for (const wait of name === 'removal' ? [0, 5] : [5]) {
        const blob = element.toBlob(given);
        if (wait > 0) {
          await new Promise((resolve) => setTimeout(resolve, wait));
        }
        change();
        if (name === 'another parent') {
          parent.lastElementChild!.append(element);
        }
        const got = await bytesOf(blob);
        if (element.parentElement === null) {
          parent.append(element);
        }
        await element.ready;
        const after = await bytesOf(element.toBlob(given));
        if (got !== after) {
          found.push(name);
        }
        if ((after === before) !== name in same) {
          found.push(`${name}: changes`);
        }
        before = after;
      }
    }
    return found;
  }, options);
  expect(wrong).toEqual([]);
});

test('toBlob({ samples }) ends with the picture of one scene where each frame changes it', async ({
  mount,
}) => {
  const viewer = await mount(`<phong-viewer alt="" geometry="torus">${light}</phong-viewer>`, size);
  const result = await viewer.evaluate(async (element, given) => {
    const bytesOf = async (blob: Promise<Blob>) =>
      new Uint8Array(await (await blob).arrayBuffer()).join();
    const angles = [10, 50];
    const wanted: string[] = [];
    for (const theta of angles) {
      element.theta = theta;
      await element.ready;
      wanted.push(await bytesOf(element.toBlob(given)));
    }
    let frame = 0;
    let going = true;
    const turn = () => {
      element.theta = angles[(frame += 1) % 2]!;
      if (going) {
        requestAnimationFrame(turn);
      }
    };
    turn();
    const got = await Promise.all([0, 1, 2].map(() => bytesOf(element.toBlob(given))));
    going = false;
    return { wanted: new Set(wanted).size, known: got.map((bytes) => wanted.includes(bytes)) };
  }, options);
  expect(result).toEqual({ wanted: 2, known: [true, true, true] });
});
