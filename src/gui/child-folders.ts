// One folder per child element, in the children's order, kept as they are while children come, go and move. Knows
// nothing of what the children are.
import type { GUI } from 'lil-gui';
import type { Folder } from './folder.js';

export interface ChildFolder {
  readonly folder: Folder;
  /** Brings title and rows in step; `index` counts the children from 0. */
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

  /** Makes these the children and brings every folder in step. */
  update(elements: readonly E[]): void {
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

  settle(): void {
    for (const { folder } of this.#folders.values()) folder.settle();
  }

  #add(element: E): ChildFolder {
    const child = this.#make(element);
    this.#folders.set(element, child);
    return child;
  }
}
