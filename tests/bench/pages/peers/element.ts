// The element itself, as a page uses it, drawn frame by frame.
import { runFrame } from '../manual-frames.js';
import 'phong-viewer';
import { glbOf } from '../../glb.mjs';
import { bentPlane, CAMERA, lightsOf, SURFACE } from '../scenes.js';
import { pause, type PeerMaker } from './peer.js';

export type Viewer = HTMLElementTagNameMap['phong-viewer'];

/** Frames until the viewer has nothing to wait for. */
export async function drawnFirst(viewer: Viewer): Promise<void> {
  const state = { ready: false };
  void viewer.ready.then(() => {
    state.ready = true;
  });
  while (!state.ready) {
    runFrame();
    await pause(5);
  }
}

/** The context that a viewer alone on its page shows. */
export function contextOf(viewer: Viewer): WebGL2RenderingContext {
  const gl = viewer.shadowRoot?.querySelector('canvas')?.getContext('webgl2');
  if (!gl) throw new Error('the viewer shows no WebGL 2 canvas');
  return gl;
}

/** Milliseconds; a size that no canvas gets has to end somewhere. */
const LONGEST_RESIZE = 20_000;

/** Gives what holds a viewer another size, and runs frames until its canvas has it. */
export async function setSize(
  holder: HTMLElement,
  gl: WebGL2RenderingContext,
  width: number,
  height: number,
): Promise<void> {
  Object.assign(holder.style, { width: `${width}px`, height: `${height}px` });
  const until = performance.now() + LONGEST_RESIZE;
  while (gl.drawingBufferWidth !== width || gl.drawingBufferHeight !== height) {
    if (performance.now() > until) throw new Error(`no canvas of ${String(width)} × ${String(height)}`);
    await pause(5);
    runFrame();
  }
}

export const element: PeerMaker = async (holder, scene) => {
  const viewer = document.createElement('phong-viewer');
  viewer.style.cssText = 'display: block; width: 100%; height: 100%';
  Object.assign(viewer, { theta: 0, phi: 90, target: [0, 0, 0], radius: CAMERA.radius, fov: CAMERA.fov });
  const { ka, kd, ks, shininess } = SURFACE;
  Object.assign(viewer, { ka: [ka, ka, ka], kd: [kd, kd, kd], ks: [ks, ks, ks], shininess });
  for (const values of lightsOf(scene)) {
    const light = document.createElement('phong-light');
    viewer.append(Object.assign(light, values));
  }
  viewer.src = URL.createObjectURL(new Blob([glbOf(bentPlane())]));
  holder.append(viewer);
  await drawnFirst(viewer);
  const gl = contextOf(viewer);
  return {
    gl,
    draw() {
      viewer.requestRender();
      if (runFrame() === 0) throw new Error('the viewer asked for no frame');
    },
    programs: () => viewer.stats.programs,
    resize: (width, height) => setSize(holder, gl, width, height),
  };
};
