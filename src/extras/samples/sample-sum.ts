// The sum of a picture's samples on the GPU. Four at a time are drawn without multisampling, as a
// picture of twice the size: shapes are set up once for all of them. It has 8 bits, which clamp as
// the canvas does. Its codes are added in float32, which holds 1,024 × 255 exactly. Half floats do
// not do: they are exact to 2,048, the codes of 8 white samples, and end at 65,504, those of 256.
import {
  FloatType,
  NearestFilter,
  SRGBColorSpace,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { ScreenPass } from './screen-pass.js';
import { type Region, type Size } from '../../phong/math/region.js';

/**
 * Most pixels of one sum. Its buffers take 64 bytes a pixel: 268 MB, and 133 MB at 1080p. Larger
 * pictures are summed in tiles.
 */
export const MOST_SUMMED = 2 ** 22;

export class SampleSum {
  readonly #renderer: WebGLRenderer;
  readonly #add = new ScreenPass(`color = texel;
  int side = int(uCount);
  for (int i = 0; i < side * side; i++) {
    color += floor(texelFetch(uSamples, side * at + ivec2(i % side, i / side), 0) * 255.0 + 0.5);
  }`);
  readonly #mean = new ScreenPass('color = floor(texel / uCount + 0.5) / 255.0;');
  #targets: ReturnType<typeof targetsOf> | null = null;
  #count = 0;
  #side = 1;

  constructor(renderer: WebGLRenderer) {
    this.#renderer = renderer;
  }

  get count(): number {
    return this.#count;
  }

  /** Samples a side of a pixel that are drawn at once. */
  get side(): number {
    return this.#side;
  }

  /** Starts at no sample. False: the GPU has no float targets, or no memory for these. */
  begin({ width, height }: Size, side: number): boolean {
    const renderer = this.#renderer;
    if (!renderer.extensions.has('EXT_color_buffer_float')) return false;
    const { sum } = this.#targets ?? {};
    this.#count = 0;
    if (sum?.width !== width || sum.height !== height || side !== this.#side) {
      this.free();
      this.#side = side;
      this.#targets = targetsOf(width, height, side);
      renderer.setRenderTarget(this.#targets.sum);
      const gl = renderer.getContext();
      if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) {
        renderer.setRenderTarget(null);
        this.free();
        return false;
      }
    }
    clear(renderer, this.#targets!.sum);
    // Drivers allocate with the first use: better now than in a later batch, which would be late.
    clear(renderer, this.#targets!.spare);
    return true;
  }

  /**
   * Adds the samples that `paint` draws into the renderer's present target, which it must not
   * clear.
   */
  add(paint: () => void): void {
    const { samples, sum, spare } = this.#targets!;
    clear(this.#renderer, samples);
    paint();
    this.#renderer.setRenderTarget(spare);
    this.#add.uniforms.uCount.value = this.#side;
    this.#add.draw(this.#renderer, sum.texture, samples.texture);
    this.#targets = { samples, sum: spare, spare: sum };
    this.#count += this.#side ** 2;
  }

  /** Returns once the GPU has drawn all of it. */
  wait(): void {
    const renderer = this.#renderer;
    renderer.setRenderTarget(this.#targets!.sum);
    const gl = renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, new Float32Array(4));
  }

  /**
   * Writes the mean of the samples so far, in 8 bits, to this place of `picture`: pixels from its
   * bottom left.
   */
  resolve(picture: WebGLRenderTarget, { x, y, width, height }: Region): void {
    const renderer = this.#renderer;
    picture.viewport.set(x, y, width, height);
    renderer.setRenderTarget(picture);
    const { uOrigin, uCount } = this.#mean.uniforms;
    uOrigin.value.set(x, y);
    uCount.value = this.#count;
    this.#mean.draw(renderer, this.#targets!.sum.texture);
  }

  /** Frees the buffers; programs stay. */
  free(): void {
    for (const target of Object.values(this.#targets ?? {})) {
      target.dispose();
    }
    this.#targets = null;
  }

  dispose(): void {
    this.free();
    this.#add.dispose();
    this.#mean.dispose();
  }
}

/** `spare` takes the next sum. */
const targetsOf = (width: number, height: number, side: number) => {
  const options = { ...NEAREST, type: FloatType, depthBuffer: false };
  return {
    samples: sampleTarget(side * width, side * height),
    sum: new WebGLRenderTarget(width, height, options),
    spare: new WebGLRenderTarget(width, height, options),
  };
};

/**
 * Gets what the canvas would get. three.js encodes and tone-maps a user's own materials for the
 * canvas, but for targets only where they stand for the canvas, as those of WebXR do. The colour
 * space is the materials' alone: with an internal format that decodes, texels would not be the
 * codes.
 */
function sampleTarget(width: number, height: number): WebGLRenderTarget {
  const options = { ...NEAREST, internalFormat: 'RGBA8', colorSpace: SRGBColorSpace } as const;
  const target = new WebGLRenderTarget(width, height, options);
  return Object.assign(target, { isXRRenderTarget: true });
}

/** A target that holds the picture in 8 bits. */
export const pictureTarget = (width: number, height: number): WebGLRenderTarget =>
  new WebGLRenderTarget(width, height, { ...NEAREST, depthBuffer: false });

const NEAREST = { minFilter: NearestFilter, magFilter: NearestFilter } as const;

function clear(renderer: WebGLRenderer, target: WebGLRenderTarget): void {
  renderer.setRenderTarget(target);
  renderer.setClearColor(0x000000, 0);
  renderer.clear(true, target.depthBuffer, false);
}
