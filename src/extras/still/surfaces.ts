// What a surface is at a hit: its normal, its coefficients and its opacity, as phong.frag.glsl has
// them. One record is written over and over.
import { coefficientsOf, type ReferenceOptions } from '../../phong/reference/index.js';
import { exponentOfRoughness, lobeScale } from '../../phong/material/file-surface.js';
import { srgbDecode, srgbEncode } from '../../phong/math/color.js';
import { add, cross, map, scale, subtract, type Vec3 } from '../../phong/math/vector.js';
import type { CastObject, CastShape, CastTexture } from './cast-scene.js';
import type { Hit } from './hit.js';
import { cornersOf, placed, type PlacedTriangles, unit } from './placed.js';
import { type Decode, readTexture } from './texture.js';

const BYTES = Float64Array.from({ length: 256 }, (_, code) => code / 255);
const DECODED = BYTES.map(srgbDecode);

/** An object of the scene, prepared for millions of hits. */
export class ObjectSurface {
  readonly object: CastObject;
  readonly isBlinn: boolean;
  readonly placed: PlacedTriangles;
  /** Ka, Kd and Ks as they enter the sum, with what textures and vertex colours multiply. */
  readonly #ka: Vec3;
  readonly #kd: Vec3;
  readonly #ks: Vec3;
  readonly #base: Vec3;
  readonly #emissive: Vec3;
  readonly #shape: CastShape;
  /** The vertices' colours as they are interpolated: under `linear` in linear light. */
  readonly #colors: ArrayLike<number> | undefined;
  readonly #linear: boolean;
  readonly #decode: Decode;

  constructor(object: CastObject, eye: Vec3, options: ReferenceOptions) {
    const { material, shape } = object;
    const { linear = false, terms = ['ambient', 'diffuse', 'specular'] } = options;
    this.object = object;
    this.isBlinn = (material.reflection ?? options.reflection) === 'blinn-phong';
    const plain = { ...material, baseColor: WHITE, metalness: 0, lobeScale: 1 };
    const { ka, kd, ks } = coefficientsOf(plain, linear);
    this.#ka = terms.includes('ambient') ? ka : BLACK;
    this.#kd = terms.includes('diffuse') ? kd : BLACK;
    this.#ks = terms.includes('specular') ? ks : BLACK;
    const decoded = (color: Vec3): Vec3 => (linear ? map(color, srgbDecode) : color);
    this.#base = decoded(material.baseColor ?? WHITE);
    this.#emissive = decoded(material.emissive ?? BLACK);
    this.#shape = shape;
    const { colors, linearColors = false } = shape;
    this.#colors =
      colors !== undefined && linear && !linearColors
        ? Float64Array.from(colors, (c, i) => (i % 4 === 3 ? c : srgbDecode(c)))
        : colors;
    this.placed = placed(shape, object.matrix, eye);
    this.#linear = linear;
    this.#decode = linear ? DECODED : BYTES;
  }

  /** The opacity at a hit, before `alphaMode`. */
  opacityAt(hit: Hit): number {
    const { texture, opacity = 1 } = this.object.material;
    let alpha = opacity;
    if (texture !== undefined) {
      this.#read(texture, hit, BYTES);
      alpha *= texel[3]!;
    }
    const { colors } = this.#shape;
    return colors === undefined ? alpha : alpha * this.mix(colors, 4, 3, hit);
  }

  /** Writes what the surface is at a hit, but for its normal: see {@link turn}. */
  at(hit: Hit, out: SurfacePoint): void {
    const { material } = this.object;
    const { texture, metalRoughTexture, emissiveTexture, unlit = false } = material;
    out.alpha = material.alphaMode === 'blend' ? this.opacityAt(hit) : 1;
    const { base } = out;
    for (const k of RGB) {
      base[k] = this.#base[k];
    }
    if (texture !== undefined) {
      this.#multiply(base, texture, hit);
    }
    const colors = this.#colors;
    if (colors !== undefined) {
      const isStoredLinear = this.#shape.linearColors === true;
      for (const k of RGB) {
        const c = this.mix(colors, 4, k, hit);
        base[k] *= isStoredLinear && !this.#linear ? srgbEncode(c) : c;
      }
    }
    if (unlit) return;
    let { metalness: m = 0, lobeScale: lobe = 1, shininess: n } = material;
    if (metalRoughTexture !== undefined) {
      this.#read(metalRoughTexture, hit, BYTES);
      m *= texel[2]!;
      if (material.roughness !== undefined && material.shading !== 'gouraud') {
        n = exponentOfRoughness(material.roughness * texel[1]!);
        lobe = lobeScale(n);
      }
    }
    out.n = n;
    for (const k of RGB) {
      out.ka[k] = this.#ka[k] * base[k];
      out.kd[k] = this.#kd[k] * base[k] * (1 - m);
      out.ks[k] = this.#ks[k] * ((1 - m) * lobe + m * base[k]);
      out.emissive[k] = this.#emissive[k];
    }
    if (emissiveTexture !== undefined) {
      this.#multiply(out.emissive, emissiveTexture, hit);
    }
  }

  /** Writes the unit normal to the hit, on the side that is seen or outward; zero for none. */
  turn(hit: Hit, isOutward = hit.front): void {
    const { shading, normalTexture, normalScale = 1 } = this.object.material;
    const { placed } = this;
    let normal: Vec3;
    if (shading === 'flat') {
      normal = faceNormal(placed, hit.triangle);
    } else {
      normal = this.#mixed(placed.normals, hit);
      if (normalTexture !== undefined && placed.tangents.length > 0) {
        this.#read(normalTexture, hit, BYTES);
        const tilt = Array.from(texel, (c) => c * 2 - 1) as [number, number, number];
        const x = this.#mixed(placed.tangents, hit);
        const z = unit(normal);
        const side = this.mix(this.#shape.tangents!, 4, 3, hit) * (placed.mirrored ? -1 : 1);
        const y = scale(cross(z, x), tilt[1] * side);
        normal = add(scale(add(scale(x, tilt[0]), y), normalScale), scale(z, tilt[2]));
      }
    }
    hit.normal = unit(normal, isOutward ? 1 : -1);
  }

  #mixed(values: Float64Array, hit: Hit): Vec3 {
    return [this.mix(values, 3, 0, hit), this.mix(values, 3, 1, hit), this.mix(values, 3, 2, hit)];
  }

  /** The mean of the corners' values, `size` numbers each, by the hit's shares. */
  mix(values: ArrayLike<number>, size: number, k: number, { triangle, a, b, c }: Hit): number {
    const index = this.#shape.index;
    const first = 3 * triangle;
    if (index === undefined) {
      const at = size * first + k;
      return a * values[at]! + b * values[at + size]! + c * values[at + 2 * size]!;
    }
    return (
      a * values[size * index[first]! + k]! +
      b * values[size * index[first + 1]! + k]! +
      c * values[size * index[first + 2]! + k]!
    );
  }

  #multiply(color: [number, number, number], texture: CastTexture, hit: Hit): void {
    this.#read(texture, hit, this.#decode);
    for (const k of RGB) {
      color[k] *= texel[k]!;
    }
  }

  #read(texture: CastTexture, hit: Hit, decode: Decode): void {
    const uv = this.#shape.uvs?.[texture.uv ?? 0] ?? NO_UV;
    readTexture(texture, this.mix(uv, 2, 0, hit), this.mix(uv, 2, 1, hit), decode, texel);
  }
}

/** The triangle's own, on the side that its corners turn to. */
function faceNormal(placed: PlacedTriangles, triangle: number): Vec3 {
  const [a, b, c] = cornersOf(placed, triangle);
  return scale(cross(subtract(b, a), subtract(c, a)), placed.mirrored ? -1 : 1);
}

/** Colours 0–1, decoded where shading is linear. */
export class SurfacePoint {
  /** The base colour. */
  readonly base: [number, number, number] = [1, 1, 1];
  readonly ka: [number, number, number] = [0, 0, 0];
  readonly kd: [number, number, number] = [0, 0, 0];
  readonly ks: [number, number, number] = [0, 0, 0];
  readonly emissive: [number, number, number] = [0, 0, 0];
  /** Exponent. */
  n = 0;
  alpha = 1;
}

/** The indices of r, g and b. */
export const RGB = [0, 1, 2] as const;
const WHITE: Vec3 = [1, 1, 1];
const BLACK: Vec3 = [0, 0, 0];
const NO_UV: readonly number[] = [];
/** Overwritten by each call of {@link readTexture}. */
const texel = new Float64Array(4);
