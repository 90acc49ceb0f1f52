// Tells of programs that do not link, without waiting for any that the driver still works on.
import type { WebGLProgram as ThreeProgram, WebGLRenderer } from 'three';
import { compilingPrograms } from '../../material/program/program-cache.js';

/** three.js's types leave these out. */
type Program = ThreeProgram & {
  readonly program: WebGLProgram;
  /** Asks KHR_parallel_shader_compile; true where the browser has it not. */
  isReady(): boolean;
};

/**
 * three.js's own check asks for three logs of each program, and each answer is waited for. Whether a program that was
 * drawn with has linked is known to the browser by then; the logs are wanted only where it has not.
 */
export class LinkCheck {
  readonly #checked = new WeakSet<Program>();

  constructor(renderer: WebGLRenderer) {
    renderer.debug.checkShaderErrors = false;
  }

  /** After drawing: each program that has failed is reported, once. */
  check(renderer: WebGLRenderer): void {
    const gl = renderer.getContext();
    for (const program of (renderer.info.programs ?? []) as Program[]) {
      if (this.#checked.has(program) || compilingPrograms.has(program) || !program.isReady()) continue;
      this.#checked.add(program);
      if (gl.getProgramParameter(program.program, gl.LINK_STATUS) === true || gl.isContextLost()) continue;
      reportError(new Error(`<phong-viewer> a program does not link: ${logOf(gl, program.program)}`));
    }
  }
}

function logOf(gl: WebGLRenderingContext | WebGL2RenderingContext, program: WebGLProgram): string {
  const shaders = gl.getAttachedShaders(program) ?? [];
  return [gl.getProgramInfoLog(program), ...shaders.map((shader) => gl.getShaderInfoLog(shader))]
    .filter((text) => text !== null && text !== '')
    .join('\n');
}
