// The other files that a model's file may name: those on its own origin, in its own folder or below, unless
// `crossorigin` allows more. A model can come from anyone, so it must not make a page fetch arbitrary addresses.
import { nameOf } from './file-name.js';
import { ModelError } from './model.js';

// Some servers treat an escaped slash as a slash, after the URL parser has resolved `..`.
const ESCAPED_SLASH = /%(2f|5c)/i;

/**
 * The address of the file that the model at `model` refers to as `uri`.
 * @param anywhere whether any http(s) origin and folder is allowed (`crossorigin` is set).
 * @throws ModelError `load-failed` if it is not allowed, or no address.
 */
export function linkedUrl(uri: string, model: URL, anywhere: boolean): URL {
  const url = parsed(uri, model);
  if (!url)
    throw new ModelError(
      'load-failed',
      `The file "${uri}", which ${nameOf(model)} names, has no valid address.`,
    );
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
    `The file "${uri}" is not in the folder of ${nameOf(model)}, which names it. ` +
      'Put it beside the model, or set crossorigin to allow it.',
  );
}

function parsed(uri: string, base: URL): URL | null {
  try {
    return new URL(uri, base);
  } catch {
    return null;
  }
}
