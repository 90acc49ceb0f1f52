// Draws a kept picture pixel by pixel.
import { type Texture, Vector4, type WebGLRenderer } from 'three';
import type { Region } from '../gpu/stage.js';
import { ScreenPass } from './screen-pass.js';

const copyPass = /* @__PURE__ */ new ScreenPass('color = texel;');
const scratch = /* @__PURE__ */ new Vector4();

/** Fills the renderer's present viewport with this part of a picture that is `height` pixels high. */
export function copyPart(renderer: WebGLRenderer, picture: Texture, part: Region, height: number): void {
  const { x, y } = fromBelow(part, height);
  const viewport = renderer.getCurrentViewport(scratch);
  copyPass.uniforms.uOrigin.value.set(viewport.x - x, viewport.y - y);
  copyPass.draw(renderer, picture);
}

/** The same part, counted from the picture's bottom left corner, as WebGL does. */
export const fromBelow = ({ x, y, width, height }: Region, whole: number): Region => ({
  x,
  y: whole - y - height,
  width,
  height,
});
