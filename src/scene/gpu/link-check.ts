// Reports programs that do not link, without waiting for programs that the driver is still compiling.
import type { WebGLProgram as ThreeProgram, WebGLRenderer } from 'three';
import { compilingPrograms } from '../../material/program/program-cache.js';

/** What three.js's types leave out. */
type Program = ThreeProgram & {
  readonly program: WebGLProgram;
  /** According to KHR_parallel_shader_compile; always true without that extension. */
  isReady(): boolean;
};

/**
 * Replaces three.js's own check, which reads three logs of each program and blocks for each. After a program has drawn,
 * the browser knows its link status without blocking. The logs are read only after a failure.
 */
export class LinkCheck {
  readonly #checked = new WeakSet<Program>();

  constructor(renderer: WebGLRenderer) {
    renderer.debug.checkShaderErrors = false;
  }

  /** Call after drawing. Reports each failed program once. */
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
