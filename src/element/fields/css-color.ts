// A CSS colour as three numbers where 255 is full, in sRGB and unrounded. The browser parses; this file asks it without
// touching the document. Knows nothing of attributes.
import type { Vec3 } from '../../math/vector.js';

const known = new Map<string, Vec3 | null>();
let context: CanvasRenderingContext2D | null | undefined;

/** Colours found so far are kept; a page that makes up endlessly many starts over. */
const KEPT = 1000;

/**
 * Any CSS `<color>` inside sRGB's gamut, its alpha left out. Null for everything else: no colour, one outside the
 * gamut, or one that depends on the element (`currentColor`).
 */
export function cssColor(text: string): Vec3 | null {
  const key = text.trim().toLowerCase();
  let color = known.get(key);
  if (color === undefined) {
    color = key.includes('currentcolor') ? null : ask(key);
    if (known.size >= KEPT) known.clear();
    known.set(key, color);
  }
  return color;
}

function ask(text: string): Vec3 | null {
  context ??= document.createElement('canvas').getContext('2d');
  if (context === null) return null;
  // A relative colour comes back as floats of sRGB, whatever space it was written in, and takes no keyword that is
  // not a colour. A value that the canvas cannot parse leaves its fill style as it was.
  return read(context, `color(from ${text} srgb r g b)`) ?? read(context, text);
}

function read(canvas: CanvasRenderingContext2D, color: string): Vec3 | null {
  canvas.fillStyle = '#010203';
  canvas.fillStyle = color;
  const first = canvas.fillStyle;
  canvas.fillStyle = '#040506';
  canvas.fillStyle = color;
  return first === canvas.fillStyle ? fromSerialized(first) : null;
}

/** The three forms in which browsers give sRGB colours back. */
function fromSerialized(text: string): Vec3 | null {
  const hex = /^#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})$/.exec(text);
  if (hex !== null)
    return [parseInt(hex[1] ?? '', 16), parseInt(hex[2] ?? '', 16), parseInt(hex[3] ?? '', 16)];
  const rgb = /^rgba?\(([\d.]+), ([\d.]+), ([\d.]+)/.exec(text);
  if (rgb !== null) return [Number(rgb[1]), Number(rgb[2]), Number(rgb[3])];
  const srgb = /^color\(srgb (\S+) (\S+) (\S+?)(?: \/ \S+)?\)$/.exec(text);
  return srgb === null ? null : insideGamut([Number(srgb[1]), Number(srgb[2]), Number(srgb[3])]);
}

/** White from a polar space comes back as 1.0000002; colours of wider gamuts are farther out than this. */
const ROUNDING = 1e-4;

function insideGamut(color: Vec3): Vec3 | null {
  if (!color.every((c) => c >= -ROUNDING && c <= 1 + ROUNDING)) return null;
  // Browsers give six decimals of 1: rounded to what they can tell apart, #fc8 is 255 204 136 again.
  const byte = (c: number): number => Math.round(255e3 * Math.min(Math.max(c, 0), 1)) / 1e3;
  return [byte(color[0]), byte(color[1]), byte(color[2])];
}
