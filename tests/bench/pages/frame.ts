// One scene drawn by one side, for the bench to drive and time:
// frame.html?scene=sphere:8&side=element.
import { onlyContext } from './page-hooks.js';
import { type OpenSide, sceneOf } from './scenes.js';
import { clockFrames, finish, pause, rendererName, timeFrames } from './timing.js';

export type SideName = 'element' | 'fixed' | 'three' | 'unlit';

/** What a picture is drawn with; the sides of one scene have to agree in it. */
interface CanvasFacts {
  readonly antialias: boolean;
  readonly alpha: boolean;
  readonly samples: number;
  readonly width: number;
  readonly height: number;
}

export interface FrameBench {
  /** Opens the scene and draws its first frame. */
  open(): Promise<{ renderer: string; canvas: CanvasFacts; lit: number }>;
  /** Draws frames; milliseconds by the clock, closed by reading a pixel back. */
  draw(frames: number): Promise<number>;
  /** Milliseconds by the GPU's timer. */
  time(frames: number): Promise<number>;
  /** Draws frames without filling the GPU's queue, which script would have to wait for. */
  script(frames: number): Promise<void>;
  /** Draws until no new program has been used for a while. */
  settle(): Promise<{ longest: number; usual: number }>;
}

declare global {
  interface Window {
    bench: FrameBench;
  }
}

/** Settled: so many frames drawn, and so long without a new program. Milliseconds. */
const SETTLED = { frames: 60, quiet: 1500, atMost: 40_000 } as const;
/** Between frames while settling: programs that are compiled in the background need time. */
const BETWEEN_MS = 4;
/** Frames between waits for the GPU. */
const RUN = 20;

const SIDES: Readonly<Record<SideName, () => Promise<OpenSide>>> = {
  element: async () => (await import('./element-side.js')).openElement,
  fixed: async () => (await import('./element-side.js')).openFixed,
  three: async () => (await import('./three-side.js')).openThree,
  unlit: async () => (await import('./three-side.js')).openUnlit,
};

const query = new URLSearchParams(location.search);
let next = 0;
let draw: (i: number) => Promise<void> = () => Promise.reject(new Error('no scene is open'));
const frame = () => draw(next++);

window.bench = {
  async open() {
    const openSide = await SIDES[query.get('side') as SideName]();
    const side = await openSide(
      document.getElementById('holder')!,
      sceneOf(query.get('scene') ?? ''),
    );
    draw = (i) => side.frame(i);
    await frame();
    const gl = onlyContext();
    const lit = litShare(gl);
    const { antialias = false, alpha = false } = gl.getContextAttributes() ?? {};
    return {
      renderer: rendererName(gl),
      canvas: {
        antialias,
        alpha,
        samples: gl.getParameter(gl.SAMPLES) as number,
        width: gl.drawingBufferWidth,
        height: gl.drawingBufferHeight,
      },
      lit,
    };
  },
  draw: (frames) => clockFrames(onlyContext(), frame, frames),
  time: (frames) => timeFrames(onlyContext(), frame, frames),
  async script(frames) {
    const gl = onlyContext();
    finish(gl);
    for (let done = 0; done < frames; done += RUN) {
      for (let i = done; i < Math.min(done + RUN, frames); i++) {
        await frame();
      }
      finish(gl);
    }
  },
  async settle() {
    const gl = onlyContext();
    const seen = new Set<WebGLProgram | null>();
    const begin = performance.now();
    let quietSince = begin;
    const useProgram = gl.useProgram.bind(gl);
    gl.useProgram = (program) => {
      if (!seen.has(program)) {
        seen.add(program);
        quietSince = performance.now();
      }
      useProgram(program);
    };
    const times: number[] = [];
    for (;;) {
      times.push(await clockFrames(gl, frame, 1));
      const now = performance.now();
      if (times.length >= SETTLED.frames && now - quietSince > SETTLED.quiet) break;
      if (now - begin > SETTLED.atMost) break;
      await pause(BETWEEN_MS);
    }
    Reflect.deleteProperty(gl, 'useProgram');
    const sorted = [...times].sort((a, b) => a - b);
    return { longest: sorted.at(-1)!, usual: sorted[sorted.length >> 1]! };
  },
};

/** Share of the picture that is not transparent. */
function litShare(gl: WebGL2RenderingContext) {
  const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
  const pixels = new Uint8Array(width * height * 4);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let lit = 0;
  for (let i = 3; i < pixels.length; i += 4) {
    if (pixels[i]! > 0) {
      lit += 1;
    }
  }
  return lit / (width * height);
}
