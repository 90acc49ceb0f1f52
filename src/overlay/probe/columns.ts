// The columns of a sum, and the shapes that its table can have. "…" stands for terms that are in the sum but have no
// column.
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import { isBlack } from '../../light/light-features.js';
import { add, type Vec3 } from '../../math/vector.js';
import { type Sum, type SumRow, numberText, termText } from './sum.js';

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

/** What a row has in its columns. */
export type Cells = Pick<SumRow, (typeof TERMS)[number] | 'total'> & {
  /** Null for several lights. */
  readonly factors: Readonly<Record<'att' | 'decay', number>> | null;
};

export const cellsOf = ({ ambient, diffuse, specular, total, att, decay }: SumRow): Cells => ({
  ...{ ambient, diffuse, specular, total },
  factors: { att, decay },
});

/** Several lights as one row. */
export const addedCells = (rows: readonly SumRow[]): Cells => {
  const sum = (key: Exclude<keyof Cells, 'factors'>): Vec3 =>
    rows.reduce<Vec3>((all, row) => add(all, row[key]), [0, 0, 0]);
  return {
    ambient: sum('ambient'),
    diffuse: sum('diffuse'),
    specular: sum('specular'),
    total: sum('total'),
    factors: null,
  };
};

/** What is in a cell: numbers, which keep their order in languages that are written from the right. */
export function cellText(
  cells: Cells,
  column: Column,
  { columns, digits }: TableShape,
  texts: ViewerTexts | null,
): string {
  if (column === '…')
    return TERMS.some((term) => !columns.includes(term) && !isBlack(cells[term])) ? column : '';
  if (column === 'sum') return termText(cells.total, digits, texts);
  if (column !== 'att' && column !== 'decay') return termText(cells[column], digits, texts);
  const factor = cells.factors?.[column];
  // 1 for most lights.
  return factor === undefined ? '' : numberText(factor, factor === 1 ? 0 : 2, texts);
}

/** A number that a stacked table leaves out. */
export const isIdle = (cells: Cells, column: Column): boolean =>
  column === 'ambient'
    ? isBlack(cells.ambient)
    : (column === 'att' || column === 'decay') && (cells.factors?.[column] ?? 1) === 1;

export const titleOf = (column: Column, texts: ViewerTexts | null): string =>
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
