// Models by the project's readers: files are read from disk or fetched, images are decoded by plain
// JavaScript.
import { clip } from '../../phong/fields/clip.js';
import type { MeshState } from '../../phong/model/mesh-fields.js';
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

type Named = Pick<MeshState['values'], 'src' | 'type' | 'autoplay' | 'animationName'>;

/** In its first pose. @throws ModelError, and TypeError for an address that is none. */
export async function modelOf(
  { src, type, autoplay, animationName }: Named,
  crossOrigin: ViewerValues['crossOrigin'],
  { base, warn, onFile }: ModelPlace,
): Promise<Content> {
  const address = src as string; // markup has no files
  if (!URL.canParse(address, base)) {
    throw new TypeError(
      `src=${JSON.stringify(clip(address))} is not an address without options.base`,
    );
  }
  const { modelContent } = await import('../models/model-content.js');
  const content = await modelContent(new URL(address, base), {
    signal: new AbortController().signal,
    anywhere: crossOrigin !== null,
    type: type ?? '',
    request: (file, redirect) => ({
      response: fetchOrRead(file, redirect, onFile),
      refusal: new Promise(() => undefined),
      stop: () => undefined,
    }),
    decodeImage: async (file) => {
      const { decodeImage } = await import('./images.js');
      return decodeImage(file);
    },
    warn,
  });
  if (autoplay) {
    content.motion?.pose(animationName, 0);
  }
  return content;
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
