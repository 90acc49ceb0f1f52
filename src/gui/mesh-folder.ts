// How does the user edit a surface? A folder for the viewer's own mesh and one for each mesh child, with its transform. Colours
// 255 = 1, degrees, scene units. Knows neither lights nor camera.
import type { GUI } from 'lil-gui';
import type { ViewerText } from '../element/fields/text-list.js';
import { fieldsOf } from '../element/internals.js';
import type { PhongMesh } from '../element/phong-mesh.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { meshTitle } from '../element/viewer/description.js';
import type { SurfaceValues } from '../material/material-values.js';
import { type Reflection, REFLECTIONS, type Shading, SHADINGS } from '../material/shading-style.js';
import { historyOf, valuesOf } from '../element/viewer/history.js';
import type { ChildEditor } from './child-editor.js';
import type { ChildFolder } from './child-folders.js';
import { Folder } from './folder.js';
import { ButtonRow } from './button-row.js';
import { label } from './label.js';
import { chooseModel } from './model-choice.js';
import {
  addButton,
  addChoice,
  addColor,
  addNumber,
  addText,
  addVector,
  type Edit,
  named,
  type Rows,
} from './rows.js';
import type { SceneRange } from './scene-range.js';
import type { TextControl } from './text-control.js';
import { linear, logarithmic } from './travel.js';
import { AXES } from './vector-control.js';

const AS_VIEWER = 'as viewer' satisfies ViewerText;

/** The surface of the viewer's own `src` or `geometry`; hidden if it has neither. */
export function ownSurfaceFolder(
  root: GUI,
  viewer: PhongViewer,
  edit: Edit,
): { update(): void; readonly folder: Folder } {
  const folder = new Folder(root, 'Material', edit, (rows) => {
    addSurface(rows, viewer, (key) => {
      fieldsOf(viewer).set(key, null);
    });
    return undefined;
  });
  return {
    folder,
    update() {
      folder.gui.show(viewer.geometry !== null || viewer.src !== '');
      folder.update();
    },
  };
}

export class MeshFolder implements ChildFolder {
  readonly folder: Folder;
  readonly #mesh: PhongMesh;
  readonly #viewer: PhongViewer;
  #title = '';
  #index = 0;
  #nameRow: TextControl | null = null;

  constructor(
    group: GUI,
    mesh: PhongMesh,
    viewer: PhongViewer,
    range: SceneRange,
    editor: ChildEditor<PhongMesh>,
  ) {
    this.#mesh = mesh;
    this.#viewer = viewer;
    const history = historyOf(viewer);
    const edit: Edit = (write, gesture) => {
      history.edit(valuesOf(mesh), write, gesture);
    };
    this.folder = new Folder(group, null, edit, (rows) => {
      const name = addText(
        rows,
        'name',
        () => mesh.name,
        (text) => (mesh.name = text),
      );
      this.#nameRow = name;
      addModel(rows, mesh);
      addSurface(rows, mesh, (key) => {
        fieldsOf(mesh).set(key, null);
      });
      addStyle(rows, mesh);
      const refreshRanges = addTransform(rows, mesh, range);
      editor.addButtons(rows.gui, mesh);
      return () => {
        this.#showTitle();
        refreshRanges();
      };
    });
    label(this.folder.gui.$title, () => {
      this.#showTitle();
    });
    editor.listenToKeys(this.folder, mesh, () => {
      this.folder.gui.open();
      this.#nameRow?.input.focus();
    });
  }

  update(index: number): void {
    this.#index = index;
    this.#showTitle();
    this.folder.update();
  }

  #showTitle(): void {
    const title = meshTitle(this.#viewer.texts, this.#mesh, this.#index);
    if (title !== this.#title) this.folder.gui.title((this.#title = title));
    if (this.#nameRow !== null) this.#nameRow.input.placeholder = title;
  }
}

/** A button that shows a file of the user's instead of the mesh's model or shape. */
function addModel({ gui, edit }: Rows, mesh: PhongMesh): void {
  new ButtonRow(gui, 'Model').add('choose model file…', () => {
    chooseModel((file) => {
      edit(() => (mesh.src = file), null);
    });
  });
}

/** `restore` returns a value to its default; for a model, to the one in its file. */
function addSurface(rows: Rows, surface: SurfaceValues, restore: (key: keyof SurfaceValues) => void): void {
  for (const key of ['ka', 'kd', 'ks'] as const) {
    addColor(
      rows,
      key,
      1,
      () => surface[key],
      (color) => (surface[key] = color),
    );
  }
  addNumber(
    rows,
    'shininess',
    logarithmic(1, 1e6),
    () => surface.shininess,
    (shininess) => (surface.shininess = shininess),
  );
  addButton(rows.gui, 'reset material', () => {
    rows.edit(() => {
      for (const key of ['ka', 'kd', 'ks', 'shininess'] as const) restore(key);
    }, null);
  });
}

function addStyle(rows: Rows, mesh: PhongMesh): void {
  addChoice<Shading | null>(
    rows,
    'shading',
    { [AS_VIEWER]: null, ...named(SHADINGS) },
    () => mesh.shading,
    (shading) => (mesh.shading = shading),
  );
  addChoice<Reflection | null>(
    rows,
    'reflection',
    { [AS_VIEWER]: null, ...named(REFLECTIONS) },
    () => mesh.reflection,
    (reflection) => (mesh.reflection = reflection),
  );
}

function addTransform(rows: Rows, mesh: PhongMesh, range: SceneRange): () => void {
  const position = addVector(
    rows,
    'position',
    AXES,
    (axis) => range.place(axis),
    () => mesh.position,
    (place) => (mesh.position = place),
  );
  addVector(
    rows,
    'rotation °',
    AXES,
    () => linear(-180, 180, 1),
    () => mesh.rotation,
    (rotation) => (mesh.rotation = rotation),
  );
  addVector(
    rows,
    'scale',
    AXES,
    () => linear(0, 4, 0.02),
    () => mesh.scale,
    (scale) => (mesh.scale = scale),
  );
  return () => {
    position.travel = (axis) => range.place(axis);
  };
}
