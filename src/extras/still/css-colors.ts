// A CSS colour as three numbers, 255 being full, in sRGB: names, hex, rgb(), hsl() and hwb(),
// without their alpha. In browsers the canvas parses them (viewer/element/fields/css-color.ts).
import { Color } from 'three';
import { clamp, map, type Vec3 } from '../../phong/math/vector.js';

/** Colours that browsers know and stills do not. */
const OTHER =
  /^((ok)?(lab|lch)|color(-mix)?|light-dark|contrast-color|device-cmyk)\(|^(rgb|hsl|hwb)a?\((\s*from\s|.*calc\()/;

/** Null for what is no colour. @throws TypeError for a colour of another kind, and names it. */
export function cssColor(text: string): Vec3 | null {
  const key = text.trim().toLowerCase();
  if (OTHER.test(key)) {
    throw new TypeError(
      `a still cannot read the colour ${JSON.stringify(key)}: write rgb(), hsl() or #hex`,
    );
  }
  const [, hex] = /^#([0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})$/.exec(key) ?? [];
  const full = hex !== undefined && hex.length < 6 ? hex.replace(/./g, '$&$&') : hex;
  const code = full === undefined ? named.get(key) : parseInt(full.slice(0, 6), 16);
  if (code !== undefined) return [code >> 16, (code >> 8) & 255, code & 255];
  const [, name, inside = ''] = /^(rgb|hsl|hwb)a?\(([^()]*)\)$/.exec(key) ?? [];
  const words = inside.trim().split(/\s*,\s*|\s*\/\s*|\s+/);
  if (name === undefined || words.length < 3 || words.length > 4) return null;
  const numbers = words.map((word, i) => numberOf(word, i, name));
  if (numbers.some(Number.isNaN)) return null;
  const [a, b, c] = numbers as [number, number, number];
  if (name === 'rgb') return map([a, b, c], rounded);
  const sum = Math.max(1, b + c);
  // hwb(): a hue at full saturation between its black and white. CSS Color 4, sections 7 and 8.
  const [low, high] = name === 'hwb' ? [b / sum, 1 - c / sum] : [0, 1];
  const [s, l] = name === 'hwb' ? [1, 0.5] : [b, c];
  const at = (n: number): number => {
    const k = (n + 12 * a) % 12;
    const hue = l - s * Math.min(l, 1 - l) * Math.max(-1, Math.min(k - 3, 9 - k, 1));
    return rounded(low + (high - low) * hue);
  };
  return [at(0), at(8), at(4)];
}

/** As browsers serialise them; see viewer/element/fields/css-color.ts. */
const rounded = (c: number): number => Math.round(255e3 * clamp(c, 0, 1)) / 1e3;

/** What is 1; `''`: of a hue. */
const WHOLE: Readonly<Record<string, number>> = {
  '': 360,
  deg: 360,
  grad: 400,
  rad: 2 * Math.PI,
  turn: 1,
  '%': 100,
};

/** A word of a colour function as turns, or as a number from 0 to 1; NaN for neither. */
function numberOf(word: string, i: number, name: string): number {
  const [, number, unit = ''] =
    /^([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[+-]?\d+)?|none)(%|deg|grad|rad|turn|)$/.exec(word) ?? [];
  const isHue = i === 0 && name !== 'rgb';
  if (number === undefined || (isHue ? unit === '%' : unit.length > 1)) return NaN;
  const value = number === 'none' ? 0 : Number(number);
  if (isHue) return (((value / WHOLE[unit]!) % 1) + 1) % 1;
  return clamp(value / (unit === '' && name === 'rgb' ? 255 : 100), 0, 1);
}

/** The names that CSS has, as numbers. */
const named = new Map(Object.entries({ ...Color.NAMES, transparent: 0 }));
