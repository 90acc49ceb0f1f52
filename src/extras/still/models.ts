// Models by the project's readers: files are read from disk or fetched, images are decoded by plain
// JavaScript.
import { clip } from '../../phong/fields/clip.js';
import { NO_CLAIMS, plus, requireWithin } from '../../phong/model/budget.js';
import type { MeshState } from '../../phong/model/mesh-fields.js';
import { createGeometry } from '../../phong/model/shapes/shapes.js';
import { type Content, ModelError } from '../../phong/model/model.js';
import { readerCode } from '../../viewer/extra.js';
import type { ViewerValues, Warn } from './markup.js';
import { nameOf } from '../../phong/fields/file-names.js';

// As the table of extras does for pages.
readerCode.glTF.provide(() => import('../models/gltf/read-gltf.js'));
readerCode.PLY.provide(() => import('../models/ply/read-ply.js'));
readerCode.STL.provide(() => import('../models/stl/read-stl.js'));
readerCode.OBJ.provide(() => import('../models/obj/read-obj.js'));

/** Where a model's address is relative to, and who hears of what is left out and what is read. */
export interface ModelPlace {
  readonly base: URL | string | undefined;
  readonly warn: Warn;
  readonly onFile?: ((url: URL, bytes: Uint8Array) => void) | undefined;
}

/** What the meshes of a scene show: equal contents are made once, and share their memory. */
export class Contents {
  readonly #place: ModelPlace;
  readonly #made = new Map<string, unknown>();
  /** By all models together. */
  #claimed = NO_CLAIMS;

  constructor(place: ModelPlace) {
    this.#place = place;
  }

  async geometry(...shape: Parameters<typeof createGeometry>) {
    return this.#once(shape.join(), () => createGeometry(...shape));
  }

  /** In its first pose. @throws ModelError, and TypeError for an address that is none. */
  async model(
    { src, type, autoplay, animationName }: MeshState['values'],
    crossOrigin: ViewerValues['crossOrigin'],
  ): Promise<Content> {
    const named = [src, type, autoplay, animationName, crossOrigin];
    return this.#once(JSON.stringify(named), async () => {
      const address = src as string; // markup has no files
      const { base } = this.#place;
      if (!URL.canParse(address, base)) {
        throw new TypeError(
          `src=${JSON.stringify(clip(address))} is not an address without options.base`,
        );
      }
      const url = new URL(address, base);
      const content = await this.#read(url, type ?? '', crossOrigin !== null);
      if (autoplay) {
        content.motion?.pose(animationName, 0);
      }
      return content;
    });
  }

  async #read(url: URL, type: string, anywhere: boolean) {
    const { modelContent } = await import('../models/model-content.js');
    const { warn, onFile } = this.#place;
    const before = this.#claimed;
    return modelContent(url, {
      signal: new AbortController().signal,
      anywhere,
      type,
      request: (file, redirect) => ({
        response: fetchOrRead(file, redirect, onFile),
        refusal: new Promise(() => undefined),
        stop: () => undefined,
      }),
      decodeImage: async (file) => {
        const { decodeImage } = await import('./images.js');
        return decodeImage(file);
      },
      onClaim: (claimed) => {
        this.#claimed = plus(before, claimed);
        requireWithin(this.#claimed, 'The still has');
      },
      warn,
    });
  }

  #once<T>(key: string, make: () => T): T {
    const made = (this.#made.get(key) as T | undefined) ?? make();
    this.#made.set(key, made);
    return made;
  }
}

async function fetchOrRead(
  url: URL,
  redirect: RequestRedirect,
  onFile: ModelPlace['onFile'],
): Promise<Response> {
  const response =
    url.protocol === 'file:' ? await readAsResponse(url) : await fetch(url, { redirect });
  onFile?.(url, new Uint8Array(await response.clone().arrayBuffer()));
  return response;
}

async function readAsResponse(url: URL): Promise<Response> {
  const { readFile, stat } = await import('node:fs/promises');
  // A folder's address may end with a slash.
  const name = nameOf(new URL(url.href.replace(/\/+$/, '')));
  let fact = `The file ${name} cannot be read.`;
  try {
    const found = await stat(url);
    if (found.isDirectory()) {
      fact = `"${name}" is a folder, not a model.`;
    }
    // A device may never end.
    if (!found.isFile()) throw new TypeError('no file');
    return new Response(await readFile(url));
  } catch (cause) {
    throw new ModelError('load-failed', fact, { cause });
  }
}
