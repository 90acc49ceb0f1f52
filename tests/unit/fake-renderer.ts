// As much of three.js's renderer as light data is sent by: which textures the GPU holds, and the calls that patch them.
// Keeps a copy of each texture as the GPU would have it. Knows nothing of lights.
import type { DataTexture, WebGLRenderer } from 'three';

/** One texSubImage2D: a rectangle of texels. */
export interface Patch {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export class FakeRenderer {
  readonly patches: Patch[] = [];
  /** What a patch must not inherit from whoever unpacked before it. */
  readonly unpack = new Map<number, number | boolean>();
  #held = new Map<DataTexture, { __webglTexture?: object }>();
  readonly #pixels = new Map<object, { width: number; data: Float32Array }>();
  #bound: object | null = null;

  get renderer(): WebGLRenderer {
    const gl = {
      ...{ TEXTURE_2D: 1, RGBA: 2, FLOAT: 3, UNPACK_FLIP_Y_WEBGL: 4 },
      ...{ UNPACK_PREMULTIPLY_ALPHA_WEBGL: 5, UNPACK_ALIGNMENT: 6 },
      texSubImage2D: (...call: Parameters<FakeRenderer['texSubImage2D']>) => {
        this.texSubImage2D(...call);
      },
    };
    return {
      properties: { get: (texture: DataTexture) => this.#propertiesOf(texture) },
      state: {
        bindTexture: (_: number, texture: object) => (this.#bound = texture),
        pixelStorei: (name: number, value: number | boolean) => this.unpack.set(name, value),
      },
      getContext: () => gl,
    } as unknown as WebGLRenderer;
  }

  /** What three.js does with a texture that a draw reads: makes it where `needsUpdate` has been set, and frees it on dispose. */
  draw(texture: DataTexture): void {
    const properties = this.#propertiesOf(texture);
    if (properties.__webglTexture !== undefined || texture.version === 0) return;
    const { data, width } = texture.image as { data: Float32Array; width: number };
    const held = {};
    properties.__webglTexture = held;
    this.#pixels.set(held, { width, data: data.slice() });
    texture.addEventListener('dispose', () => this.#held.delete(texture));
  }

  /** Texels that the GPU has of a texture; none where it holds nothing. */
  pixels(texture: DataTexture): readonly number[] {
    return [...(this.#pixels.get(this.#propertiesOf(texture).__webglTexture ?? {})?.data ?? [])];
  }

  loseContext(): void {
    this.#held = new Map();
  }

  texSubImage2D(
    ...[, , x, y, width, height, , , data, first]: [
      ...[target: number, level: number, x: number, y: number, width: number, height: number],
      ...[format: number, type: number, data: Float32Array, first: number],
    ]
  ): void {
    this.patches.push({ x, y, width, height });
    const bound = this.#pixels.get(this.#bound ?? {})!;
    for (let line = 0; line < height; line++) {
      const from = first + line * width * 4;
      const to = ((y + line) * bound.width + x) * 4;
      if (to + width * 4 > bound.data.length || x + width > bound.width)
        throw new RangeError('beyond the texture');
      bound.data.set(data.subarray(from, from + width * 4), to);
    }
  }

  #propertiesOf(texture: DataTexture): { __webglTexture?: object } {
    const known = this.#held.get(texture) ?? {};
    this.#held.set(texture, known);
    return known;
  }
}
