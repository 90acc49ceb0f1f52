// Which parts of a glTF material does the equation use? Base colour, its texture, alpha, sides. Indices are checked. Knows the JSON only.
import { indexAt, numberAt, numbersAt, objectsAt, optionalObject, textAt, type JsonObject } from './json.js';

export interface GltfTexture {
  /** Undefined if there is no image in a supported format. */
  readonly image: number | undefined;
  /** The unsupported extension that holds the image, if any. */
  readonly needs: string | undefined;
  readonly sampler: JsonObject;
}

/** Image formats that browsers decode, best first; the plain `source` is the fallback. */
const IMAGE_EXTENSIONS = ['EXT_texture_avif', 'EXT_texture_webp'];

export function readTextures(json: JsonObject, images: number): readonly GltfTexture[] {
  const samplers = objectsAt(json['samplers'], 'samplers');
  return objectsAt(json['textures'], 'textures').map((texture, i) => {
    const what = `textures[${String(i)}]`;
    const extensions = optionalObject(texture['extensions'], `${what}.extensions`);
    const known = IMAGE_EXTENSIONS.find((name) => name in extensions);
    const source =
      known === undefined ? texture['source'] : optionalObject(extensions[known], what)['source'];
    const sampler = texture['sampler'];
    return {
      image: source === undefined ? undefined : indexAt(source, images, `${what}.source`),
      needs: Object.keys(extensions)[0],
      sampler: sampler === undefined ? {} : (samplers[indexAt(sampler, samplers.length, what)] ?? {}),
    };
  });
}

export function readMaterials(json: JsonObject, textures: readonly GltfTexture[]): readonly JsonObject[] {
  return objectsAt(json['materials'], 'materials').map((material, i) => {
    const what = `materials[${String(i)}]`;
    const metallic = optionalObject(material['pbrMetallicRoughness'], what);
    const specular = optionalObject(material['extensions'], what)['KHR_materials_pbrSpecularGlossiness'];
    const glossy = optionalObject(specular, what);
    const map = metallic['baseColorTexture'] ?? glossy['diffuseTexture'];
    return {
      name: textAt(material['name']),
      alphaMode: textAt(material['alphaMode']) || 'OPAQUE',
      doubleSided: material['doubleSided'] === true,
      alphaCutoff: numberAt(material['alphaCutoff'], `${what}.alphaCutoff`, 0.5),
      pbrMetallicRoughness: {
        baseColorFactor: numbersAt(metallic['baseColorFactor'] ?? glossy['diffuseFactor'], 4, what),
        baseColorTexture: map === undefined ? undefined : readTextureUse(map, textures, what),
      },
    };
  });
}

function readTextureUse(value: unknown, textures: readonly GltfTexture[], what: string): JsonObject {
  const use = optionalObject(value, what);
  const extensions = optionalObject(use['extensions'], what);
  const transform = extensions['KHR_texture_transform'];
  const moved = optionalObject(transform, what);
  return {
    index: indexAt(use['index'], textures.length, `${what}'s texture`),
    texCoord: indexAt(use['texCoord'] ?? 0, UV_SETS, `${what}'s texCoord`),
    extensions: transform === undefined ? undefined : { KHR_texture_transform: readTransform(moved, what) },
  };
}

/** Number of texture coordinate sets that three.js supports. */
const UV_SETS = 4;

function readTransform(transform: JsonObject, what: string): JsonObject {
  const { texCoord } = transform;
  return {
    offset: numbersAt(transform['offset'], 2, what),
    scale: numbersAt(transform['scale'], 2, what),
    rotation: transform['rotation'] === undefined ? undefined : numberAt(transform['rotation'], what, 0),
    texCoord: texCoord === undefined ? undefined : indexAt(texCoord, UV_SETS, `${what}'s texCoord`),
  };
}
