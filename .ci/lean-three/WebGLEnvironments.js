// Reflections of surroundings, which the Phong equation does not know: textures stay what they are.

export const WebGLEnvironments = function () {
  return { get: (texture) => texture ?? null, dispose() {} };
};
