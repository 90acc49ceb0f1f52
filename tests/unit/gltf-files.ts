// glTF documents written by tests and loaded as data: addresses.
import { modelContent } from '../../src/model/model-content.js';
import type { Content } from '../../src/model/model.js';
import { type Json, viewsOf } from '../fuzz/glb.js';
import { OPTIONS } from './model-files.js';

export const FLOAT = 5126;
export const SHORT = 5122;
export const UBYTE = 5121;
export const TRIANGLE = [0, 0, 0, 1, 0, 0, 0, 1, 0];

/** A document whose buffer views are the given arrays, one each, end to end. */
export function gltf(blobs: readonly ArrayBufferView[], accessors: readonly Json[], more: Json): Promise<Content> {
  const { bufferViews, buffers, body } = viewsOf(
    blobs.map(({ buffer, byteOffset, byteLength }) => new Uint8Array(buffer, byteOffset, byteLength)),
  );
  const strides = (more['strides'] ?? []) as readonly number[];
  const uri = `data:;base64,${body.toString('base64')}`;
  const document = {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    bufferViews: bufferViews.map((view, i) => ({ ...view, byteStride: strides[i] })),
    buffers: [{ ...buffers[0], uri }],
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
