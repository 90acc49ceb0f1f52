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
import { srgbDecode } from '../math/color.js';
import type { Vec3 } from '../math/vector.js';
import { SURFACE_FIELDS, type SurfaceValues } from './material-values.js';
import { normalMatrix } from './normal-matrix.js';
import type { PhongLighting } from './phong-lighting.js';
import { FRAGMENT_SHADER, VERTEX_SHADER } from './shader-source.js';
import {
  type AlphaMode,
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
}

const DEFAULT_STYLE: ShadingStyle = { shading: 'phong', reflection: 'phong', terms: TERMS };

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
  readonly #look: BaseLook;
  #surface: Readonly<SurfaceValues> = DEFAULT_SURFACE;
  #style: ShadingStyle = DEFAULT_STYLE;
  #programKey = '';
  /** The lighting's version that the program was last chosen for; -1 after a change of its own. */
  #chosenFor = -1;
  readonly #model = new Matrix4();

  constructor(lighting: PhongLighting, look: BaseLook = PLAIN_LOOK) {
    super({
      glslVersion: '300 es',
      vertexShader: VERTEX_SHADER,
      fragmentShader: FRAGMENT_SHADER,
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
        uLightTexture: lighting.rows.texture,
      },
      side: DoubleSide,
      vertexColors: look.vertexColors,
      premultipliedAlpha: true,
      blending: NormalBlending,
      transparent: look.alphaMode === 'blend',
      toneMapped: false,
    });
    this.#lighting = lighting;
    this.#look = look;
    this.#writeSurface();
  }

  get look(): BaseLook {
    return this.#look;
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
  }

  /** three.js calls this before each mesh that it draws with this material. */
  override onBeforeRender(...[, , , , object]: Parameters<ShaderMaterial['onBeforeRender']>): void {
    if (this.#chosenFor !== this.#lighting.programVersion) this.#writeVariant();
    this.#writePlace(object);
    this.uniformsNeedUpdate = true;
  }

  #writeSurface(): void {
    const { uniforms } = this;
    const linear = this.#lighting.linear;
    const color = (target: string, k: Vec3, base: Vec3): void => {
      const channel = (i: 0 | 1 | 2): number =>
        linear ? srgbDecode(k[i] / 255) * srgbDecode(base[i]) : (k[i] / 255) * base[i];
      (uniforms[target]?.value as Vector3).set(channel(0), channel(1), channel(2));
    };
    color('uKa', this.#surface.ka, this.#look.baseColor);
    color('uKd', this.#surface.kd, this.#look.baseColor);
    color('uKs', this.#surface.ks, PLAIN_LOOK.baseColor);
    if (uniforms['uShininess'] !== undefined) uniforms['uShininess'].value = this.#surface.shininess;
  }

  #writeVariant(): void {
    const lighting = this.#lighting;
    this.#chosenFor = lighting.programVersion;
    const look = this.#look;
    const defines = variantDefines(
      {
        ...this.#style,
        linear: lighting.linear,
        storage: lighting.rows.storage,
        map: look.map !== null,
        vertexColors: look.vertexColors,
        alphaMode: look.alphaMode,
        matte: this.#surface.ks.every((k) => k === 0),
      },
      lighting.facts,
    );
    const key = Object.entries(defines).join();
    if (key === this.#programKey) return;
    this.#programKey = key;
    this.defines = defines;
    // A group that the program has no block for is an error to WebGL.
    this.uniformsGroups = lighting.rows.storage === 'block' ? [lighting.rows.group] : [];
    this.needsUpdate = true;
    this.#writeSurface(); // linear or not may be what changed
  }

  #writePlace(object: Object3D): void {
    const { origin } = this.#lighting;
    const model = this.#model.copy(object.matrixWorld);
    const e = model.elements;
    e[12] -= origin[0];
    e[13] -= origin[1];
    e[14] -= origin[2];
    (this.uniforms['uModelToShading']?.value as Matrix4).copy(model);
    normalMatrix(model, this.uniforms['uNormalToShading']?.value as Matrix3);
  }
}
