// Reports a program that does not link.

/** Reports it to the page's error handlers, with the driver's logs. */
export function reportLinkFailure(
  gl: WebGLRenderingContext | WebGL2RenderingContext,
  program: WebGLProgram,
): void {
  const shaders = gl.getAttachedShaders(program) ?? [];
  const logs = [gl.getProgramInfoLog(program), ...shaders.map((shader) => gl.getShaderInfoLog(shader))];
  const text = logs.filter((log) => log !== null && log !== '').join('\n');
  reportError(new Error(`PhongMaterial: a program does not link: ${text}`));
}
