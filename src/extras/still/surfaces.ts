// What a surface is at a hit: its normal, its coefficients and its opacity, as phong.frag.glsl has
// them.
import type { ReferenceOptions } from '../../phong/reference/index.js';
import { coefficientsOf, decoded } from '../../phong/reference/equation.js';
import { exponentOfRoughness, lobeScale } from '../../phong/material/file-surface.js';
import { srgbDecode, srgbEncode } from '../../phong/math/color.js';
import { add, cross, map, multiply, scale, subtract, type Vec3 } from '../../phong/math/vector.js';
import type { CastObject, CastTexture } from './cast-scene.js';
import { Hit } from './hit.js';
import { PlacedShape, unit, vectorAt } from './placed.js';
import { type Decode, readTexture } from './texture.js';

const BYTES = Float64Array.from({ length: 256 }, (_, code) => code / 255);
const DECODED = BYTES.map(srgbDecode);

/** An object of the scene, prepared for millions of hits. */
export class ObjectSurface extends PlacedShape {
  readonly object: CastObject;
  readonly isBlinn: boolean;
  /** Ka, Kd and Ks as they enter the sum, with what textures and vertex colours multiply. */
  readonly #ka: Vec3;
  readonly #kd: Vec3;
  readonly #ks: Vec3;
  readonly #base: Vec3;
  readonly #emissive: Vec3;
  /** The vertices' colours as they are interpolated: under `linear` in linear light. */
  readonly #colors: ArrayLike<number> | undefined;
  readonly #decode: Decode;
  /** What it is at all hits, where no texture and no vertex colours differ. */
  readonly point: SurfacePoint | undefined;

  constructor(object: CastObject, eye: Vec3, options: ReferenceOptions) {
    super(object, eye);
    const { material, shape } = object;
    const { linear = false, terms = ['ambient', 'diffuse', 'specular'] } = options;
    this.object = object;
    this.isBlinn = (material.reflection ?? options.reflection) === 'blinn-phong';
    const plain = { ...material, baseColor: WHITE, metalness: 0, lobeScale: 1 };
    const { ka, kd, ks } = coefficientsOf(plain, linear);
    this.#ka = terms.includes('ambient') ? ka : BLACK;
    // A copy: where a thousand of a function's lists live long, V8 makes all its next ones for long
    // lives, too, and `scale` makes those of each sample: 1,000 balls took 14 s so, and take 12 s.
    this.#kd = terms.includes('diffuse') ? [...kd] : BLACK;
    this.#ks = terms.includes('specular') ? ks : BLACK;
    this.#base = decoded(material.baseColor ?? WHITE, linear);
    this.#emissive = decoded(material.emissive ?? BLACK, linear);
    const { colors, linearColors = false } = shape;
    this.#colors =
      colors !== undefined && linear && !linearColors
        ? Float64Array.from(colors, (c, i) => (i % 4 === 3 ? c : srgbDecode(c)))
        : colors;
    this.#decode = linear ? DECODED : BYTES;
    if (!shape.uvs?.length && !colors) {
      this.point = this.at(new Hit());
    }
  }

  /** The opacity at a hit, before `alphaMode`. */
  opacityAt(hit: Hit): number {
    const { texture, opacity = 1 } = this.object.material;
    let alpha = opacity;
    if (texture !== undefined) {
      this.#read(texture, hit, BYTES);
      alpha *= texel[3]!;
    }
    const { colors } = this.shape;
    return colors === undefined ? alpha : alpha * this.mix(colors, 4, 3, hit);
  }

  /**
   * What the surface is at a hit, but for its normal: see {@link turn}. Colours 0–1, decoded where
   * shading is linear. `n`: the exponent.
   */
  at(hit: Hit) {
    const { material } = this.object;
    const { texture, metalRoughTexture, emissiveTexture } = material;
    let base = this.#multiplied(this.#base, texture, hit);
    const colors = this.#colors;
    if (colors !== undefined) {
      const isEncoded = this.shape.linearColors === true && this.#decode === BYTES;
      const color = map(RGB, (k) => this.mix(colors, 4, k, hit));
      base = multiply(base, isEncoded ? map(color, srgbEncode) : color);
    }
    let { metalness: m = 0, lobeScale: lobe = 1, shininess: n } = material;
    if (metalRoughTexture !== undefined) {
      this.#read(metalRoughTexture, hit, BYTES);
      m *= texel[2]!;
      const { roughness = null, shading } = material;
      if (roughness !== null && shading !== 'gouraud') {
        n = exponentOfRoughness(roughness * texel[1]!);
        lobe = lobeScale(n);
      }
    }
    return {
      base,
      ka: multiply(this.#ka, base),
      // Not `scale`: see the constructor.
      kd: map(multiply(this.#kd, base), (c) => c * (1 - m)),
      ks: multiply(
        this.#ks,
        map(base, (c) => (1 - m) * lobe + m * c),
      ),
      emissive: this.#multiplied(this.#emissive, emissiveTexture, hit),
      n,
      alpha: material.alphaMode === 'blend' ? this.opacityAt(hit) : 1,
    };
  }

  /**
   * Writes the unit normal to the hit, on the side that is seen or outward; zero for none. `normals`:
   * of the triangle's corners, from `at` on.
   */
  turn(hit: Hit, normals: ArrayLike<number>, at: number, isOutward: boolean): void {
    const { shading, normalTexture, normalScale = 1 } = this.object.material;
    let normal: Vec3;
    if (shading === 'flat') {
      const [p, q, r] = this.cornersOf(hit.triangle);
      normal = scale(cross(subtract(q, p), subtract(r, p)), this.mirrored ? -1 : 1);
    } else {
      normal = mean(normals, at, hit);
      if (
        shading !== 'gouraud' &&
        normalTexture !== undefined &&
        this.shape.tangents !== undefined
      ) {
        this.#read(normalTexture, hit, BYTES);
        const tilt = map(vectorAt(texel, 0), (code) => code * 2 - 1);
        const tangents = this.verticesOf(hit.triangle).flatMap((vertex) => this.tangent(vertex));
        const x = mean(tangents, 0, hit);
        const z = unit(normal);
        const side = this.mix(this.shape.tangents, 4, 3, hit) * (this.mirrored ? -1 : 1);
        const y = scale(cross(z, x), tilt[1] * side);
        normal = add(scale(add(scale(x, tilt[0]), y), normalScale), scale(z, tilt[2]));
      }
    }
    hit.normal = unit(normal, isOutward ? 1 : -1);
  }

  /** The mean of the corners' values, `size` numbers each, by the hit's shares. */
  mix(values: ArrayLike<number>, size: number, k: number, { triangle, a, b, c }: Hit): number {
    const [u, v, w] = this.verticesOf(triangle);
    return a * values[size * u + k]! + b * values[size * v + k]! + c * values[size * w + k]!;
  }

  #multiplied(color: Vec3, texture: CastTexture | undefined, hit: Hit): Vec3 {
    if (texture === undefined) return color;
    this.#read(texture, hit, this.#decode);
    return multiply(color, vectorAt(texel, 0));
  }

  #read(texture: CastTexture, hit: Hit, decode: Decode): void {
    const uv = this.shape.uvs?.[texture.uv ?? 0] ?? NO_UV;
    readTexture(texture, this.mix(uv, 2, 0, hit), this.mix(uv, 2, 1, hit), decode, texel);
  }
}

/** The mean of three vectors, from `at` on, by a hit's shares. */
const mean = (list: ArrayLike<number>, at: number, { a, b, c }: Hit): Vec3 =>
  map([at, at + 1, at + 2], (i) => a * list[i]! + b * list[i + 3]! + c * list[i + 6]!);

export type SurfacePoint = ReturnType<ObjectSurface['at']>;

/** The indices of r, g and b. */
export const RGB = [0, 1, 2] as const;
const WHITE: Vec3 = [1, 1, 1];
const BLACK: Vec3 = [0, 0, 0];
const NO_UV: readonly number[] = [];
/** Overwritten by each call of {@link readTexture}. */
const texel = new Float64Array(4);
