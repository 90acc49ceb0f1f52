// three.js's own lights on three.js's own materials: the Phong material has lights of its own.

export const WebGLLights = function () {
  const none = [];
  const kinds = ['sun', 'directional', 'point', 'spot', 'rectArea', 'hemi', 'spotLightMap'];
  const shadows = ['sun', 'directional', 'point', 'spot'].map((kind) => `${kind}ShadowMap`);
  const state = Object.fromEntries([...kinds, ...shadows].map((name) => [name, none]));
  return {
    state: { ...state, version: 0, numSpotLightShadowsWithMaps: 0, numLightProbes: 0 },
    setup() {},
    setupView() {},
  };
};
