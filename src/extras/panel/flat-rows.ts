// The rows of a few attributes, one below the other: the panel of `gui="cutoff theta"`. Each
// attribute has a row for every element that has it; where that is more than one, the row says
// whose it is.
import type { GUI } from 'lil-gui';
import type { PhongLight, PhongMesh, PhongViewer } from '../../viewer/extra.js';
import { sameValue } from '../../phong/fields/field-store.js';
import { type ChildKind, showRows } from './folders.js';
import { nameOwner, relabel } from './label.js';
import { LIGHT_ROWS, LIGHTS } from './light-rows.js';
import { MESH_ROWS, MESHES } from './mesh-rows.js';
import {
  type AddedRow,
  addRows,
  type Editable,
  NO_ROW,
  type RowContext,
  type Rows,
} from './rows.js';
import type { SceneRange } from './travel.js';
import { VIEWER_ROWS } from './viewer-rows.js';
import { attributeOf } from '../../phong/fields/attribute-text.js';

/** An element with the rows that it could have. */
interface Owner extends RowContext<Editable> {
  readonly rows: Rows<never>;
}

/** Returns a function that follows values, and children that come, go or change places. */
export function addFlatRows(
  gui: GUI,
  viewer: PhongViewer,
  range: SceneRange,
  attributes: readonly string[],
): () => void {
  const tables: readonly Rows<never>[] = [LIGHT_ROWS, MESH_ROWS, VIEWER_ROWS];
  for (const attribute of attributes) {
    if (tables.every((rows) => keyOf(rows, attribute) === undefined)) {
      console.warn(`<phong-viewer gui>: the panel has no row for ${attribute}.`);
    }
  }
  let elements: readonly Editable[] = [];
  let titles: readonly string[] = [];
  let added: readonly (readonly [Editable, readonly AddedRow<Editable>[]])[] = [];
  return () => {
    const owners = ownersIn(viewer, range);
    const present = owners.map(({ element }) => element);
    const isNew = !sameValue(present, elements);
    if (isNew) {
      elements = present;
      for (const control of [...gui.controllers]) {
        control.destroy();
      }
      added = attributes.flatMap((attribute) => {
        const having = owners.filter(({ rows }) => keyOf(rows, attribute) !== undefined);
        return having.map(
          (owner) => [owner.element, addRow(gui, owner, attribute, having.length > 1)] as const,
        );
      });
    }
    const now = owners.map((owner) => owner.title());
    if (!isNew && !sameValue(now, titles)) {
      relabel(gui.domElement);
    }
    titles = now;
    for (const [element, rows] of added) {
      showRows(element, rows);
    }
    for (const control of gui.controllers) {
      control.updateDisplay();
    }
  };
}

function ownersIn(viewer: PhongViewer, range: SceneRange): readonly Owner[] {
  const { geometry, src } = viewer;
  const hasSurface = geometry !== null || src !== '';
  const viewerRows = Object.entries(VIEWER_ROWS).filter(
    ([, row]) => row?.folder !== 'Material' || hasSurface,
  );
  const owners = <E extends PhongLight | PhongMesh>({
    rows,
    children,
    title,
  }: ChildKind<E>): Owner[] =>
    children(viewer).map((element, i) => ({
      element,
      viewer,
      range,
      rows,
      title: () => title(element, i, viewer.texts),
    }));
  const own = {
    element: viewer,
    viewer,
    range,
    rows: Object.fromEntries(viewerRows),
    title: () => '',
  };
  return [own, ...owners(LIGHTS), ...owners(MESHES)];
}

const keyOf = (rows: Rows<never>, attribute: string): string | undefined =>
  Object.keys(rows).find((key) => attributeOf(key) === attribute && rows[key] !== NO_ROW);

function addRow(
  gui: GUI,
  owner: Owner,
  attribute: string,
  isOneOfSeveral: boolean,
): readonly AddedRow<Editable>[] {
  const key = keyOf(owner.rows, attribute)!;
  const rows = [...addRows(gui, owner, { [key]: owner.rows[key]! } as Rows<Editable>).values()];
  if (isOneOfSeveral) {
    for (const control of rows.flatMap(({ controls }) => controls)) {
      nameOwner(control, () => owner.title());
    }
  }
  return rows;
}
