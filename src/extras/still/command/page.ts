// The viewers of an HTML file as it is written: where they stand, how large they are, and which
// poster they have. Edits the file by places in its text, so that nothing else changes.
import { type DefaultTreeAdapterTypes, html, parse } from 'parse5';
import { PANEL_PLACE } from '../../../viewer/extra.js';
import { elementsBelow } from '../elements.js';

/** CSS pixels. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** A part of the text and what stands there instead. */
export interface Edit {
  readonly start: number;
  readonly end: number;
  readonly text: string;
}

export type PageViewer = ReturnType<typeof pageViewer>;

export interface Page {
  readonly viewers: readonly PageViewer[];
  /** What addresses are relative to, if the page says so. */
  readonly base: string | null;
}

type Element = DefaultTreeAdapterTypes.Element;

/** @throws Error with `line`s for viewers that have no end tag, or hold another one. */
export function readPage(text: string): Page {
  const all = elementsBelow(parse(text, { sourceCodeLocationInfo: true }));
  const rules = all.flatMap(rulesIn);
  // In SVG they are no viewers, and an <img> would end it.
  const viewers = all.filter(
    ({ tagName, namespaceURI }) => tagName === 'phong-viewer' && namespaceURI === html.NS.HTML,
  );
  const base = all.find((one) => one.tagName === 'base' && attribute(one, 'href') !== null);
  return {
    viewers: viewers.map((element, i) => pageViewer(text, element, i + 1, rules)),
    base: base === undefined ? null : attribute(base, 'href'),
  };
}

export const edited = (text: string, edits: readonly Edit[]): string =>
  [...edits]
    .sort((a, b) => b.start - a.start)
    .reduce((all, { start, end, text: own }) => all.slice(0, start) + own + all.slice(end), text);

/** A viewer of the page. */
function pageViewer(text: string, element: Element, number: number, rules: readonly Rule[]) {
  const place = element.sourceCodeLocation!;
  const { startTag } = place;
  const problem = (what: string): Error => new Error(`${String(place.startLine)}: ${what}`);
  if (startTag === undefined || place.endTag === undefined) {
    throw problem('<phong-viewer> needs its end tag, </phong-viewer>.');
  }
  if (elementsBelow(element).some(({ tagName }) => tagName === 'phong-viewer')) {
    throw problem('<phong-viewer> holds another <phong-viewer>.');
  }
  const image = element.childNodes.find(
    (child): child is Element => 'tagName' in child && attribute(child, 'slot') === 'poster',
  );
  const style = styleOf(element, rules);
  let skipped = isInComparison(element) ? 'is in a comparison, which sets its size' : null;
  if (attribute(element, 'poster') !== null) {
    skipped = 'has a poster of its own, the attribute "poster"';
  }
  if (image !== undefined && image.tagName !== 'img') {
    skipped = `has a poster of its own, <${image.tagName}>`;
  }
  return {
    /** In the file, from 1. */
    line: place.startLine,
    /** Its `id`, or its number on the page. */
    name: attribute(element, 'id') || String(number),
    /** As it is written, without its poster. */
    markup: without(image, text.slice(place.startOffset, place.endOffset), place.startOffset),
    /**
     * Of its picture, without the place of its panel. `unstated`: of a viewer whose size the page does
     * not say in pixels.
     */
    pictureSize: (unstated: Size | null) =>
      besidePanel(element, sizeOf(element, style) ?? unstated),
    /** The size of the image in its slot. */
    posterSize: image === undefined ? null : sizeOf(image, ''),
    /** What its style says; null for nothing. */
    background: declared(style, 'background-color') ?? declared(style, 'background'),
    /** Why no poster of it is made; null for no reason. */
    skipped,
    /** The address of the image in its slot; null for no image. */
    poster: image === undefined ? null : (attribute(image, 'src') ?? ''),
    /** The edits that give the slot an image of this address and size. */
    withPoster(src: string, { width, height }: Size): readonly Edit[] {
      const values = { src, width: String(width), height: String(height) };
      if (image !== undefined) return valueEdits(image, values);
      const at = startTag.endOffset;
      const indent = /^\r?\n[ \t]*/.exec(text.slice(at))?.[0] ?? '';
      const tag = `<img slot="poster" src="${escaped(src)}" width="${values.width}" height="${values.height}" alt="" decoding="async">`;
      return [{ start: at, end: at, text: indent + tag }];
    },
  };
}

/** The markup without its poster and the white space before it. */
function without(image: Element | undefined, markup: string, offset: number): string {
  const part = image?.sourceCodeLocation;
  if (!part) return markup;
  const before = markup.slice(0, part.startOffset - offset).trimEnd();
  return before + markup.slice(part.endOffset - offset);
}

/** Those that differ from what is written. */
function valueEdits(element: Element, values: Readonly<Record<string, string>>): Edit[] {
  const place = element.sourceCodeLocation!;
  const edits: Edit[] = [];
  let missing = '';
  for (const [name, value] of Object.entries(values)) {
    const text = `${name}="${escaped(value)}"`;
    const at = place.attrs?.[name];
    if (at === undefined) {
      missing += ` ${text}`;
    } else if (attribute(element, name) !== value) {
      edits.push({ start: at.startOffset, end: at.endOffset, text });
    }
  }
  if (missing !== '') {
    const start = place.startOffset + 1 + element.tagName.length;
    edits.push({ start, end: start, text: missing });
  }
  return edits;
}

const escaped = (text: string): string => text.replaceAll('&', '&amp;').replaceAll('"', '&quot;');

const attribute = ({ attrs }: Element, name: string): string | null =>
  attrs.find((one) => one.name === name)?.value ?? null;

const isInComparison = ({ parentNode: around }: Element): boolean =>
  around !== null &&
  'tagName' in around &&
  (around.tagName === 'phong-compare' || isInComparison(around));

/** A rule of a style sheet whose selector has no spaces and colons. */
interface Rule {
  /** A tag, `#id`s and `.class`es. */
  readonly parts: readonly string[];
  readonly declarations: string;
}

/** The rules of a `<style>`, without those inside `@media` and the like. */
function rulesIn({ tagName, childNodes }: Element): Rule[] {
  if (tagName !== 'style') return [];
  const css = childNodes
    .map((node) => ('value' in node ? node.value : ''))
    .join('')
    .replace(/\/\*[^]*?\*\/|@[^{};]*(;|\{([^{}]*\{[^{}]*\})*[^{}]*\})/g, '');
  return [...css.matchAll(/([^{}]+)\{([^{}]*)\}/g)].flatMap(([, selectors, declarations]) =>
    selectors!
      .split(',')
      .filter((selector) => /^\s*([\w-]+|\*|)([.#][\w-]+)*\s*$/.test(selector))
      .map((selector) => ({
        parts: (selector.match(/[.#]?[\w-]+/g) ?? []).map((part) =>
          /^[.#]/.test(part) ? part : part.toLowerCase(),
        ),
        declarations: declarations!,
      })),
  );
}

/** All declarations for an element, the strongest last. */
function styleOf(element: Element, rules: readonly Rule[]): string {
  const classes = (attribute(element, 'class') ?? '').split(/\s+/).map((name) => `.${name}`);
  const own = [element.tagName, `#${attribute(element, 'id') ?? ''}`, ...classes];
  const strength = ({ parts }: Rule): number =>
    parts.reduce((sum, [sign]) => sum + (sign === '#' ? 1e6 : sign === '.' ? 1e3 : 1), 0);
  return rules
    .filter(({ parts }) => parts.every((part) => own.includes(part)))
    .sort((a, b) => strength(a) - strength(b))
    .map(({ declarations }) => declarations)
    .concat(attribute(element, 'style') ?? '')
    .join(';');
}

/** From its style, else from its attributes. A viewer has a ratio of 2, as its style sheet says. */
function sizeOf(element: Element, style: string): Size | null {
  const width =
    numberIn(PIXELS, declared(style, 'width')) ?? numberIn(WHOLE, attribute(element, 'width'));
  const ratio = declared(style, 'aspect-ratio') ?? (element.tagName === 'phong-viewer' ? '2' : '');
  const [, across, down = '1'] = /^([\d.]+)\s*(?:\/\s*([\d.]+))?$/.exec(ratio) ?? [];
  const isFree = width !== null && across !== undefined && declared(style, 'height') === null;
  const height =
    numberIn(PIXELS, declared(style, 'height')) ??
    numberIn(WHOLE, attribute(element, 'height')) ??
    (isFree ? (width * Number(down)) / Number(across) : null);
  if (width === null || height === null) return null;
  const size = { width: Math.round(width), height: Math.round(height) };
  return size.width >= 1 && size.height >= 1 && Number.isFinite(size.height) ? size : null;
}

/**
 * What an open panel leaves. Its column has 24.17em and 16 pixels, see own-text.css: 306 where an
 * em is the element's usual 12.
 */
function besidePanel(element: Element, size: Size | null): Size | null {
  return size !== null &&
    size.width >= PANEL_PLACE.wide &&
    (attribute(element, 'gui') ?? 'false') !== 'false'
    ? { ...size, width: size.width - 306 }
    : size;
}

/** The number that a value of this form begins with. */
const numberIn = (form: RegExp, value: string | null): number | null =>
  value !== null && form.test(value) ? parseFloat(value) : null;

const PIXELS = /^\d*\.?\d+px$/i;
const WHOLE = /^\d+$/;

/** The last value of a property in a style; null for none. */
function declared(style: string, property: string): string | null {
  const values = style
    .replace(/\/\*[^]*?\*\//g, '')
    .split(';')
    .map((part) => part.split(/:(.*)/s))
    .filter(([name = '']) => name.trim().toLowerCase() === property);
  return (
    values
      .at(-1)?.[1]
      ?.replace(/!important\s*$/i, '')
      .trim() ?? null
  );
}
