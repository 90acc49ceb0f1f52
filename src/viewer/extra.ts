// All that extras may import of the viewer. Its own files import each other, and never this one.

export type {
  FragmentExplanation,
  PhongCompare,
  PhongLight,
  PhongMesh,
  PhongViewer,
  PictureOptions,
  ValuesByTag,
} from './element/elements.js';
export type { AnswerDetail } from './element/phong-probe.js';
export type { MistakeTests } from './element/extra-code.js';
export { ExtraElement } from './element/extra-element.js';
export { cssColor } from './element/fields/css-color.js';
export { localNumber, phrase, type ViewerText, type ViewerTexts } from './element/fields/texts.js';
export { VIEWER_FIELDS } from './element/fields/viewer-fields.js';
export { fieldsOf, hostOf, sceneMeshes } from './element/internals.js';
export { copyText } from './element/page/copy-text.js';
export { CORNER_MARKS, pictureBox } from './element/page/picture-box.js';
export { addStyles } from './element/page/style-sheets.js';
export { lightName } from './element/phong-light.js';
export { lightNameText, lightText } from './element/viewer/description.js';
export type { Extra, ExtraHost, ViewerSnapshot } from './element/viewer/extra-host.js';
export { historyOf, type Subject } from './element/viewer/history.js';
export type { ExtraRows } from './element/panel-rows.js';
export { PANEL_PLACE } from './element/viewer/viewer-panel.js';
export { type LoadOptions, modelCode, readerCode } from './model/request-model.js';
export { afterPictures } from './scene/frame-loop.js';
export { stage } from './scene/gpu/stage.js';
export type { SampledViewport } from './scene/still-picture.js';
