// Adds, duplicates, reorders and removes children. Each is one step that can be undone. The focus follows the child.
import type { GUI } from 'lil-gui';
import { fieldsOf } from '../element/internals.js';
import type { PhongLight } from '../element/phong-light.js';
import type { PhongMesh } from '../element/phong-mesh.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { childrenOf, historyOf } from '../element/viewer/history.js';
import { ButtonRow } from './button-row.js';
import type { ChildFolders } from './child-folders.js';
import type { Folder } from './folder.js';

export class ChildEditor<E extends PhongLight | PhongMesh> {
  readonly #viewer: PhongViewer;
  readonly #group: GUI;
  readonly #folders: ChildFolders<E>;
  readonly #children: () => readonly E[];

  constructor(viewer: PhongViewer, group: GUI, folders: ChildFolders<E>, children: () => readonly E[]) {
    this.#viewer = viewer;
    this.#group = group;
    this.#folders = folders;
    this.#children = children;
  }

  /** Buttons in the child's folder. */
  addButtons(gui: GUI, child: E): void {
    const row = new ButtonRow(gui, 'Order and copies');
    row.addSymbol('↑', 'move up', () => this.#move(child, -1));
    row.addSymbol('↓', 'move down', () => this.#move(child, 1));
    row.add('duplicate', () => this.add(copyOf(child, this.#children()), (copy) => child.after(copy)));
    row.add('remove', () => this.#remove(child));
  }

  /** Keys on the child's title. */
  listenToKeys(folder: Folder<E>, child: E): void {
    const title = folder.gui.$title;
    title.setAttribute('aria-keyshortcuts', 'Alt+ArrowUp Alt+ArrowDown Delete F2');
    title.addEventListener('keydown', (event) => {
      const { key, altKey } = event;
      if (altKey && (key === 'ArrowUp' || key === 'ArrowDown')) this.#move(child, key === 'ArrowUp' ? -1 : 1);
      else if (key === 'Delete') this.#remove(child);
      else if (key === 'F2') folder.edit('name');
      else return;
      event.preventDefault();
    });
  }

  /** Adds a child, opens its folder and scrolls to it. */
  add(child: E, insert: (child: E) => void): void {
    this.#edit(() => insert(child));
    const folder = this.#folders.folderOf(child);
    if (folder === undefined) return;
    folder.open();
    focus(folder.gui.$title);
    const list = folder.gui.root.$children;
    list.scrollTop += folder.gui.domElement.getBoundingClientRect().top - list.getBoundingClientRect().top;
  }

  /** Removes a child and moves the focus to the next one's title, or to the last one's. */
  #remove(child: E): void {
    const at = this.#children().indexOf(child);
    this.#edit(() => {
      unnest(child);
      child.remove();
    });
    const children = this.#children();
    const next = children[at] ?? children.at(-1);
    const folder = next === undefined ? this.#group : this.#folders.folderOf(next)?.gui;
    if (folder !== undefined) focus(folder.$title);
  }

  /** Before the previous child, or after the next one, wherever that is. */
  #move(child: E, by: -1 | 1): void {
    const children = this.#children();
    const neighbour = children[children.indexOf(child) + by];
    if (neighbour === undefined) return;
    this.#edit(() => {
      for (const element of [child, neighbour]) unnest(element);
      if (by < 0) neighbour.before(child);
      else neighbour.after(child);
    });
  }

  #edit(write: () => void): void {
    historyOf(this.#viewer).edit(childrenOf(this.#viewer), write);
    this.#folders.update(this.#children());
  }
}

const focus = (element: HTMLElement): void => element.focus({ preventScroll: true });

/** HTML nests self-closed tags in one another. Moves the children of an element behind it. */
function unnest(element: HTMLElement): void {
  element.after(...element.children);
}

/** A copy with the values as they are now and a name of its own. */
function copyOf<E extends PhongLight | PhongMesh>(original: E, siblings: readonly E[]): E {
  const copy = original.cloneNode(false) as E;
  copy.removeAttribute('id');
  const from = fieldsOf(original as PhongMesh).store;
  const to = fieldsOf(copy as PhongMesh);
  for (const key of Object.keys(from.fields) as (keyof typeof from.values)[])
    to.set(key, from.given(key) ? from.values[key] : null);
  const { name } = from.values;
  if (name !== '') copy.name = freeName(name, new Set(siblings.map((sibling) => sibling.name)));
  return copy;
}

/** `lamp 2` for a copy of `lamp`, or the next free number. */
function freeName(name: string, taken: ReadonlySet<string>): string {
  const stem = name.replace(/ \d+$/, '');
  let number = 2;
  while (taken.has(`${stem} ${String(number)}`)) number++;
  return `${stem} ${String(number)}`;
}
