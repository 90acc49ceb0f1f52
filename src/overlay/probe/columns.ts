// The columns of a sum, and the shapes that its table can have. "…" stands for terms that are in the sum but have no
// column.
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import { isBlack } from '../../math/color.js';
import { add } from '../../math/vector.js';
import { type Sum, type SumRow, shortNumber, termText } from './sum.js';

const TERMS = ['ambient', 'diffuse', 'specular'] as const;

/** A column after the light's name. */
export type Column = (typeof TERMS)[number] | 'att' | 'decay' | 'sum' | '…';

/** How the table shows a sum. */
export interface TableShape {
  readonly columns: readonly Column[];
  /** Decimals of its codes. */
  readonly digits: number;
  /** Each light's numbers stand below its name. */
  readonly stacked: boolean;
}

/** Several lights as one row, without factors. */
export const addedRow = ([first, ...rest]: readonly SumRow[]): SumRow =>
  rest.reduce(
    (all, { ambient, diffuse, specular, total }) => ({
      ...all,
      ambient: add(all.ambient, ambient),
      diffuse: add(all.diffuse, diffuse),
      specular: add(all.specular, specular),
      total: add(all.total, total),
    }),
    { ...first!, att: NaN, decay: NaN },
  );

/** What is in a cell: numbers, which keep their order in languages that are written from the right. */
export function cellText(
  row: SumRow,
  column: Column,
  { columns, digits }: TableShape,
  texts: ViewerTexts | null,
): string {
  if (column === '…') return TERMS.some((term) => !columns.includes(term) && !isBlack(row[term])) ? column : '';
  if (column === 'sum') return termText(row.total, digits, texts);
  if (column !== 'att' && column !== 'decay') return termText(row[column], digits, texts);
  // 1 for most lights.
  return Number.isNaN(row[column]) ? '' : shortNumber(row[column], row[column] === 1 ? 0 : 2, texts);
}

/** A number that a stacked table leaves out. */
export const isIdle = (row: SumRow, column: Column): boolean =>
  column === 'ambient' ? isBlack(row.ambient) : (column === 'att' || column === 'decay') && row[column] === 1;

export const columnTitle = (column: Column, texts: ViewerTexts | null): string =>
  column === '…' ? column : phrase(texts, column);

/** The first one is left out first. */
const DISPENSABLE: readonly Column[] = ['decay', 'att', 'ambient', 'specular', 'diffuse'];

/** All columns but the first `left` of the dispensable ones. `factors`: att and decay belong to the terms. */
export function columnsOf({ rows }: Sum, left: number, factors: boolean): readonly Column[] {
  const all: readonly Column[] = [...TERMS, ...(factors ? (['att', 'decay'] as const) : []), 'sum'];
  const columns = all.filter((column) => !DISPENSABLE.slice(0, left).includes(column));
  const hasMore = TERMS.some((term) => !columns.includes(term) && rows.some((row) => !isBlack(row[term])));
  return hasMore ? ['…', ...columns] : columns;
}

/** The number of columns left out with ambient. */
export const NO_AMBIENT = DISPENSABLE.indexOf('ambient') + 1;

export const MOST_LEFT = DISPENSABLE.length;
