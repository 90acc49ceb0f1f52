// How are Draco-compressed triangles decoded? On the main thread in plain JavaScript: a strict CSP allows neither blob: workers nor
// WebAssembly. A separate chunk with half a megabyte of decoder. Must not know what uses it.
import { BufferAttribute, BufferGeometry } from 'three';
import createDraco, { type Draco } from 'three/examples/jsm/libs/draco/gltf/draco_decoder.js';

type IdByName = Readonly<Record<string, number>>;

/** The methods of a Draco loader that three's glTF loader calls. */
export interface DracoAdapter {
  preload(): void;
  decodeDracoFile(
    buffer: ArrayBuffer,
    onLoad: (geometry: BufferGeometry) => void,
    idByName: IdByName,
    arrayTypeByName: Readonly<Record<string, string>>,
    colorSpace: string,
    onError: (error: unknown) => void,
  ): void;
}

/**
 * A decoder with its own heap, freed with the object. Its console output is suppressed.
 * @param pause awaited before each mesh, so that every mesh is a task of its own.
 */
export async function createDracoAdapter(pause: () => Promise<void>): Promise<DracoAdapter> {
  const silent = (): void => undefined;
  let last = Promise.resolve();
  const draco = await createDraco({ print: silent, printErr: silent });
  return {
    preload: silent,
    decodeDracoFile(buffer, onLoad, idByName, arrayTypeByName, _colorSpace, onError) {
      last = last
        .then(pause)
        .then(() => {
          onLoad(decodeMesh(draco, new Int8Array(buffer), idByName, arrayTypeByName));
        })
        .catch(onError);
    },
  };
}

/**
 * Decodes a mesh. Attributes are looked up by their Draco id and returned by name, as arrays of the given type.
 * @throws Error if the bytes are not a Draco mesh or an attribute is missing.
 */
export function decodeMesh(
  draco: Draco,
  bytes: Int8Array,
  idByName: IdByName,
  arrayTypeByName: Readonly<Record<string, string>>,
): BufferGeometry {
  const decoder = new draco.Decoder();
  const mesh = new draco.Mesh();
  try {
    if (decoder.GetEncodedGeometryType(bytes) !== draco.TRIANGULAR_MESH)
      throw new Error('it contains no Draco mesh');
    const status = decoder.DecodeArrayToMesh(bytes, bytes.byteLength, mesh);
    if (!status.ok() || mesh.ptr === 0) throw new Error(`its Draco data is broken (${status.error_msg()})`);
    const geometry = new BufferGeometry();
    const corners = mesh.num_faces() * 3;
    geometry.setIndex(
      copyOut(draco, Uint32Array, corners, (size, pointer) =>
        decoder.GetTrianglesUInt32Array(mesh, size, pointer),
      ),
    );
    for (const [name, id] of Object.entries(idByName)) {
      const attribute = decoder.GetAttributeByUniqueId(mesh, id);
      const type = arrayTypes(draco)[arrayTypeByName[name] ?? ''];
      if (attribute.ptr === 0 || !type) throw new Error(`its Draco data lacks the attribute ${name}`);
      const items = attribute.num_components();
      const values = copyOut(draco, type.array, mesh.num_points() * items, (size, pointer) =>
        decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, type.id, size, pointer),
      );
      geometry.setAttribute(name, new BufferAttribute(values.array, items));
    }
    return geometry;
  } finally {
    draco.destroy(mesh);
    draco.destroy(decoder);
  }
}

type ArrayType =
  | Int8ArrayConstructor
  | Uint8ArrayConstructor
  | Int16ArrayConstructor
  | Uint16ArrayConstructor
  | Int32ArrayConstructor
  | Uint32ArrayConstructor
  | Float32ArrayConstructor;

const arrayTypes = (
  draco: Draco,
): Readonly<Record<string, { readonly array: ArrayType; readonly id: number }>> => ({
  Int8Array: { array: Int8Array, id: draco.DT_INT8 },
  Uint8Array: { array: Uint8Array, id: draco.DT_UINT8 },
  Int16Array: { array: Int16Array, id: draco.DT_INT16 },
  Uint16Array: { array: Uint16Array, id: draco.DT_UINT16 },
  Int32Array: { array: Int32Array, id: draco.DT_INT32 },
  Uint32Array: { array: Uint32Array, id: draco.DT_UINT32 },
  Float32Array: { array: Float32Array, id: draco.DT_FLOAT32 },
});

/** Lets the decoder write `count` numbers to its heap, and copies them. */
function copyOut(
  draco: Draco,
  type: ArrayType,
  count: number,
  write: (bytes: number, pointer: number) => boolean,
): BufferAttribute {
  const bytes = count * type.BYTES_PER_ELEMENT;
  const pointer = draco._malloc(bytes);
  try {
    if (!write(bytes, pointer)) throw new Error('its Draco data cannot be read');
    return new BufferAttribute(new type(draco.HEAPF32.buffer, pointer, count).slice(), 1);
  } finally {
    draco._free(pointer);
  }
}
