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
 * On a canvas of this size: each other size later makes all buffers anew, twice, and the page waits for both. Throws
 * {@link NoWebGL2Error}.
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
  renderer.setClearColor(0x000000, 0);
  renderer.setOpaqueSort(byScene);
  renderer.setTransparentSort(fromBehind);
  return renderer;
}

/**
 * In the order of the scene, which sorting leaves as it is: of surfaces in one place the last one shows. three.js's own order
 * is that in which materials were made, of which the markup says nothing and which exact programs change.
 */
const byScene = (a: Ordered, b: Ordered): number =>
  a.groupOrder - b.groupOrder || a.renderOrder - b.renderOrder;

/** Farther ones first; three.js's own order goes on by which object was made first. */
const fromBehind = (a: Ordered, b: Ordered): number => byScene(a, b) || b.z - a.z;

/** Of what three.js sorts. */
interface Ordered {
  readonly groupOrder: number;
  readonly renderOrder: number;
  /** Depth. */
  readonly z: number;
}

/** The largest side of one drawing, in pixels. */
export function maxSizeOf(gl: WebGL2RenderingContext): number {
  const viewport = gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array;
  return Math.min(viewport[0] ?? 0, viewport[1] ?? 0, gl.getParameter(gl.MAX_RENDERBUFFER_SIZE) as number);
}

/** Browsers keep few contexts: gives one back now rather than at some garbage collection. */
export function closeContext(renderer: WebGLRenderer): void {
  renderer.dispose();
  renderer.getContext().getExtension('WEBGL_lose_context')?.loseContext();
}
