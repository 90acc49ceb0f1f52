// The loops' arithmetic, drawn and timed: a bent floor that fills the picture, its points and normals made in the fragment
// shader without any rounding, so that what differs from float64 is the loop alone.
import type { ColorPicture } from '../error/error-figures.js';
import { shade } from '../../../src/reference/equation.js';
import { isSoftware } from '../sampling.mjs';
import { rendererName, fullScreenProgram } from '../../glsl/float-pass.js';
import { BEND, FLOOR_SCENES, type FloorScene } from './floor-scenes.js';
import { ARRAY_ROWS, loopsOf, type LoopText, SURFACE } from './loops.js';
import { type Axis, type Pace, type Size, squareSide, type Stand, type Subject } from './stand.js';

export const loops: Axis = {
  title: 'The loop’s arithmetic',
  scenes: Object.keys(FLOOR_SCENES),
  open(name, { size, seed, evaluations }, holder) {
    const scene = FLOOR_SCENES[name]!(seed);
    const { gl, close } = floatCanvas(holder, size);
    const side = squareSide(evaluations, scene.lights.filter((light) => light.active).length);
    const floor = new Floor(gl, scene, size, [side, side]);
    const texts = loopsOf(scene, isSoftware(rendererName(gl)));
    const stand: Stand = {
      title: `The loop’s arithmetic: ${scene.title}`,
      truth: 'the equation in float64, fragment by fragment',
      ...{ base: 'literal', shipped: 'shipped', size, errorSize: [side, side] },
      subjects: texts.map((text) => floor.subject(text)),
      reference: (pace) => floorReference(scene, side, pace),
      close,
    };
    return Promise.resolve(stand);
  },
};

/** A canvas in `holder` whose context can draw into floats too. */
export function floatCanvas(
  holder: HTMLElement,
  size: Size,
): { gl: WebGL2RenderingContext; close: () => void } {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = size;
  holder.append(canvas);
  const gl = canvas.getContext('webgl2', { antialias: false, depth: false, alpha: false });
  if (gl === null) throw new Error('no WebGL 2');
  if (gl.getExtension('EXT_color_buffer_float') === null)
    throw new Error('this device cannot draw into floats: nothing tells how exact a loop is');
  const close = (): void => {
    gl.getExtension('WEBGL_lose_context')?.loseContext();
    canvas.remove();
  };
  return { gl, close };
}

const TEXTURE_WIDTH = 1024; // 1 << TEXTURE_ROWS_LOG2, as the shipped text reads it
const BLOCK_FLOATS = 4096;

export class Floor {
  readonly #gl: WebGL2RenderingContext;
  readonly #scene: FloorScene;
  readonly #size: Size;
  readonly #errorSize: Size;

  constructor(gl: WebGL2RenderingContext, scene: FloorScene, size: Size, errorSize: Size) {
    this.#gl = gl;
    this.#scene = scene;
    this.#size = size;
    this.#errorSize = errorSize;
  }

  subject(text: LoopText): Subject {
    const gl = this.#gl;
    const storage = text.storage === 'array' && text.rows.length / 4 > ARRAY_ROWS ? 'texture' : text.storage;
    const program = fullScreenProgram(gl, fragmentOf(text, storage));
    const at = (name: string): WebGLUniformLocation | null => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    const { eye, shininess } = this.#scene;
    const { ka, kd, ks } = SURFACE;
    gl.uniform3f(at('uEye'), ...eye);
    gl.uniform3f(at('uKa'), ka, ka, ka);
    gl.uniform3f(at('uKd'), kd, kd, kd);
    gl.uniform3f(at('uKs'), ks, ks, ks);
    gl.uniform1f(at('uShininess'), shininess);
    const bind = this.#store(program, text.rows, storage);
    const window = at('uWindow');
    const draw = ([width, height]: Size): void => {
      gl.useProgram(program);
      bind();
      gl.uniform3f(window, width / 2, height / 2, (2 * this.#scene.half) / height);
      gl.viewport(0, 0, width, height);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    };
    return {
      ...{ id: text.id, label: text.label, gl },
      draw: () => {
        draw(this.#size);
      },
      picture: () => this.#floats(draw),
    };
  }

  /** Sends the rows; what comes back makes them the program's own for a draw. */
  #store(program: WebGLProgram, rows: Float32Array, storage: LoopText['storage']): () => void {
    const gl = this.#gl;
    if (storage === 'array') {
      gl.uniform4fv(gl.getUniformLocation(program, 'uRows'), rows.length > 0 ? rows : new Float32Array(4));
      return () => undefined;
    }
    if (storage === 'block') {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
      gl.bufferData(gl.UNIFORM_BUFFER, 4 * BLOCK_FLOATS, gl.STATIC_DRAW);
      gl.bufferSubData(gl.UNIFORM_BUFFER, 0, rows);
      gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, 'LightRows'), 0);
      return () => {
        gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, buffer);
      };
    }
    const texture = gl.createTexture();
    const height = Math.ceil(rows.length / 4 / TEXTURE_WIDTH);
    const data = new Float32Array(4 * TEXTURE_WIDTH * height);
    data.set(rows);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, TEXTURE_WIDTH, height, 0, gl.RGBA, gl.FLOAT, data);
    return () => {
      gl.bindTexture(gl.TEXTURE_2D, texture);
    };
  }

  /** A frame in floats, which 8-bit codes would round. */
  #floats(draw: (size: Size) => void): ColorPicture {
    const gl = this.#gl;
    const [width, height] = this.#errorSize;
    const target = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, target);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, width, height);
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
    draw([width, height]);
    const floats = new Float32Array(width * height * 4);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, floats);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(frame);
    gl.deleteTexture(target);
    const data = new Float64Array(width * height * 3);
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        const from = 4 * (x + width * (height - 1 - y)); // WebGL counts rows from the bottom
        for (let k = 0; k < 3; k++) data[3 * (x + width * y) + k] = shown(floats[from + k]!);
      }
    }
    return { width, height, data };
  }
}

/** In 1/255, clamped as a screen does it; what is no number is as wrong as can be. */
const shown = (channel: number): number =>
  Number.isFinite(channel) ? 255 * Math.min(Math.max(channel, 0), 1) : NOT_A_NUMBER;
/** Farther from any colour than any colour is. */
const NOT_A_NUMBER = -255;

function fragmentOf({ defines, glsl, rows, precision }: LoopText, storage: LoopText['storage']): string {
  const count = Math.max(rows.length / 4, 1);
  const rowOf =
    storage === 'array'
      ? `uniform vec4 uRows[${String(count)}];\nvec4 row(int i) { return uRows[i]; }`
      : `uniform highp sampler2D uRowTexture;\nvec4 row(int i) { return texelFetch(uRowTexture, ivec2(i % ${String(TEXTURE_WIDTH)}, i / ${String(TEXTURE_WIDTH)}), 0); }`;
  const text = `precision highp float;
precision highp int;
#define LIGHT_STORAGE ${storage === 'block' ? 'STORAGE_BLOCK' : 'STORAGE_TEXTURE'}
${defines.map((define) => `#define ${define}`).join('\n')}
uniform vec3 uEye, uKa, uKd, uKs;
uniform float uShininess;
${storage === 'block' ? '' : rowOf}
${glsl}`;
  const lowered = precision === 'mediump' ? text.replaceAll(/\bhighp (float|vec4)\b/g, 'mediump $1') : text;
  return `#version 300 es
${lowered}
uniform highp vec3 uWindow;
out vec4 outColor;
void main() {
  highp vec2 at = (gl_FragCoord.xy - uWindow.xy) * uWindow.z;
  highp vec3 p = vec3(at, ${(-BEND).toExponential()} * dot(at, at));
  highp vec3 normal = vec3(${(2 * BEND).toExponential()} * at, 1.0);
  outColor = vec4(shadeHere(p, normal), 1.0);
}`;
}

async function floorReference(
  { lights, shininess, eye, half }: FloorScene,
  side: number,
  pace: Pace,
): Promise<ColorPicture> {
  const { ka, kd, ks } = SURFACE;
  const grey = (k: number) => [255 * k, 255 * k, 255 * k] as const;
  const surface = { ka: grey(ka), kd: grey(kd), ks: grey(ks), shininess };
  const active = lights.filter((light) => light.active);
  const step = (2 * half) / side;
  const data = new Float64Array(3 * side * side);
  for (let j = 0; j < side; j++) {
    const y = (side / 2 - j - 0.5) * step;
    for (let i = 0; i < side; i++) {
      const x = (i + 0.5 - side / 2) * step;
      const p = [x, y, -BEND * (x * x + y * y)] as const;
      const { color } = shade({ p, normal: [2 * BEND * x, 2 * BEND * y, 1], eye }, surface, active);
      color.forEach((channel, k) => (data[3 * (i + side * j) + k] = 255 * channel));
    }
    await pace();
  }
  return { width: side, height: side, data };
}
