// The rows of a few attributes, one below the other: the panel of `gui="cutoff theta"`. Each attribute has a row for
// every element that has it; where that is more than one, the row says whose it is.
import type { GUI } from 'lil-gui';
import { attributeOf } from '../element/fields/attribute-text.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { meshTitle } from '../element/viewer/description.js';
import { sameValue } from '../fields/field-store.js';
import { showRows } from './folder.js';
import { nameOwner } from './label.js';
import { LIGHT_ROWS } from './light-folder.js';
import { MESH_ROWS } from './mesh-folder.js';
import { type AddedRow, addRows, type Editable, NO_ROW, type Rows } from './rows.js';
import type { SceneRange } from './scene-range.js';
import { VIEWER_ROWS } from './viewer-folders.js';

/** An element with the rows that it could have. */
interface Owner {
  readonly element: Editable;
  readonly rows: Rows<Editable>;
  readonly title: () => string;
}

interface Added {
  readonly element: Editable;
  readonly rows: readonly AddedRow<Editable>[];
}

export class FlatRows {
  readonly #gui: GUI;
  readonly #viewer: PhongViewer;
  readonly #range: SceneRange;
  readonly #attributes: readonly string[];
  #elements: readonly Editable[] = [];
  #added: readonly Added[] = [];

  constructor(gui: GUI, viewer: PhongViewer, range: SceneRange, attributes: readonly string[]) {
    this.#gui = gui;
    this.#viewer = viewer;
    this.#range = range;
    this.#attributes = attributes;
    const rows = [LIGHT_ROWS, MESH_ROWS, VIEWER_ROWS].flatMap((table: Rows<never>) => Object.entries(table));
    const shown = rows.flatMap(([key, row]) => (row === NO_ROW ? [] : [attributeOf(key)]));
    for (const attribute of attributes)
      if (!shown.includes(attribute)) console.warn(`<phong-viewer gui>: the panel has no row for ${attribute}.`);
  }

  /** Follows values, and children that come, go or change places. */
  update(): void {
    const owners = this.#owners();
    const elements = owners.map(({ element }) => element);
    if (!sameValue(elements, this.#elements)) {
      this.#elements = elements;
      for (const control of [...this.#gui.controllers]) control.destroy();
      this.#added = this.#attributes.flatMap((attribute) => this.#add(attribute, owners));
    }
    for (const { element, rows } of this.#added) showRows(element, rows);
    for (const control of this.#gui.controllers) control.updateDisplay();
  }

  #owners(): readonly Owner[] {
    const viewer = this.#viewer;
    const { lights, meshes, geometry, src } = viewer;
    const viewerRows = Object.entries(VIEWER_ROWS).filter(
      ([, row]) => row?.folder !== 'Material' || geometry !== null || src !== '',
    );
    const lightOwners = lights.map((light) => ({
      element: light,
      rows: LIGHT_ROWS,
      title: () => light.name,
    }));
    const meshOwners = meshes.map((mesh, i) => ({
      element: mesh,
      rows: MESH_ROWS,
      title: () => meshTitle(viewer.texts, mesh, i),
    }));
    const own = { element: viewer, rows: Object.fromEntries(viewerRows), title: () => '' };
    return [own, ...lightOwners, ...meshOwners] as unknown as readonly Owner[];
  }

  #add(attribute: string, owners: readonly Owner[]): readonly Added[] {
    const keyOf = ({ rows }: Owner): string | undefined =>
      Object.keys(rows).find((key) => attributeOf(key) === attribute && rows[key] !== NO_ROW);
    const having = owners.filter((owner) => keyOf(owner) !== undefined);
    return having.map((owner) => {
      const { element, rows, title } = owner;
      const key = keyOf(owner)!;
      const place = { element, viewer: this.#viewer, range: this.#range, title };
      const added = [...addRows(this.#gui, place, { [key]: rows[key]! }).values()];
      if (having.length > 1) for (const control of added.flatMap(({ controls }) => controls)) nameOwner(control, title);
      return { element, rows: added };
    });
  }
}
