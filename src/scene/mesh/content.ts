// What a mesh shows: a built-in shape or a loaded model, fetched and brought into one form.
import { type BufferGeometry, Matrix4 } from 'three';
import { PLAIN_LOOK } from '../../material/base-look.js';
import type { Content } from '../../model/content.js';
import { acquireGeometry, releaseGeometry, type ShapeKey, shapeNeeds } from './shapes/shared-shapes.js';
import { CLOSED } from './shapes/shapes.js';
import { flatTriangles, type Need } from './triangle-budget.js';
import { lazyCode } from '../../model/lazy-code.js';
import { gltfCode, isNamedGltf } from '../../model/gltf-code.js';
import type { LoadOptions } from '../../model/load-model.js';
import { isDataUri, requestFile } from '../../model/request-file.js';

/** A built-in shape: at once if its code is loaded, else a promise. */
export function shapeContent(key: ShapeKey): Content | Promise<Content> {
  const geometry = acquireGeometry(key);
  const content = (ready: BufferGeometry): Content => {
    let known = shapeContents.get(ready);
    if (known === undefined) {
      const { name } = key;
      const sides = CLOSED.has(name) ? 'closed' : 'double';
      known = {
        parts: [{ name, geometry: ready, matrix: IDENTITY, look: PLAIN_LOOK, sides, surface: {} }],
        motion: null,
        dispose: () => {
          releaseGeometry(key);
        },
      };
      shapeContents.set(ready, known);
      flatNeeds.set(known, shapeNeeds(key, true));
    }
    return known;
  };
  return geometry instanceof Promise ? geometry.then(content) : content(geometry);
}

/** Equal shapes are one content. */
const shapeContents = new WeakMap<BufferGeometry, Content>();

/** What flat copies of a content's geometries hold. */
export const flatNeedsOf = (content: Content): readonly Need[] =>
  flatNeeds.get(content) ??
  [...new Set(content.parts.map(({ geometry }) => geometry))].map((geometry) => ({
    key: geometry,
    triangles: flatTriangles(geometry),
    flat: true,
  }));

/** Those of shapes, which are claimed before there is a geometry. */
const flatNeeds = new WeakMap<Content, readonly Need[]>();

const IDENTITY: Matrix4 = /* @__PURE__ */ new Matrix4();

/** The code that reads models. */
export const modelCode = /* @__PURE__ */ lazyCode(() => import('../../model/model-content.js'), 'models');

/**
 * A model from its address or a file. A file is requested at once; the code that reads models comes with the first one.
 */
export async function requestModel(url: URL, options: LoadOptions, file: Blob | null): Promise<Content> {
  const request = file !== null || isDataUri(url.href) ? null : requestFile(url, 'follow', options);
  // Its failure is reported when the file is read.
  if (request !== null && isNamedGltf(url.pathname)) gltfCode().catch(() => undefined);
  return (await modelCode()).modelContent(url, options, file ?? request);
}
