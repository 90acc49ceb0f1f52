// What the canvas is cleared to: the clear colour, or the scene's background where that is a colour. Textures as
// backgrounds need shaders of three.js that the file does not carry.

import { Color } from 'three';
import { getUnlitUniformColorSpace } from 'three/src/renderers/shaders/UniformsUtils.js';

export const WebGLBackground = function (renderer, environments, state, objects, alpha, premultipliedAlpha) {
  const clearColor = new Color(0x000000);
  const rgb = { r: 0, g: 0, b: 0 };
  let clearAlpha = alpha ? 0 : 1;

  function setClear(color, opacity) {
    color.getRGB(rgb, getUnlitUniformColorSpace(renderer));
    state.buffers.color.setClear(rgb.r, rgb.g, rgb.b, opacity, premultipliedAlpha);
  }

  return {
    getClearColor: () => clearColor,
    setClearColor(color, opacity = 1) {
      clearColor.set(color);
      clearAlpha = opacity;
      setClear(clearColor, clearAlpha);
    },
    getClearAlpha: () => clearAlpha,
    setClearAlpha(opacity) {
      clearAlpha = opacity;
      setClear(clearColor, clearAlpha);
    },
    render(scene) {
      const background = scene.isScene && scene.background?.isColor ? scene.background : null;
      setClear(background ?? clearColor, background ? 1 : clearAlpha);
      if (!renderer.autoClear && background === null) return;
      const { depth, color } = state.buffers;
      depth.setTest(true);
      depth.setMask(true);
      color.setMask(true);
      renderer.clear(renderer.autoClearColor, renderer.autoClearDepth, renderer.autoClearStencil);
    },
    addToRenderList() {},
    dispose() {},
  };
};
