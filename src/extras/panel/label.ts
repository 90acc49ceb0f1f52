// The panel's texts, which follow `viewer.texts`: an element that shows one keeps the function that
// writes it.
import type { Controller } from 'lil-gui';
import { type PhongViewer, phrase, type ViewerText } from '../../viewer/extra.js';

/** A text in the page's words, with values in place of the words in braces. */
export type Say = (text: ViewerText, values?: Readonly<Record<string, string>>) => string;

const writers = new WeakMap<Element, (say: Say) => void>();

/**
 * `write` shows the text of `element`: now and whenever the texts change. An element has one such
 * function.
 */
export function label(element: Element, write: (say: Say) => void): void {
  writers.set(element, write);
  write(sayIn(element));
}

/** Writes only what changes: screen readers may read again what is written. */
export function show(element: Element, text: string): void {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}

/** Names a row. Returns it. */
export function nameRow<Row extends Controller>(row: Row, name: ViewerText): Row {
  label(row.$name, (say) => row.name(say(name)));
  return row;
}

export function explain(element: HTMLElement, text: ViewerText): void {
  label(element, (say) => (element.title = say(text)));
}

/** Names the attribute that a row edits, in its tooltip and before a hint. */
export function nameAttribute(row: HTMLElement, attribute: string): void {
  const hint = writers.get(row);
  label(row, (say) => {
    row.title = '';
    hint?.(say);
    row.title = row.title === '' ? attribute : `${attribute}: ${row.title}`;
  });
}

/** Says before a row's name whose value it is. */
export function nameOwner(row: Controller, title: () => string): void {
  const name = writers.get(row.$name);
  label(row.$name, (say) => {
    name?.(say);
    row.name(`${title()}: ${row.$name.textContent}`);
  });
}

/** The viewer's texts have changed. */
export function relabel(panel: Element): void {
  const say = sayIn(panel);
  for (const element of [panel, ...panel.querySelectorAll('*')]) {
    writers.get(element)?.(say);
  }
}

function sayIn(panel: Element): Say {
  const root = panel.getRootNode();
  // Where a wait ends after the panel has gone, there is no host.
  const texts = 'host' in root ? (root as { host: PhongViewer }).host.texts : null;
  return (text, values) => phrase(texts, text, values);
}
