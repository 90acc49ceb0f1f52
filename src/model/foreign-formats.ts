// Formats that people bring and that cannot be read. For error messages only. Knows beginnings and extensions, no
// content.

export interface ForeignFormat {
  /** Such as `an FBX file`. */
  readonly what: string;
  /** What to do about it, as a sentence; by default it is to be exported in a supported format. */
  readonly cure?: string;
}

const FBX: ForeignFormat = { what: 'an FBX file' };
const BLEND: ForeignFormat = { what: 'a Blender file (BLEND)' };
const COLLADA: ForeignFormat = { what: 'a COLLADA file (DAE)' };
const USD: ForeignFormat = { what: 'a USD file' };
const ARCHIVE: ForeignFormat = { what: 'an archive', cure: 'Unpack it, and use the model in it.' };
// Many servers answer with a web page when a file is missing.
const WEB_PAGE: ForeignFormat = { what: 'a web page or XML, not a model', cure: 'Check the address.' };

const EXTENSIONS: Readonly<Record<string, ForeignFormat>> = {
  fbx: FBX,
  blend: BLEND,
  dae: COLLADA,
  usd: USD,
  usda: USD,
  usdc: USD,
  usdz: USD,
  zip: ARCHIVE,
};

/** Beginnings that no other format has, as Latin-1. */
const BEGINNINGS: readonly (readonly [text: string, format: ForeignFormat])[] = [
  ['Kaydara FBX Binary', FBX],
  ['; FBX', FBX],
  ['BLENDER', BLEND],
  ['#usda', USD],
  ['PXR-USDC', USD],
  ['PK\x03\x04', ARCHIVE],
  ['\x1f\x8b', ARCHIVE],
];

/** Recognised by the first bytes, then by the extension (lower case, without the dot); null if unknown. */
export function foreignContent(bytes: Uint8Array, extension: string): ForeignFormat | null {
  const start = new TextDecoder('latin1').decode(bytes.subarray(0, 2048));
  const known = BEGINNINGS.find(([text]) => start.startsWith(text));
  // A USDZ file is an archive.
  if (known) return known[1] === ARCHIVE ? (foreignExtension(extension) ?? ARCHIVE) : known[1];
  // A byte order mark of UTF-8 reads as these three characters.
  const markup = start.replace(/^ï»¿/, '').trimStart();
  if (!markup.startsWith('<')) return null;
  return /<COLLADA\b/.test(markup) ? COLLADA : WEB_PAGE;
}

/** @param extension lower case, without the dot. */
export const foreignExtension = (extension: string): ForeignFormat | null =>
  Object.hasOwn(EXTENSIONS, extension) ? (EXTENSIONS[extension] ?? null) : null;
