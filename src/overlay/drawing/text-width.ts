// The width of a label. Measured by a canvas, which costs no layout. CSS pixels.
import { FONT } from './display-list.js';

/** Names are few; a page that writes new ones every frame must not keep them all. */
const MOST_WIDTHS = 1000;

const widths = new Map<string, number>();
let context: CanvasRenderingContext2D | null = null;

export function textWidth(text: string): number {
  const known = widths.get(text);
  if (known !== undefined) return known;
  if (widths.size >= MOST_WIDTHS) widths.clear();
  context ??= document.createElement('canvas').getContext('2d');
  if (context !== null) context.font = FONT;
  // Without a canvas: seven pixels a letter is wider than most text.
  const width = context?.measureText(text).width ?? 7 * text.length;
  widths.set(text, width);
  return width;
}

/** At most so many characters, with an ellipsis in place of the rest. */
export function shortened(text: string, most = 24): string {
  const characters = Array.from(text);
  return characters.length <= most ? text : `${characters.slice(0, most - 1).join('')}…`;
}
