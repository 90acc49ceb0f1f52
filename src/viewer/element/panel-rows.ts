// The rows of the panel that other extras bring. The panel gives the functions that make rows: extras
// do not import each other.
import type { ExtraCode } from '../model/provided-code.js';
import type { PhongViewer } from './elements.js';
import type { ViewerText } from './fields/texts.js';
import type { ViewerValues } from './fields/viewer-fields.js';

/** How a value is edited. */
interface PanelRow<T> {
  readonly add: (folder: never, place: never, value: { value: T }) => void;
}

/** A text in the page's words, with values in place of the words in braces. */
type Say = (text: ViewerText, values?: Readonly<Record<string, string>>) => string;

/** What makes rows. */
interface RowKit {
  readonly flag: (label: ViewerText) => PanelRow<boolean>;
  /** A flag for each word that the field can list. */
  readonly flags: <T extends string>(
    words: readonly T[],
    label: (word: T) => ViewerText,
  ) => PanelRow<readonly T[]>;
  /** One of several words. */
  readonly oneOf: <T extends ViewerText>(label: ViewerText, words: readonly T[]) => PanelRow<T>;
  /** One of the names that `values` lists, which depend on the scene. */
  readonly oneName: (
    label: ViewerText,
    values: (viewer: PhongViewer) => readonly string[],
    textOf: (name: string, viewer: PhongViewer, say: Say) => string,
  ) => PanelRow<string>;
}

/**
 * The viewer's values whose rows extras bring. One that no extra brings fails in Node; the panel has
 * a row or `NO_ROW` for all others, or does not compile.
 */
type Brought = 'view' | 'viewLight' | 'helpers' | 'probe';

/** Rows of the folder *Show*, by their fields. */
export type ExtraRows = (kit: RowKit) => {
  readonly [K in Brought]?: PanelRow<ViewerValues[K]>;
};

/** Filled by the table of extras. */
export const panelRows: (() => Promise<{ readonly rows: ExtraRows }>)[] = [];

/** Code that shows rows, with those that extras bring. */
export async function withRows<Code extends { takeRows(rows: ExtraRows): void }>(
  code: ExtraCode<Code>,
): Promise<Code> {
  const [panel, ...brought] = await Promise.all([code(), ...panelRows.map((load) => load())]);
  for (const { rows } of brought) {
    panel.takeRows(rows);
  }
  return panel;
}
