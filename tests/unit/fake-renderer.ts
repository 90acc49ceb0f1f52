// As much of three.js's renderer as light data and programs need: textures with the calls that fill
// them, and programs that link at once. Keeps a copy of each texture as the GPU would have it.
// Knows nothing of lights.
import type { BufferGeometry, ExternalTexture, Material, Mesh, WebGLRenderer } from 'three';

interface Texels {
  width: number;
  height: number;
  data: Float32Array;
}

export class FakeRenderer {
  /** Rectangles of texels that were sent, one a call. */
  patches: object[] = [];
  /** Materials whose programs were compiled. */
  readonly compiled: Material[] = [];
  /** How textures are sampled. */
  readonly sampling = new Map<string, string>();
  readonly renderer: WebGLRenderer;
  /** By the object that represents a texture in WebGL. */
  readonly #held = new Map<object, Texels>();
  #bound: object = {};
  readonly #programs = new Map<Material, object>();

  /** `name`: of the device, as the browser reports it. */
  constructor({ name = 'NVIDIA' }: { readonly name?: string } = {}) {
    const gl = {
      RENDERER: 7,
      LINK_STATUS: 8,
      MAX_FRAGMENT_UNIFORM_VECTORS: 9,
      MAX_VERTEX_UNIFORM_VECTORS: 9,
      getExtension: () => null,
      getParameter: (what: number) => (what === 7 ? name : 1024),
      getProgramParameter: () => true,
      getAttachedShaders: () => [],
      isContextLost: () => false,
      TEXTURE_2D: 1,
      RGBA: 2,
      FLOAT: 3,
      createTexture: () => {
        const texture = {};
        this.#held.set(texture, { width: 0, height: 0, data: new Float32Array(0) });
        return texture;
      },
      deleteTexture: (texture: object | null) => texture !== null && this.#held.delete(texture),
      TEXTURE_WRAP_S: 'wrap s',
      TEXTURE_WRAP_T: 'wrap t',
      CLAMP_TO_EDGE: 'clamp',
      texParameteri: (...[, name, value]: [number, string, string]) =>
        this.sampling.set(name, value),
      texStorage2D: (...[, , , width, height]: [number, number, number, number, number]) => {
        Object.assign(this.#texels(), {
          width,
          height,
          data: new Float32Array(width * height * 4),
        });
      },
      texSubImage2D: (
        ...[, , x, y, width, height, , , data, first]: [
          ...[target: number, level: number, x: number, y: number, width: number, height: number],
          ...[format: number, type: number, data: Float32Array, first: number],
        ]
      ) => {
        this.patches.push({ x, y, width, height });
        const bound = this.#texels();
        for (let line = 0; line < height; line++) {
          const from = first + line * width * 4;
          const to = ((y + line) * bound.width + x) * 4;
          if (to + width * 4 > bound.data.length || x + width > bound.width) {
            throw new RangeError('beyond the texture');
          }
          bound.data.set(data.subarray(from, from + width * 4), to);
        }
      },
    };
    this.renderer = {
      state: {
        bindTexture: (_: number, texture: object) => (this.#bound = texture),
        pixelStorei: () => undefined,
      },
      getContext: () => gl,
      extensions: { has: () => true },
      info: { render: { frame: 0 } },
      properties: {
        get: (material: Material) => ({ currentProgram: this.#programs.get(material) }),
      },
      compile: ({ material }: Mesh<BufferGeometry, Material>) => {
        this.compiled.push(material);
        this.#programs.set(material, { program: material, isReady: () => true });
      },
    } as unknown as WebGLRenderer;
  }

  /** What the GPU holds: in total, and of one texture. */
  get textures(): number {
    return this.#held.size;
  }

  sizeOf(texture: ExternalTexture): { width: number; height: number } | undefined {
    const texels = this.#texelsOf(texture);
    return texels && { width: texels.width, height: texels.height };
  }

  /** Texels that the GPU has of a texture; none where it holds nothing. */
  pixels(texture: ExternalTexture): readonly number[] {
    return [...(this.#texelsOf(texture)?.data ?? [])];
  }

  #texelsOf({ sourceTexture }: ExternalTexture): Texels | undefined {
    return this.#held.get(sourceTexture ?? {});
  }

  #texels(): Texels {
    const texels = this.#held.get(this.#bound);
    if (texels === undefined) throw new Error('no texture of this context is bound');
    return texels;
  }
}
