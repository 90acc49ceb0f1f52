// Fetches what a mesh shows: a built-in shape or a loaded model, in one form. Knows neither materials nor elements.
import { type BufferGeometry, Matrix4 } from 'three';
import { type BaseLook, PLAIN_LOOK } from '../../material/phong-material.js';
import type { SurfaceValues } from '../../material/material-values.js';
import { acquireGeometry, type GeometryName, releaseGeometry } from './shapes/shapes.js';
import { requestModel } from '../model/fetch-bytes.js';
import type { LoadOptions } from '../model/load-model.js';

/** Geometry with everything a file, or a built-in shape, says of how it looks. */
export interface ContentPart {
  readonly name: string;
  readonly geometry: BufferGeometry;
  /** Part to mesh. */
  readonly matrix: Matrix4;
  readonly look: BaseLook;
  /** What the file says of the surface; HTML's units. */
  readonly surface: Partial<SurfaceValues>;
}

export interface Content {
  readonly parts: readonly ContentPart[];
  /** Called once, by whoever shows it or has no use for it any more. */
  dispose(): void;
}

export const NOTHING: Content = { parts: [], dispose: () => undefined };

/** A built-in shape; at once where its code is here, else a promise. */
export function shapeContent(name: GeometryName, segments: number | null): Content | Promise<Content> {
  const wanted = segments ?? undefined;
  const geometry = acquireGeometry(name, wanted);
  const content = (ready: BufferGeometry): Content => ({
    parts: [{ name, geometry: ready, matrix: new Matrix4(), look: PLAIN_LOOK, surface: {} }],
    dispose: () => {
      releaseGeometry(name, wanted);
    },
  });
  return geometry instanceof Promise ? geometry.then(content) : content(geometry);
}

/** A model from its address. Its file is requested at once; the code that reads models comes with the first one. */
export async function modelContent(url: URL, options: LoadOptions): Promise<Content> {
  const request = requestModel(url, options);
  return (await import('../model/model-content.js')).modelContent(url, options, request);
}
