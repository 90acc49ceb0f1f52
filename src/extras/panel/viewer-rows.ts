// The rows of the viewer's own folders: camera, shading, what is shown beside the shaded picture,
// and its own surface.
import type { Pose } from '../../phong/camera/orbit.js';
import {
  type ExtraRows,
  fieldsOf,
  historyOf,
  type PhongViewer,
  type ValuesByTag,
} from '../../viewer/extra.js';
import { REFLECTIONS, SHADINGS } from '../../phong/material/material-values.js';
import { TERMS } from '../../phong/light/light-state.js';
import { SEGMENTS_ROW, SURFACE_ROWS } from './mesh-rows.js';
import {
  button,
  flag,
  flags,
  inFolder,
  NO_ROW,
  number,
  oneName,
  oneOf,
  readout,
  type Row,
  type Rows,
  type RowTable,
  vector,
} from './rows.js';
import { linear, logarithmic, numberText } from './travel.js';

type ViewerValues = ValuesByTag['phong-viewer'];

/** Those whose rows no other extra brings. */
type OwnValues = Omit<ViewerValues, keyof ReturnType<ExtraRows>>;

/**
 * Edits the camera as it is now, not the declared values, as a drag does: reset returns to what is
 * declared. Writes throw RangeError, as the properties do, for values outside the field's domain.
 * Nothing fits the camera to the scene afterwards.
 */
const ofCamera = <K extends keyof Pose>(
  key: K,
  row: Row<Pose[K], PhongViewer>,
): Row<ViewerValues[K], PhongViewer> => ({
  ...(row as Row<ViewerValues[K], PhongViewer>),
  source: (viewer) => ({
    subject: historyOf(viewer).camera,
    get: () => viewer.camera[key],
    set(value) {
      const checked = fieldsOf(viewer).store.fields[key].check(value);
      historyOf(viewer).camera.move({ [key]: checked });
    },
  }),
});

const OWN_ROWS = {
  ...inFolder('Camera', {
    theta: ofCamera('theta', number('θ azimuth °', linear(-180, 180, 1))),
    phi: ofCamera('phi', number('φ polar °', linear(0, 180, 1))),
    radius: ofCamera(
      'radius',
      number('radius', ({ range }) => logarithmic(range.reach / 100, range.reach * 10)),
    ),
    eye: readout('eye', eyeText),
    target: ofCamera(
      'target',
      vector('target', ({ range }, axis) => range.place(axis)),
    ),
    fov: number('fov °', linear(1, 170, 1)),
    autoRotate: number('auto-rotate', linear(-90, 90, 1), 'Degrees per second about y'),
    resetCamera: button<PhongViewer>('reset camera', ({ viewer }) => {
      const history = historyOf(viewer);
      history.edit(history.camera, () => history.camera.reset());
    }),
  }),
  ...inFolder('Shading', {
    shading: oneOf('shading', SHADINGS),
    reflection: oneOf('reflection', REFLECTIONS),
    terms: flags(TERMS, (term) => `${term} term`),
    colorInterpolation: oneOf('colour space', ['srgb', 'linear']),
    antialias: oneOf('antialias', ['edges', 'full']),
    samples: number('samples', linear(16, 1024, 1), 'Per pixel, with antialias full'),
  }),
  ...inFolder('Material', { ...SURFACE_ROWS, segments: SEGMENTS_ROW }),
  // The row of files opens models.
  src: NO_ROW,
  type: NO_ROW,
  geometry: NO_ROW,
  autoplay: NO_ROW,
  animationName: NO_ROW,
  alt: NO_ROW,
  poster: NO_ROW,
  loading: NO_ROW,
  droppable: NO_ROW,
  crossOrigin: NO_ROW,
  orbit: NO_ROW,
  zoom: NO_ROW,
  pixelRatio: NO_ROW,
  probeAt: NO_ROW,
  cameraGroup: NO_ROW,
  gui: NO_ROW,
} satisfies RowTable<OwnValues, PhongViewer, 'eye' | 'resetCamera' | 'resetMaterial'>;

/** With those that other extras bring. */
export const VIEWER_ROWS: Rows<PhongViewer> = { ...OWN_ROWS };

export function takeRows(rows: ExtraRows): void {
  Object.assign(
    VIEWER_ROWS,
    inFolder('Show', rows({ flag, flags, oneOf, oneName }) as Rows<never>),
  );
}

/** Rounded to a thousandth of the distance, which removes rounding noise. */
function eyeText({ camera: { eye, radius } }: PhongViewer): string {
  const unit = 10 ** (Math.floor(Math.log10(radius)) - 3);
  return eye.map((n) => numberText(Math.round(n / unit) * unit, unit)).join(', ');
}
