// Reports programs that do not link, without waiting for programs that the driver is still compiling.
import type { WebGLProgram as ThreeProgram, WebGLRenderer } from 'three';
import { reportLinkFailure, compilingPrograms } from '../../material/program/program-cache.js';

/** What three.js's types leave out. */
type Program = ThreeProgram & {
  readonly program: WebGLProgram;
  /** According to KHR_parallel_shader_compile; always true without that extension. */
  isReady(): boolean;
  /** Locations by name; always the same object. */
  getAttributes(): object;
};

const checked = new WeakSet<Program>();

/**
 * Call after drawing. Reports each failed program once. Stands in place of three.js's own check (`checkShaderErrors`),
 * which reads three logs of each program and blocks for each. After a program has drawn, the browser knows its link
 * status without blocking. The logs are read only after a failure.
 */
export function checkLinks(renderer: WebGLRenderer): void {
  const gl = renderer.getContext();
  for (const program of (renderer.info.programs ?? []) as Program[]) {
    if (checked.has(program) || compilingPrograms.has(program) || !program.isReady()) continue;
    checked.add(program);
    if (gl.isContextLost()) continue;
    if (gl.getProgramParameter(program.program, gl.LINK_STATUS) === true) sealAttributes(program);
    else reportLinkFailure(gl, program.program);
  }
}

/**
 * V8 (Chromium 156) compiles three.js's loop over a program's attributes again and again once a page has used two
 * programs: 0.4 µs a mesh, a quarter of the script of 2,000 boxes. It does not where nothing can be added to them, and
 * three.js never does.
 */
function sealAttributes(program: Program): void {
  Object.preventExtensions(program.getAttributes());
}
