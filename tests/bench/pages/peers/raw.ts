// A page of WebGL 2 calls alone that draws what another page drew, from what was captured there: the same texts, numbers
// and triangles, and nothing per frame but a clear and a draw.
import type { Capture, CapturedUniform } from '../capture.js';
import { bentPlane } from '../scenes.js';
import type { Peer } from './peer.js';

export function raw(holder: HTMLElement, { vertex, fragment, uniforms, blocks }: Capture): Peer {
  const canvas = document.createElement('canvas');
  holder.append(canvas);
  const gl = canvas.getContext('webgl2', { alpha: true, antialias: true, depth: true })!;
  const program = linked(gl, vertex, fragment);
  gl.useProgram(program);
  for (const uniform of uniforms) setUniform(gl, program, uniform);
  blocks.forEach(({ name, data }, i) => {
    gl.bindBufferBase(gl.UNIFORM_BUFFER, i, gl.createBuffer());
    gl.bufferData(gl.UNIFORM_BUFFER, new Float32Array(data), gl.DYNAMIC_DRAW);
    gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, name), i);
  });
  const { positions, normals, indices } = bentPlane();
  attribute(gl, program, 'position', positions);
  attribute(gl, program, 'normal', normals);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LEQUAL); // as three.js does
  gl.clearColor(0, 0, 0, 0);
  return {
    gl,
    draw() {
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.useProgram(program);
      gl.drawElements(gl.TRIANGLES, indices.length, gl.UNSIGNED_SHORT, 0);
    },
    programs: () => 1,
    resize(width, height) {
      canvas.width = width;
      canvas.height = height;
      gl.viewport(0, 0, width, height);
      return Promise.resolve();
    },
  };
}

function linked(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const program = gl.createProgram();
  for (const [type, text] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(type)!;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (gl.getProgramParameter(program, gl.LINK_STATUS) !== true)
    throw new Error(gl.getProgramInfoLog(program) ?? 'the program does not link');
  return program;
}

function attribute(
  gl: WebGL2RenderingContext,
  program: WebGLProgram,
  name: string,
  data: Float32Array,
): void {
  const location = gl.getAttribLocation(program, name);
  if (location < 0) return;
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(location);
  gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 0, 0);
}

function setUniform(gl: WebGL2RenderingContext, program: WebGLProgram, uniform: CapturedUniform): void {
  const { name, type, values } = uniform;
  const at = gl.getUniformLocation(program, name);
  const setters: Record<number, () => void> = {
    [gl.FLOAT]: () => gl.uniform1fv(at, values),
    [gl.FLOAT_VEC2]: () => gl.uniform2fv(at, values),
    [gl.FLOAT_VEC3]: () => gl.uniform3fv(at, values),
    [gl.FLOAT_VEC4]: () => gl.uniform4fv(at, values),
    [gl.FLOAT_MAT3]: () => gl.uniformMatrix3fv(at, false, values),
    [gl.FLOAT_MAT4]: () => gl.uniformMatrix4fv(at, false, values),
    [gl.INT]: () => gl.uniform1iv(at, values),
    [gl.BOOL]: () => gl.uniform1iv(at, values),
    [gl.INT_VEC2]: () => gl.uniform2iv(at, values),
    [gl.INT_VEC3]: () => gl.uniform3iv(at, values),
    [gl.INT_VEC4]: () => gl.uniform4iv(at, values),
  };
  const set = setters[type];
  if (set === undefined) throw new Error(`${name}: no uniform of type ${type} is copied`);
  set();
}
