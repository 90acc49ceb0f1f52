// Can a page use the standalone file together with its own three.js, without console lines? Objects of the page's copy
// work in `viewer.scene` if they have their own shaders; three.js's materials give a clear error.

import type * as Three from 'three';
import type { PhongViewer } from '../../src/index.js';
import { allReady, compare, expect, pixels, test } from '../support/test.js';

const box = '<phong-viewer geometry="box" radius="4"></phong-viewer>';
const three = '/node_modules/three/build/three.module.js';

for (const order of ['before', 'after'] as const) {
  test(`a page that loads three.js of its own ${order} the standalone file has an empty console`, async ({
    page,
    site,
  }) => {
    const scripts = [three, '/dist/phong-viewer.standalone.js'];
    if (order === 'after') scripts.reverse();
    const head = scripts.map((address) => `<script type="module" src="${address}"></script>`).join('');
    await page.goto(site.page(box, { head }));
    await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
    await allReady(page);
    // three.js leaves its version there, and warns where it finds one.
    const stamp = await page.evaluate(() => (window as { __THREE__?: string }).__THREE__);
    expect(stamp).toMatch(/^\d+/);
  });
}

test('the standalone file registers no version of three.js on the page', async ({ mount }) => {
  const viewer = await mount(box);
  expect(await viewer.evaluate(() => '__THREE__' in window)).toBe(false);
});

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

test('an InstancedMesh with vertex colours and a ShaderMaterial is drawn', async ({ mount }) => {
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

test("an object with one of three.js's own materials gives an error that names the cure", async ({
  mount,
  consoleGuard,
}) => {
  const said = consoleGuard.allow(
    /does not contain the shaders of three\.js's own materials \(basic\): .* use the ES modules/,
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
