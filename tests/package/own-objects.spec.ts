// What three.js users may put into `viewer.scene` of the standalone file, whose copy of three.js carries only what a
// ShaderMaterial needs: objects of another copy with shaders of their own; three.js's own materials are refused in words.

import type * as Three from 'three';
import type { PhongViewer } from '../../src/index.js';
import { compare, expect, pixels, test } from '../support/test.js';

const box = '<phong-viewer geometry="box" radius="4"></phong-viewer>';
const three = '/node_modules/three/build/three.module.js';

test('an object of another three.js with a ShaderMaterial is drawn', async ({ mount }) => {
  const viewer = await mount(box);
  const before = await pixels(viewer);
  await viewer.evaluate(async (element: PhongViewer, address) => {
    const { Mesh, PlaneGeometry, ShaderMaterial } = (await import(address)) as typeof Three;
    const material = new ShaderMaterial({
      fragmentShader: 'void main() { gl_FragColor = vec4(0.0, 1.0, 0.0, 1.0); }',
    });
    const plane = new Mesh(new PlaneGeometry(1, 1), material);
    plane.position.y = 1;
    element.scene.add(plane);
    element.requestRender();
    await element.ready;
  }, three);
  const after = await pixels(viewer);
  expect(compare(after, before).share).toBeGreaterThan(0.01);
  const isGreen = (i: number): boolean =>
    after.data[i] === 0 && after.data[i + 1] === 255 && after.data[i + 2] === 0;
  expect(
    Array.from({ length: after.data.length / 4 }, (_, i) => 4 * i).filter(isGreen).length,
  ).toBeGreaterThan(100);
});

test('its ShaderMaterial may be drawn in instances, with colours of vertices', async ({ mount }) => {
  const viewer = await mount('<phong-viewer radius="4"></phong-viewer>');
  await viewer.evaluate(async (element: PhongViewer, address) => {
    const { BufferAttribute, InstancedMesh, Matrix4, PlaneGeometry, ShaderMaterial } = (await import(
      address
    )) as typeof Three;
    const geometry = new PlaneGeometry(0.5, 0.5);
    geometry.setAttribute(
      'color',
      new BufferAttribute(Float32Array.from([0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0]), 3),
    );
    const material = new ShaderMaterial({
      vertexColors: true,
      vertexShader: `varying vec3 vColor;
        void main() {
          vColor = color;
          gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0);
        }`,
      fragmentShader: 'varying vec3 vColor; void main() { gl_FragColor = vec4(vColor, 1.0); }',
    });
    const planes = new InstancedMesh(geometry, material, 2);
    planes.setMatrixAt(0, new Matrix4().makeTranslation(-1, 0, 0));
    planes.setMatrixAt(1, new Matrix4().makeTranslation(1, 0, 0));
    element.scene.add(planes);
    element.theta = 0;
    element.phi = 90;
    element.requestRender();
    await element.ready;
  }, three);
  const { data, width, height } = await pixels(viewer);
  const row = Array.from({ length: width }, (_, x) => data[4 * (width * (height >> 1) + x) + 1]);
  const runs = row.join().match(/255(,255)*/g);
  expect(runs).toHaveLength(2);
});

test('an object with a material that the file has no shaders for is refused in words', async ({
  mount,
  consoleGuard,
}) => {
  const said = consoleGuard.allow(
    /carries no shaders of three\.js's own materials \(basic\): use the ES modules/,
  );
  const viewer = await mount(box);
  const before = await pixels(viewer);
  await viewer.evaluate(async (element: PhongViewer, address) => {
    const { Mesh, MeshBasicMaterial, PlaneGeometry } = (await import(address)) as typeof Three;
    const own = new Mesh(new PlaneGeometry(1, 1), new MeshBasicMaterial());
    element.scene.add(own);
    element.requestRender();
    await element.ready;
    element.scene.remove(own);
    element.requestRender();
    await element.ready;
  }, three);
  expect(said.length).toBeGreaterThan(0);
  expect(compare(await pixels(viewer), before).max).toBe(0);
});
