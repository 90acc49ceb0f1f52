// A three.js material that draws with the hand-written light loop. Keeps uniforms and program in step with its surface, its
// style and its picture's lights, and decides per draw which program and which sides of a mesh it needs. Knows neither
// elements nor the scene it is used in.
import {
  DoubleSide,
  FrontSide,
  GLSL3,
  Material,
  Matrix3,
  Matrix4,
  type Mesh,
  NormalBlending,
  RawShaderMaterial,
  type Texture,
  Vector2,
  Vector3,
} from 'three';
import { isBlack, isIntegerPower, isPowerTo64 } from '../light/light-features.js';
import { srgbDecode } from '../math/color.js';
import type { Vec3 } from '../math/vector.js';
import { cullsBackFaces, type Sides } from './back-faces.js';
import type { LightBuffer } from './light-buffer.js';
import type { PhongLighting } from './lighting.js';
import { SURFACE_FIELDS, type SurfaceValues } from './material-values.js';
import { normalMatrix } from './normal-matrix.js';
import { type Drawing, variantParameters } from './program/program-cache.js';
import {
  type AlphaMode,
  type Antialias,
  generalVariant,
  type Reflection,
  type RowCapacity,
  type Shading,
  specialisedVariant,
  type Term,
  TERMS,
  type Variant,
} from './program/variant.js';

/** What a file says about a surface's colour: it multiplies Ka and Kd. */
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
   * `edges` (default): one sample per pixel inside faces; the renderer smooths edges. `highlights`: the specular lobe is
   * also averaged over each pixel, so that highlights smaller than a pixel keep their brightness; not under `gouraud`.
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

const BLACK: Vec3 = [0, 0, 0];

/** Parameters of three.js's hook before each draw. */
type BeforeRender = Parameters<RawShaderMaterial['onBeforeRender']>;

/**
 * Draws opaque or blended 8-bit colour: the sum is clamped to 0–1 and rounded to the nearest code, whatever the target.
 * Call {@link PhongLighting.update} before each frame. A raw material, because three.js's key for its programs then leaves out
 * `side`: culling back faces in one draw and not in the next compiles nothing.
 */
export class PhongMaterial extends RawShaderMaterial {
  /** Which sides can be seen: back faces that cannot are culled. Default `double`. */
  sides: Sides = 'double';
  readonly look: BaseLook;
  readonly #lighting: PhongLighting;
  #surface: Readonly<SurfaceValues> = DEFAULT_SURFACE;
  #style: ShadingStyle = DEFAULT_STYLE;
  /** Terms that were ever summed: their code stays, so that turning one off and on compiles nothing. */
  readonly #terms = new Set<Term>();
  /** All exponents so far were 64 at most. */
  #shininessTo64 = true;
  #general: Variant | null = null;
  /** What {@link #general} was made for: lighting's version, row capacity; -1 after a change of this material. */
  #generalFor = -1;
  #capacity: RowCapacity = 0;
  /** What a specialised program has in it besides its lights. */
  #key = '';
  /** The last key asked for, to build no text in each draw. */
  #asked = { material: '', lights: '', key: '' };
  #variant: Variant | null = null;
  readonly #model = new Matrix4();
  #placed: Mesh | null = null;
  readonly #uniforms;

  constructor(lighting: PhongLighting, look: BaseLook = PLAIN_LOOK) {
    const uniforms = {
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
      uLightRows: { value: new Float32Array(4) as Float32Array },
      uLightTexture: { value: null as Texture | null },
      uLightTextureScale: { value: new Vector2() },
    };
    super({
      uniforms,
      glslVersion: GLSL3,
      side: DoubleSide,
      vertexColors: look.vertexColors,
      premultipliedAlpha: true,
      blending: NormalBlending,
      transparent: look.alphaMode === 'blend',
      toneMapped: false,
    });
    this.#uniforms = uniforms;
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

  /** Shades in linear light, as its picture does. */
  get linear(): boolean {
    return this.#lighting.linear;
  }

  /** Sets Ka, Kd, Ks (255 = 1) and the exponent. Throws for values outside their domain and then changes nothing. */
  setSurface(values: Partial<SurfaceValues>): void {
    const { ka, kd, ks, shininess } = { ...this.#surface, ...values };
    this.#surface = {
      ka: SURFACE_FIELDS.ka.check(ka),
      kd: SURFACE_FIELDS.kd.check(kd),
      ks: SURFACE_FIELDS.ks.check(ks),
      shininess: SURFACE_FIELDS.shininess.check(shininess),
    };
    this.#generalFor = -1;
    this.#writeSurface();
  }

  setStyle(style: Partial<ShadingStyle>): void {
    this.#style = { ...this.#style, ...style };
    this.#generalFor = -1;
    this.#writeSurface();
  }

  /** Another material with the same lighting, look, surface, style and sides. */
  override clone(): this {
    const other = new PhongMaterial(this.#lighting, this.look);
    Material.prototype.copy.call(other, this);
    other.sides = this.sides;
    other.setStyle(this.#style);
    other.setSurface(this.#surface);
    return other as this;
  }

  /** three.js calls this before each draw: chooses sides, program and lights for this mesh. */
  override onBeforeRender(...[renderer, , camera, geometry, object]: BeforeRender): void {
    const mesh = object as Mesh;
    const culls = cullsBackFaces(this.sides, geometry, mesh.matrixWorld, camera);
    this.side = culls ? FrontSide : DoubleSide;
    const lights = this.#chooseProgram({ renderer, camera, mesh });
    this.#lighting.countUpload(lights);
    const uniforms = this.#uniforms;
    if (this.#readsTexture) {
      uniforms.uLightTexture.value = lights.sendTexture(renderer);
      uniforms.uLightTextureScale.value.copy(lights.textureScale);
    }
    const sameRows = uniforms.uLightRows.value === lights.rows;
    uniforms.uLightRows.value = lights.rows;
    const sameMesh = this.#place(mesh);
    // three.js sends a material's uniforms once per frame; meshes after the first need theirs sent again.
    this.uniformsNeedUpdate = !(sameMesh && sameRows);
  }

  get #readsTexture(): boolean {
    return this.#variant?.defines['LIGHT_STORAGE'] === 'STORAGE_TEXTURE';
  }

  /** Chooses the variant for this draw, and returns the lights it reads. */
  #chooseProgram(drawing: Drawing): LightBuffer {
    const lighting = this.#lighting;
    const general = this.#generalVariant(lighting.capacityFor(drawing.renderer));
    const lights = lighting.lightsOf(drawing.mesh);
    const grid = lighting.gridOf(drawing.mesh);
    const form = lighting.formFor(lights, grid);
    let special: Variant | null = null;
    if (form !== null) {
      // Inlined numbers are those of one version; other forms depend on counts and features alone.
      const lightKey = form === 'inlined' ? lights.contentKey : lights.featureKey;
      special = lighting.programs.choose(this.#keyFor(`${form} ${lightKey}`), drawing, () =>
        specialisedVariant(
          general,
          { terms: this.#summedTerms, integerShininess: this.#integerShininess },
          form,
          lights.packed,
        ),
      );
    }
    this.#use(special ?? general);
    return special !== null && grid !== null ? grid : lights;
  }

  #keyFor(lights: string): string {
    const { material, lights: before } = this.#asked;
    if (material !== this.#key || before !== lights)
      this.#asked = { material: this.#key, lights, key: `${this.#key} ${lights}` };
    return this.#asked.key;
  }

  #use(variant: Variant): void {
    if (variant === this.#variant) return;
    this.#variant = variant;
    Object.assign(this, variantParameters(variant));
    this.needsUpdate = true;
  }

  #generalVariant(capacity: RowCapacity): Variant {
    const lighting = this.#lighting;
    const { featureVersion } = lighting;
    if (this.#general !== null && this.#generalFor === featureVersion && this.#capacity === capacity)
      return this.#general;
    this.#generalFor = featureVersion;
    this.#capacity = capacity;
    for (const term of this.#summedTerms) this.#terms.add(term);
    const { look } = this;
    this.#general = generalVariant(
      {
        ...this.#style,
        terms: [...this.#terms],
        linear: lighting.linear,
        shininessTo64: this.#shininessTo64,
        map: look.map !== null,
        vertexColors: look.vertexColors,
        alphaMode: look.alphaMode,
      },
      lighting.declared,
      capacity,
    );
    const { terms } = this.#style;
    this.#key = `${this.#general.key} ${terms.join()} ${String(this.#integerShininess)}`;
    this.#writeSurface(); // linear or not may have changed
    return this.#general;
  }

  /** The terms of the style that this surface gives back. */
  get #summedTerms(): readonly Term[] {
    const matte = isBlack(this.#surface.ks);
    return this.#style.terms.filter((term) => term !== 'specular' || !matte);
  }

  get #integerShininess(): number | null {
    const { shininess } = this.#surface;
    return isIntegerPower(shininess) ? shininess : null;
  }

  /** Writes the mesh's place into the uniforms; true where they were the same mesh's. */
  #place(mesh: Mesh): boolean {
    const { origin } = this.#lighting;
    const model = this.#model.copy(mesh.matrixWorld);
    const e = model.elements;
    e[12] -= origin[0];
    e[13] -= origin[1];
    e[14] -= origin[2];
    const { uModelToShading, uNormalToShading } = this.#uniforms;
    const last = uModelToShading.value;
    if (!last.equals(model)) normalMatrix(last.copy(model), uNormalToShading.value);
    const same = mesh === this.#placed;
    this.#placed = mesh;
    return same;
  }

  #writeSurface(): void {
    const { uKa, uKd, uKs, uShininess } = this.#uniforms;
    const { linear } = this.#lighting;
    const { terms } = this.#style;
    const { ka, kd, ks, shininess } = this.#surface;
    const write = (into: Vector3, term: Term, k: Vec3, base: Vec3): void => {
      const channel = (i: 0 | 1 | 2): number =>
        linear ? srgbDecode(k[i] / 255) * srgbDecode(base[i]) : (k[i] / 255) * base[i];
      if (terms.includes(term)) into.set(channel(0), channel(1), channel(2));
      else into.set(...BLACK);
    };
    write(uKa.value, 'ambient', ka, this.look.baseColor);
    write(uKd.value, 'diffuse', kd, this.look.baseColor);
    write(uKs.value, 'specular', ks, PLAIN_LOOK.baseColor);
    uShininess.value = shininess;
    if (!isPowerTo64(shininess)) this.#shininessTo64 = false;
  }
}
