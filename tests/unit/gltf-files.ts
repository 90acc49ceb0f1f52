// glTF documents written by tests and loaded as data: addresses.
import { modelContent } from '../../src/model/model-content.js';
import type { Content } from '../../src/model/model.js';
import { OPTIONS } from './model-files.js';

export type Json = Record<string, unknown>;

export const FLOAT = 5126;
export const SHORT = 5122;
export const UBYTE = 5121;
export const TRIANGLE = [0, 0, 0, 1, 0, 0, 0, 1, 0];

/** A document whose buffer views are the given arrays, one each, end to end. */
export function gltf(
  blobs: readonly ArrayBufferView[],
  accessors: readonly Json[],
  more: Json,
): Promise<Content> {
  const buffers = blobs.map(({ buffer, byteOffset, byteLength }) =>
    Buffer.from(buffer, byteOffset, byteLength),
  );
  let byteOffset = 0;
  const bufferViews = buffers.map(({ length: byteLength }) => {
    const view = { buffer: 0, byteOffset, byteLength };
    byteOffset += byteLength;
    return view;
  });
  const strides = (more['strides'] ?? []) as readonly number[];
  const uri = `data:;base64,${Buffer.concat(buffers).toString('base64')}`;
  const document = {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    bufferViews: bufferViews.map((view, i) => ({ ...view, byteStride: strides[i] })),
    buffers: [{ byteLength: byteOffset, uri }],
    accessors,
    ...more,
  };
  const url = new URL(`data:model/gltf+json,${encodeURIComponent(JSON.stringify(document))}`);
  return modelContent(url, OPTIONS);
}

export const mesh = (attributes: Json, more: Json = {}): Json => ({
  meshes: [{ primitives: [{ attributes, ...more }] }],
});

export function numbers(model: Content, name: string, part = 0): number[] {
  return Array.from(model.parts[part]?.geometry.getAttribute(name).array ?? []);
}
