// When are a folder's rows built and refreshed? Built when the folder is first opened, refreshed only while they are visible.
// Opens without animation, so no frame is requested. Knows nothing about what its rows show.
import type { GUI } from 'lil-gui';
import type { ViewerText } from '../element/fields/text-list.js';
import { label } from './label.js';
import { type Edit, refresh, type Rows } from './rows.js';

/** Builds the rows. Returns a function to call before each refresh, if one is needed. */
export type BuildRows = (rows: Rows) => (() => void) | undefined;

export class Folder {
  readonly gui: GUI;
  readonly #edit: Edit;
  readonly #build: BuildRows;
  #prepare: (() => void) | undefined;
  #built = false;
  #stale = true;

  /** Starts closed. `title`: null if the caller writes it. `edit`: how its rows write. */
  constructor(parent: GUI, title: ViewerText | null, edit: Edit, build: BuildRows) {
    this.gui = addGroup(parent, title).close();
    this.#edit = edit;
    this.#build = build;
  }

  /** Marks the rows as outdated and refreshes them if they are visible. */
  update(): void {
    this.#stale = true;
    this.refreshVisible();
  }

  /** Refreshes outdated rows if they are visible. To be called whenever a folder around it opens. */
  refreshVisible(): void {
    if (!this.#stale || !isVisible(this.gui)) return;
    this.#stale = false;
    if (!this.#built) {
      this.#built = true;
      this.#prepare = this.#build({ gui: this.gui, edit: this.#edit });
    }
    this.#prepare?.();
    for (const row of this.gui.controllers) refresh(row);
  }
}

/** A folder of folders. Starts open. `title`: null if the caller writes it. */
export function addGroup(parent: GUI, title: ViewerText | null): GUI {
  const gui = withoutAnimation(parent.addFolder(''));
  if (title !== null) label(gui.$title, (say) => gui.title(say(title)));
  return gui;
}

/** Makes a GUI open and close without animation. */
export function withoutAnimation(gui: GUI): GUI {
  gui.openAnimated = (open = true) => gui.open(open);
  return gui;
}

const isVisible = (gui: GUI | undefined): boolean =>
  gui === undefined || (!gui._closed && !gui._hidden && isVisible(gui.parent));
