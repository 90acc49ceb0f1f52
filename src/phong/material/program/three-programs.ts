// The programs that three.js makes of variants: their compilation in the background, and a check
// that they have linked.
import {
  type Camera,
  type Material,
  Mesh,
  type WebGLProgram as ThreeProgram,
  type WebGLRenderer,
} from 'three';
import type { Variant } from './variant.js';

/**
 * Programs compiled in the background and not drawn yet. A query of their link status could block.
 */
export const compilingPrograms = new WeakSet<object>();

export const variantParameters = ({ defines, vertexShader, fragmentShader }: Variant) => ({
  // Without a prototype: three.js would define what a page added to Object.prototype.
  defines: Object.assign(Object.create(null) as object, defines),
  vertexShader,
  fragmentShader,
});

/** Compiles the material's program in the background, where the browser can. False: it is there. */
export function compiles(material: Material, renderer: WebGLRenderer, camera: Camera): boolean {
  renderer.compile(new Mesh(undefined, material), camera);
  return programOf({ renderer, material })?.isReady() === false;
}

/** What three.js's types leave out. */
type Program = ThreeProgram & {
  readonly program: WebGLProgram;
  /** According to KHR_parallel_shader_compile; always true without that extension. */
  isReady(): boolean;
  /** Locations by name; always the same object. */
  getAttributes(): object;
};

export const programOf = ({
  renderer,
  material,
}: {
  renderer: WebGLRenderer;
  material: Material;
}): Program | undefined =>
  (renderer.properties.get(material) as { currentProgram?: Program }).currentProgram;

const checked = new WeakSet<Program>();

/**
 * Call after drawing: the browser then knows the link status without blocking. Reports each failed
 * program once, in place of three.js's own check (`checkShaderErrors`), which reads three logs of
 * each program and blocks for each.
 */
export function checkLinks(renderer: WebGLRenderer): void {
  const gl = renderer.getContext();
  for (const program of (renderer.info.programs ?? []) as Program[]) {
    if (checked.has(program) || compilingPrograms.has(program) || !program.isReady()) continue;
    checked.add(program);
    if (gl.isContextLost()) continue;
    if (gl.getProgramParameter(program.program, gl.LINK_STATUS) !== true) {
      reportLinkFailure(gl, program.program);
    } else {
      // V8 (Chromium 156) compiles three.js's loop over a program's attributes again and again once
      // a page has used two programs, unless nothing can be added to them: 0.4 µs a mesh, a quarter
      // of the script of 2,000 boxes.
      Object.preventExtensions(program.getAttributes());
    }
  }
}

/**
 * Reports a program that does not link to the page's error handlers, with the driver's logs. Not
 * where the context was lost meanwhile: then no program links.
 */
export function reportLinkFailure(
  gl: WebGLRenderingContext | WebGL2RenderingContext,
  program: WebGLProgram,
): void {
  const shaders = gl.getAttachedShaders(program) ?? [];
  const logs = [
    gl.getProgramInfoLog(program),
    ...shaders.map((shader) => gl.getShaderInfoLog(shader)),
  ];
  if (gl.isContextLost()) return;
  const text = logs.filter((log) => log !== null && log !== '').join('\n');
  reportError(new Error(`PhongMaterial: a program does not link: ${text}`));
}
