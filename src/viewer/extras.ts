// The one table of extras: what is fetched, when, and how; the rows of the panel and the texts that
// they bring. Nothing else in this folder knows an extra: the code that uses one says what it needs
// of it (`extraCode`), and without its row here it is not there. Imported by the package's entry before everything that takes long to run.
import type compareTexts from '../extras/compare/texts.json';
import type exerciseTexts from '../extras/exercise/texts.json';
import type overlayTexts from '../extras/overlay/texts.json';
import type panelTexts from '../extras/panel/texts.json';
import type probeTexts from '../extras/probe/texts.json';
import {
  comparisonCode,
  controlCode,
  diagnosisCode,
  elementCode,
  explanationCode,
  panelCode,
  pictureCode,
} from './element/extra-code.js';
import { panelRows } from './element/panel-rows.js';
import { extraKinds } from './element/viewer/extra-host.js';
import { lazyCode } from '../phong/lazy-code.js';
import { modelCode, readerCode } from './model/request-model.js';
import { samplingCode } from './scene/still-picture.js';

// With the first use of each.
modelCode.provide(() => import('../extras/models/model-content.js'));
readerCode.glTF.provide(() => import('../extras/models/gltf/read-gltf.js'));
readerCode.PLY.provide(() => import('../extras/models/ply/read-ply.js'));
readerCode.STL.provide(() => import('../extras/models/stl/read-stl.js'));
readerCode.OBJ.provide(() => import('../extras/models/obj/read-obj.js'));
samplingCode.provide(() => import('../extras/samples/converging-picture.js'));
pictureCode.provide(() => import('../extras/samples/picture-blob.js'));
explanationCode.provide(() => import('../extras/explain/shade-at.js'));
comparisonCode.provide(() => import('../extras/compare/comparison.js'));
panelCode.provide(() => import('../extras/panel/panel.js'));
controlCode.provide(() => import('../extras/panel/control.js'));
elementCode('phong-probe').provide(() => import('../extras/probe/probe-element.js'));
elementCode('phong-exercise').provide(() => import('../extras/exercise/exercise.js'));
diagnosisCode.provide(() => import('../extras/diagnosis/diagnose.js'));

// While a viewer's values ask for it. What lies over the picture is drawn in this order.
extraKinds.push(
  {
    wanted: ({ helpers }) => helpers.length > 0,
    load: lazyCode(() => import('../extras/overlay/helpers/helpers.js'), 'helpers'),
  },
  {
    wanted: ({ view, viewLight }) => view !== 'shaded' || viewLight !== '',
    load: lazyCode(() => import('../extras/overlay/legend/legend.js'), 'views'),
  },
  {
    wanted: ({ probe }) => probe,
    load: lazyCode(() => import('../extras/overlay/probe/probe.js'), 'the probe'),
  },
  {
    wanted: ({ probe, probeAt }) => !probe && probeAt !== null,
    load: lazyCode(() => import('../extras/overlay/probe/watch.js'), 'the probe'),
  },
  {
    wanted: ({ cameraGroup }, viewer) =>
      cameraGroup !== '' || viewer.parentElement?.localName === 'phong-compare',
    load: lazyCode(() => import('../extras/compare/camera-group.js'), 'linked cameras'),
    first: true,
  },
  {
    wanted: ({ droppable }) => droppable,
    load: lazyCode(() => import('./element/viewer/drops.js'), 'dropped files'),
  },
);

// In the panel, beside its own.
panelRows.push(lazyCode(() => import('../extras/overlay/show-rows.js'), 'the control panel'));

declare module './element/fields/text-key.js' {
  interface TextTables {
    readonly compare: typeof compareTexts;
    readonly exercise: typeof exerciseTexts;
    readonly overlay: typeof overlayTexts;
    readonly panel: typeof panelTexts;
    readonly probe: typeof probeTexts;
  }
}
