// Clipping planes, for which the Phong material has no code.

export const WebGLClipping = function () {
  return {
    uniform: { value: null, needsUpdate: false },
    numPlanes: 0,
    numIntersection: 0,
    init: () => false,
    beginShadows() {},
    endShadows() {},
    setGlobalState() {},
    setState() {},
  };
};
