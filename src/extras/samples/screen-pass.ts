// One pass over the pixels of a target: a triangle that covers them all, and a fragment shader that
// reads textures.
import {
  BufferAttribute,
  BufferGeometry,
  Camera,
  GLSL3,
  Mesh,
  NoBlending,
  RawShaderMaterial,
  type Texture,
  Vector2,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { type Region } from '../../phong/math/region.js';

const VERTEX = `
precision highp float;
in vec3 position;
void main() { gl_Position = vec4(position, 1.0); }`;

/**
 * Never executed. On a page with many viewers WebKitGTK 2.50 loses track of the driver's active
 * texture unit, and a program with one texture then reads whatever is bound elsewhere. For a
 * program with two it sets the unit again.
 */
const SECOND_TEXTURE = 'if (uCount < 0.0) texel = texelFetch(uSamples, at, 0);';

export class ScreenPass {
  readonly uniforms = {
    uPixels: { value: null as Texture | null },
    uSamples: { value: null as Texture | null },
    /** Where the first texel is drawn, in pixels of the target. */
    uOrigin: { value: new Vector2() },
    uCount: { value: 1 },
  };
  readonly #mesh: Mesh<BufferGeometry, RawShaderMaterial>;
  readonly #camera = new Camera();

  /**
   * `body`: GLSL statements that set `color` from `texel`, both vec4. They may read `uSamples` at
   * `at`.
   */
  constructor(body: string) {
    const geometry = new BufferGeometry();
    geometry.setAttribute(
      'position',
      new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3),
    );
    // Without prototypes: three.js would use what a page added to Object.prototype.
    Object.setPrototypeOf(geometry.attributes, null);
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      defines: Object.create(null) as Record<string, string>,
      vertexShader: VERTEX,
      fragmentShader: `
precision highp float;
uniform highp sampler2D uPixels;
uniform highp sampler2D uSamples;
uniform vec2 uOrigin;
uniform float uCount;
out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy - uOrigin);
  vec4 texel = texelFetch(uPixels, at, 0);
  ${SECOND_TEXTURE}
  ${body}
}`,
      uniforms: this.uniforms,
      depthTest: false,
      depthWrite: false,
      toneMapped: false,
      blending: NoBlending,
    });
    this.#mesh = new Mesh(geometry, material);
    this.#mesh.frustumCulled = false;
    this.#mesh.matrixAutoUpdate = false;
    this.#mesh.matrixWorldAutoUpdate = false;
  }

  /** Draws over the renderer's present viewport. */
  draw(renderer: WebGLRenderer, pixels: Texture, samples: Texture | null = null): void {
    const { uPixels, uSamples } = this.uniforms;
    uPixels.value = pixels;
    uSamples.value = samples;
    renderer.render(this.#mesh, this.#camera);
    uPixels.value = uSamples.value = null;
  }

  dispose(): void {
    this.#mesh.geometry.dispose();
    this.#mesh.material.dispose();
  }
}

const copyPass = /* @__PURE__ */ new ScreenPass('color = texel;');
const scratch = /* @__PURE__ */ new Vector4();

/**
 * Fills the renderer's present viewport with this part of a picture that is `height` pixels high.
 */
export function copyPart(
  renderer: WebGLRenderer,
  picture: Texture,
  part: Region,
  height: number,
): void {
  const { x, y } = fromBelow(part, height);
  const viewport = renderer.getCurrentViewport(scratch);
  copyPass.uniforms.uOrigin.value.set(viewport.x - x, viewport.y - y);
  copyPass.draw(renderer, picture);
}

/** The same part, counted from the picture's bottom left corner, as WebGL does. */
export const fromBelow = (part: Region, whole: number): Region => ({
  ...part,
  y: whole - part.y - part.height,
});
