// A front: variants of the light loop as points of run time against error. Draws them on a canvas
// of its own, and compares each with float64. Knows nothing of how results are shown.
import { fullScreenProgram } from '../../glsl/float-pass.js';
import { clockFrames, hasTimer, rendererName, timeFrames } from '../pages/timing.js';
import { errorOf, type ErrorFigures } from './errors.js';
import { BEND, type Floor, FLOORS, floorTruth, SURFACE } from './floor.js';
import { BASE, type Variant, variantsOf } from './variants.js';

interface FrontFacts {
  readonly title: string;
  readonly renderer: string;
  readonly hasTimer: boolean;
  /** Labels, in the order of the indices that `draw` and `time` take. */
  readonly variants: readonly string[];
  /** Index of the variant that times are compared with. */
  readonly base: number;
}

export interface Front {
  readonly facts: FrontFacts;
  /** Of each variant, against float64. */
  errors(): Promise<ErrorFigures[]>;
  /** Draws frames of a variant; milliseconds by the clock. */
  draw(variant: number, frames: number): Promise<number>;
  /** Milliseconds by the GPU's timer. */
  time(variant: number, frames: number): Promise<number>;
  close(): void;
}

export const FRONTS = Object.keys(FLOORS);

/** Of the square picture that errors are taken of, in pixels. */
const ERROR_SIDE = 128;
/** A task may last so long before the page gets a turn. Milliseconds. */
const TASK_MS = 12;

/** `holder` shows the canvas. */
export function openFront(
  holder: HTMLElement,
  name: string,
  [width, height]: readonly [number, number],
): Front {
  const floor = FLOORS[name]?.();
  if (floor === undefined) throw new RangeError(`no front is called ${name}`);
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width, height });
  holder.append(canvas);
  const gl = canvas.getContext('webgl2', { antialias: false, depth: false, alpha: false });
  if (gl === null) throw new Error('this browser has no WebGL 2');
  if (gl.getExtension('EXT_color_buffer_float') === null) {
    throw new Error('this device cannot draw floats, which errors are taken from');
  }
  const variants = variantsOf(floor.lights);
  const drawers = variants.map((variant) => drawerOf(gl, floor, variant));
  const frameOf = (variant: number) => () => {
    drawers[variant]!(width, height);
    return Promise.resolve();
  };
  return {
    facts: {
      title: floor.title,
      renderer: rendererName(gl),
      hasTimer: hasTimer(gl),
      variants: variants.map(({ label }) => label),
      base: variants.findIndex(({ label }) => label === BASE),
    },
    async errors() {
      const truth = await floorTruth(floor, ERROR_SIDE, pace());
      return drawers.map((draw) => errorOf(floatsOf(gl, draw), truth));
    },
    draw: (variant, frames) => clockFrames(gl, frameOf(variant), frames),
    time: (variant, frames) => timeFrames(gl, frameOf(variant), frames),
    close() {
      gl.getExtension('WEBGL_lose_context')?.loseContext();
      canvas.remove();
    },
  };
}

type Drawer = (width: number, height: number) => void;

function drawerOf(
  gl: WebGL2RenderingContext,
  { eye, shininess, half }: Floor,
  variant: Variant,
): Drawer {
  const program = fullScreenProgram(gl, fragmentOf(variant));
  const at = (uniform: string): WebGLUniformLocation | null =>
    gl.getUniformLocation(program, uniform);
  const { ka, kd, ks } = SURFACE;
  gl.useProgram(program);
  gl.uniform3f(at('uEye'), ...eye);
  gl.uniform3f(at('uKa'), ka, ka, ka);
  gl.uniform3f(at('uKd'), kd, kd, kd);
  gl.uniform3f(at('uKs'), ks, ks, ks);
  gl.uniform1f(at('uShininess'), shininess);
  gl.uniform4fv(at('uRows'), variant.rows);
  const window = at('uWindow');
  return (width, height) => {
    gl.useProgram(program);
    gl.uniform3f(window, width / 2, height / 2, (2 * half) / height);
    gl.viewport(0, 0, width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  };
}

const fragmentOf = ({ glsl, rows }: Variant): string => `#version 300 es
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

/** Gives the page a turn whenever a task has lasted long. */
function pace(): () => Promise<void> {
  let last = performance.now();
  return async () => {
    if (performance.now() - last < TASK_MS) return;
    await new Promise((resolve) => setTimeout(resolve));
    last = performance.now();
  };
}
