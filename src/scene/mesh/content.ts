// What does a mesh show? A built-in shape or a loaded model, fetched and brought into one form. Knows neither materials nor
// elements.
import { type BufferGeometry, Matrix4 } from 'three';
import type { Sides } from '../../material/back-faces.js';
import { type BaseLook, PLAIN_LOOK } from '../../material/phong-material.js';
import type { SurfaceValues } from '../../material/material-values.js';
import { acquireGeometry, CLOSED, type GeometryName, releaseGeometry } from './shapes/shapes.js';
import { lazyCode } from '../lazy-code.js';
import { gltfCode, isNamedGltf } from '../model/gltf-code.js';
import type { LoadOptions } from '../model/load-model.js';
import { isDataUri, requestFile } from '../model/request-file.js';

/** A geometry and how it looks, as far as its file or shape says. */
export interface ContentPart {
  readonly name: string;
  readonly geometry: BufferGeometry;
  /** Part to mesh. {@link Motion} changes it. */
  readonly matrix: Matrix4;
  readonly look: BaseLook;
  /** `closed` for opaque closed shapes, `single` or `double` as a file says. */
  readonly sides: Sides;
  /** Surface values from the file; HTML's units. */
  readonly surface: Partial<SurfaceValues>;
}

/** The animations of a content. */
export interface Motion {
  /** As in the file. */
  readonly names: readonly string[];
  /** Length in seconds of the animation with this name; of the first one if the name is empty or unknown. */
  durationOf(name: string): number;
  /** Writes a pose into the parts' matrices and geometries. After its end an animation begins again. Null: the pose without animation. */
  pose(name: string | null, seconds: number): void;
}

export interface Content {
  readonly parts: readonly ContentPart[];
  /** Null if nothing in it moves. */
  readonly motion: Motion | null;
  /** Frees it. Call once for each mesh that shows it. */
  dispose(): void;
}

export const NOTHING: Content = { parts: [], motion: null, dispose: () => undefined };

/** A built-in shape: at once if its code is loaded, else a promise. */
export function shapeContent(name: GeometryName, segments: number | null): Content | Promise<Content> {
  const wanted = segments ?? undefined;
  const geometry = acquireGeometry(name, wanted);
  const content = (ready: BufferGeometry): Content => {
    let known = shapeContents.get(ready);
    if (known === undefined) {
      const sides = CLOSED.has(name) ? 'closed' : 'double';
      known = {
        parts: [{ name, geometry: ready, matrix: IDENTITY, look: PLAIN_LOOK, sides, surface: {} }],
        motion: null,
        dispose: () => {
          releaseGeometry(name, wanted);
        },
      };
      shapeContents.set(ready, known);
    }
    return known;
  };
  return geometry instanceof Promise ? geometry.then(content) : content(geometry);
}

/** Equal shapes are one content. */
const shapeContents = new WeakMap<BufferGeometry, Content>();

const IDENTITY: Matrix4 = /* @__PURE__ */ new Matrix4();

/** The code that reads models. */
export const modelCode = /* @__PURE__ */ lazyCode(() => import('../model/model-content.js'), 'models');

/** A model from its address or a file. A file is requested at once; the code that reads models comes with the first one. */
export async function modelContent(url: URL, options: LoadOptions, file: Blob | null): Promise<Content> {
  const request = file !== null || isDataUri(url.href) ? null : requestFile(url, 'follow', options);
  // Its failure is reported when the file is read.
  if (request !== null && isNamedGltf(url.pathname)) gltfCode().catch(() => undefined);
  return (await modelCode()).modelContent(url, options, file ?? request);
}
