// As much of three.js's renderer as light data and programs need: textures with the calls that fill them, and programs
// that compile in the background. Keeps a copy of each texture as the GPU would have it. Knows nothing of lights.
import type { ExternalTexture, Material, Mesh, WebGLRenderer } from 'three';

/** One texSubImage2D: a rectangle of texels. */
export interface Patch {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

interface Texels {
  width: number;
  height: number;
  data: Float32Array;
}

/** What the browser reports about the device. */
export interface FakeDevice {
  readonly name: string;
  /** Has KHR_parallel_shader_compile. */
  readonly tells: boolean;
  readonly uniformVectors: number;
}

const GPU: FakeDevice = { name: 'NVIDIA', tells: true, uniformVectors: 1024 };

export class FakeRenderer {
  patches: Patch[] = [];
  /** Whether programs have linked, and whether they do at all. */
  ready = true;
  links = true;
  /** Materials whose programs were compiled, and of these the ones that were disposed of. */
  readonly compiled: Material[] = [];
  readonly disposed: Material[] = [];
  /** Programs whose shaders were deleted by hand. */
  readonly withoutShaders: object[] = [];
  readonly #device: FakeDevice;
  /** The unpack settings, which an upload must set for itself. */
  readonly unpack = new Map<number, number | boolean>();
  /** How textures are sampled. */
  readonly sampling = new Map<string, string>();
  /** By the object that represents a texture in WebGL. */
  readonly #held = new Map<object, Texels>();
  #bound: object = {};
  readonly #programs = new Map<Material, object>();

  constructor(device: Partial<FakeDevice> = {}) {
    this.#device = { ...GPU, ...device };
  }

  /** Always the same object. */
  get renderer(): WebGLRenderer {
    return (this.#renderer ??= this.#make());
  }

  #renderer: WebGLRenderer | null = null;

  #make(): WebGLRenderer {
    const { name, tells, uniformVectors } = this.#device;
    const gl = {
      ...{ RENDERER: 7, LINK_STATUS: 8, MAX_FRAGMENT_UNIFORM_VECTORS: 9, MAX_VERTEX_UNIFORM_VECTORS: 9 },
      getExtension: () => null,
      getParameter: (what: number) => (what === 7 ? name : uniformVectors),
      getProgramParameter: () => this.links,
      getProgramInfoLog: () => 'broken by hand',
      getAttachedShaders: (program: object) => [{ of: program }],
      getShaderInfoLog: () => '',
      deleteShader: ({ of }: { of: object }) => this.withoutShaders.push(of),
      isContextLost: () => false,
      ...{ TEXTURE_2D: 1, RGBA: 2, FLOAT: 3, UNPACK_FLIP_Y_WEBGL: 4 },
      ...{ UNPACK_PREMULTIPLY_ALPHA_WEBGL: 5, UNPACK_ALIGNMENT: 6 },
      createTexture: () => {
        const texture = {};
        this.#held.set(texture, { width: 0, height: 0, data: new Float32Array(0) });
        return texture;
      },
      deleteTexture: (texture: object | null) => texture !== null && this.#held.delete(texture),
      ...{ TEXTURE_WRAP_S: 'wrap s', TEXTURE_WRAP_T: 'wrap t', CLAMP_TO_EDGE: 'clamp' },
      texParameteri: (...[, name, value]: [number, string, string]) => this.sampling.set(name, value),
      texStorage2D: (...[, , , width, height]: [number, number, number, number, number]) => {
        Object.assign(this.#texels(), { width, height, data: new Float32Array(width * height * 4) });
      },
      texSubImage2D: (...call: Parameters<FakeRenderer['texSubImage2D']>) => {
        this.texSubImage2D(...call);
      },
    };
    return {
      state: {
        bindTexture: (_: number, texture: object) => (this.#bound = texture),
        pixelStorei: (name: number, value: number | boolean) => this.unpack.set(name, value),
      },
      getContext: () => gl,
      extensions: { has: () => tells },
      properties: {
        get: (material: Material) =>
          this.compiled.includes(material) ? { currentProgram: this.programOf(material) } : {},
      },
      compile: ({ material }: Mesh) => {
        const one = material as Material;
        this.compiled.push(one);
        one.addEventListener('dispose', () => this.disposed.push(one));
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

  /** The program that a compiled material has. */
  programOf(material: Material): object {
    const program = this.#programs.get(material) ?? { program: material, isReady: () => this.ready };
    this.#programs.set(material, program);
    return program;
  }

  texSubImage2D(
    ...[, , x, y, width, height, , , data, first]: [
      ...[target: number, level: number, x: number, y: number, width: number, height: number],
      ...[format: number, type: number, data: Float32Array, first: number],
    ]
  ): void {
    this.patches.push({ x, y, width, height });
    const bound = this.#texels();
    for (let line = 0; line < height; line++) {
      const from = first + line * width * 4;
      const to = ((y + line) * bound.width + x) * 4;
      if (to + width * 4 > bound.data.length || x + width > bound.width)
        throw new RangeError('beyond the texture');
      bound.data.set(data.subarray(from, from + width * 4), to);
    }
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
