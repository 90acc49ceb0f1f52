// The page's WebGL 2 context and three.js's renderer on it. Knows nothing of what is drawn.
import { WebGLRenderer } from 'three';
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
 * Opens the context on a canvas of the size of the first drawing. A later change of size allocates all buffers again, once
 * for each side, and blocks the page. Throws {@link NoWebGL2Error}.
 */
export function openContext({ width, height }: Size): WebGL2RenderingContext {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('webgl2', CONTEXT);
  if (context === null) throw new NoWebGL2Error('this browser gives no WebGL 2 context');
  return context;
}

export function rendererOf(context: WebGL2RenderingContext): WebGLRenderer {
  const canvas = context.canvas as HTMLCanvasElement;
  const renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true });
  renderer.autoClear = false; // the stage clears once for all pictures of a frame
  renderer.setOpaqueSort(byScene);
  renderer.setTransparentSort(fromBehind);
  return renderer;
}

/**
 * Keeps the scene's order (sorting is stable): where surfaces coincide, the last one in the markup shows. three.js would
 * sort by material, in the order in which materials were created.
 */
const byScene = (a: Ordered, b: Ordered): number =>
  a.groupOrder - b.groupOrder || a.renderOrder - b.renderOrder;

/** Farther objects first. At equal depth this keeps the scene's order; three.js would sort by creation. */
const fromBehind = (a: Ordered, b: Ordered): number => byScene(a, b) || b.z - a.z;

/** The part of three.js's render item that sorting reads. */
interface Ordered {
  readonly groupOrder: number;
  readonly renderOrder: number;
  /** Depth. */
  readonly z: number;
}

/** Largest side of one drawing, in pixels. */
export function maxSizeOf(gl: WebGL2RenderingContext): number {
  const viewport = gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array;
  return Math.min(viewport[0] ?? 0, viewport[1] ?? 0, gl.getParameter(gl.MAX_RENDERBUFFER_SIZE) as number);
}

/** Releases the context now. Browsers allow few, and garbage collection would release it late. */
export function closeContext(renderer: WebGLRenderer): void {
  renderer.dispose();
  renderer.getContext().getExtension('WEBGL_lose_context')?.loseContext();
}
