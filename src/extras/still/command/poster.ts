// A poster's file: what it was drawn from stands in it, so that it is drawn again only when that
// has changed.
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { withText } from '../../png/chunks.js';
import { PngTextError, textIn } from '../../png/read-text.js';
import { still } from '../index.js';
import type { Size } from './page.js';

/** What decides the pixels of a poster. */
export interface PosterSource {
  readonly markup: string;
  /** Pixels of the file. */
  readonly size: Size;
  /** Behind what is transparent; null for nothing. */
  readonly background: readonly [number, number, number] | null;
  /** What addresses are relative to. */
  readonly base: URL;
  /** This package's version. */
  readonly version: string;
}

/** Names the chunk that says how the picture was made. */
const KEYWORD = 'phong-viewer still';

/** What a poster was made from, but for files. The markup by its SHA-256. */
const sourceOf = ({ markup, size, background, version }: PosterSource) => ({
  version,
  markup: hashOf(markup),
  size,
  background,
});

type Stamp = Readonly<Record<string, unknown>> & {
  /** SHA-256 of the files that were read from disk, by their addresses relative to the base. */
  readonly files?: Readonly<Record<string, string>>;
};

/** Draws the poster. */
export async function drawPoster(
  source: PosterSource,
  warn: (message: string) => void,
): Promise<Uint8Array> {
  const { markup, size, background, base } = source;
  const files: Record<string, string> = {};
  const { png } = await still(markup, {
    ...size,
    base,
    warn,
    ...(background !== null && { background }),
    onFile: (url, bytes) => {
      if (url.protocol === 'file:') {
        files[relative(base, url)] = hashOf(bytes);
      }
    },
  });
  return withText(png, KEYWORD, JSON.stringify({ ...sourceOf(source), files }));
}

/** Why a file is not the poster of this source any more; null if it is. */
export function staleness(png: Uint8Array, source: PosterSource): string | null {
  const stamp = stampOf(png);
  if (stamp === null) return 'was not made by this command';
  const own = Object.entries(sourceOf(source)).find(
    ([key, value]) => JSON.stringify(stamp[key]) !== JSON.stringify(value),
  );
  const [changed] =
    own ??
    Object.entries(stamp.files ?? {}).find(
      ([name, hash]) => hashOfFile(name, source.base) !== hash,
    ) ??
    [];
  return changed === undefined ? null : `is of another ${changed}`;
}

/** Not there, or made by this command: no other file is written over. */
export const isOwn = (path: string): boolean =>
  !existsSync(path) || stampOf(readFileSync(path)) !== null;

/** It may be a stranger's: its values can be anything. */
function stampOf(png: Uint8Array): Stamp | null {
  try {
    const stamp = JSON.parse(textIn(png, KEYWORD)) as Stamp | null;
    return typeof stamp === 'object' ? stamp : null;
  } catch (error) {
    if (error instanceof PngTextError || error instanceof SyntaxError) return null;
    throw error;
  }
}

const hashOf = (data: Uint8Array | string): string =>
  createHash('sha256').update(data).digest('hex');

/** Null for what is no file on this disk: a device may never end. */
function hashOfFile(name: string, base: URL): string | null {
  try {
    const path = fileURLToPath(new URL(name, base));
    return statSync(path).isFile() ? hashOf(readFileSync(path)) : null;
  } catch {
    return null;
  }
}

/** Below the base without what the machine's path is. */
const relative = (base: URL, { href }: URL): string => {
  const folder = new URL('.', base).href;
  return href.startsWith(folder) ? href.slice(folder.length) : href;
};
