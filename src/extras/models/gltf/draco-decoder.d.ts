// The part used here of Google's Draco decoder, as three.js ships it (its own IDL names).
declare module 'three/examples/jsm/libs/draco/gltf/draco_decoder.js' {
  interface DracoObject {
    /** 0 where the decoder found nothing. */
    readonly ptr: number;
  }
  interface DracoStatus extends DracoObject {
    ok(): boolean;
    error_msg(): string;
  }
  interface DracoMesh extends DracoObject {
    num_faces(): number;
    num_points(): number;
  }
  interface DracoAttribute extends DracoObject {
    num_components(): number;
  }
  interface DracoDecoder extends DracoObject {
    GetEncodedGeometryType(bytes: Int8Array): number;
    DecodeArrayToMesh(bytes: Int8Array, size: number, mesh: DracoMesh): DracoStatus;
    GetAttributeByUniqueId(mesh: DracoMesh, id: number): DracoAttribute;
    GetTrianglesUInt32Array(mesh: DracoMesh, bytes: number, pointer: number): boolean;
    GetAttributeDataArrayForAllPoints(
      mesh: DracoMesh,
      attribute: DracoAttribute,
      type: number,
      bytes: number,
      pointer: number,
    ): boolean;
  }
  export interface Draco {
    readonly Decoder: new () => DracoDecoder;
    readonly Mesh: new () => DracoMesh;
    readonly TRIANGULAR_MESH: number;
    readonly DT_INT8: number;
    readonly DT_UINT8: number;
    readonly DT_INT16: number;
    readonly DT_UINT16: number;
    readonly DT_INT32: number;
    readonly DT_UINT32: number;
    readonly DT_FLOAT32: number;
    /** Replaced when the heap grows: read it again after every call. */
    readonly HEAPF32: Float32Array<ArrayBuffer>;
    destroy(object: DracoObject): void;
    _malloc(bytes: number): number;
    _free(pointer: number): void;
  }
  const createDraco: (options: {
    readonly print: (text: string) => void;
    readonly printErr: (text: string) => void;
  }) => Promise<Draco>;
  export default createDraco;
}

declare module 'three/examples/jsm/libs/draco/gltf/draco_wasm_wrapper.js' {
  import type { Draco } from 'three/examples/jsm/libs/draco/gltf/draco_decoder.js';
  const createDraco: (options: import('../decoders/decoder.js').WasmOptions) => Promise<Draco>;
  export default createDraco;
}
