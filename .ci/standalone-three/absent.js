// What stands in for the parts of three.js that the standalone file leaves out (plugin.ts lists
// them). The names are three's own, since its other modules import them. What a user can still
// reach fails with a message that names the cure.

import colorspace_pars_fragment from 'three/src/renderers/shaders/ShaderChunk/colorspace_pars_fragment.glsl.js';

/** @param {string} name @returns {never} */
function refuse(name) {
  throw new Error(
    `phong-viewer.standalone.js does not contain all of three.js (${name} is missing): ` +
      'use the ES modules together with three.js.',
  );
}

/** An object with these properties. Reading any other one throws. @param {object} present */
const orRefuse = (present) =>
  new Proxy(present, {
    get: (target, name) => target[name] ?? refuse(String(name)),
  });

/** The programs of three's own materials: the Phong material brings its own. */
export const ShaderLib = orRefuse({});

/** The GLSL that `#include` finds. three puts this one piece before every ShaderMaterial. */
export const ShaderChunk = orRefuse({ colorspace_pars_fragment });

/** A table for three's physical materials. */
export const getDFGLUT = () => null;

/** Clipping planes, which the viewer's renderer never has. */
export const WebGLClipping = function () {
  return { uniform: { value: null }, numPlanes: 0, numIntersection: 0, init: () => false };
};

/** Environment maps, which only three's own materials read: a texture stays what it is. */
export const WebGLEnvironments = function () {
  return { get: (texture) => texture ?? null, dispose() {} };
};

/** three's own lights, which only its own materials read. */
export const WebGLLights = function () {
  const none = [];
  const kinds = ['sun', 'directional', 'point', 'spot', 'rectArea', 'hemi', 'spotLightMap'];
  const shadows = ['sun', 'directional', 'point', 'spot'].map((kind) => `${kind}ShadowMap`);
  const lists = Object.fromEntries([...kinds, ...shadows].map((name) => [name, none]));
  return {
    state: { ...lists, version: 0, numSpotLightShadowsWithMaps: 0, numLightProbes: 0 },
    setup() {},
    setupView() {},
  };
};

/**
 * Writes the values of three's own materials into uniforms: a ShaderMaterial has uniforms of its
 * own.
 */
export const WebGLMaterials = function () {
  return {
    refreshFogUniforms() {},
    refreshMaterialUniforms(_uniforms, material) {
      material.uniformsNeedUpdate = false;
    },
  };
};

/**
 * Morph targets: the elements pose models themselves, and the shaders that read three's are not
 * here.
 */
export const WebGLMorphtargets = function () {
  return { update: () => refuse('morph targets') };
};

/** Output buffers other than the canvas: the viewer's renderer is never made with one. */
export const WebGLOutput = undefined;

/** Shadow maps: the shading equation has no shadows. */
export const WebGLShadowMap = function () {
  return { enabled: false, autoUpdate: true, needsUpdate: false, render() {} };
};

/** Uniform blocks, which only a user's own material could have. */
export const WebGLUniformsGroups = function () {
  return { update: () => refuse('uniform groups'), bind() {}, dispose() {} };
};

/** The frustums of a camera of several views, as WebXR has. */
export const FrustumArray = function () {};

/** WebXR: the viewer starts no session. */
export class WebXRManager {
  enabled = false;
  isPresenting = false;
  addEventListener() {}
  removeEventListener() {}
  getEnvironmentBlendMode() {}
  setAnimationLoop() {}
  dispose() {}
}
