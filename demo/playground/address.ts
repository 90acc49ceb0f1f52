// Writes a scene into the address and reads it: `#example=name`, or `#scene=` and the text,
// compressed, in the letters of base64url. Reading never throws and never yields more than the
// longest text: a few letters can claim gigabytes.

/**
 * Characters of a scene. One of 1,000 elements has about 100,000; more would freeze the editor and
 * the address.
 */
export const LONGEST_TEXT = 100_000;

/** Bytes of a text of the longest length, at UTF-8's four per character. */
const MOST_BYTES = 4 * LONGEST_TEXT;

export type Addressed =
  | { readonly example: string }
  | { readonly text: string }
  | { readonly fault: string }
  | null;

/** The scene's part of an address, with `#`. */
export async function fragmentOf(text: string): Promise<string> {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return `#scene=${btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')}`;
}

export async function readFragment(fragment: string): Promise<Addressed> {
  const [, name, value] = /^#(scene|example)=([\w-]*)$/.exec(fragment) ?? [];
  if (name === undefined || value === undefined) return fragment.length > 1 ? BROKEN : null;
  if (name === 'example') return { example: value };
  try {
    const letters = atob(value.replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
    const text = await inflated(bytes);
    return text === null ? { fault: 'The scene in this link is too long to show.' } : { text };
  } catch {
    return BROKEN;
  }
}

const BROKEN: Addressed = { fault: 'This link is broken: it holds no scene.' };

/**
 * The text; null if it is longer than {@link MOST_BYTES}. Throws if the bytes are no compressed
 * text.
 */
async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<string | null> {
  const reader = new Blob([bytes])
    .stream()
    .pipeThrough(new DecompressionStream('deflate-raw'))
    .getReader();
  const decoder = new TextDecoder('utf-8', { fatal: true });
  let text = '';
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return text + decoder.decode();
    size += value.byteLength;
    if (size > MOST_BYTES) {
      await reader.cancel();
      return null;
    }
    text += decoder.decode(value, { stream: true });
  }
}
