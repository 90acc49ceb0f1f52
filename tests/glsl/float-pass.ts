// Runs GLSL on numbers: float textures in, one case a texel, RGBA32F and RGBA8 out, on whatever
// WebGL 2 the browser has. Knows nothing of lighting.

const VERTEX = `#version 300 es
void main() {
  // One triangle over everything.
  gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);
}`;

export interface PassSource {
  /** Defines, constants and functions: the text under test. */
  readonly glsl: string;
  /** Names of the inputs: `vec4`s that `main` may read. */
  readonly inputs: readonly string[];
  /** Names of other float textures, read by the text itself as `sampler2D`. */
  readonly textures?: readonly string[];
  /**
   * Statements that set `result` (vec4, as it is) and may set `shown` (vec4, kept as 8-bit codes).
   */
  readonly main: string;
}

export interface PassResult {
  /** Four floats per case. */
  readonly floats: Float32Array;
  /** Four codes per case. */
  readonly codes: Uint8Array;
}

/** Uniforms by name: two numbers are a vec2, more are an array of vec4. */
export type Uniforms = Readonly<Record<string, ArrayLike<number>>>;

/** RGBA32F texels, row by row. */
interface FloatTexture {
  readonly data: Float32Array;
  readonly width: number;
}

/** The context that all passes share. Throws where the browser cannot draw into floats. */
export function floatContext(): WebGL2RenderingContext {
  const canvas = document.createElement('canvas');
  const gl = canvas.getContext('webgl2', { antialias: false, depth: false });
  if (gl === null) throw new Error('no WebGL 2');
  if (gl.getExtension('EXT_color_buffer_float') === null) {
    throw new Error('no EXT_color_buffer_float');
  }
  return gl;
}

/** The renderer's name. */
export function rendererName(gl: WebGL2RenderingContext): string {
  // Firefox gives the name without the extension, and warns about it.
  const plain = String(gl.getParameter(gl.RENDERER));
  if (!/WebKit|Mozilla/.test(plain)) return plain;
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return info === null ? plain : String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL));
}

export class FloatPass {
  readonly #gl: WebGL2RenderingContext;
  readonly #program: WebGLProgram;
  readonly #samplers: readonly string[];

  constructor(gl: WebGL2RenderingContext, { glsl, inputs, textures = [], main }: PassSource) {
    this.#gl = gl;
    this.#samplers = [...inputs.map(samplerOf), ...textures];
    this.#program = fullScreenProgram(
      gl,
      `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
${inputs.map((name) => `uniform sampler2D ${samplerOf(name)};`).join('\n')}
${inputs.map((name) => `vec4 ${name};`).join('\n')}
${glsl}
layout(location = 0) out vec4 outFloats;
layout(location = 1) out vec4 outCodes;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  ${inputs.map((name) => `${name} = texelFetch(${samplerOf(name)}, at, 0);`).join('\n  ')}
  vec4 result = vec4(0.0);
  vec4 shown = vec4(0.0);
  ${main}
  outFloats = result;
  outCodes = shown;
}`,
    );
  }

  /**
   * One texture an input and one a further texture, in the order of the source; inputs share one
   * size.
   */
  run(textures: readonly FloatTexture[], uniforms: Uniforms = {}): PassResult {
    const gl = this.#gl;
    const { data, width } = textures[0]!;
    const height = data.length / 4 / width;
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    const targets = [gl.RGBA32F, gl.RGBA8].map((format, i) => {
      const target = gl.createTexture();
      gl.activeTexture(gl.TEXTURE0);
      gl.bindTexture(gl.TEXTURE_2D, target);
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, target, 0);
      return target;
    });
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) {
      throw new Error('this driver cannot draw into RGBA32F and RGBA8 at once');
    }
    gl.viewport(0, 0, width, height);
    gl.useProgram(this.#program);
    const bound = textures.map((texture, i) => this.#bind(texture, i));
    for (const [name, numbers] of Object.entries(uniforms)) {
      const place = gl.getUniformLocation(this.#program, name);
      if (numbers.length === 2) {
        gl.uniform2fv(place, Float32Array.from(numbers));
      } else {
        gl.uniform4fv(place, Float32Array.from(numbers));
      }
    }
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const floats = new Float32Array(width * height * 4);
    const codes = new Uint8Array(width * height * 4);
    gl.readBuffer(gl.COLOR_ATTACHMENT0);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, floats);
    gl.readBuffer(gl.COLOR_ATTACHMENT1);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, codes);
    for (const texture of [...targets, ...bound]) {
      gl.deleteTexture(texture);
    }
    gl.deleteFramebuffer(frame);
    const error = gl.getError();
    if (error !== gl.NO_ERROR) throw new Error(`WebGL error ${error}`);
    return { floats, codes };
  }

  dispose(): void {
    this.#gl.deleteProgram(this.#program);
  }

  #bind({ data, width }: FloatTexture, unit: number) {
    const gl = this.#gl;
    const texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    const height = data.length / 4 / width;
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, data);
    gl.uniform1i(gl.getUniformLocation(this.#program, this.#samplers[unit]!), unit);
    return texture;
  }
}

const samplerOf = (input: string) => `u_${input}`;

/** A program that runs this fragment shader on every pixel. Throws with the driver's words. */
export function fullScreenProgram(gl: WebGL2RenderingContext, fragment: string): WebGLProgram {
  const program = gl.createProgram();
  const sources = [
    [gl.VERTEX_SHADER, VERTEX],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const;
  for (const [type, source] of sources) {
    const shader = gl.createShader(type)!;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (gl.getShaderParameter(shader, gl.COMPILE_STATUS) !== true) {
      throw new Error(`${gl.getShaderInfoLog(shader) ?? ''}\n${numbered(source)}`);
    }
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
  }
  gl.linkProgram(program);
  if (gl.getProgramParameter(program, gl.LINK_STATUS) !== true) {
    throw new Error(gl.getProgramInfoLog(program) ?? 'the program does not link');
  }
  return program;
}

const numbered = (source: string) =>
  source
    .split('\n')
    .map((line, i) => `${i + 1}: ${line}`)
    .join('\n');
