// Decodes Draco data by Google's decoder. Must not import three.js: a worker would load all of it.
import type { Draco } from 'three/examples/jsm/libs/draco/gltf/draco_decoder.js';
import type { Decoded } from '../decoders/decoder.js';

export interface DracoJob {
  readonly bytes: ArrayBuffer;
  /** Draco's id of each attribute that is wanted. */
  readonly idByName: Readonly<Record<string, number>>;
  /** The typed array that each is wanted as. */
  readonly arrayTypeByName: Readonly<Record<string, string>>;
}

export interface DracoMesh {
  readonly index: Uint32Array<ArrayBuffer>;
  readonly attributes: Readonly<Record<string, { readonly array: DracoArray; readonly itemSize: number }>>;
}

type DracoArray = InstanceType<ArrayType>;

/** The copy's heap is freed with the function. */
export const meshDecoder =
  (draco: Draco) =>
  (job: DracoJob): Decoded<DracoMesh> => {
    const result = decodeMesh(draco, job);
    const arrays = [result.index, ...Object.values(result.attributes).map(({ array }) => array)];
    return { result, transfer: arrays.map(({ buffer }) => buffer) };
  };

/** @throws Error if the bytes are not a Draco mesh or an attribute is missing. */
function decodeMesh(draco: Draco, { bytes: data, idByName, arrayTypeByName }: DracoJob): DracoMesh {
  const bytes = new Int8Array(data);
  const decoder = new draco.Decoder();
  const mesh = new draco.Mesh();
  try {
    if (decoder.GetEncodedGeometryType(bytes) !== draco.TRIANGULAR_MESH) throw new Error('it contains no Draco mesh');
    const status = decoder.DecodeArrayToMesh(bytes, bytes.byteLength, mesh);
    if (!status.ok() || mesh.ptr === 0) throw new Error(`its Draco data is broken (${status.error_msg()})`);
    const corners = mesh.num_faces() * 3;
    const index = copyOut(draco, Uint32Array, corners, (size, pointer) =>
      decoder.GetTrianglesUInt32Array(mesh, size, pointer),
    );
    const attributes: Record<string, { array: DracoArray; itemSize: number }> = {};
    for (const [name, id] of Object.entries(idByName)) {
      const attribute = decoder.GetAttributeByUniqueId(mesh, id);
      const type = arrayTypes(draco)[arrayTypeByName[name] ?? ''];
      if (attribute.ptr === 0 || !type) throw new Error(`its Draco data lacks the attribute ${name}`);
      const itemSize = attribute.num_components();
      const array = copyOut(draco, type.array, mesh.num_points() * itemSize, (size, pointer) =>
        decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, type.id, size, pointer),
      );
      attributes[name] = { array, itemSize };
    }
    return { index, attributes };
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

const arrayTypes = (draco: Draco): Readonly<Record<string, { readonly array: ArrayType; readonly id: number }>> => ({
  Int8Array: { array: Int8Array, id: draco.DT_INT8 },
  Uint8Array: { array: Uint8Array, id: draco.DT_UINT8 },
  Int16Array: { array: Int16Array, id: draco.DT_INT16 },
  Uint16Array: { array: Uint16Array, id: draco.DT_UINT16 },
  Int32Array: { array: Int32Array, id: draco.DT_INT32 },
  Uint32Array: { array: Uint32Array, id: draco.DT_UINT32 },
  Float32Array: { array: Float32Array, id: draco.DT_FLOAT32 },
});

/** Lets the decoder write `count` numbers to its heap, and copies them. */
function copyOut<Type extends ArrayType>(
  draco: Draco,
  type: Type,
  count: number,
  write: (bytes: number, pointer: number) => boolean,
): InstanceType<Type> {
  const bytes = count * type.BYTES_PER_ELEMENT;
  const pointer = draco._malloc(bytes);
  try {
    if (!write(bytes, pointer)) throw new Error('its Draco data cannot be read');
    return new type(draco.HEAPF32.buffer, pointer, count).slice() as InstanceType<Type>;
  } finally {
    draco._free(pointer);
  }
}
