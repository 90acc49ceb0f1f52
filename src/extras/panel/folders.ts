// The folders of the panel. Rows are built when their folder is first opened, and refreshed only
// while they are visible.
import type { GUI } from 'lil-gui';
import {
  fieldsOf,
  historyOf,
  type PhongLight,
  type PhongMesh,
  type PhongViewer,
  type ViewerText,
  type ViewerTexts,
} from '../../viewer/extra.js';
import { ButtonRow } from './button-row.js';
import { label } from './label.js';
import { type AddedRow, addRows, type Editable, type RowContext, type Rows } from './rows.js';
import type { SceneRange } from './travel.js';

export class Folder<E extends Editable> {
  readonly gui: GUI;
  readonly #place: RowContext<E>;
  readonly #table: Rows<E>;
  readonly #built: (gui: GUI) => void;
  #rows: ReadonlyMap<string, AddedRow<E>> | null = null;
  #stale = true;

  /**
   * Starts closed. `title`: null if the caller writes it. `built`: adds what stands below the
   * table's rows.
   */
  constructor(
    parent: GUI,
    title: ViewerText | null,
    place: RowContext<E>,
    table: Rows<E>,
    built: (gui: GUI) => void = () => undefined,
  ) {
    this.gui = addFolder(parent, title).close();
    this.#place = place;
    this.#table = table;
    this.#built = built;
  }

  /** Marks the rows as outdated and refreshes them if they are visible. */
  update(): void {
    this.#stale = true;
    this.refreshVisible();
  }

  /**
   * Refreshes outdated rows if they are visible. To be called whenever a folder around it opens.
   */
  refreshVisible(): void {
    if (!this.#stale || this.gui.domElement.closest('.lil-closed') !== null) return;
    this.#stale = false;
    if (this.#rows === null) {
      this.#rows = addRows(this.gui, this.#place, this.#table);
      this.#built(this.gui);
    }
    showRows(this.#place.element, [...this.#rows.values()]);
    for (const control of this.gui.controllers) {
      control.updateDisplay();
    }
  }

  open(): void {
    this.gui.open();
    this.refreshVisible();
  }

  /** Opens the folder and puts the focus into a field's row. */
  edit(field: string): void {
    this.open();
    const [control] = this.#rows?.get(field)?.controls ?? [];
    control?.domElement.querySelector('input')?.focus();
  }
}

/**
 * Shows the rows whose condition holds. One stays while it, or a row under the same condition, is
 * being edited.
 */
export function showRows<E>(element: E, rows: readonly AddedRow<E>[]): void {
  for (const { row, controls } of rows) {
    const { shown } = row;
    if (shown === undefined) continue;
    const together = rows
      .filter((other) => other.row.shown === shown)
      .flatMap((other) => other.controls);
    const visible =
      shown(element) || together.some(({ domElement }) => domElement.matches(':focus-within'));
    for (const control of controls) {
      control.show(visible);
    }
  }
}

/** Opens without animation. `title`: null if the caller writes it. */
function addFolder(parent: GUI, title: ViewerText | null): GUI {
  const gui = withoutAnimation(parent.addFolder(''));
  if (title !== null) {
    label(gui.$title, (say) => gui.title(say(title)));
  }
  return gui;
}

/** Without animation, a GUI requests no frame. */
export function withoutAnimation(gui: GUI): GUI {
  gui.openAnimated = (open = true) => gui.open(open);
  return gui;
}

/** What the folders of lights and those of meshes differ in. */
export interface ChildKind<E> {
  readonly rows: Rows<E>;
  readonly children: (viewer: PhongViewer) => readonly E[];
  /**
   * The element's name, or what stands for it, in the page's words. `index`: position among the
   * children, from 0.
   */
  readonly title: (element: E, index: number, texts: ViewerTexts | null) => string;
  /** Adds a switch beside the folder's title. */
  readonly addSwitch?: (gui: GUI, element: E, viewer: PhongViewer) => TitleSwitch;
}

export interface TitleSwitch {
  update(): void;
  /** The folder has another title. */
  rename(title: string): void;
}

interface ChildFolder<E> {
  readonly folder: Folder<E & (PhongLight | PhongMesh)>;
  readonly toggle: TitleSwitch | undefined;
  title: string;
}

/**
 * The folders of the lights or of the meshes: one per child, in document order, which keeps its
 * state while children change. Each change is one step that can be undone. The focus follows the
 * child.
 */
export class ChildFolders<E extends PhongLight | PhongMesh> {
  readonly group: GUI;
  readonly #viewer: PhongViewer;
  readonly #range: SceneRange;
  readonly #kind: ChildKind<E>;
  readonly #folders = new Map<E, ChildFolder<E>>();

  constructor(
    parent: GUI,
    title: ViewerText,
    viewer: PhongViewer,
    range: SceneRange,
    kind: ChildKind<E>,
  ) {
    this.group = addFolder(parent, title);
    this.#viewer = viewer;
    this.#range = range;
    this.#kind = kind;
  }

  /** Adds, removes and reorders folders to match the children, and refreshes all of them. */
  update(): void {
    const { domElement, $title } = this.group;
    const { activeElement } = domElement.getRootNode() as ShadowRoot;
    const focused = domElement.contains(activeElement) ? (activeElement as HTMLElement) : null;
    this.#arrange(this.#children);
    // A folder that moves or goes drops the focus, and with it the keys for undo.
    if (focused?.matches(':focus') === false) {
      focus(focused.isConnected ? focused : $title);
    }
  }

  refreshVisible(): void {
    for (const { folder } of this.#folders.values()) {
      folder.refreshVisible();
    }
  }

  /** Adds a child, opens its folder and scrolls to it. */
  add(child: E, insert: (child: E) => void): void {
    this.#edit(() => insert(child));
    const folder = this.#folders.get(child)?.folder;
    if (folder === undefined) return;
    folder.open();
    focus(folder.gui.$title);
    const list = folder.gui.root.$children;
    list.scrollTop +=
      folder.gui.domElement.getBoundingClientRect().top - list.getBoundingClientRect().top;
  }

  get #children(): readonly E[] {
    return this.#kind.children(this.#viewer);
  }

  #arrange(elements: readonly E[]): void {
    const present = new Set(elements);
    for (const [element, { folder }] of this.#folders) {
      if (present.has(element)) continue;
      this.#folders.delete(element);
      folder.gui.destroy();
    }
    const list = this.group.$children;
    let after: Element | null = null;
    elements.forEach((element, index) => {
      const child = this.#folders.get(element) ?? this.#addFolder(element);
      const node = child.folder.gui.domElement;
      const next: Element | null =
        after === null ? list.querySelector(':scope > .lil-gui') : after.nextElementSibling;
      if (node !== next) {
        list.insertBefore(node, next);
      }
      after = node;
      const title = this.#kind.title(element, index, this.#viewer.texts);
      if (title !== child.title) {
        child.title = title;
        child.folder.gui.title(title);
        child.toggle?.rename(title);
      }
      child.toggle?.update();
      child.folder.update();
    });
  }

  #addFolder(element: E): ChildFolder<E> {
    const { rows, addSwitch } = this.#kind;
    const viewer = this.#viewer;
    const place = { element, viewer, range: this.#range, title: () => child.title };
    const folder = new Folder(this.group, null, place, rows, (gui) =>
      this.#addButtons(gui, element),
    );
    const child: ChildFolder<E> = {
      folder,
      toggle: addSwitch?.(folder.gui, element, viewer),
      title: '',
    };
    const { $title } = folder.gui;
    $title.setAttribute('aria-keyshortcuts', 'Alt+ArrowUp Alt+ArrowDown Delete F2');
    $title.addEventListener('keydown', (event) => {
      const { key, altKey } = event;
      if (altKey && (key === 'ArrowUp' || key === 'ArrowDown')) {
        this.#move(element, key === 'ArrowUp' ? -1 : 1);
      } else if (key === 'Delete') {
        this.#remove(element);
      } else if (key === 'F2') {
        folder.edit('name');
      } else {
        return;
      }
      event.preventDefault();
    });
    this.#folders.set(element, child);
    return child;
  }

  #addButtons(gui: GUI, child: E): void {
    const row = new ButtonRow(gui, 'Order and copies');
    row.addSymbol('↑', 'move up', () => this.#move(child, -1));
    row.addSymbol('↓', 'move down', () => this.#move(child, 1));
    row.add('duplicate', () =>
      this.add(copyOf(child, this.#children), (copy) => child.after(copy)),
    );
    row.add('remove', () => this.#remove(child));
  }

  /** Removes a child and moves the focus to the next one's title, or to the last one's. */
  #remove(child: E): void {
    const at = this.#children.indexOf(child);
    this.#edit(() => {
      unnest(child);
      child.remove();
    });
    const children = this.#children;
    const next = children[at] ?? children.at(-1);
    const gui = next === undefined ? this.group : this.#folders.get(next)?.folder.gui;
    if (gui !== undefined) {
      focus(gui.$title);
    }
  }

  /** Before the previous child, or after the next one, wherever that is. */
  #move(child: E, by: -1 | 1): void {
    const children = this.#children;
    const neighbour = children[children.indexOf(child) + by];
    if (neighbour === undefined) return;
    this.#edit(() => {
      for (const element of [child, neighbour]) {
        unnest(element);
      }
      if (by < 0) {
        neighbour.before(child);
      } else {
        neighbour.after(child);
      }
    });
  }

  #edit(write: () => void): void {
    const history = historyOf(this.#viewer);
    history.edit(history.children, write);
    this.update();
  }
}

const focus = (element: HTMLElement): void => element.focus({ preventScroll: true });

/** HTML nests self-closed tags in one another. Moves the children of an element behind it. */
const unnest = (element: HTMLElement): void => element.after(...element.children);

/**
 * A copy with the values as they are now and a name of its own: `lamp 2` for a copy of `lamp`, or
 * the next free number.
 */
function copyOf<E extends PhongLight | PhongMesh>(original: E, siblings: readonly E[]): E {
  const copy = original.cloneNode(false) as E;
  copy.removeAttribute('id');
  const from = fieldsOf(original as PhongMesh).store;
  const to = fieldsOf(copy as PhongMesh);
  for (const key of Object.keys(from.fields) as (keyof typeof from.values)[]) {
    to.set(key, from.given(key) ? from.values[key] : null);
  }
  const { name } = from.values;
  if (name === '') return copy;
  const taken = siblings.map((sibling) => sibling.name);
  const stem = name.replace(/ \d+$/, '');
  let number = 2;
  while (taken.includes(`${stem} ${String(number)}`)) {
    number++;
  }
  copy.name = `${stem} ${String(number)}`;
  return copy;
}
