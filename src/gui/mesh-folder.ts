// How does the user edit a surface? A folder for the viewer's own mesh and one for each mesh child, with its transform. Colours
// 255 = 1, degrees, scene units. Knows neither lights nor camera.
import type { GUI } from 'lil-gui';
import { fieldsOf } from '../element/internals.js';
import type { PhongMesh } from '../element/phong-mesh.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import type { SurfaceValues } from '../material/material-values.js';
import { type Reflection, REFLECTIONS, type Shading, SHADINGS } from '../material/program/variant.js';
import { fileName } from '../scene/mesh/file-name.js';
import type { ChildFolder } from './child-folders.js';
import { Folder } from './folder.js';
import { addButton, addChoice, addColor, addNumber, addVector, axesOf, named } from './rows.js';
import type { SceneRange } from './scene-range.js';
import { linear, logarithmic } from './travel.js';

const AS_VIEWER = 'as viewer';

/** The surface of the viewer's own `src` or `geometry`; hidden if it has neither. */
export function ownSurfaceFolder(
  root: GUI,
  viewer: PhongViewer,
): { update(): void; readonly folder: Folder } {
  const folder = new Folder(root, 'Material', (gui) => {
    addSurface(gui, viewer, (key) => {
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
  #title = '';

  constructor(group: GUI, mesh: PhongMesh, range: SceneRange) {
    this.#mesh = mesh;
    this.folder = new Folder(group, '', (gui) => {
      addSurface(gui, mesh, (key) => {
        fieldsOf(mesh).set(key, null);
      });
      addStyle(gui, mesh);
      return addTransform(gui, mesh, range);
    });
  }

  update(index: number): void {
    const { name, src, geometry } = this.#mesh;
    const title =
      name ||
      (src === '' ? geometry : fileOf(typeof src === 'string' ? src : fileName(src))) ||
      `mesh ${String(index + 1)}`;
    if (title !== this.#title) this.folder.gui.title((this.#title = title));
    this.folder.update();
  }
}

/** `teapot.glb` from `models/teapot.glb?v=2`. */
const fileOf = (src: string): string => /([^/?#]*)(?:[?#].*)?$/.exec(src)?.[1] ?? '';

/** `restore` returns a value to its default; for a model, to the one in its file. */
function addSurface(gui: GUI, surface: SurfaceValues, restore: (key: keyof SurfaceValues) => void): void {
  for (const key of ['ka', 'kd', 'ks'] as const) {
    addColor(
      gui,
      key,
      1,
      () => surface[key],
      (color) => (surface[key] = color),
    );
  }
  addNumber(
    gui,
    'shininess',
    logarithmic(1, 1e6),
    () => surface.shininess,
    (shininess) => (surface.shininess = shininess),
  );
  addButton(gui, 'reset material', () => {
    for (const key of ['ka', 'kd', 'ks', 'shininess'] as const) restore(key);
  });
}

function addStyle(gui: GUI, mesh: PhongMesh): void {
  addChoice<Shading | null>(
    gui,
    'shading',
    { [AS_VIEWER]: null, ...named(SHADINGS) },
    () => mesh.shading,
    (shading) => (mesh.shading = shading),
  );
  addChoice<Reflection | null>(
    gui,
    'reflection',
    { [AS_VIEWER]: null, ...named(REFLECTIONS) },
    () => mesh.reflection,
    (reflection) => (mesh.reflection = reflection),
  );
}

function addTransform(gui: GUI, mesh: PhongMesh, range: SceneRange): () => void {
  const position = addVector(
    gui,
    axesOf('position'),
    (axis) => range.place(axis),
    () => mesh.position,
    (place) => (mesh.position = place),
  );
  addVector(
    gui,
    ['rotation x °', 'rotation y °', 'rotation z °'],
    () => linear(-180, 180, 1),
    () => mesh.rotation,
    (rotation) => (mesh.rotation = rotation),
  );
  addVector(
    gui,
    axesOf('scale'),
    () => linear(0, 4, 0.02),
    () => mesh.scale,
    (scale) => (mesh.scale = scale),
  );
  return () => {
    position.forEach((row, axis) => {
      row.travel = range.place(axis as 0 | 1 | 2);
    });
  };
}
