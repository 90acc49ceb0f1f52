// Which columns of a sum there is room for. Names can be shortened, numbers cannot: columns are left out instead, and
// the sum last; "…" stands for terms that it has all the same. CSS pixels. Widths are measured without layout: a table is shown once per frame.
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import { isBlack } from '../../light/light-features.js';
import { PLAIN, textWidth } from '../drawing/label-layout.js';
import { type Sum, type SumRow, numberText, termText, tripleText } from './sum.js';

/** A column after the light's name. */
export type Column = (typeof TERMS)[number] | 'att' | 'decay' | 'sum' | '…';

/** The columns of a table, and the decimals of its codes. Null where there is only room for the colour. */
export interface TableLayout {
  readonly columns: readonly Column[];
  readonly digits: number;
  /** Names have too little width for a note below them. */
  readonly narrow: boolean;
}

/** 1 for most lights. */
const factorText = (factor: number): string => numberText(factor, factor === 1 ? 0 : 2);

const TERMS = ['ambient', 'diffuse', 'specular'] as const;

/** The row's sum has a term that has no column. */
const hasMore = (row: SumRow, columns: readonly Column[]): boolean =>
  TERMS.some((term) => !columns.includes(term) && !isBlack(row[term]));

/** What a row has in a column: numbers, which keep their order in languages that are written from the right. */
export const CONTENTS = {
  '…': (row: SumRow, _: number, columns: readonly Column[]): string => (hasMore(row, columns) ? '…' : ''),
  ambient: ({ ambient }: SumRow, digits: number): string => termText(ambient, digits),
  diffuse: ({ diffuse }: SumRow, digits: number): string => termText(diffuse, digits),
  specular: ({ specular }: SumRow, digits: number): string => termText(specular, digits),
  att: ({ att }: SumRow): string => factorText(att),
  decay: ({ decay }: SumRow): string => factorText(decay),
  sum: ({ total }: SumRow, digits: number): string => termText(total, digits),
} as const satisfies Record<Column, unknown>;

export const titleOf = (column: Column, texts: ViewerTexts | null): string =>
  column === '…' ? column : phrase(texts, column);

const ALL: readonly Column[] = [...TERMS, 'att', 'decay', 'sum'];

/** The first one is left out first. */
const DISPENSABLE: readonly Column[] = ['decay', 'att', 'ambient', 'specular', 'diffuse'];

/** In font sizes. */
const SIZES = {
  /** Tables in less than this show the colour alone. */
  least: 12,
  /** From here on codes have a decimal, if all columns fit with it. */
  decimals: 50,
  /** Between two columns; see probe.css. */
  gap: 0.6,
  /** A name: a few letters. */
  name: 2.5,
  /** A name with a note below it. */
  note: 6,
} as const;

/** `width`: of the free part of the picture; `room`: of the table in it. */
export function layoutOf(
  sum: Sum,
  { width, room, fontSize }: Readonly<Record<'width' | 'room' | 'fontSize', number>>,
  texts: ViewerTexts | null,
): TableLayout | null {
  if (width < SIZES.least * fontSize) return null;
  const restOf = (columns: readonly Column[], digits: number): number =>
    columns.reduce((rest, column) => rest - columnWidth(sum, column, columns, digits, fontSize, texts), room);
  const nameRoom = SIZES.name * fontSize;
  if (width >= SIZES.decimals * fontSize && restOf(ALL, 1) >= nameRoom)
    return { columns: ALL, digits: 1, narrow: false };
  for (let left = 0; left <= DISPENSABLE.length; left++) {
    const columns = ALL.filter((column) => !DISPENSABLE.slice(0, left).includes(column));
    if (sum.rows.some((row) => hasMore(row, columns))) columns.unshift('…');
    const rest = restOf(columns, 0);
    if (rest >= nameRoom) return { columns, digits: 0, narrow: rest < SIZES.note * fontSize };
  }
  return null;
}

function columnWidth(
  { rows, totals }: Sum,
  column: Column,
  columns: readonly Column[],
  digits: number,
  fontSize: number,
  texts: ViewerTexts | null,
): number {
  const cells = rows.map((row) => CONTENTS[column](row, digits, columns));
  if (column === 'sum') cells.push(...totals.map(({ color }) => tripleText(color, digits)));
  // Digits are equally wide, so that few texts have to be measured.
  const words = [titleOf(column, texts), ...new Set(cells.map((text) => text.replace(/\d/g, '0')))];
  return Math.max(...words.map((text) => textWidth(text, fontSize, PLAIN))) + SIZES.gap * fontSize;
}
