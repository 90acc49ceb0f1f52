// Times light loops against each other in this browser: the same lights, every pixel lit, texts interleaved in rounds, each
// sample closed by reading a pixel back.
import { emptyPack, packLights } from '../../../src/light/pack-lights.js';
import type { LightValues } from '../../../src/light/light-state.js';
import { ORIGIN } from '../../stress/case.js';
import { anyLight, colors } from '../../stress/fragments.js';
import { Random } from '../../stress/random.js';
import { FACTS } from '../../glsl/loop-pass.js';
import { floatContext, fullScreenProgram, rendererName } from '../../glsl/float-pass.js';

export interface Loop {
  readonly name: string;
  /** Functions and uniforms: the text under test. */
  readonly glsl: string;
  /** Sets `vec3 color` from `vec3 p, normal, eye`. */
  readonly main: string;
}

export interface TimeOptions {
  readonly loops: readonly Loop[];
  readonly lights: number;
  readonly blinn: boolean;
  readonly size: number;
  readonly rounds: number;
  /** Draws a sample. */
  readonly draws: number;
}

export interface Times {
  readonly renderer: string;
  /** Milliseconds a draw: [loop][round]. */
  readonly samples: readonly (readonly number[])[];
}

declare global {
  interface Window {
    timeLoops: (options: TimeOptions) => Promise<Times>;
  }
}

const fragment = ({ glsl, main }: Loop, blinn: boolean, size: number): string => `#version 300 es
precision highp float;
precision highp int;
#define LIGHT_STORAGE STORAGE_BLOCK
${FACTS.map((fact) => `#define HAS_${fact}`).join('\n')}
${blinn ? '#define REFLECTION_BLINN_PHONG' : ''}
${glsl}
out vec4 outColor;
void main() {
  vec2 at = gl_FragCoord.xy / ${size.toFixed(1)} * 2.0 - 1.0;
  // A bulging floor: every pixel has a point and a normal of its own.
  vec3 p = vec3(at, 0.3 * dot(at, at));
  vec3 normal = vec3(-0.6 * at, 1.0);
  vec3 eye = vec3(0.3, 0.2, 4.0);
  vec3 color;
  ${main}
  outColor = vec4(color, 1.0);
}`;

/** Lights of all kinds over the floor, from the stress cases' own generator. */
function mixedLights(count: number): LightValues[] {
  const random = new Random(1);
  return Array.from({ length: count }, () => anyLight(random, ORIGIN, colors(random, 510 / count)));
}

window.timeLoops = async ({ loops, lights, blinn, size, rounds, draws }) => {
  const gl = floatContext();
  const programs = loops.map((loop) => fullScreenProgram(gl, fragment(loop, blinn, size)));
  bindLights(gl, programs, mixedLights(lights));
  const target = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, target);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, size, size);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
  gl.viewport(0, 0, size, size);
  const pixel = new Uint8Array(4);
  const sample = (program: WebGLProgram): number => {
    gl.useProgram(program);
    const start = performance.now();
    for (let i = 0; i < draws; i++) gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return (performance.now() - start) / draws;
  };
  programs.forEach(sample); // compiled by now, and warm
  const samples: number[][] = loops.map(() => []);
  for (let round = 0; round < rounds; round++) {
    // Every other round backwards, so that none always follows the same one.
    const order = programs.map((_, i) => (round % 2 === 0 ? i : programs.length - 1 - i));
    for (const i of order) samples[i]!.push(sample(programs[i]!));
    await new Promise((resolve) => setTimeout(resolve));
  }
  return { renderer: rendererName(gl), samples };
};

function bindLights(
  gl: WebGL2RenderingContext,
  programs: readonly WebGLProgram[],
  lights: readonly LightValues[],
): void {
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const packed = emptyPack();
  packLights(lights, { worldToShading: identity, cameraToShading: identity, linear: false }, packed);
  gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, gl.createBuffer());
  gl.bufferData(gl.UNIFORM_BUFFER, 16384, gl.STATIC_DRAW);
  gl.bufferSubData(gl.UNIFORM_BUFFER, 0, packed.data, 0, packed.rows * 4);
  for (const program of programs) {
    gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, 'LightRows'), 0);
  }
}
