// What a glTF document says by its extensions, and which are left out.
import { namesIn, objectsAt, optionalObject, shortListAt, type JsonObject } from './json.js';

export const INSTANCING = 'EXT_mesh_gpu_instancing';
export const VISIBILITY = 'KHR_node_visibility';

/** Extensions that a document can require beside {@link SHOWN}: without them it is shown still. */
const READABLE =
  /^((EXT|KHR)_(meshopt_compression|texture_\w+)|KHR_(materials_\w+|lights_punctual|animation_pointer))$/;

/** Extensions that are shown, or that change no picture. */
const SHOWN =
  /^(KHR_draco_mesh_compression|KHR_mesh_quantization|EXT_mesh_gpu_instancing|KHR_node_visibility|KHR_node_(hover|select)ability|KHR_materials_(unlit|emissive_strength|specular|pbrSpecularGlossiness)|KHR_xmp\w*|EXT_(structural_metadata|mesh_features|instance_features)|GODOT_single_root)$/;

/** The first extension that the document requires and that is not supported. */
export const unreadable = (json: JsonObject) =>
  shortListAt(json['extensionsRequired'], 'extensionsRequired')
    .map(String)
    .find((name) => !SHOWN.test(name) && !READABLE.test(name));

/**
 * The names of the extensions in use that are left out. Those of textures are reported with their
 * images.
 */
export function* extensionsLeftOut(json: JsonObject): Iterable<string> {
  yield* leftOutOf(json);
  for (const name of ['scenes', 'nodes', 'meshes', 'materials']) {
    for (const object of objectsAt(json[name], name)) {
      yield* leftOutOf(object);
    }
  }
}

/** As {@link extensionsLeftOut}, of one object. */
export const leftOutOf = ({ extensions }: JsonObject): readonly string[] =>
  extensions === undefined
    ? []
    : namesIn(optionalObject(extensions, 'extensions'), 'extensions').filter(
        (name) => !SHOWN.test(name),
      );
