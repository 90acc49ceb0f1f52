// Morph targets, which the Phong material does not read.

export const WebGLMorphtargets = function () {
  return { update() {} };
};
