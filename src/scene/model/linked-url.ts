// Which files may a model's file name? Those of its own origin, in its own folder or below it, unless the page's
// author has widened that. A model is somebody else's text: it must not make a page fetch what it likes.
import { ModelError } from './model.js';

// A server may read an escaped slash as a slash, after the URL parser has resolved the dots.
const ESCAPED_SLASH = /%(2f|5c)/i;

/**
 * The address of the file called `uri` in the model at `model`.
 * @param anywhere any http(s) origin and folder is allowed (`crossorigin` is set).
 * @throws ModelError `load-failed` where it is not allowed, `bad-model` where it is no address.
 */
export function linkedUrl(uri: string, model: URL, anywhere: boolean): URL {
  const url = parsed(uri, model);
  if (!url)
    throw new ModelError('bad-model', `The model ${model.href} names a file "${uri}", which is no address.`);
  if (anywhere && /^https?:$/.test(url.protocol)) return url;
  const folder = model.pathname.slice(0, model.pathname.lastIndexOf('/') + 1);
  const below =
    url.origin === model.origin &&
    url.protocol === model.protocol &&
    url.username === model.username &&
    url.password === model.password &&
    /^(https?|file):$/.test(url.protocol) &&
    url.pathname.startsWith(folder) &&
    !ESCAPED_SLASH.test(url.pathname.slice(folder.length));
  if (below) return url;
  throw new ModelError(
    'load-failed',
    `The model ${model.href} names the file ${url.href}, which is not in its own folder. ` +
      'Put the file beside the model, or set crossorigin to allow it.',
  );
}

function parsed(uri: string, base: URL): URL | null {
  try {
    return new URL(uri, base);
  } catch {
    return null;
  }
}
