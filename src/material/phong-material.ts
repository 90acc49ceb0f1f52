// A three.js material whose program is the hand-written light loop. Keeps uniforms and variant in step with its
// surface and its picture's lights. Knows neither elements nor the scene it is used in.
import {
  DoubleSide,
  Matrix3,
  Matrix4,
  NormalBlending,
  type Object3D,
  ShaderMaterial,
  type Texture,
  Vector3,
} from 'three';
import type { Reflectance } from '../light/light-reach.js';
import { isBlack } from '../light/light-kind.js';
import { isMildPower, isWholePower } from '../light/steady-light.js';
import { srgbDecode } from '../math/color.js';
import type { Vec3 } from '../math/vector.js';
import { SURFACE_FIELDS, type SurfaceValues } from './material-values.js';
import { normalMatrix } from './normal-matrix.js';
import type { PhongLighting } from './phong-lighting.js';
import { hasAverages, shadersOf } from './shader-source.js';
import {
  type AlphaMode,
  type Antialias,
  type Reflection,
  type Shading,
  type Term,
  TERMS,
  variantDefines,
} from './variant.js';

/** What a file says of a surface's colour: multiplies Ka and Kd. */
export interface BaseLook {
  /** Encoded sRGB, 0–1. */
  readonly baseColor: Vec3;
  readonly opacity: number;
  readonly alphaMode: AlphaMode;
  readonly alphaCutoff: number;
  readonly map: Texture | null;
  readonly vertexColors: boolean;
}

export const PLAIN_LOOK: BaseLook = {
  baseColor: [1, 1, 1],
  opacity: 1,
  alphaMode: 'opaque',
  alphaCutoff: 0.5,
  map: null,
  vertexColors: false,
};

/** How a surface is shaded, besides its colours. `flat` needs a geometry that carries the triangles' own normals. */
export interface ShadingStyle {
  readonly shading: Shading;
  readonly reflection: Reflection;
  readonly terms: readonly Term[];
  /**
   * `highlights`: the specular lobe is averaged over each pixel, so that highlights smaller than pixels keep their
   * brightness; not under `gouraud`, which has no pixels. Default `edges`: one sample a pixel inside faces. Edges
   * themselves are the renderer's.
   */
  readonly antialias: Antialias;
}

export const DEFAULT_STYLE: ShadingStyle = {
  ...{ shading: 'phong', reflection: 'phong', terms: TERMS },
  antialias: 'edges',
};

const DEFAULT_SURFACE: SurfaceValues = {
  ka: SURFACE_FIELDS.ka.fallback,
  kd: SURFACE_FIELDS.kd.fallback,
  ks: SURFACE_FIELDS.ks.fallback,
  shininess: SURFACE_FIELDS.shininess.fallback,
};

/**
 * Draws opaque or blended 8-bit colour: the sum is clamped to 0–1 and rounded to the nearest code, whatever the target.
 * Update the {@link PhongLighting} it was made with before each frame.
 */
export class PhongMaterial extends ShaderMaterial {
  readonly #lighting: PhongLighting;
  readonly look: BaseLook;
  #surface: Readonly<SurfaceValues> = DEFAULT_SURFACE;
  #style: ShadingStyle = DEFAULT_STYLE;
  /** Terms that have ever been summed: their code stays, so that turning one off and on compiles nothing. */
  readonly #terms = new Set<Term>();
  #programKey = '';
  #programVersion = 0;
  #surfaceVersion = 0;
  #exactKey = '';
  #reflectance: Reflectance = { ka: [], kd: [], ks: [] };
  /** The lighting's version that the program was last chosen for; -1 after a change of its own. */
  #chosenFor = -1;
  readonly #model = new Matrix4();
  #placed: Object3D | null = null;

  constructor(lighting: PhongLighting, look: BaseLook = PLAIN_LOOK) {
    super({
      glslVersion: '300 es',
      ...shadersOf({}),
      uniforms: {
        uModelToShading: { value: new Matrix4() },
        uNormalToShading: { value: new Matrix3() },
        uEye: lighting.eye,
        uKa: { value: new Vector3() },
        uKd: { value: new Vector3() },
        uKs: { value: new Vector3() },
        uShininess: { value: 0 },
        uOpacity: { value: look.opacity },
        uAlphaCutoff: { value: look.alphaCutoff },
        uMap: { value: look.map },
        uMapTransform: { value: look.map?.matrix ?? new Matrix3() },
        uLightTexture: { value: null },
      },
      side: DoubleSide,
      vertexColors: look.vertexColors,
      premultipliedAlpha: true,
      blending: NormalBlending,
      transparent: look.alphaMode === 'blend',
      toneMapped: false,
    });
    this.#lighting = lighting;
    this.look = look;
    this.#writeSurface();
  }

  get surface(): Readonly<SurfaceValues> {
    return this.#surface;
  }

  get style(): ShadingStyle {
    return this.#style;
  }

  /** Shades in linear light: as its picture does. */
  get linear(): boolean {
    return this.#lighting.linear;
  }

  /** Goes up when this material needs another program than before. */
  get programVersion(): number {
    return this.#programVersion;
  }

  /** What of the surface a program for exactly this material has in it; see ExactMaterial. */
  get exactKey(): string {
    return this.#exactKey;
  }

  /** Goes up when what the surface gives back changes. */
  get surfaceVersion(): number {
    return this.#surfaceVersion;
  }

  /** What the surface gives back at most: Ka, Kd and Ks as the shader has them, 0 for terms that are not summed. */
  get reflectance(): Reflectance {
    return this.#reflectance;
  }

  /** Ka, Kd, Ks (255 = 1) and the exponent; throws for values outside their domain and then changes nothing. */
  setSurface(values: Partial<SurfaceValues>): void {
    const { ka, kd, ks, shininess } = { ...this.#surface, ...values };
    this.#surface = {
      ka: SURFACE_FIELDS.ka.check(ka),
      kd: SURFACE_FIELDS.kd.check(kd),
      ks: SURFACE_FIELDS.ks.check(ks),
      shininess: SURFACE_FIELDS.shininess.check(shininess),
    };
    this.#chosenFor = -1;
    this.#writeSurface();
  }

  setStyle(style: Partial<ShadingStyle>): void {
    this.#style = { ...this.#style, ...style };
    this.#chosenFor = -1;
    this.#writeSurface();
  }

  /** three.js calls this before each mesh that it draws with this material. */
  override onBeforeRender(...[renderer, , , , object]: Parameters<ShaderMaterial['onBeforeRender']>): void {
    this.chooseProgram();
    const { uLightTexture } = this.uniforms;
    if (uLightTexture !== undefined)
      uLightTexture.value = this.#lighting.lightsOf(object).rows.sendTexture(renderer);
    this.uniformsNeedUpdate = this.place(object);
  }

  /** Brings the program's defines in step with surface, style and lights. */
  chooseProgram(): void {
    if (this.#chosenFor !== this.#lighting.programVersion) this.#writeVariant();
  }

  /** Writes where `object` stands into the uniforms; true where they stood for another one. */
  place(object: Object3D): boolean {
    const { origin } = this.#lighting;
    const model = this.#model.copy(object.matrixWorld);
    const e = model.elements;
    e[12] -= origin[0];
    e[13] -= origin[1];
    e[14] -= origin[2];
    const { uModelToShading, uNormalToShading } = this.uniforms;
    const last = uModelToShading?.value as Matrix4;
    if (!last.equals(model)) normalMatrix(last.copy(model), uNormalToShading?.value as Matrix3);
    // What was the same object's is right already: three.js sends all uniforms of the first mesh of a material in each frame.
    const another = object !== this.#placed;
    this.#placed = object;
    return another;
  }

  #writeSurface(): void {
    const { uniforms } = this;
    const { linear } = this.#lighting;
    const { terms } = this.#style;
    const color = (target: string, term: Term, k: Vec3, base: Vec3): void => {
      const channel = (i: 0 | 1 | 2): number =>
        linear ? srgbDecode(k[i] / 255) * srgbDecode(base[i]) : (k[i] / 255) * base[i];
      const summed = terms.includes(term);
      (uniforms[target]?.value as Vector3).set(
        ...(summed ? ([channel(0), channel(1), channel(2)] as const) : NONE),
      );
    };
    color('uKa', 'ambient', this.#surface.ka, this.look.baseColor);
    color('uKd', 'diffuse', this.#surface.kd, this.look.baseColor);
    color('uKs', 'specular', this.#surface.ks, PLAIN_LOOK.baseColor);
    const { ks, shininess } = this.#surface;
    if (uniforms['uShininess'] !== undefined) uniforms['uShininess'].value = shininess;
    this.#surfaceVersion += 1;
    const power = isWholePower(shininess) ? shininess : isMildPower(shininess);
    const k = (name: string): number[] => (uniforms[name]?.value as Vector3).toArray();
    this.#reflectance = { ka: k('uKa'), kd: k('uKd'), ks: k('uKs') };
    this.#exactKey = `${String(power)} ${String(isBlack(ks))} ${terms.join()}`;
  }

  #writeVariant(): void {
    const lighting = this.#lighting;
    this.#chosenFor = lighting.programVersion;
    const look = this.look;
    const matte = isBlack(this.#surface.ks);
    for (const term of this.#style.terms) if (term !== 'specular' || !matte) this.#terms.add(term);
    const defines = variantDefines(
      {
        ...this.#style,
        antialias: hasAverages() ? this.#style.antialias : 'edges',
        terms: [...this.#terms],
        linear: lighting.linear,
        map: look.map !== null,
        vertexColors: look.vertexColors,
        alphaMode: look.alphaMode,
      },
      lighting.facts,
    );
    const key = Object.entries(defines).join();
    if (key === this.#programKey) return;
    this.#programKey = key;
    this.#programVersion += 1;
    this.defines = defines;
    Object.assign(this, shadersOf(defines));
    this.needsUpdate = true;
    this.#writeSurface(); // linear or not may be what changed
  }
}

/** The Phong material that `material` is or, for one that draws with an exact program, stands for; null for any other. */
export function phongOf(material: unknown): PhongMaterial | null {
  if (material instanceof PhongMaterial) return material;
  const { standsFor } = (material ?? {}) as { standsFor?: unknown };
  return standsFor instanceof PhongMaterial ? standsFor : null;
}

const NONE = [0, 0, 0] as const;
