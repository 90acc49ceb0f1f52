// A whole picture by three.js, under a ShaderMaterial of the same equation: the triangles of the
// element's plain picture, multisampled by the canvas; or those of its samples, by three.js's
// passes as shipped.
import {
  LinearSRGBColorSpace,
  Mesh,
  PerspectiveCamera,
  Scene,
  SRGBColorSpace,
  Vector3,
  WebGLRenderer,
} from 'three';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js';
import { SSAARenderPass } from 'three/addons/postprocessing/SSAARenderPass.js';
import { TAARenderPass } from 'three/addons/postprocessing/TAARenderPass.js';
import { CODES, MULTISAMPLED, SSAA, ssaa, TAA, TAA_PASS } from '../pictures.mjs';
import { sceneOnPage } from '../../support/drawn-scene.js';
import type { Viewer } from './element-side.js';
import { shownMeshes } from './cast-scene.js';
import { equationMaterial } from './equation-material.js';
import { antialiasAll, showViewers, WARM } from './picture-element.js';
import type { Cell, OpenPicture } from './picture.js';
import type { PictureScene } from './picture-scenes.js';
import { finish, pause } from './timing.js';

/** What accumulates averages linear light, as three.js's pages do, or the equation's own codes. */
type Averages = 'light' | 'codes';

interface Canvas {
  readonly renderer: WebGLRenderer;
  readonly gl: WebGL2RenderingContext;
  readonly camera: PerspectiveCamera;
  readonly scenes: Readonly<Record<Averages, Scene>>;
}

/** Draws one canvas for the k-th time since a change, from 0. */
type Draw = (canvas: Canvas, k: number) => void;

/** Takes over what the viewers draw, and removes them. `multisamples`: for the plain picture. */
async function canvases(
  holder: HTMLElement,
  scene: PictureScene,
  { width, height }: Cell,
  multisamples: boolean,
): Promise<Canvas[]> {
  const viewers = await showViewers(holder, scene);
  if (!multisamples) {
    await antialiasAll(viewers, WARM);
  }
  const taken = viewers.map((viewer) => ({
    camera: cameraOf(viewer, width / height),
    scenes: { light: sceneOf(viewer, true), codes: sceneOf(viewer, false) },
  }));
  holder.replaceChildren();
  await pause(0);
  return taken.map((one) => {
    const renderer = new WebGLRenderer({ antialias: multisamples, alpha: true });
    renderer.setSize(width, height);
    holder.append(renderer.domElement);
    return { ...one, renderer, gl: renderer.getContext() as WebGL2RenderingContext };
  });
}

function cameraOf({ camera: { eye, target, up, radius }, fov }: Viewer, aspect: number) {
  const camera = new PerspectiveCamera(fov, aspect, radius / 20, 20 * radius);
  camera.position.set(...eye);
  camera.up.set(...up);
  camera.lookAt(new Vector3(...target));
  camera.updateMatrixWorld();
  return camera;
}

function sceneOf(viewer: Viewer, decodes: boolean) {
  const scene = new Scene();
  const { lights } = sceneOnPage(viewer);
  for (const shown of shownMeshes(viewer)) {
    const place = { eye: viewer.camera.eye, matrix: shown.matrixWorld };
    const material = equationMaterial(shown.material, lights, place, decodes);
    const mesh = new Mesh(shown.geometry.clone(), material);
    mesh.matrixAutoUpdate = false;
    mesh.matrix.copy(shown.matrixWorld);
    scene.add(mesh);
  }
  return scene;
}

interface Way {
  /** Pictures on the way to the last one. */
  readonly steps: number;
  readonly draw: Draw;
}

const open =
  (multisamples: boolean, ways: Readonly<Record<string, Way>>): OpenPicture =>
  async (holder, scene, cell) => {
    const all = await canvases(holder, scene, cell, multisamples);
    /** The picture that the canvases show. */
    let last = { method: '', step: 0 };
    const drawAll = ({ draw }: Way, k: number) => all.forEach((canvas) => draw(canvas, k));
    const finishAll = () => all.forEach((canvas) => finish(canvas.gl));
    return {
      methods: Object.fromEntries(
        Object.entries(ways).map(([name, { steps }]) => [name, { steps }]),
      ),
      scenes: () => [], // those of the element
      async time(method) {
        const way = ways[method]!;
        last = { method: '', step: 0 };
        finishAll();
        const start = performance.now();
        const times: number[] = [];
        for (let k = 0; k < way.steps; k++) {
          await Promise.resolve();
          drawAll(way, k);
          finishAll();
          times.push(performance.now() - start);
        }
        return times;
      },
      async codes(method, step) {
        const { draw } = ways[method]!;
        const next = last.method === method && last.step < step ? last.step + 1 : 0;
        last = { method, step };
        await Promise.resolve();
        const parts = all.map((canvas) => {
          for (let k = next; k <= step; k++) {
            draw(canvas, k);
          }
          return codesOf(canvas.gl, cell);
        });
        const joined = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
        parts.forEach((part, i) => joined.set(part, i * part.length));
        return joined;
      },
    };
  };

/** In the task that drew them. Premultiplied, which is the colour over black. */
function codesOf(gl: WebGL2RenderingContext, { width, height }: Cell): Uint8Array {
  const pixels = new Uint8Array(4 * width * height);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const codes = new Uint8Array(3 * width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const from = 4 * ((height - 1 - y) * width + x);
      codes.set(pixels.subarray(from, from + 3), 3 * (y * width + x));
    }
  }
  return codes;
}

export const openMultisampled: OpenPicture = open(true, {
  [MULTISAMPLED]: {
    steps: 1,
    draw({ renderer, scenes, camera }) {
      renderer.render(scenes.light, camera);
    },
  },
});

type RenderPass = SSAARenderPass | TAARenderPass;

/** One composer for each canvas. `set` prepares the pass for the k-th picture since the change. */
function composed<P extends RenderPass>(
  Pass: new (scene: Scene, camera: PerspectiveCamera) => P,
  averages: Averages,
  set: (pass: P, k: number) => void,
): Draw {
  const composers = new Map<Canvas, { composer: EffectComposer; pass: P }>();
  return (canvas, k) => {
    const { renderer, scenes, camera } = canvas;
    let found = composers.get(canvas);
    if (found === undefined) {
      const composer = new EffectComposer(renderer);
      const pass = new Pass(scenes[averages], camera);
      composer.addPass(pass);
      composer.addPass(new OutputPass());
      composers.set(canvas, (found = { composer, pass }));
    }
    // Encoded codes need no encoding.
    renderer.outputColorSpace = averages === 'light' ? SRGBColorSpace : LinearSRGBColorSpace;
    set(found.pass, k);
    found.composer.render();
  };
}

const passes = (averages: Averages, end: string): Readonly<Record<string, Way>> => ({
  ...Object.fromEntries(
    SSAA.map((samples, level) => [
      ssaa(samples) + end,
      { steps: 1, draw: composed(SSAARenderPass, averages, (pass) => (pass.sampleLevel = level)) },
    ]),
  ),
  [TAA_PASS + end]: {
    steps: TAA.length,
    // The picture of the change itself does not accumulate; it also resets what has accumulated.
    draw: composed(TAARenderPass, averages, (pass, k) => (pass.accumulate = k > 0)),
  },
});

export const openPasses: OpenPicture = open(false, {
  ...passes('light', ''),
  ...passes('codes', CODES),
});
