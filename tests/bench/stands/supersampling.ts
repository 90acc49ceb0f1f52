// Many samples a pixel: a larger picture averaged down on the GPU, and pictures moved by parts of a pixel averaged exactly,
// which is what the others are held against.
import {
  GLSL3,
  Mesh,
  OrthographicCamera,
  PlaneGeometry,
  type Scene,
  Scene as EmptyScene,
  ShaderMaterial,
  WebGLRenderTarget,
} from 'three';
import type { ColorPicture } from '../error/error-figures.js';
import type { CoreView } from './core-view.js';
import type { Pace, Size } from './stand.js';

/** Draws a picture `side` times as wide and high and averages each `side` × `side` of its pixels into one of the canvas. */
export class Supersampled {
  readonly #view: CoreView;
  readonly #side: number;
  readonly #target = new WebGLRenderTarget(1, 1);
  readonly #average: Scene;
  readonly #camera = new OrthographicCamera(-1, 1, 1, -1, -1, 1);

  constructor(view: CoreView, side: number) {
    this.#view = view;
    this.#side = side;
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      uniforms: { uPicture: { value: this.#target.texture } },
      vertexShader: 'void main() { gl_Position = vec4(position, 1.0); }',
      fragmentShader: `
        uniform sampler2D uPicture;
        out vec4 outColor;
        void main() {
          ivec2 first = ivec2(gl_FragCoord.xy) * ${String(side)};
          vec3 sum = vec3(0.0);
          for (int y = 0; y < ${String(side)}; y++)
            for (int x = 0; x < ${String(side)}; x++) sum += texelFetch(uPicture, first + ivec2(x, y), 0).rgb;
          outColor = vec4(sum / ${(side * side).toFixed(1)}, 1.0);
        }`,
      depthTest: false,
    });
    this.#average = new EmptyScene().add(new Mesh(new PlaneGeometry(2, 2), material));
  }

  draw(scene: Scene, [width, height]: Size): void {
    const { renderer } = this.#view;
    this.#target.setSize(width * this.#side, height * this.#side);
    this.#view.prepare([width, height]);
    renderer.setRenderTarget(this.#target);
    renderer.render(scene, this.#view.camera);
    renderer.setRenderTarget(null);
    renderer.render(this.#average, this.#camera);
  }
}

/** The mean of `side` × `side` pictures, each moved by a part of a pixel: the part of `picture` pixels from `x`, `y` on. */
export async function converged(
  view: CoreView,
  scene: Scene,
  { size, part, x, y, side }: { size: Size; part: Size; x: number; y: number; side: number },
  pace: Pace,
): Promise<ColorPicture> {
  const [width, height] = part;
  const sum = new Float64Array(width * height * 3);
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      const [dx, dy] = [(i + 0.5) / side - 0.5, (j + 0.5) / side - 0.5];
      view.camera.setViewOffset(size[0], size[1], dx, dy, size[0], size[1]);
      view.draw(scene, size);
      view.read(part, x, y).data.forEach((code, k) => (sum[k] = sum[k]! + code));
      await pace();
    }
  }
  view.camera.clearViewOffset();
  return { width, height, data: sum.map((total) => total / (side * side)) };
}
