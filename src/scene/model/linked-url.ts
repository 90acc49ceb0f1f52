// Which other files may a model's file refer to? Those on its own origin, in its own folder or below, unless `crossorigin` allows
// more. A model can come from anyone, so it must not make a page fetch arbitrary addresses.
import { ModelError } from './model.js';

// Some servers treat an escaped slash as a slash, after the URL parser has resolved `..`.
const ESCAPED_SLASH = /%(2f|5c)/i;

/**
 * The address of the file that the model at `model` refers to as `uri`.
 * @param anywhere whether any http(s) origin and folder is allowed (`crossorigin` is set).
 * @throws ModelError `load-failed` if it is not allowed, `bad-model` if it is not an address.
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
