// The page's WebGL 2 context and three.js's renderer on it.
import { getConsoleFunction, setConsoleFunction, WebGLRenderer } from 'three';
import type { Size } from './atlas.js';

/** The browser gave no WebGL 2 context. */
export class NoWebGL2Error extends Error {
  override readonly name = 'NoWebGL2Error';
}

const CONTEXT: WebGLContextAttributes = {
  alpha: true,
  antialias: true,
  depth: true,
  stencil: false,
  premultipliedAlpha: true,
};

/**
 * Pixels of the longest side of a drawing that any GPU has memory for, with 4 samples per pixel. Tiles of a capture and
 * the canvas of a new context are not larger.
 */
export const SAFE_SIDE = 4096;

/**
 * Opens the context on a canvas of the size of the first drawing: opening small and growing takes 6 ms longer at 600 ×
 * 400 and at 1920 × 1080 (medians of 24, software). A drawing beyond {@link SAFE_SIDE} starts on a canvas of one pixel:
 * Chromium gives no context for 8192 × 8192, nor any other to this page afterwards, but a canvas that grows gets a
 * smaller drawing buffer at worst. Throws {@link NoWebGL2Error}.
 */
export function openContext({ width, height }: Size): WebGL2RenderingContext {
  const canvas = document.createElement('canvas');
  const isSafe = Math.max(width, height) <= SAFE_SIDE;
  canvas.width = isSafe ? width : 1;
  canvas.height = isSafe ? height : 1;
  let cause: unknown;
  try {
    const context = canvas.getContext('webgl2', CONTEXT);
    if (context !== null) return context;
  } catch (error) {
    cause = error; // some privacy tools replace getContext by a function that throws
  }
  throw new NoWebGL2Error('this browser gives no WebGL 2 context', { cause });
}

/** Throws if the context is lost, or gets lost meanwhile. */
export function rendererOf(context: WebGL2RenderingContext): WebGLRenderer {
  const canvas = context.canvas as HTMLCanvasElement;
  // three.js logs what it cannot read, and a lost context answers null. The stage reports the loss.
  const log = getConsoleFunction() as ConsoleFunction | null; // null if none was set, whatever the types say
  setConsoleFunction((type, ...parts) => {
    if (context.isContextLost()) return;
    if (log === null) console.warn(...parts);
    else log(type, ...parts);
  });
  let renderer: WebGLRenderer;
  try {
    // The canvas gives three.js the same context again. Given it, three.js would touch WebGLRenderingContext, whose
    // interface the browser builds at the first touch (35 kB of heap).
    renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  } finally {
    setConsoleFunction(log as ConsoleFunction);
  }
  renderer.debug.checkShaderErrors = false; // see checkLinks
  renderer.autoClear = false; // the stage clears once for all pictures of a frame
  renderer.setOpaqueSort(byScene);
  renderer.setTransparentSort(fromBehind);
  return renderer;
}

type ConsoleFunction = ReturnType<typeof getConsoleFunction>;

/**
 * Keeps the scene's order (sorting is stable): where surfaces coincide, the last one in the markup shows. three.js
 * would sort by material, in the order in which materials were created.
 */
const byScene = (a: Ordered, b: Ordered): number => a.groupOrder - b.groupOrder || a.renderOrder - b.renderOrder;

/** Farther objects first. At equal depth this keeps the scene's order; three.js would sort by creation. */
const fromBehind = (a: Ordered, b: Ordered): number => byScene(a, b) || b.z - a.z;

/** The part of three.js's render item that sorting reads. */
interface Ordered {
  readonly groupOrder: number;
  readonly renderOrder: number;
  /** Depth. */
  readonly z: number;
}

/**
 * Longest side of a drawing, in pixels, by what the GPU says. Whether there is memory shows when the canvas has that
 * size.
 */
export function largestSideOf(gl: WebGL2RenderingContext): number {
  // A lost context answers null.
  const viewport = (gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array | null) ?? [];
  const sides = [...viewport, gl.getParameter(gl.MAX_RENDERBUFFER_SIZE), gl.getParameter(gl.MAX_TEXTURE_SIZE)];
  return Math.min(...sides.map(Number));
}

/**
 * Whether 2D canvases get the pixels of a restored context. After a crash of the GPU process they get none in Chromium
 * (156), however often the context draws: only a new canvas helps. Overwrites one drawing.
 */
export function canBeCopied(gl: WebGL2RenderingContext): boolean {
  gl.clearColor(1, 1, 1, 1);
  gl.clear(gl.COLOR_BUFFER_BIT);
  const copy = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  copy?.drawImage(gl.canvas, 0, 0);
  return copy?.getImageData(0, 0, 1, 1).data[3] === 255;
}

/**
 * Releases the context now, or as soon as it is restored. Browsers allow few, and garbage collection would release it
 * late.
 */
export function closeContext(gl: WebGL2RenderingContext): void {
  const close = (): void => gl.getExtension('WEBGL_lose_context')?.loseContext(); // null while the context is lost
  gl.canvas.addEventListener('webglcontextrestored', close, { once: true });
  close();
}
