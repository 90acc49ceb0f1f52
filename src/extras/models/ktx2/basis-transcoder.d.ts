// The part used here of the Basis Universal transcoder, as three.js ships it (its own names).
declare module 'three/examples/jsm/libs/basis/basis_transcoder.js' {
  export interface Ktx2File {
    isValid(): boolean;
    isHDR(): boolean;
    getWidth(): number;
    getHeight(): number;
    startTranscoding(): boolean;
    getImageTranscodedSizeInBytes(
      level: number,
      layer: number,
      face: number,
      format: number,
    ): number;
    /** The last three: no flags, and channels by default. */
    transcodeImage(
      pixels: Uint8Array,
      level: number,
      layer: number,
      face: number,
      format: number,
      flags: 0,
      channel0: -1,
      channel1: -1,
    ): boolean;
    close(): void;
    delete(): void;
  }
  export interface Basis {
    initializeBasis(): void;
    readonly KTX2File: new (bytes: Uint8Array) => Ktx2File;
  }
  const createBasis: (options: import('../decoders/decoder.js').WasmOptions) => Promise<Basis>;
  export default createBasis;
}

/** The address of a file that is served beside the code. */
declare module '*.wasm?url' {
  const address: string;
  export default address;
}
