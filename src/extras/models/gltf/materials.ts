// The parts of a glTF material that the equation uses: read and checked in the JSON, and turned
// into the equation's terms when three's loader has made the material. See BaseLook for their
// meaning.
import { type BufferGeometry, DoubleSide, type MeshStandardMaterial, type Texture } from 'three';
import { LIMITS } from '../../../phong/light/light-state.js';
import { exponentOfRoughness } from '../../../phong/material/file-surface.js';
import { SURFACE_FIELDS } from '../../../phong/material/material-values.js';
import { srgbEncode } from '../../../phong/math/color.js';
import { clamp, map, multiply } from '../../../phong/math/vector.js';
import type { ContentPart } from '../../../phong/model/model.js';
import type { Slices } from '../slices.js';
import {
  countAt,
  indexAt,
  optionalIndex,
  numberAt,
  numbersAt,
  objectsAt,
  optionalObject,
  textAt,
  type JsonObject,
} from './json.js';

export interface GltfTexture {
  /** Undefined if there is no image in a supported format. */
  readonly image: number | undefined;
  /** The unsupported extension that holds the image, if any. */
  readonly needs: string | undefined;
  readonly sampler: JsonObject;
}

const GLOSSY = 'KHR_materials_pbrSpecularGlossiness';
/** Mostly smaller than the plain `source`, which is the fallback. */
const WEBP = 'EXT_texture_webp';
/**
 * Used where there is no other image: those need no transcoder, and have more of the original's
 * colours.
 */
const KTX2 = 'KHR_texture_basisu';

export function readTextures(
  json: JsonObject,
  images: number,
  slices: Slices,
): Promise<readonly GltfTexture[]> {
  const samplers = objectsAt(json['samplers'], 'samplers');
  return slices.map(objectsAt(json['textures'], 'textures'), (texture, i) => {
    const what = `textures[${String(i)}]`;
    const extensions = optionalObject(texture['extensions'], `${what}.extensions`);
    const sourceOf = (name: string) => optionalObject(extensions[name], what)['source'];
    const source = WEBP in extensions ? sourceOf(WEBP) : (texture['source'] ?? sourceOf(KTX2));
    const sampler = texture['sampler'];
    return {
      image: optionalIndex(source, images, `${what}.source`),
      needs: Object.keys(extensions)[0],
      sampler:
        sampler === undefined ? {} : (samplers[indexAt(sampler, samplers.length, what)] ?? {}),
    };
  });
}

/** What a material says beside base colour, alpha and sides. Colours are linear, as in the file. */
interface MaterialValues {
  readonly unlit: boolean;
  readonly emissive: readonly number[];
  /**
   * Null: the file leaves metalness and roughness at glTF's default, a rough metal, which shows
   * nothing but its surroundings.
   */
  readonly metalRough: { readonly metalness: number; readonly roughness: number } | null;
  /** Factor of the specular coefficient; null for none. */
  readonly specular: readonly number[] | null;
  readonly normalScale: number;
  /**
   * Whether the file names these maps: where their image is missing, the factors that multiply it
   * mean nothing.
   */
  readonly mapped: { readonly emissive: boolean; readonly metalRough: boolean };
}

export interface GltfMaterial extends JsonObject {
  readonly uses: readonly TextureUse[];
  /** Sets of texture coordinates that were moved to an unused place, by that place. */
  readonly uvSets: ReadonlyMap<number, number>;
}

/**
 * For the parser, with {@link MaterialValues} as `extras.surface`. @param dropped gets textures
 * that are left out.
 */
export function readMaterials(
  json: JsonObject,
  textures: readonly GltfTexture[],
  dropped: Set<string>,
  slices: Slices,
): Promise<readonly GltfMaterial[]> {
  return slices.map(objectsAt(json['materials'], 'materials'), (material, i) => {
    const what = `materials[${String(i)}]`;
    const extensions = optionalObject(material['extensions'], what);
    const glossy = optionalObject(extensions[GLOSSY], what);
    // What stands beside the extension is for programs that do not know it.
    const metallic =
      GLOSSY in extensions ? {} : optionalObject(material['pbrMetallicRoughness'], what);
    const specular = optionalObject(extensions['KHR_materials_specular'], what);
    for (const name of NOT_SHOWN) {
      if ([material, glossy, specular].some((object) => name in object)) {
        dropped.add(name);
      }
    }
    const uses: TextureUse[] = [];
    const use = (value: unknown): TextureUse | undefined => {
      if (value === undefined) return undefined;
      uses.push(readTextureUse(value, textures, what));
      return uses.at(-1);
    };
    const normal = optionalObject(material['normalTexture'], what);
    const read = {
      name: textAt(material['name']),
      alphaMode: textAt(material['alphaMode']) || 'OPAQUE',
      doubleSided: material['doubleSided'] === true,
      alphaCutoff: numberAt(material['alphaCutoff'], `${what}.alphaCutoff`, 0.5),
      pbrMetallicRoughness: {
        baseColorFactor: numbersAt(metallic['baseColorFactor'] ?? glossy['diffuseFactor'], 4, what),
        baseColorTexture: use(metallic['baseColorTexture'] ?? glossy['diffuseTexture']),
        metallicRoughnessTexture: use(metallic['metallicRoughnessTexture']),
      },
      normalTexture: use(material['normalTexture']),
      emissiveTexture: use(material['emissiveTexture']),
      extras: {
        surface: {
          unlit: 'KHR_materials_unlit' in extensions,
          emissive: readEmissive(material, extensions, what),
          metalRough: readMetalRough(metallic, glossy, what),
          specular: readSpecular(specular, glossy, what),
          normalScale: numberAt(normal['scale'], `${what}.normalTexture.scale`, 1),
          mapped: {
            emissive: 'emissiveTexture' in material,
            metalRough: 'metallicRoughnessTexture' in metallic,
          },
        } satisfies MaterialValues,
      },
    };
    return { ...read, uses, uvSets: movedUvSets(uses) };
  });
}

/** Textures of a material and of its extensions that the equation has no place for. */
const NOT_SHOWN = [
  'occlusionTexture',
  'specularGlossinessTexture',
  'specularTexture',
  'specularColorTexture',
];

/**
 * Moves sets of texture coordinates above the fourth to places among the first four that the
 * material does not use; four uses need no more. Returns the moved sets by their new places.
 */
function movedUvSets(uses: readonly TextureUse[]): ReadonlyMap<number, number> {
  const used = new Set(uses.map(({ texCoord }) => texCoord));
  const moved = new Map<number, number>();
  for (const set of used) {
    if (set < UV_SETS) continue;
    const place = [0, 1, 2, 3].find((free) => !used.has(free) && !moved.has(free))!;
    moved.set(place, set);
    for (const use of uses.filter(({ texCoord }) => texCoord === set)) {
      use.texCoord = place;
    }
  }
  return moved;
}

const BLACK = [0, 0, 0];
const WHITE = [1, 1, 1];

function readEmissive(
  material: JsonObject,
  extensions: JsonObject,
  what: string,
): readonly number[] {
  const factor = numbersAt(material['emissiveFactor'], 3, `${what}.emissiveFactor`) ?? BLACK;
  const { emissiveStrength } = optionalObject(extensions['KHR_materials_emissive_strength'], what);
  const strength = numberAt(emissiveStrength, `${what}.emissiveStrength`, 1);
  return factor.map((c) => c * strength);
}

function readMetalRough(
  metallic: JsonObject,
  glossy: JsonObject,
  what: string,
): MaterialValues['metalRough'] {
  const { metallicFactor, roughnessFactor, metallicRoughnessTexture } = metallic;
  const glossiness = share(glossy['glossinessFactor'], `${what}.glossinessFactor`);
  if (glossiness < 1) return { metalness: 0, roughness: 1 - glossiness };
  const metalness = share(metallicFactor, `${what}.metallicFactor`);
  const roughness = share(roughnessFactor, `${what}.roughnessFactor`);
  if (metallicRoughnessTexture !== undefined) return { metalness, roughness };
  return metalness === 1 && roughness === 1
    ? null
    : { metalness: Math.min(metalness, MOST_METAL), roughness };
}

/**
 * Metalness of a metal all over, without a texture. What it shows of its surroundings is not in the
 * equation; half of Kd stands for that.
 */
const MOST_METAL = 0.5;

function readSpecular(
  specular: JsonObject,
  glossy: JsonObject,
  what: string,
): readonly number[] | null {
  const color = specular['specularColorFactor'] ?? glossy['specularFactor'];
  if (color === undefined && specular['specularFactor'] === undefined) return null;
  const factor = share(specular['specularFactor'], `${what}.specularFactor`);
  return (numbersAt(color, 3, `${what}.specularColorFactor`) ?? WHITE).map((c) => c * factor);
}

/** A number clamped to 0–1; 1 by default. */
const share = (value: unknown, what: string) => clamp(numberAt(value, what, 1), 0, 1);

interface TextureUse extends JsonObject {
  /** The set of texture coordinates. */
  texCoord: number;
}

function readTextureUse(
  value: unknown,
  textures: readonly GltfTexture[],
  what: string,
): TextureUse {
  const use = optionalObject(value, what);
  const extensions = optionalObject(use['extensions'], what);
  const transform = extensions['KHR_texture_transform'];
  const moved = optionalObject(transform, what);
  return {
    index: indexAt(use['index'], textures.length, `${what}'s texture`),
    texCoord: countAt(moved['texCoord'] ?? use['texCoord'], `${what}'s texCoord`, 0),
    extensions:
      transform === undefined ? undefined : { KHR_texture_transform: readTransform(moved, what) },
  };
}

/** Number of texture coordinate sets that three.js supports. */
const UV_SETS = 4;

function readTransform(transform: JsonObject, what: string): JsonObject {
  return {
    offset: numbersAt(transform['offset'], 2, what),
    scale: numbersAt(transform['scale'], 2, what),
    rotation:
      transform['rotation'] === undefined ? undefined : numberAt(transform['rotation'], what, 0),
  };
}

/**
 * The maps of a material that are drawn, with those that the geometry has no coordinates for left
 * out.
 */
export function mapsOf(material: MeshStandardMaterial, geometry: BufferGeometry) {
  const usable = (map: Texture | null) =>
    map !== null && geometry.hasAttribute(uvNameOf(map)) ? map : null;
  const { unlit, emissive } = valuesOf(material);
  return {
    map: usable(material.map),
    emissiveMap: emissive.some((c) => c > 0) && !unlit ? usable(material.emissiveMap) : null,
    metalRoughMap: unlit ? null : usable(material.metalnessMap),
    normalMap: unlit ? null : usable(material.normalMap),
  };
}

/** The attribute of a map's texture coordinates. */
export const uvNameOf = ({ channel }: Texture) => (channel === 0 ? 'uv' : `uv${String(channel)}`);

/** @param color of the instance: linear, with opacity; multiplies base colour and opacity. */
export function lookOf(
  material: MeshStandardMaterial,
  geometry: BufferGeometry,
  [red = 1, green = 1, blue = 1, alpha = 1]: readonly number[],
): Pick<ContentPart, 'look' | 'surface' | 'sides'> {
  const { color, transparent, alphaTest } = material;
  const { unlit, emissive, metalRough, specular, normalScale, mapped } = valuesOf(material);
  const maps = mapsOf(material, geometry);
  const vertexColors = geometry.hasAttribute('color');
  const vertexAlpha = vertexColors && geometry.getAttribute('color').itemSize === 4;
  const opacity = material.opacity * alpha;
  // Exporters often mark opaque materials as blended. Blending those, unsorted and without depth,
  // would show their backs.
  const blends = transparent && (opacity < 1 || maps.map !== null || vertexAlpha);
  const alphaMode = blends ? 'blend' : alphaTest > 0 ? 'mask' : 'opaque';
  // The usual factors are 1: without the images, all of it would glow, or be metal.
  const glows = !mapped.emissive || material.emissiveMap !== null;
  const isRough = !mapped.metalRough || material.metalnessMap !== null;
  const { metalness = 0, roughness = null } = (isRough ? metalRough : null) ?? {};
  const base = [color.r * red, color.g * green, color.b * blue] as const;
  return {
    sides: material.side === DoubleSide ? 'double' : 'single',
    surface: {
      ...(specular !== null && { ks: multiply(encoded(specular), SURFACE_FIELDS.ks.fallback) }),
      ...(roughness !== null && { shininess: exponentOfRoughness(roughness) }),
    },
    look: {
      baseColor: map(base, (c) => srgbEncode(clamp(c, 0, 1))),
      opacity: alphaMode === 'opaque' ? 1 : clamp(opacity, 0, 1),
      alphaMode,
      alphaCutoff: alphaTest,
      vertexColors: vertexColors && 'linear',
      ...maps,
      unlit,
      emissive: encoded(glows ? emissive : BLACK),
      metalness,
      roughness,
      normalScale: clamp(normalScale, -LIMITS.color, LIMITS.color),
    },
  };
}

const valuesOf = ({ userData }: MeshStandardMaterial) =>
  (userData as { surface?: MaterialValues }).surface ?? UNNAMED;

/** The parser's own material of meshes that name none. */
const UNNAMED: MaterialValues = {
  unlit: false,
  emissive: BLACK,
  metalRough: null,
  specular: null,
  normalScale: 1,
  mapped: { emissive: false, metalRough: false },
};

/** Within a colour's domain: products with texels stay finite. */
const encoded = ([r = 0, g = 0, b = 0]: readonly number[]) =>
  map([r, g, b], (c) => Math.min(srgbEncode(c), LIMITS.color / 255));
