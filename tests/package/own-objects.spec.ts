// Can a page use the standalone file together with its own three.js, without console lines? Objects
// of the page's copy work in `viewer.scene` if they have their own shaders; three.js's materials
// give a clear error.

import type * as Three from 'three';
import { allReady, expect, pixels, same, test } from '../support/test.js';

const box = '<phong-viewer geometry="box" radius="4"></phong-viewer>';
const three = '/node_modules/three/build/three.module.js';

test('a page with three.js of its own, before or after ours, has an empty console', async ({
  page,
  site,
}) => {
  const scripts = [three, '/dist/phong-viewer.standalone.js'];
  for (const order of [scripts, scripts.toReversed()]) {
    const head = order
      .map((address) => `<script type="module" src="${address}"></script>`)
      .join('');
    await page.goto(site.page(box, { head }));
    await allReady(page);
    // three.js leaves its version there, and warns where it finds one.
    const stamp = await page.evaluate(() => (window as { __THREE__?: string }).__THREE__);
    expect(stamp).toMatch(/^\d+/);
  }
});

test('objects of another three.js with a ShaderMaterial are drawn, coloured instances too', async ({
  mount,
}) => {
  const viewer = await mount('<phong-viewer radius="4" theta="0" phi="90"></phong-viewer>');
  expect(await viewer.evaluate(() => '__THREE__' in window), 'the viewer registers none').toBe(
    false,
  );
  await viewer.evaluate(async (element, address) => {
    const { BufferAttribute, InstancedMesh, Matrix4, Mesh, PlaneGeometry, ShaderMaterial } =
      (await import(address)) as typeof Three;
    const plain = new ShaderMaterial({
      fragmentShader: 'void main() { gl_FragColor = vec4(0.0, 1.0, 0.0, 1.0); }',
    });
    const colored = new ShaderMaterial({
      vertexColors: true,
      vertexShader: `varying vec3 vColor;
        void main() {
          vColor = color;
          gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0);
        }`,
      fragmentShader: 'varying vec3 vColor; void main() { gl_FragColor = vec4(vColor, 1.0); }',
    });
    const geometry = new PlaneGeometry(0.5, 0.5);
    geometry.setAttribute(
      'color',
      new BufferAttribute(Float32Array.from([0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0]), 3),
    );
    const planes = new InstancedMesh(geometry, colored, 2);
    planes.setMatrixAt(0, new Matrix4().makeTranslation(-1, 0, 0));
    planes.setMatrixAt(1, new Matrix4().makeTranslation(1, 0, 0));
    element.scene.add(planes, new Mesh(new PlaneGeometry(0.5, 0.5), plain));
    element.requestRender();
    await element.ready;
  }, three);
  const { data, width, height } = await pixels(viewer);
  const green = Array.from({ length: width }, (_, x) => data[4 * (width * (height >> 1) + x) + 1]);
  // One plane, and an instance at each side of it.
  expect(green.join().match(/255(,255)*/g)).toHaveLength(3);
});

test('an object with a material of three.js gives an error that names the cure', async ({
  mount,
  consoleGuard,
}) => {
  const said = consoleGuard.allow(
    /does not contain all of three\.js \(basic is missing\): use the ES modules/,
  );
  const viewer = await mount(box);
  const before = await pixels(viewer);
  await viewer.evaluate(async (element, address) => {
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
  same(await pixels(viewer), before);
});

test("the scene's own functions are three's, in the standalone file too", async ({ mount }) => {
  const viewer = await mount(box);
  const written = await viewer.evaluate((element) => JSON.stringify(element.scene.toJSON().object));
  expect(JSON.parse(written)).toMatchObject({ type: 'Scene', children: [{ type: 'Mesh' }] });
});
