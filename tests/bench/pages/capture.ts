// What a frame hands to its program, read back from the context that drew it: the texts as they were compiled, uniforms and
// uniform blocks. With it a page without any library draws the same picture by the same arithmetic.
import type { Peer } from './peers/peer.js';

export interface CapturedUniform {
  readonly name: string;
  readonly type: number;
  readonly values: readonly number[];
}

export interface Capture {
  readonly vertex: string;
  readonly fragment: string;
  readonly uniforms: readonly CapturedUniform[];
  readonly blocks: readonly { readonly name: string; readonly data: readonly number[] }[];
}

/** After a frame: of the program that drew last. */
export function captureOf(peer: Peer): Capture {
  const { gl } = peer;
  peer.draw();
  const program = gl.getParameter(gl.CURRENT_PROGRAM) as WebGLProgram;
  const text = (type: number): string => {
    const shader = gl
      .getAttachedShaders(program)
      ?.find((s) => gl.getShaderParameter(s, gl.SHADER_TYPE) === type);
    const source = shader === undefined ? null : gl.getShaderSource(shader);
    if (source === null) throw new Error('the program no longer has its texts');
    return source;
  };
  return {
    vertex: text(gl.VERTEX_SHADER),
    fragment: text(gl.FRAGMENT_SHADER),
    uniforms: uniformsOf(gl, program),
    blocks: blocksOf(gl, program),
  };
}

function uniformsOf(gl: WebGL2RenderingContext, program: WebGLProgram): CapturedUniform[] {
  const uniforms: CapturedUniform[] = [];
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) as number;
  for (let i = 0; i < count; i++) {
    const { name, type, size } = gl.getActiveUniform(program, i)!;
    for (let k = 0; k < size; k++) {
      const element = name.replace(/\[0\]$/, `[${k}]`);
      const location = gl.getUniformLocation(program, element);
      if (location === null) continue; // a block's
      const value: unknown = gl.getUniform(program, location);
      if (type === gl.SAMPLER_2D) throw new Error(`${name}: textures are not captured`);
      const values = typeof value === 'object' ? Array.from(value as ArrayLike<number>) : [Number(value)];
      uniforms.push({ name: element, type, values });
    }
  }
  return uniforms;
}

function blocksOf(gl: WebGL2RenderingContext, program: WebGLProgram): Capture['blocks'] {
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORM_BLOCKS) as number;
  return Array.from({ length: count }, (_, i) => {
    const bytes = gl.getActiveUniformBlockParameter(program, i, gl.UNIFORM_BLOCK_DATA_SIZE) as number;
    const at = gl.getActiveUniformBlockParameter(program, i, gl.UNIFORM_BLOCK_BINDING) as number;
    const buffer = gl.getIndexedParameter(gl.UNIFORM_BUFFER_BINDING, at) as WebGLBuffer;
    const data = new Float32Array(bytes / 4);
    gl.bindBuffer(gl.COPY_READ_BUFFER, buffer);
    gl.getBufferSubData(gl.COPY_READ_BUFFER, 0, data);
    gl.bindBuffer(gl.COPY_READ_BUFFER, null);
    return { name: gl.getActiveUniformBlockName(program, i)!, data: Array.from(data) };
  });
}
