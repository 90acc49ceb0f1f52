// Shadow maps, which nothing here casts or catches.

export const WebGLShadowMap = function () {
  return { enabled: false, autoUpdate: true, needsUpdate: false, render() {} };
};
