// Draco decoding for three's glTF loader, and the check before it of the size that the data claim.
import wasm from 'three/examples/jsm/libs/draco/gltf/draco_decoder.wasm?url';
import { BufferAttribute, BufferGeometry } from 'three';
import type { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { lazyCode } from '../../../phong/lazy-code.js';
import { requireAtMost } from '../../../phong/model/budget.js';
import { DecoderThread } from '../decoders/decoder-thread.js';
import { neededCode } from '../model-reader.js';
import type { Slices } from '../slices.js';
import type { DracoJob, DracoMesh } from './draco-mesh.js';
import { DRACO_LIMIT } from '../limits.js';

const decoderCode = lazyCode(() => import('./draco.js'), 'the Draco decoder');

/**
 * For meshes of any size: the bunny blocks the main thread for 42 ms of processor time, a million
 * triangles for 870 ms. More workers are no faster: each warms the decoder up again, and three of
 * them took 180 ms each for 34 meshes that one unpacks in 190 ms.
 */
const thread = /* @__PURE__ */ new DecoderThread<DracoJob, DracoMesh>(
  () => new Worker(new URL('./draco-worker.ts', import.meta.url), { type: 'module' }),
  async () => (await neededCode(decoderCode(), 'The Draco decoder')).createDecoder,
  wasm,
);

type DracoLoader = Parameters<GLTFLoader['setDRACOLoader']>[0];

/** Looks like three's own Draco loader, as far as it is called. */
export function dracoLoader(slices: Slices, signal: AbortSignal): DracoLoader {
  thread.start();
  const decode = async (job: DracoJob): Promise<BufferGeometry> => {
    // On the main thread every mesh is a task of its own.
    await slices.pause();
    const { index, attributes } = await thread.decode(job, signal);
    const geometry = new BufferGeometry();
    Object.setPrototypeOf(geometry.attributes, null); // as in primitives.ts
    geometry.setIndex(new BufferAttribute(index, 1));
    for (const [name, { array, itemSize }] of Object.entries(attributes)) {
      geometry.setAttribute(name, new BufferAttribute(array, itemSize));
    }
    return geometry;
  };
  return {
    preload: (): void => undefined,
    decodeDracoFile(
      bytes: ArrayBuffer,
      onLoad: (geometry: BufferGeometry) => void,
      idByName: DracoJob['idByName'],
      arrayTypeByName: DracoJob['arrayTypeByName'],
      _colorSpace: string,
      onError: (error: unknown) => void,
    ): void {
      decode({ bytes, idByName, arrayTypeByName }).then(onLoad).catch(onError);
    },
  } as unknown as DracoLoader;
}

/** What the document says of the mesh in a buffer view. */
export interface DracoClaims {
  readonly corners: number;
  readonly vertices: number;
}

/**
 * Encoders merge or split vertices, and some do not update the accessors. None that we have seen
 * comes near twice their count.
 */
const TOLERANCE = 2;

/**
 * Throws if the header says more than the document, or is no header of a mesh. Follows the Draco
 * bitstream specification 2.2, sections 3.2 to 5, and its differences in older versions.
 */
export function checkDracoHeader(bytes: Uint8Array, { corners, vertices }: DracoClaims): void {
  const { faces, points } = meshSize(bytes);
  requireAtMost(Math.max(faces * 3, points), DRACO_LIMIT, 'corners in one Draco mesh');
  if (faces * 3 <= corners * TOLERANCE && points <= vertices * TOLERANCE) return;
  throw new Error(
    `its Draco data claims ${String(faces)} triangles and ${String(points)} vertices, ` +
      `its accessors ${String(corners / 3)} and ${String(vertices)}`,
  );
}

const MESH = 1;
const HAS_METADATA = 0x8000;

function meshSize(bytes: Uint8Array) {
  const reader = new Reader(bytes);
  if (String.fromCharCode(...bytes.subarray(0, 5)) !== 'DRACO') {
    throw new Error('its Draco data is broken');
  }
  reader.skip(5);
  const version = reader.uint(1) * 256 + reader.uint(1);
  if (reader.uint(1) !== MESH) throw new Error('it contains no Draco mesh');
  const edgebreaker = reader.uint(1) === 1;
  if (reader.uint(2) & HAS_METADATA) {
    skipMetadata(reader);
  }
  const fixed = version < (edgebreaker ? 0x200 : 0x202);
  const number = () => (fixed ? reader.uint(4) : reader.varint());
  if (!edgebreaker) return { faces: number(), points: number() };
  reader.skip(1); // traversal
  if (version < 0x202) {
    number(); // new vertices
  }
  const vertices = number();
  const faces = number();
  reader.skip(1); // attributes
  number(); // symbols
  const splits = number(); // each makes a vertex
  return { faces, points: vertices + splits };
}

function skipMetadata(reader: Reader) {
  for (let attributes = reader.varint(); attributes > 0; attributes -= 1) {
    reader.varint(); // the attribute's id
    skipElement(reader);
  }
  skipElement(reader);
}

/** Entries of a name and a value, then elements inside it, each after its name. */
function skipElement(reader: Reader) {
  for (let pending = 1; ;) {
    for (let entries = reader.varint(); entries > 0; entries -= 1) {
      reader.skip(reader.uint(1));
      reader.skip(reader.varint());
    }
    pending += reader.varint() - 1;
    if (pending === 0) return;
    reader.skip(reader.uint(1));
  }
}

class Reader {
  readonly #view: DataView;
  #at = 0;

  constructor(bytes: Uint8Array) {
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  skip(bytes: number): void {
    this.#at += bytes;
  }

  /** Little-endian. */
  uint(bytes: 1 | 2 | 4): number {
    const at = this.#at;
    if (at + bytes > this.#view.byteLength) throw new Error('its Draco data is truncated');
    this.#at += bytes;
    if (bytes === 1) return this.#view.getUint8(at);
    return bytes === 2 ? this.#view.getUint16(at, true) : this.#view.getUint32(at, true);
  }

  varint(): number {
    let value = 0;
    for (let scale = 1; scale <= 2 ** 28; scale *= 128) {
      const byte = this.uint(1);
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
    throw new Error('its Draco data is broken');
  }
}
