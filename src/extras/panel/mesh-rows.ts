// The rows of a mesh. Those of its surface are the rows of the viewer's own surface too.
import type { MeshValues } from '../../phong/model/mesh-fields.js';
import {
  fieldsOf,
  historyOf,
  type PhongMesh,
  type PhongViewer,
  sceneMeshes,
} from '../../viewer/extra.js';
import {
  SURFACE_FIELDS,
  type SurfaceValues,
  REFLECTIONS,
  SHADINGS,
} from '../../phong/material/material-values.js';
import { ButtonRow } from './button-row.js';
import type { ChildKind } from './folders.js';
import { chooseModel } from './files-row.js';
import { meshTitle } from './mesh-title.js';
import {
  button,
  color,
  readout,
  NO_ROW,
  number,
  oneOf,
  type Row,
  type RowTable,
  text,
  vector,
} from './rows.js';
import { linear, logarithmic } from './travel.js';

const modelFile: Row<MeshValues['src'], PhongMesh> = {
  add: (gui, { element: mesh, viewer }) =>
    new ButtonRow(gui, 'Model').add('choose model file…', () =>
      chooseModel(viewer, (file) => historyOf(viewer).edit(mesh, () => (mesh.src = file), file)),
    ),
};

export const SURFACE_ROWS = {
  ka: color('ka', 1),
  kd: color('kd', 1),
  ks: color('ks', 1),
  shininess: number('shininess', logarithmic(1, 1e6)),
  // To the defaults; for a model, to the values in its file.
  resetMaterial: button('reset material', ({ element, viewer }) =>
    historyOf(viewer).edit(element, () => {
      const binding = fieldsOf(element as PhongMesh);
      for (const key of Object.keys(SURFACE_FIELDS) as (keyof SurfaceValues)[]) {
        binding.set(key, null);
      }
    }),
  ),
} satisfies RowTable<SurfaceValues, PhongMesh | PhongViewer, 'resetMaterial'>;

/** Under `auto`: what that gives now. */
export const SEGMENTS_ROW: Row<MeshValues['segments'], PhongMesh | PhongViewer> = {
  ...readout(
    'segments',
    (element: PhongMesh | PhongViewer) => String(sceneMeshes.get(element)?.segments ?? ''),
    true,
  ),
  shown: ({ src, geometry }) => src === '' && geometry !== null,
};

export const MESH_ROWS = {
  name: text('name'),
  src: modelFile,
  ...SURFACE_ROWS,
  shading: oneOf('shading', [null, ...SHADINGS]),
  reflection: oneOf('reflection', [null, ...REFLECTIONS]),
  position: vector('position', ({ range }, axis) => range.place(axis)),
  rotation: vector('rotation °', linear(-180, 180, 1)),
  scale: vector('scale', linear(0, 4, 0.02)),
  type: NO_ROW,
  geometry: NO_ROW,
  segments: SEGMENTS_ROW,
  autoplay: NO_ROW,
  animationName: NO_ROW,
} satisfies RowTable<MeshValues, PhongMesh, 'resetMaterial'>;

export const MESHES: ChildKind<PhongMesh> = {
  rows: MESH_ROWS,
  children: ({ meshes }) => meshes,
  title: (mesh, index, texts) => meshTitle(texts, mesh, index),
};
