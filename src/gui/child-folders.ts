// The folders of the child elements: one per child, in document order. A folder keeps its state while children are
// added, removed and reordered.
import type { GUI } from 'lil-gui';
import type { PhongLight } from '../element/phong-light.js';
import type { PhongMesh } from '../element/phong-mesh.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import type { ChildEditor } from './child-editor.js';
import { Folder } from './folder.js';
import type { Rows } from './rows.js';
import type { SceneRange } from './scene-range.js';

export abstract class ChildFolder<E extends PhongLight | PhongMesh> {
  readonly folder: Folder<E>;
  protected readonly element: E;
  protected readonly viewer: PhongViewer;
  #title = '';

  constructor(group: GUI, element: E, viewer: PhongViewer, range: SceneRange, rows: Rows<E>, editor: ChildEditor<E>) {
    this.element = element;
    this.viewer = viewer;
    const place = { element, viewer, range, title: () => this.#title };
    this.folder = new Folder(group, null, place, rows, (gui) => editor.addButtons(gui, element));
    editor.listenToKeys(this.folder, element);
  }

  /** Refreshes title and rows. `index`: position among the children, from 0. */
  update(index: number): void {
    const title = this.titleAt(index);
    if (title !== this.#title) this.showTitle(title);
    this.folder.update();
  }

  /** The element's name, or what stands for it, in the page's words. */
  protected abstract titleAt(index: number): string;

  protected showTitle(title: string): void {
    this.#title = title;
    this.folder.gui.title(title);
  }
}

export class ChildFolders<E extends PhongLight | PhongMesh> {
  readonly #group: GUI;
  readonly #make: (element: E) => ChildFolder<E>;
  readonly #folders = new Map<E, ChildFolder<E>>();

  constructor(group: GUI, make: (element: E) => ChildFolder<E>) {
    this.#group = group;
    this.#make = make;
  }

  folderOf(element: E): Folder<E> | undefined {
    return this.#folders.get(element)?.folder;
  }

  /** Adds, removes and reorders folders to match these children, and refreshes all of them. */
  update(elements: readonly E[]): void {
    const { domElement, $title } = this.#group;
    const { activeElement } = domElement.getRootNode() as ShadowRoot;
    const focused = domElement.contains(activeElement) ? (activeElement as HTMLElement) : null;
    this.#arrange(elements);
    // A folder that moves or goes drops the focus, and with it the keys for undo.
    if (focused?.matches(':focus') === false) (focused.isConnected ? focused : $title).focus({ preventScroll: true });
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
      const next: Element | null = after === null ? list.querySelector(':scope > .lil-gui') : after.nextElementSibling;
      if (node !== next) list.insertBefore(node, next);
      after = node;
      child.update(index);
    });
  }

  #add(element: E): ChildFolder<E> {
    const child = this.#make(element);
    this.#folders.set(element, child);
    return child;
  }
}
