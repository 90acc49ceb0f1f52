// Decodes Draco data by Google's decoder. Must not import three.js: a worker would load all of it.
import type { Draco } from 'three/examples/jsm/libs/draco/gltf/draco_decoder.js';
import type { Decoded } from '../decoders/decoder.js';

export interface DracoJob {
  readonly bytes: ArrayBuffer;
  /** Draco's id of each attribute that is wanted. */
  readonly idByName: Readonly<Record<string, number>>;
  /** The typed array that each is wanted as. */
  readonly arrayTypeByName: Readonly<Record<string, keyof typeof TYPES>>;
}

export interface DracoMesh {
  readonly index: Uint32Array<ArrayBuffer>;
  readonly attributes: Readonly<
    Record<string, { readonly array: DracoArray; readonly itemSize: number }>
  >;
}

type DracoArray = InstanceType<ArrayType>;

/** The decoder's heap is freed when nothing holds the function. */
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
    if (decoder.GetEncodedGeometryType(bytes) !== draco.TRIANGULAR_MESH) {
      throw new Error('it contains no Draco mesh');
    }
    const status = decoder.DecodeArrayToMesh(bytes, bytes.byteLength, mesh);
    if (!status.ok() || mesh.ptr === 0) {
      throw new Error(`its Draco data is broken (${status.error_msg()})`);
    }
    const corners = mesh.num_faces() * 3;
    const index = copyOut(draco, Uint32Array, corners, (size, pointer) =>
      decoder.GetTrianglesUInt32Array(mesh, size, pointer),
    );
    const attributes: Record<string, { array: DracoArray; itemSize: number }> = {};
    for (const [name, id] of Object.entries(idByName)) {
      const attribute = decoder.GetAttributeByUniqueId(mesh, id);
      const wanted = arrayTypeByName[name];
      if (attribute.ptr === 0 || !wanted) {
        throw new Error(`its Draco data lacks the attribute ${name}`);
      }
      const [type, number] = TYPES[wanted];
      const itemSize = attribute.num_components();
      const array = copyOut(draco, type, mesh.num_points() * itemSize, (size, pointer) =>
        decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, draco[number], size, pointer),
      );
      attributes[name] = { array, itemSize };
    }
    return { index, attributes };
  } finally {
    draco.destroy(mesh);
    draco.destroy(decoder);
  }
}

/** The typed arrays by name, each with the decoder's name of its number for that type. */
const TYPES = {
  Int8Array: [Int8Array, 'DT_INT8'],
  Uint8Array: [Uint8Array, 'DT_UINT8'],
  Int16Array: [Int16Array, 'DT_INT16'],
  Uint16Array: [Uint16Array, 'DT_UINT16'],
  Int32Array: [Int32Array, 'DT_INT32'],
  Uint32Array: [Uint32Array, 'DT_UINT32'],
  Float32Array: [Float32Array, 'DT_FLOAT32'],
} as const;

type ArrayType = (typeof TYPES)[keyof typeof TYPES][0];

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
