// What draws: software or a GPU, and how many rows of lights fit its uniforms.
import type { WebGLRenderer } from 'three';

/**
 * Rows of the uniform array in general programs: what WebGL 2 promises (224) less RESERVED, then
 * 1,000.
 */
const CAPACITIES = [200, 1000] as const;
const RESERVED = 24;

export class NoWebGL2Error extends Error {
  override readonly name = 'NoWebGL2Error';
}

export interface Device {
  readonly renderer: WebGLRenderer;
  /** A software renderer. An unknown name means a GPU. */
  readonly software: boolean;
  /** Rows of the uniform array, in steps. */
  readonly capacities: readonly number[];
}

const devices = new WeakMap<WebGLRenderer, Device>();

/**
 * What a renderer draws on. Ask once before its first commands: the answer waits for all that are
 * queued.
 */
export function deviceOf(renderer: WebGLRenderer): Device {
  const present = devices.get(renderer);
  if (present !== undefined) return present;
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(gl.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
  const most = Math.min(
    gl.getParameter(gl.MAX_FRAGMENT_UNIFORM_VECTORS) as number,
    gl.getParameter(gl.MAX_VERTEX_UNIFORM_VECTORS) as number,
  );
  const software = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
  const device = {
    renderer,
    software,
    // SwiftShader draws 1.4 times as long with a uniform array, which it reads float by float.
    capacities: software ? [] : CAPACITIES.filter((rows) => rows <= most - RESERVED),
  };
  if (!gl.isContextLost()) {
    devices.set(renderer, device); // a lost context answers null
  }
  return device;
}
