// A CSS colour as three numbers, 255 being full, in sRGB and unrounded. The browser's canvas parses
// it.
import { clamp, type Vec3 } from '../../../phong/math/vector.js';

let context: CanvasRenderingContext2D | null | undefined;

/**
 * Limits of the text that the browser parses. In Chromium 156 the time doubles with each unclosed
 * `color-mix(` (20 take 0.4 s), and 50,000 nested `color(from ` crash the tab.
 */
const LONGEST = 200;
const DEEPEST = 4;

/** Strings, escapes and comments could hide parentheses. No colour needs them. */
const HIDING = /["'\\]|\/\*/;

/**
 * Any CSS `<color>` inside sRGB's gamut, without its alpha. Null for everything else: text that is
 * no colour, a colour outside the gamut, one that depends on the element (`currentColor`), and text
 * that is too long or too deep to be parsed safely.
 */
export function cssColor(text: string): Vec3 | null {
  if (text.length > LONGEST) return null;
  const color = text.trim().toLowerCase();
  if (HIDING.test(color) || depthOf(color) > DEEPEST || color.includes('currentcolor')) return null;
  return parsed(color);
}

/** The most parentheses that are open at once. */
function depthOf(text: string): number {
  let depth = 0;
  let most = 0;
  for (const character of text) {
    if (character === '(') {
      most = Math.max(most, ++depth);
    } else if (character === ')' && depth > 0) {
      depth--;
    }
  }
  return most;
}

function parsed(text: string): Vec3 | null {
  context ??= document.createElement('canvas').getContext('2d');
  if (context === null) return null;
  // A relative colour is serialised as sRGB floats, whatever its own space, and accepts no keyword
  // that is not a colour. A value that the canvas cannot parse leaves its fill style unchanged.
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

/** The three forms in which browsers serialise sRGB colours. */
function fromSerialized(text: string): Vec3 | null {
  const hex = /^#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})$/.exec(text);
  if (hex !== null) {
    return [parseInt(hex[1] ?? '', 16), parseInt(hex[2] ?? '', 16), parseInt(hex[3] ?? '', 16)];
  }
  const rgb = /^rgba?\(([\d.]+), ([\d.]+), ([\d.]+)/.exec(text);
  if (rgb !== null) return [Number(rgb[1]), Number(rgb[2]), Number(rgb[3])];
  const srgb = /^color\(srgb (\S+) (\S+) (\S+?)(?: \/ \S+)?\)$/.exec(text);
  return srgb === null ? null : insideGamut([Number(srgb[1]), Number(srgb[2]), Number(srgb[3])]);
}

/**
 * White converted from a polar space gives 1.0000002; colours outside the gamut are farther out
 * than this.
 */
const ROUNDING = 1e-4;

function insideGamut(color: Vec3): Vec3 | null {
  if (!color.every((c) => c >= -ROUNDING && c <= 1 + ROUNDING)) return null;
  // Browsers serialise six decimals. Rounding to three of 255 gives #fc8 back as 255 204 136.
  const byte = (c: number) => Math.round(255e3 * clamp(c, 0, 1)) / 1e3;
  return [byte(color[0]), byte(color[1]), byte(color[2])];
}
