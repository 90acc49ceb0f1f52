// Which folders do the child elements have? One per child, in document order. A folder keeps its state while children are added,
// removed and reordered. Knows nothing about what the children are.
import type { GUI } from 'lil-gui';
import type { Folder } from './folder.js';

export interface ChildFolder {
  readonly folder: Folder;
  /** Refreshes title and rows. `index`: position among the children, from 0. */
  update(index: number): void;
}

export class ChildFolders<E extends HTMLElement> {
  readonly #group: GUI;
  readonly #make: (element: E) => ChildFolder;
  readonly #folders = new Map<E, ChildFolder>();

  constructor(group: GUI, make: (element: E) => ChildFolder) {
    this.#group = group;
    this.#make = make;
  }

  folderOf(element: E): Folder | undefined {
    return this.#folders.get(element)?.folder;
  }

  /** Adds, removes and reorders folders to match these children, and refreshes all of them. */
  update(elements: readonly E[]): void {
    const { domElement, $title } = this.#group;
    const { activeElement } = domElement.getRootNode() as ShadowRoot;
    const focused = domElement.contains(activeElement) ? (activeElement as HTMLElement) : null;
    this.#arrange(elements);
    // A folder that moves or goes drops the focus, and with it the keys for undo.
    if (focused?.matches(':focus') === false)
      (focused.isConnected ? focused : $title).focus({ preventScroll: true });
  }

  refreshVisible(): void {
    for (const { folder } of this.#folders.values()) folder.refreshVisible();
  }

  #arrange(elements: readonly E[]): void {
    const present = new Set(elements);
    for (const [element, { folder }] of this.#folders) {
      if (present.has(element)) continue;
      this.#folders.delete(element);
      folder.gui.destroy();
    }
    const list = this.#group.$children;
    let after: Element | null = null;
    elements.forEach((element, index) => {
      const child = this.#folders.get(element) ?? this.#add(element);
      const node = child.folder.gui.domElement;
      const next: Element | null =
        after === null ? list.querySelector(':scope > .lil-gui') : after.nextElementSibling;
      if (node !== next) list.insertBefore(node, next);
      after = node;
      child.update(index);
    });
  }

  #add(element: E): ChildFolder {
    const child = this.#make(element);
    this.#folders.set(element, child);
    return child;
  }
}
