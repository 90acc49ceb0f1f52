/**
 * `phong-viewer`: registers `<phong-viewer>`, `<phong-light>`, `<phong-mesh>`, `<phong-compare>`,
 * `<phong-control>`, `<phong-probe>` and `<phong-exercise>`. Importing it without a DOM does nothing.
 * A second copy on a page leaves the first copy's elements alone.
 */
// First, because they must run before Lit and three.js do.
import { litWasImported } from './element/page/trusted-types.js';
import './extras.js';
import './element/page/early-requests.js';
import type { ElementsByTag } from './element/elements.js';
import { PhongCompare } from './element/phong-compare.js';
import { PhongControl } from './element/phong-control.js';
import { PhongExercise } from './element/phong-exercise.js';
import { PhongLight } from './element/phong-light.js';
import { PhongMesh } from './element/phong-mesh.js';
import { PhongProbe } from './element/phong-probe.js';
import { PhongViewer } from './element/phong-viewer.js';
import { endEarly } from './model/request-model.js';

litWasImported();

// Children first: the viewer then finds all of them at once when it is upgraded.
const page = typeof customElements === 'undefined' ? undefined : globalThis.document;
if (page !== undefined && page.contentType !== 'text/html') {
  console.warn(
    `<phong-viewer>: the page is served as ${page.contentType}, so the elements are not defined. Serve it as text/html.`,
  );
} else if (page !== undefined) {
  const classes: { readonly [T in keyof ElementsByTag]: new () => ElementsByTag[T] } = {
    'phong-light': PhongLight,
    'phong-mesh': PhongMesh,
    'phong-viewer': PhongViewer,
    'phong-compare': PhongCompare,
    'phong-control': PhongControl,
    'phong-probe': PhongProbe,
    'phong-exercise': PhongExercise,
  };
  for (const [name, element] of Object.entries(classes)) {
    if (customElements.get(name) === undefined) {
      customElements.define(name, element);
    }
  }
}
// Meshes request their models in microtasks.
setTimeout(endEarly);

export {
  PhongCompare,
  PhongControl,
  PhongExercise,
  PhongLight,
  PhongMesh,
  PhongProbe,
  PhongViewer,
};
export type { ViewerErrorCode, ViewerTexts } from './element/fields/texts.js';
export type {
  CameraSource,
  CameraState,
  FragmentExplanation,
  LightExplanation,
  LightsByName,
  LoadDetail,
  PhongCompareEventMap,
  PhongMeshEventMap,
  PhongViewerEventMap,
  PictureOptions,
  ShadeOptions,
  ViewerErrorDetail,
  ViewerStats,
} from './element/elements.js';
export type { PhongExerciseEventMap } from './element/phong-exercise.js';
export type { AnswerDetail, AnswerMistake, PhongProbeEventMap } from './element/phong-probe.js';
export type { NumberList } from './element/fields/properties.js';
export type {
  PhongCompareProps,
  PhongControlProps,
  PhongExerciseProps,
  PhongLightProps,
  PhongMeshProps,
  PhongProbeProps,
  PhongViewerProps,
} from './element/template-types.js';
export type { Vec3, Vec4 } from '../phong/math/vector.js';
