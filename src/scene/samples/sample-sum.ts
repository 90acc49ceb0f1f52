// The sum of a picture's samples on the GPU. Each sample is drawn without multisampling into 8 bits, which clamps it as
// the canvas does; its codes are added in float32, which holds 1,024 × 255 exactly. Half floats would lose 8 bits over
// 64 samples.
import { FloatType, NearestFilter, SRGBColorSpace, type WebGLRenderer, WebGLRenderTarget } from 'three';
import type { Size } from '../gpu/atlas.js';
import type { Region } from '../gpu/stage.js';
import { ScreenPass } from './screen-pass.js';

/**
 * Most pixels of one sum. Its buffers take 24 bytes a pixel, 40 where the GPU cannot blend floats: 100 or 168 MB.
 * Larger pictures are summed in tiles.
 */
export const MOST_SUMMED = 2 ** 22;

const CODES = 'floor(texel * 255.0 + 0.5)';

/** Whether the GPU can draw into 32-bit floats. */
export const canSum = (renderer: WebGLRenderer): boolean => renderer.extensions.has('EXT_color_buffer_float');

export class SampleSum {
  readonly #renderer: WebGLRenderer;
  /** Adds by blending, or else from one buffer to the other. */
  readonly #blends: boolean;
  readonly #add: ScreenPass;
  readonly #mean = new ScreenPass('floor(texel / uCount + 0.5) / 255.0');
  #targets: Targets | null = null;
  #count = 0;

  constructor(renderer: WebGLRenderer) {
    this.#renderer = renderer;
    this.#blends = renderer.extensions.has('EXT_float_blend');
    this.#add = this.#blends
      ? new ScreenPass(CODES, true)
      : new ScreenPass(`texelFetch(uOther, at, 0) + ${CODES}`);
  }

  /** Samples so far. */
  get count(): number {
    return this.#count;
  }

  /** Starts at no sample. False: the GPU has no memory for a sum of this size. */
  begin({ width, height }: Size): boolean {
    const renderer = this.#renderer;
    this.#count = 0;
    if (this.#targets?.sample.width !== width || this.#targets.sample.height !== height) {
      this.free();
      this.#targets = targetsOf(width, height, this.#blends);
      renderer.setRenderTarget(this.#targets.sum);
      const gl = renderer.getContext();
      if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) return false;
    }
    clear(renderer, this.#targets.sum);
    return true;
  }

  /** Adds the sample that `paint` draws into the renderer's present target, which it must not clear. */
  add(paint: () => void): void {
    const renderer = this.#renderer;
    const targets = this.#targets!;
    clear(renderer, targets.sample);
    paint();
    if (targets.spare !== null) {
      renderer.setRenderTarget(targets.spare);
      this.#add.draw(renderer, targets.sample.texture, targets.sum.texture);
      this.#targets = { ...targets, sum: targets.spare, spare: targets.sum };
    } else {
      renderer.setRenderTarget(targets.sum);
      this.#add.draw(renderer, targets.sample.texture);
    }
    this.#count += 1;
  }

  /** Returns once the GPU has drawn all of it. */
  wait(): void {
    const renderer = this.#renderer;
    renderer.setRenderTarget(this.#targets!.sum);
    const gl = renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, new Float32Array(4));
  }

  /** Writes the mean of the samples so far, in 8 bits, to this place of `picture`: pixels from its bottom left. */
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
    const { sample, sum, spare } = this.#targets ?? {};
    this.#targets = null;
    for (const target of [sample, sum, spare]) target?.dispose();
  }

  dispose(): void {
    this.free();
    this.#add.dispose();
    this.#mean.dispose();
  }
}

interface Targets {
  readonly sample: WebGLRenderTarget;
  readonly sum: WebGLRenderTarget;
  /** Takes the next sum, where the GPU cannot blend floats. */
  readonly spare: WebGLRenderTarget | null;
}

function targetsOf(width: number, height: number, blends: boolean): Targets {
  const sum = (): WebGLRenderTarget => targetOf(width, height, { type: FloatType, depthBuffer: false });
  return { sample: sampleTarget(width, height), sum: sum(), spare: blends ? null : sum() };
}

/**
 * Gets what the canvas would get. three.js encodes and tone-maps a user's own materials for the canvas, but for targets
 * only where they stand for the canvas, as those of WebXR do. The colour space is the materials' alone: an internal
 * format that decodes would give texels that are not the codes.
 */
function sampleTarget(width: number, height: number): WebGLRenderTarget {
  const target = targetOf(width, height, { internalFormat: 'RGBA8', colorSpace: SRGBColorSpace });
  return Object.assign(target, { isXRRenderTarget: true });
}

/** A target that holds the picture in 8 bits. */
export const pictureTarget = (width: number, height: number): WebGLRenderTarget =>
  targetOf(width, height, { depthBuffer: false });

type TargetOptions = NonNullable<ConstructorParameters<typeof WebGLRenderTarget>[2]>;

const targetOf = (width: number, height: number, options: TargetOptions): WebGLRenderTarget =>
  new WebGLRenderTarget(width, height, {
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    ...options,
  });

function clear(renderer: WebGLRenderer, target: WebGLRenderTarget): void {
  renderer.setRenderTarget(target);
  renderer.setClearColor(0x000000, 0);
  renderer.clear(true, target.depthBuffer, false);
}
