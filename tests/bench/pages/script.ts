// What a frame costs the page's own thread: the element whose lights all move, against three.js drawing one unlit box, both
// on canvases so small that the GPU has nothing to do. Also counts the calls to WebGL that a frame makes.
import { runFrame } from './manual-frames.js';
import { BoxGeometry, MeshBasicMaterial } from 'three';
import { rendererName } from '../../glsl/float-pass.js';
import { contextOf, drawnFirst } from './peers/element.js';
import { finish, pause } from './peers/peer.js';
import { plainThree, threePeer } from './peers/plain-three.js';
import { lightsOf } from './scenes.js';

const SIZE = 4;
/** Frames between waits for the GPU: so few that the page never has to wait for it in between. */
const RUN = 100;
/** Frames until the browser's compiler has nothing left to do. */
const WARM = 3000;

/** What is timed, a frame at a time. */
export type Step = 'moving' | 'setting' | 'still' | 'unlit' | 'turning';

export interface ScriptBench {
  readonly renderer: string;
  readonly steps: readonly Step[];
  /** Milliseconds by the clock, without waits for the GPU. */
  run(step: Step, frames: number): Promise<number>;
  /** Calls to WebGL of one frame, by name. */
  calls(step: Step): Record<string, number>;
}

declare global {
  interface Window {
    openScript: (lights: number, seed: number) => Promise<ScriptBench>;
    scriptBench: ScriptBench;
  }
}

window.openScript = async (lights, seed) => {
  const viewer = document.createElement('phong-viewer');
  viewer.style.cssText = 'display: block; width: 100%; height: 100%';
  viewer.geometry = 'box';
  const scene = lightsOf({ lights, active: lights, kind: 'mixed', seed });
  const elements = scene.map((values) => Object.assign(document.createElement('phong-light'), values));
  viewer.append(...elements);
  document.getElementById('element')!.append(viewer);
  await drawnFirst(viewer);
  const gl = contextOf(viewer);

  const holder = document.getElementById('three')!;
  const three = plainThree(holder, new BoxGeometry(), new MeshBasicMaterial(), false);
  const unlit = threePeer(three);
  const box = three.scene.children[0]!;
  await unlit.resize(SIZE, SIZE);

  let time = 0;
  const move = (): void => {
    time += 0.01;
    const sway = 0.1 * Math.sin(time);
    elements.forEach((element, i) => {
      const [x, y, z, w] = scene[i]!.position;
      element.position = [x + sway, y, z - sway, w];
    });
  };
  const frame = (): void => {
    if (runFrame() === 0) throw new Error('the viewer asked for no frame');
  };
  const steps: Record<Step, { gl: WebGL2RenderingContext; run(): void }> = {
    moving: {
      gl,
      run() {
        move();
        frame();
      },
    },
    setting: { gl, run: move },
    still: {
      gl,
      run() {
        viewer.requestRender();
        frame();
      },
    },
    unlit: { gl: unlit.gl, run: () => unlit.draw() },
    turning: {
      gl: unlit.gl,
      run() {
        box.rotation.y += 0.01;
        unlit.draw();
      },
    },
  };
  const bench: ScriptBench = {
    renderer: rendererName(gl),
    steps: Object.keys(steps) as Step[],
    async run(step, frames) {
      const { gl: context, run } = steps[step];
      let ms = 0;
      for (let done = 0; done < frames; done += RUN) {
        const start = performance.now();
        for (let i = 0; i < RUN; i++) {
          run();
          await Promise.resolve(); // what waits for the task's end, events among it, is a frame's as well
        }
        ms += performance.now() - start;
        finish(context);
      }
      return ms;
    },
    calls: (step) => countCalls(steps[step].gl, steps[step].run),
  };
  for (const step of bench.steps) {
    await bench.run(step, WARM);
    await pause(100);
  }
  window.scriptBench = bench;
  return bench;
};

/** Calls that one frame makes on a context. */
function countCalls(gl: WebGL2RenderingContext, frame: () => void): Record<string, number> {
  frame(); // what another step has left to be sent is no part of this one
  const counts: Record<string, number> = {};
  const context = gl as unknown as Record<string, unknown>;
  const wrapped: string[] = [];
  for (const name in gl) {
    const method = context[name];
    if (typeof method !== 'function') continue;
    wrapped.push(name);
    context[name] = (...args: unknown[]): unknown => {
      counts[name] = (counts[name] ?? 0) + 1;
      return Reflect.apply(method, gl, args) as unknown;
    };
  }
  frame();
  for (const name of wrapped) Reflect.deleteProperty(gl, name);
  return counts;
}
