// A folder that builds its rows when it is first opened and brings them in step only while they can be seen. Opens at once:
// nothing moves, and no frame is asked for. Knows nothing of what its rows are about.
import type { GUI } from 'lil-gui';
import { refresh } from './rows.js';

/** Builds the rows; gives what has to be done before they are brought in step, if anything. */
export type BuildRows = (gui: GUI) => (() => void) | undefined;

export class Folder {
  readonly gui: GUI;
  readonly #build: BuildRows;
  #prepare: (() => void) | undefined;
  #built = false;
  #stale = true;

  /** Closed at first. */
  constructor(parent: GUI, title: string, build: BuildRows) {
    this.gui = addGroup(parent, title).close();
    this.#build = build;
  }

  /** Something has changed that rows may show. */
  update(): void {
    this.#stale = true;
    this.settle();
  }

  /** Does what has to be done now that it can be seen: to be called whenever any folder around it opens. */
  settle(): void {
    if (!this.#stale || !isShown(this.gui)) return;
    this.#stale = false;
    if (!this.#built) {
      this.#built = true;
      this.#prepare = this.#build(this.gui);
    }
    this.#prepare?.();
    for (const row of this.gui.controllers) refresh(row);
  }
}

/** A folder of folders. Open at first. */
export const addGroup = (parent: GUI, title: string): GUI => atOnce(parent.addFolder(title));

/** Makes a GUI open and close without animation. */
export function atOnce(gui: GUI): GUI {
  gui.openAnimated = (open = true) => gui.open(open);
  return gui;
}

const isShown = (gui: GUI | undefined): boolean =>
  gui === undefined || (!gui._closed && !gui._hidden && isShown(gui.parent));
