// A three.js material that draws with the hand-written light loop. Keeps uniforms and program in
// step with its surface, its style and its picture's lights, and decides per draw which program and
// which sides of a mesh it needs.
import {
  DoubleSide,
  FrontSide,
  GLSL3,
  Material,
  Matrix3,
  type Mesh,
  RawShaderMaterial,
  Vector2,
  Vector3,
} from 'three';
import type { Texture } from 'three';
import { srgbDecode } from '../math/color.js';
import { map, type Vec3 } from '../math/vector.js';
import { cullsBackFaces, type Sides } from './back-faces.js';
import { decodedTexture } from './decoded-texture.js';
import { type BaseLook, PLAIN_LOOK, lobeScale, usesRoughnessMap } from './file-surface.js';
import type { LightBuffer } from './light-buffer.js';
import type { PhongLighting } from './lighting.js';
import {
  SURFACE_FIELDS,
  type SurfaceValues,
  DEFAULT_STYLE,
  type ShadingStyle,
} from './material-values.js';
import type { Term } from '../light/light-state.js';
import { normalMatrix } from './normal-matrix.js';
import { MaterialPrograms } from './program/material-programs.js';
import { compiles, variantParameters } from './program/three-programs.js';
import type { Variant } from './program/variant.js';

const DEFAULT_SURFACE: SurfaceValues = {
  ka: SURFACE_FIELDS.ka.fallback,
  kd: SURFACE_FIELDS.kd.fallback,
  ks: SURFACE_FIELDS.ks.fallback,
  shininess: SURFACE_FIELDS.shininess.fallback,
};

const BLACK: Vec3 = [0, 0, 0];

/**
 * The revision of the rows that each program's uniform array holds, by the variant's key: many
 * meshes would spend their frame on sending 1,000 rows each. Forgotten with every disposed
 * material: a program made again starts empty.
 */
let programRows = new WeakMap<object, Map<string, number>>();
/** How often rows were sent to any program. */
let rowsSent = 0;

type BeforeRender = Parameters<RawShaderMaterial['onBeforeRender']>;

/**
 * Draws opaque or blended 8-bit colour: the sum is clamped to 0–1 and rounded to the nearest code,
 * whatever the target. Call the lighting's `update` before each frame. A raw material, because
 * three.js's key for its programs then leaves out `side`: culling back faces in one draw and not in
 * the next compiles nothing.
 */
export class PhongMaterial extends RawShaderMaterial {
  /** Which sides can be seen: back faces that cannot are culled. Default `double`. */
  sides: Sides = 'double';
  readonly look: BaseLook;
  readonly #lighting: PhongLighting;
  #surface: Readonly<SurfaceValues> = DEFAULT_SURFACE;
  #style: ShadingStyle = DEFAULT_STYLE;
  readonly #programs: MaterialPrograms;
  /** The key of the variant whose program was compiled before a draw last. */
  #compiled = '';
  #linear = false;
  #variant: Variant | null = null;
  // What the last draw used.
  #lights: LightBuffer | null = null;
  #aim = 0;
  /** {@link PhongLighting.passOf} and {@link rowsSent}, which only increase. */
  #pass = 0;
  readonly #uniforms;

  /** What `look` leaves out is as in a file that says nothing. */
  constructor(lighting: PhongLighting, given: Partial<BaseLook> = PLAIN_LOOK) {
    const look = { ...PLAIN_LOOK, ...given };
    const uniforms = {
      ...fileUniforms(look),
      uEye: lighting.space.eye,
      uShadingToClip: lighting.space.clip,
      uKa: { value: new Vector3() },
      uKd: { value: new Vector3() },
      uKs: { value: new Vector3() },
      uShininess: { value: 0 },
      uOpacity: { value: look.opacity },
      uMapBias: lighting.space.mapBias,
      uAlphaCutoff: { value: look.alphaCutoff },
      // three.js sends a uniform array whether it changed or not, unless needsUpdate is false.
      uLightRows: { value: new Float32Array(4) as Float32Array, needsUpdate: true },
      uLightTexture: { value: null as Texture | null },
      uLightTextureScale: { value: new Vector2() },
    };
    super({
      uniforms,
      glslVersion: GLSL3,
      side: DoubleSide,
      vertexColors: look.vertexColors !== false,
      premultipliedAlpha: true,
      transparent: look.alphaMode === 'blend',
      toneMapped: false,
    });
    this.#uniforms = uniforms;
    this.#lighting = lighting;
    this.look = look;
    this.#programs = new MaterialPrograms(lighting, look);
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

  /**
   * Sets Ka, Kd, Ks (255 = 1) and the exponent. Throws for values outside their domain and then
   * changes nothing.
   */
  setSurface(values: Partial<SurfaceValues>): void {
    const { ka, kd, ks, shininess } = { ...this.#surface, ...values };
    this.#surface = {
      ka: SURFACE_FIELDS.ka.check(ka),
      kd: SURFACE_FIELDS.kd.check(kd),
      ks: SURFACE_FIELDS.ks.check(ks),
      shininess: SURFACE_FIELDS.shininess.check(shininess),
    };
    this.#writeSurface();
  }

  setStyle(style: Partial<ShadingStyle>): void {
    this.#style = { ...this.#style, ...style };
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

  /**
   * Whether the program of its next draw is being compiled in the background; drawing waits for it.
   * Programs in `asked` are left to the materials that asked for them.
   */
  compiles(renderer: BeforeRender[0], camera: BeforeRender[2], asked: string[]): boolean {
    this.#lighting.drawWith(renderer);
    const variant = this.#programs.general();
    const { key } = variant;
    if (key === this.#compiled || asked.includes(key)) return false;
    asked.push(key);
    this.#use(variant);
    if (compiles(this, renderer, camera)) return true;
    this.#compiled = key;
    return false;
  }

  /** three.js calls this before each draw: chooses sides, program and lights for this mesh. */
  override onBeforeRender(...[renderer, , camera, geometry, object]: BeforeRender): void {
    const mesh = object as Mesh;
    const culls = cullsBackFaces(this.sides, geometry, mesh.matrixWorld, camera);
    this.side = culls ? FrontSide : DoubleSide;
    const mirrors = this.#writeMatrices(mesh);
    const { meshLights, packing, space, special } = this.#lighting;
    const reaching = meshLights.of(mesh);
    const pass = this.#lighting.passOf(renderer, camera);
    const { uLightRows, uLightTexture, uLightTextureScale } = this.#uniforms;
    const isSame = pass + rowsSent === this.#pass && reaching === this.#lights;
    if (isSame && special?.divides(reaching) !== true) {
      uLightRows.needsUpdate = false;
      this.uniformsNeedUpdate = mirrors;
      return;
    }
    if (this.#linear !== this.linear) {
      this.#writeSurface();
    }
    this.#chooseTextures();
    const { variant, lights } = this.#programs.forDraw({ renderer, camera, mesh }, reaching);
    Object.assign(this.uniforms, packing.view?.program?.uniforms);
    this.#use(variant);
    const storage = variant.defines['LIGHT_STORAGE'];
    if (storage !== 'STORAGE_INLINED') {
      meshLights.countUpload(lights);
    }
    uLightRows.needsUpdate = storage === 'STORAGE_UNIFORMS' && !this.#holdsRows(renderer, lights);
    if (uLightRows.needsUpdate) {
      uLightRows.value = lights.rows;
      rowsSent += 1;
    }
    if (storage === 'STORAGE_TEXTURE') {
      uLightTexture.value = lights.sendTexture(renderer);
      uLightTextureScale.value.copy(lights.textureScale);
    }
    const aim = space.aim(camera);
    // three.js sends a material's uniforms once per frame, unless they change between two of its
    // draws.
    this.uniformsNeedUpdate =
      aim !== this.#aim || lights !== this.#lights || uLightRows.needsUpdate || mirrors;
    this.#aim = aim;
    this.#lights = lights;
    this.#pass = pass + rowsSent;
  }

  /** Frees the material's programs; drawing makes them again. */
  override dispose(): void {
    super.dispose();
    programRows = new WeakMap();
  }

  /** Whether the program of this draw holds these rows already; from now on it does. */
  #holdsRows({ properties }: BeforeRender[0], { revision }: LightBuffer): boolean {
    // three.js replaces a renderer's properties when a lost context is restored.
    const held = programRows.get(properties) ?? new Map<string, number>();
    programRows.set(properties, held);
    const program = this.#variant?.key ?? '';
    if (held.get(program) === revision) return true;
    held.set(program, revision);
    return false;
  }

  #use(variant: Variant): void {
    if (variant.key === this.#variant?.key) return;
    this.#variant = variant;
    Object.assign(this, variantParameters(variant));
    this.needsUpdate = true;
  }

  /**
   * Writes the mesh's place in shading space into three.js's matrices. True where `uMirrored` has
   * changed.
   */
  #writeMatrices(mesh: Mesh): boolean {
    const { origin } = this.#lighting.space;
    const model = mesh.modelViewMatrix.copy(mesh.matrixWorld);
    const e = model.elements;
    e[12] -= origin[0];
    e[13] -= origin[1];
    e[14] -= origin[2];
    normalMatrix(model, mesh.normalMatrix);
    if (this.look.normalMap === null) return false;
    const { uMirrored } = this.#uniforms;
    const before = uMirrored.value;
    uMirrored.value = model.determinant() < 0 ? -1 : 1;
    return uMirrored.value !== before;
  }

  /** Under `linear`, colours are decoded before they are filtered. */
  #chooseTextures(): void {
    const { uMap, uEmissiveMap } = this.#uniforms;
    const { map: base, emissiveMap } = this.look;
    uMap.value = base && this.#linear ? decodedTexture(base) : base;
    uEmissiveMap.value = emissiveMap && this.#linear ? decodedTexture(emissiveMap) : emissiveMap;
  }

  #writeSurface(): void {
    const { uKa, uKd, uKs, uShininess, uBaseColor, uEmissive, uLobeScale } = this.#uniforms;
    const { look } = this;
    const linear = (this.#linear = this.linear);
    const term = this.#lighting.packing.view?.term ?? null;
    const style = term === null ? this.#style : { ...this.#style, terms: [term] };
    const { terms } = style;
    const { ka, kd, ks, shininess } = this.#surface;
    const decode = (v: Vec3): Vec3 => (linear ? map(v, srgbDecode) : v);
    const write = (into: Vector3, term: Term, k: Vec3, base: Vec3): void => {
      const shares = map(terms.includes(term) ? k : BLACK, (code) => code / 255);
      into.set(...decode(shares)).multiply(new Vector3(...decode(base)));
    };
    write(uKa.value, 'ambient', ka, look.baseColor);
    write(uKd.value, 'diffuse', kd, look.baseColor);
    write(uKs.value, 'specular', ks, PLAIN_LOOK.baseColor);
    uShininess.value = shininess;
    uBaseColor.value.set(...decode(term !== null && look.unlit ? BLACK : look.baseColor));
    uEmissive.value.set(...decode(term === null ? look.emissive : BLACK));
    uLobeScale.value = look.roughness === null ? 1 : lobeScale(shininess);
    // Where the shader does not scale Ks itself.
    if (!(look.metalness > 0) && !usesRoughnessMap(look, this.#style)) {
      uKs.value.multiplyScalar(uLobeScale.value);
    }
    this.#programs.describe(style, this.#surface);
    // A page may change the surface between two draws of a frame: the next draw takes all steps.
    this.#lights = null;
  }
}

/** The uniforms that hold what a file says, with the values that do not depend on the style. */
function fileUniforms(look: BaseLook) {
  const { map, emissiveMap, metalRoughMap, normalMap } = look;
  const transform = (texture: Texture | null) => ({ value: texture?.matrix ?? new Matrix3() });
  return {
    uMap: { value: map },
    uMapTransform: transform(map),
    uEmissiveMap: { value: emissiveMap },
    uEmissiveMapTransform: transform(emissiveMap),
    uMetalRoughMap: { value: metalRoughMap },
    uMetalRoughMapTransform: transform(metalRoughMap),
    uNormalMap: { value: normalMap },
    uNormalMapTransform: transform(normalMap),
    uNormalScale: { value: look.normalScale },
    uMirrored: { value: 1 },
    uBaseColor: { value: new Vector3() },
    uEmissive: { value: new Vector3() },
    uMetalness: { value: look.metalness },
    uRoughness: { value: look.roughness ?? 1 },
    uLobeScale: { value: 1 },
  };
}
