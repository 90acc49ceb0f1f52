// The width of a text over the picture. Measured by a canvas, which costs no layout. CSS pixels.
import { labelFont } from './display-list.js';

/** Names are few; a page that writes new ones every frame must not keep them all. */
const MOST_WIDTHS = 1000;

/** Pixels at which texts are measured. Widths at other sizes are in proportion. */
const MEASURED = 12;

const LABEL = labelFont(`${String(MEASURED)}px`);

/** Of a table. */
export const PLAIN = `${String(MEASURED)}px system-ui, sans-serif`;

const widths = new Map<string, number>();
let context: CanvasRenderingContext2D | null = null;

/** `font`: that of labels, or {@link PLAIN}. */
export function textWidth(text: string, fontSize: number, font = LABEL): number {
  return (widthAt(text, font) * fontSize) / MEASURED;
}

function widthAt(text: string, font: string): number {
  const key = `${font} ${text}`;
  const known = widths.get(key);
  if (known !== undefined) return known;
  if (widths.size >= MOST_WIDTHS) widths.clear();
  context ??= document.createElement('canvas').getContext('2d');
  if (context !== null) context.font = font;
  // Without a canvas: seven pixels a letter is wider than most text.
  const width = context?.measureText(text).width ?? 7 * text.length;
  widths.set(key, width);
  return width;
}

/** At most so many characters, with an ellipsis in place of the rest. */
export function shortened(text: string, most = 24): string {
  const characters = Array.from(text);
  return characters.length <= most ? text : `${characters.slice(0, most - 1).join('')}…`;
}
