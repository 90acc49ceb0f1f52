// Text in the shader that is to be another: how a guard's worth is found out.

export interface Edit {
  readonly from: string;
  readonly to: string;
}

/** `glsl` with the edit, where there is one. Throws unless `from` stands in it exactly once. */
export function edited(glsl: string, edit: Edit | null): string {
  if (edit === null) return glsl;
  if (glsl.split(edit.from).length !== 2) throw new Error(`not in the shader once: ${edit.from}`);
  return glsl.replace(edit.from, () => edit.to);
}
