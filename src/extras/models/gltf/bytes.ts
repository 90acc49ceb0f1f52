// The bytes of a glTF document's buffers, buffer views and images. Each is fetched or decoded once,
// on first use.
import { lazyCode } from '../../../phong/lazy-code.js';
import { requireAtMost } from '../../../phong/model/budget.js';
import { LIMITS } from '../../../phong/model/limits.js';
import { type FileBytes, type ModelSource, neededCode, requireDecoders } from '../model-reader.js';
import type { Container } from './container.js';
import type { GltfDocument } from './document.js';
import { indexAt, textAt } from './json.js';
import type { MeshoptView } from './accessors.js';
import { Slices } from '../slices.js';
import { isDataUri } from '../../../phong/fields/file-names.js';

export type GltfBytes = ReturnType<typeof gltfBytes>;

export function gltfBytes(document: GltfDocument, { body, data }: Container, source: ModelSource) {
  const buffers = new Map<number, Promise<Uint8Array<ArrayBuffer>>>();
  let copied = 0;

  const bytesOf = async (uri: string) =>
    isDataUri(uri) ? (await data(uri)).bytes : source.linked(uri);

  const load = async (index: number): Promise<Uint8Array<ArrayBuffer>> => {
    const uri = document.buffers[index];
    const bytes = uri === undefined ? body : await bytesOf(uri);
    if (!bytes || (uri === undefined && index > 0)) {
      throw new Error(`buffers[${String(index)}] has no bytes`);
    }
    return bytes;
  };

  const buffer = (index: number): Promise<Uint8Array<ArrayBuffer>> => {
    const pending = buffers.get(index) ?? load(index);
    buffers.set(index, pending);
    return pending;
  };

  const slice = async (index: number): Promise<Uint8Array<ArrayBuffer>> => {
    const definition = document.bufferViews[index];
    if (!definition) throw new Error(`bufferViews[${String(index)}] is missing`);
    const view = definition.meshopt ?? definition;
    const bytes = await buffer(view.buffer);
    const end = view.byteOffset + view.byteLength;
    if (end > bytes.byteLength) {
      const has = `${String(bytes.byteLength)} of at least ${String(end)} bytes`;
      throw new Error(`buffers[${String(view.buffer)}] is truncated: ${has}`);
    }
    return bytes.subarray(view.byteOffset, end);
  };

  return {
    /** A copy of the view's bytes, padded by the view's stride after the last element. */
    view: async (index: number): Promise<ArrayBuffer> => {
      const view = document.bufferViews[index];
      const meshopt = view?.meshopt;
      if (meshopt) {
        requireDecoders(source, 'meshopt');
      }
      const bytes = await slice(index);
      const whole = meshopt ? meshopt.count * meshopt.stride : bytes.byteLength;
      const elements = view?.elements;
      const length = elements ? elements.count * elements.item : whole;
      const size = length + (view?.byteStride ?? 0);
      copied += size;
      // Views may overlap or be compressed, so a small file can claim any size.
      requireAtMost(copied, LIMITS.bytes, 'bytes once they are unpacked');
      const copy = new Uint8Array(size);
      const plain = meshopt ? await unpacked(bytes, meshopt) : bytes;
      const { offset, item, stride, count } = elements ?? { ...PIECES, count: whole / PIECES.item };
      await new Slices(source.signal).over(count, (from, to) => {
        for (let i = from; i < to; i += 1) {
          copy.set(plain.subarray(offset + i * stride, offset + i * stride + item), i * item);
        }
      });
      return copy.buffer;
    },
    image: async (index: number): Promise<FileBytes> => {
      const image = document.images[index] ?? {};
      const uri = textAt(image['uri']);
      const type = textAt(image['mimeType']);
      if (isDataUri(uri)) return data(uri);
      if (uri !== '') return { bytes: await bytesOf(uri), type };
      const view = indexAt(
        image['bufferView'],
        document.bufferViews.length,
        `images[${String(index)}].bufferView`,
      );
      return { bytes: await slice(view), type };
    },
  };
}

/** Pieces of a view that is copied as it is: in one piece, 60 MB take 80 ms. The last is shorter. */
const PIECES = { offset: 0, item: 512, stride: 512 };

const meshoptCode = lazyCode(() => import('./meshopt.js'), 'the meshopt decoder');

async function unpacked(bytes: Uint8Array, view: MeshoptView): Promise<Uint8Array> {
  const { decodeMeshopt } = await neededCode(meshoptCode(), 'The meshopt decoder');
  return decodeMeshopt(bytes, view);
}
