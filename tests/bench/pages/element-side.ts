// The element itself, as a page uses it, driven frame by frame.
import { runFrame } from './page-hooks.js';
import 'phong-viewer';
import {
  extraLight,
  FOV,
  lightAt,
  type OpenSide,
  ORIGIN,
  type RoundShape,
  type Scene,
  type SceneLight,
  type Side,
  SURFACE,
  swing,
  thetaAt,
} from './scenes.js';
import { pause } from './timing.js';

export type Viewer = HTMLElementTagNameMap['phong-viewer'];
type LightElement = HTMLElementTagNameMap['phong-light'];

const lightElement = (values: SceneLight): LightElement =>
  Object.assign(document.createElement('phong-light'), values);

/** Runs frames until everything that these viewers were asked for is drawn. */
export async function drawUntilReady(...viewers: readonly Viewer[]): Promise<void> {
  const state = { ready: false };
  void Promise.all(viewers.map(({ ready }) => ready)).then(() => (state.ready = true));
  while (!state.ready) {
    runFrame();
    await pause(2);
  }
}

export const openElement: OpenSide = (holder, scene) => open(holder, scene);

/** The same with a fixed number of segments. */
export const openFixed: OpenSide = (holder, scene) => open(holder, scene, scene.segments);

async function open(
  holder: HTMLElement,
  scene: Scene,
  segments: number | 'auto' = 'auto',
): Promise<Side> {
  const viewer = document.createElement('phong-viewer');
  Object.assign(viewer.style, { display: 'block', width: '100%', height: '100%' });
  Object.assign(viewer, { alt: 'The scene', theta: 0, phi: 90, fov: FOV });
  viewer.pixelRatio = devicePixelRatio; // all pixels, as all sides draw, also where that is slow
  if (scene.autoFit !== true) {
    Object.assign(viewer, { target: ORIGIN, radius: scene.radius });
  }
  const lights = scene.lights.map(lightElement);
  const { ka, kd, ks } = SURFACE;
  const { shininess = SURFACE.shininess } = scene;
  const meshes = scene.meshes.map(({ shape, position = ORIGIN, scale = 1 }) => {
    const mesh = document.createElement('phong-mesh');
    if (shape.endsWith('.glb')) {
      mesh.src = shape;
    } else {
      mesh.geometry = shape as RoundShape | 'box';
    }
    if (shape !== 'box') {
      mesh.segments = segments;
    }
    return Object.assign(mesh, { position, scale, ka, kd, ks, shininess });
  });
  viewer.append(...lights, ...meshes);
  holder.append(viewer);
  await drawUntilReady(viewer);

  let extra: LightElement | null = null;
  const change = (i: number) => {
    switch (scene.motion) {
      case 'camera':
        viewer.theta = thetaAt(i);
        break;
      case 'lights':
        lights.forEach((light, k) => (light.position = lightAt(scene.lights[k]!, i)));
        break;
      case 'light count':
        if (extra === null) {
          viewer.append((extra = lightElement(scene.lights[extraLight(i)]!)));
        } else {
          extra.remove();
          extra = null;
        }
        break;
      case 'toggle':
        lights[lights.length >> 1]!.active = i % 2 === 0;
        break;
      case 'mesh':
        meshes[0]!.position = [0.1 * swing(i), 0, 0];
    }
  };
  return {
    async frame(i) {
      change(i);
      await Promise.resolve(); // the element gathers changes until here
      viewer.requestRender();
      if (runFrame() === 0) throw new Error('the viewer asked for no frame');
    },
  };
}
