// A poster's file: what it was drawn from stands in it, so that it is drawn again only when that
// has changed.
import { createHash } from 'node:crypto';
import { readFileSync, statSync } from 'node:fs';
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

interface Stamp {
  readonly version: string;
  /** Its SHA-256. */
  readonly markup: string;
  readonly width: number;
  readonly height: number;
  readonly background: PosterSource['background'];
  /** SHA-256 of the files that were read from disk, by their addresses relative to the base. */
  readonly files: Readonly<Record<string, string>>;
}

/** Draws the poster. */
export async function drawPoster(
  source: PosterSource,
  warn: (message: string) => void,
): Promise<Uint8Array> {
  const { markup, size, background, base, version } = source;
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
  const stamp: Stamp = { version, markup: hashOf(markup), ...size, background, files };
  return withText(png, KEYWORD, JSON.stringify(stamp));
}

/** Why a file is not the poster of this source any more; null if it is. */
export async function staleness(png: Uint8Array, source: PosterSource): Promise<string | null> {
  const stamp = await stampOf(png);
  const { markup, size, background, base, version } = source;
  if (stamp === null) return 'was not made by this command';
  if (stamp.version !== version) return `was made by version ${String(stamp.version)}`;
  if (stamp.markup !== hashOf(markup)) return 'shows other markup';
  if (stamp.width !== size.width || stamp.height !== size.height) return 'has another size';
  if (JSON.stringify(stamp.background) !== JSON.stringify(background)) {
    return 'has another background';
  }
  const changed = Object.entries(stamp.files ?? {}).find(
    ([name, hash]) => hashOfFile(name, base) !== hash,
  );
  return changed === undefined ? null : `shows another ${changed[0]}`;
}

/** Whether the command has made this file: no other is written over. */
export const isPoster = async (png: Uint8Array): Promise<boolean> => (await stampOf(png)) !== null;

/** It may be a stranger's: its values can be anything. */
async function stampOf(png: Uint8Array): Promise<Partial<Stamp> | null> {
  try {
    const stamp = JSON.parse(await textIn(png, KEYWORD)) as Partial<Stamp> | null;
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
