// What files are called in messages.

/** The name of a `File`; `model` for a `Blob`, which has none. */
export const fileName = (file: Blob): string =>
  ('name' in file ? String(file.name) : '') || 'model';

/**
 * The last part of an address, for messages: addresses can be long. Those that have none give their
 * host.
 */
export function nameOf(url: URL): string {
  if (url.protocol === 'data:') return 'the data: URI';
  const last = url.pathname.slice(url.pathname.lastIndexOf('/') + 1);
  if (last === '') return url.host === '' ? 'the file' : url.host;
  try {
    return decodeURIComponent(last);
  } catch {
    return last; // a percent sign that escapes nothing
  }
}

/** Such a file is not requested: a strict policy forbids it, and what it holds is there already. */
export const isDataUri = (uri: string): boolean => /^data:/i.test(uri);
