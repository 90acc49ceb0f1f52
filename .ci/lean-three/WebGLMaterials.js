// How the values of three.js's own materials become uniforms: a ShaderMaterial's uniforms are its own.

export const WebGLMaterials = function () {
  return {
    refreshFogUniforms() {},
    refreshMaterialUniforms(uniforms, material) {
      material.uniformsNeedUpdate = false;
    },
  };
};
