// Brings the posters of a page up to date, and says what was done.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, dirname, join, relative, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { cssColor } from '../css-colors.js';
import { type Edit, edited, type Page, type PageViewer, readPage, type Size } from './page.js';
import { drawPoster, isOwn, type PosterSource, staleness } from './poster.js';

export interface Settings {
  /** For viewers without a size of their own. */
  readonly size: Size | null;
  readonly scale: number;
  readonly check: boolean;
  /** Null: beside the page. */
  readonly out: string | null;
  readonly version: string;
}

export const say = (line: string): boolean => process.stdout.write(`${printable(line)}\n`);
export const complain = (line: string): boolean => process.stderr.write(`${printable(line)}\n`);

/** Without what terminals obey: pages quote anything. */
const printable = (line: string): string => line.replaceAll(/\p{Cc}/gu, '\ufffd');

const messageOf = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

/** Whether all is well. What is not is said. */
export async function updatePage(file: string, settings: Settings): Promise<boolean> {
  try {
    const bytes = readFileSync(file);
    const text = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
    const page = readPage(text);
    const { viewers } = page;
    if (viewers.length === 0 || (settings.out !== null && viewers.length > 1)) {
      complain(
        `${file}: has ${viewers.length === 0 ? 'no <phong-viewer>' : 'several viewers: --out is for one'}.`,
      );
      return false;
    }
    const edits: Edit[] = [];
    const targets = new Targets(file, page);
    let isWell = true;
    for (const viewer of viewers) {
      const at = `${file}:${String(viewer.line)}:`;
      try {
        const own = await updateViewer(viewer, { at, targets, settings });
        edits.push(...(own ?? []));
        isWell &&= own !== null;
      } catch (error) {
        complain(`${at} ${messageOf(error)}`);
        isWell = false;
      }
    }
    if (edits.length > 0) {
      writeFileSync(file, edited(text, edits));
    }
    return isWell;
  } catch (error) {
    complain(`${file}:${reasonOf(error)}`);
    return false;
  }
}

const REASONS: Readonly<Record<string, string>> = {
  ENOENT: ' there is no such file.',
  EISDIR: ' is a folder: name the pages in it.',
  EACCES: ' this user may not read or write it.',
  ERR_ENCODING_INVALID_ENCODED_DATA: ' is not UTF-8.',
};

/** Ends the line that begins with a file's name. */
function reasonOf(error: unknown): string {
  const { code = '' } = error as { readonly code?: string };
  const message = messageOf(error);
  return REASONS[code] ?? (/^\d/.test(message) ? message : ` ${message}`);
}

interface ViewerPlace {
  /** The line's beginning: file and line. */
  readonly at: string;
  readonly targets: Targets;
  readonly settings: Settings;
}

/** Draws what is not up to date, and says how the page has to change. Null: a check has failed. */
async function updateViewer(
  viewer: PageViewer,
  place: ViewerPlace,
): Promise<readonly Edit[] | null> {
  const { at, targets, settings } = place;
  const { out, check, scale } = settings;
  if (out === null && viewer.skipped !== null) {
    say(`${at} left alone: it ${viewer.skipped}.`);
    return [];
  }
  const size = viewer.pictureSize(settings.size) ?? viewer.posterSize;
  if (size === null) {
    throw new Error(
      'the viewer has no size in pixels, by its style, a rule in <style> or its attributes width and height: use --size 760x420.',
    );
  }
  const scaled = (length: number) => Math.max(1, Math.round(length * scale));
  const source: PosterSource = {
    markup: viewer.markup,
    size: { width: scaled(size.width), height: scaled(size.height) },
    background: backgroundOf(viewer, (message) => complain(`${at} ${message}`)),
    base: targets.base,
    version: settings.version,
  };
  const { path, src } = out === null ? targets.of(viewer) : { path: out, src: '' };
  if (path === null) {
    say(`${at} left alone: ${src} was not made by this command.`);
    return [];
  }
  const edits = out === null ? viewer.withPoster(src, size) : [];
  const stale = existsSync(path) ? staleness(readFileSync(path), source) : 'is not there';
  const name = out ?? src;
  if (check) {
    const fault =
      stale ?? (edits.length > 0 ? 'is not the image in the page, or not in its size' : null);
    if (fault !== null) {
      complain(`${at} ${name} ${fault}.`);
    }
    return fault === null ? [] : null;
  }
  if (stale === null) {
    say(`${at} ${name} is up to date.`);
  } else {
    const start = performance.now();
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, await drawPoster(source, (message) => complain(`${at} ${message}`)));
    const { width, height } = source.size;
    const seconds = ((performance.now() - start) / 1000).toFixed(1);
    say(`${at} ${name}, ${String(width)} × ${String(height)}, drawn in ${seconds} s.`);
  }
  return edits;
}

/** A colour that is opaque; null, and a warning, for what is none. */
function backgroundOf(
  { background }: PageViewer,
  warn: (message: string) => void,
): PosterSource['background'] {
  if (background === null || /^(none|transparent|initial|unset|inherit)$/i.test(background)) {
    return null;
  }
  const isTranslucent = /^#(\w{4}|\w{8})$|\/|a\(/i.test(background);
  let color: ReturnType<typeof cssColor> = null;
  try {
    color = isTranslucent ? null : cssColor(background);
  } catch {
    // A notation that is not read here.
  }
  if (color === null) {
    warn(
      `the background ${JSON.stringify(background)} is no opaque colour, so the poster is transparent.`,
    );
  }
  return color;
}

/** Where the posters of a page are. */
class Targets {
  /** What addresses in the page are relative to. */
  readonly base: URL;
  readonly #folder: string;
  readonly #stem: string;
  readonly #taken: Set<string>;

  constructor(file: string, { viewers, base }: Page) {
    const page = pathToFileURL(resolve(file));
    // Browsers, too, take no notice of a base that is no address.
    this.base = base !== null && URL.canParse(base, page) ? new URL(base, page) : page;
    this.#folder = dirname(resolve(file));
    this.#stem = basename(file).replace(/\.html$/, '');
    this.#taken = new Set(viewers.map(({ poster }) => poster ?? ''));
  }

  /** `path` is null where the image in the page is not this command's. */
  of({ poster, name }: PageViewer): { readonly path: string | null; readonly src: string } {
    if (this.base.protocol !== 'file:') {
      throw new Error(`<base href> leads to ${this.base.origin}: where its files are is unknown.`);
    }
    if (poster !== null && poster !== '') {
      const path = this.#pathOf(poster);
      return { path: path !== null && isOwn(path) ? path : null, src: poster };
    }
    const words = name.replaceAll(/[^\p{L}\p{N}_-]+/gu, '-').slice(0, 50);
    for (let i = 1; ; i++) {
      const more = i > 1 ? `.${String(i)}` : '';
      const path = join(this.#folder, `${this.#stem}.${words}${more}.png`);
      const src = relative(fileURLToPath(new URL('.', this.base)), path).replaceAll('\\', '/');
      const address = src.split('/').map(encodeURIComponent).join('/');
      if (this.#taken.has(address) || !isOwn(path)) continue;
      this.#taken.add(address);
      return { path, src: address };
    }
  }

  /** Null for no PNG on this disk. */
  #pathOf(src: string): string | null {
    const url = URL.canParse(src, this.base) ? new URL(src, this.base) : null;
    if (url?.protocol !== 'file:' || !/\.png$/i.test(url.pathname)) return null;
    const path = fileURLToPath(url);
    // A file that is not there is made below the page alone.
    const isBelow = !relative(this.#folder, path).startsWith('..');
    return existsSync(path) || isBelow ? path : null;
  }
}
