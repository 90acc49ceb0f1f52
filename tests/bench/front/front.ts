// Draws one scene by all ways to write the light loop, on a canvas of its own, times them and
// compares each with float64. Knows nothing of how results are shown.
import { fullScreenProgram } from '../../glsl/float-pass.js';
import { clockFrames, hasTimer, timeFrames } from '../pages/timing.js';
import type { WayName } from '../accuracy-words.mjs';
import { errorsOf } from './errors.js';
import { BEND, type Floor, floorOf, floorTruth, SURFACE } from './floor.js';
import { type Variant, variantsOf } from './variants.js';

export interface Front {
  readonly hasTimer: boolean;
  /** Of every channel of a square picture of ERROR_SIDE, rows from the bottom, against float64. */
  errors(signal: AbortSignal): Promise<Record<WayName, Float64Array>>;
  /** Draws frames; milliseconds by the clock. */
  draw(way: WayName, frames: number): Promise<number>;
  /** Milliseconds by the GPU's timer. */
  time(way: WayName, frames: number): Promise<number>;
  close(): void;
}

/** Of the picture that errors are taken of, in pixels. */
export const ERROR_SIDE = 128;
/** A task may last so long before the page gets a turn. Milliseconds. */
const TASK_MS = 12;

/** @param holder shows the canvas @param software see {@link variantsOf} */
export function openFront(
  holder: HTMLElement,
  shininess: number,
  [width, height]: readonly [number, number],
  software: boolean,
): Front {
  const floor = floorOf(shininess);
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width, height });
  holder.append(canvas);
  const gl = canvas.getContext('webgl2', { antialias: false, depth: false, alpha: false });
  if (gl === null) throw new Error('this browser has no WebGL 2');
  if (gl.getExtension('EXT_color_buffer_float') === null) {
    throw new Error('this device cannot draw floats, which errors are taken from');
  }
  const drawers = eachWay(variantsOf(floor.lights, shininess, software), (variant) =>
    drawerOf(gl, floor, variant),
  );
  const frameOf = (way: WayName) => () => {
    drawers[way](width, height);
    return Promise.resolve();
  };
  return {
    hasTimer: hasTimer(gl),
    async errors(signal) {
      const truth = await floorTruth(floor, ERROR_SIDE, pace(signal));
      return eachWay(drawers, (draw) => errorsOf(floatsOf(gl, draw), truth));
    },
    draw: (way, frames) => clockFrames(gl, frameOf(way), frames),
    time: (way, frames) => timeFrames(gl, frameOf(way), frames),
    close() {
      gl.getExtension('WEBGL_lose_context')?.loseContext();
      canvas.remove();
    },
  };
}

const eachWay = <T, U>(of: Readonly<Record<WayName, T>>, make: (one: T) => U) =>
  Object.fromEntries(Object.entries(of).map(([way, one]) => [way, make(one)])) as Record<
    WayName,
    U
  >;

type Drawer = (width: number, height: number) => void;

function drawerOf(
  gl: WebGL2RenderingContext,
  { eye, shininess, half }: Floor,
  variant: Variant,
): Drawer {
  const program = fullScreenProgram(gl, fragmentOf(variant));
  const at = (uniform: string) => gl.getUniformLocation(program, uniform);
  const { ka, kd, ks } = SURFACE;
  gl.useProgram(program);
  gl.uniform3f(at('uEye'), ...eye);
  gl.uniform3f(at('uKa'), ka, ka, ka);
  gl.uniform3f(at('uKd'), kd, kd, kd);
  gl.uniform3f(at('uKs'), ks, ks, ks);
  gl.uniform1f(at('uShininess'), shininess);
  gl.uniform4fv(at('uRows'), variant.rows);
  const texture = at('uLightTexture') === null ? null : rowTexture(gl, variant.rows);
  gl.uniform2f(at('uLightTextureScale'), 4 / variant.rows.length, 1);
  const window = at('uWindow');
  return (width, height) => {
    gl.useProgram(program);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform3f(window, width / 2, height / 2, (2 * half) / height);
    gl.viewport(0, 0, width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  };
}

/** The rows of lights, one a texel. */
function rowTexture(gl: WebGL2RenderingContext, rows: Float32Array) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, rows.length / 4, 1, 0, gl.RGBA, gl.FLOAT, rows);
  for (const [name, value] of [
    [gl.TEXTURE_MIN_FILTER, gl.NEAREST],
    [gl.TEXTURE_MAG_FILTER, gl.NEAREST],
    [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
    [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE],
  ] as const) {
    gl.texParameteri(gl.TEXTURE_2D, name, value);
  }
  return texture;
}

const fragmentOf = ({ glsl, rows }: Variant) => `#version 300 es
precision highp float;
precision highp int;
uniform vec3 uEye, uKa, uKd, uKs, uWindow;
uniform float uShininess;
uniform vec4 uRows[${rows.length / 4}];
vec4 row(int i) { return uRows[i]; }
${glsl}
out vec4 outColor;
void main() {
  vec2 at = (gl_FragCoord.xy - uWindow.xy) * uWindow.z;
  vec3 p = vec3(at, ${(-BEND).toExponential()} * dot(at, at));
  outColor = vec4(shadeHere(p, vec3(${(2 * BEND).toExponential()} * at, 1.0)), 1.0);
}`;

/** A square picture in floats, three channels of 0 to 255 a pixel. */
function floatsOf(gl: WebGL2RenderingContext, draw: Drawer): Float64Array {
  const target = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, target);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, ERROR_SIDE, ERROR_SIDE);
  const frame = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
  draw(ERROR_SIDE, ERROR_SIDE);
  const floats = new Float32Array(ERROR_SIDE * ERROR_SIDE * 4);
  gl.readPixels(0, 0, ERROR_SIDE, ERROR_SIDE, gl.RGBA, gl.FLOAT, floats);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(frame);
  gl.deleteTexture(target);
  const data = new Float64Array(ERROR_SIDE * ERROR_SIDE * 3);
  for (let i = 0; i < data.length; i++) {
    data[i] = 255 * Math.min(Math.max(floats[4 * Math.floor(i / 3) + (i % 3)]!, 0), 1);
  }
  return data;
}

/** Gives the page a turn whenever a task has lasted long; throws once `signal` is aborted. */
function pace(signal: AbortSignal) {
  let last = performance.now();
  return async () => {
    signal.throwIfAborted();
    if (performance.now() - last < TASK_MS) return;
    await new Promise((resolve) => setTimeout(resolve));
    last = performance.now();
  };
}
