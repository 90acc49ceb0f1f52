// The parts of the source that the manifests import and run: the tables of fields by tag, and the
// functions that write a field's value as an attribute.

import type { Field } from '../../src/phong/fields/field.js';
import { COMPARE_FIELDS } from '../../src/viewer/element/fields/compare-fields.js';
import { CONTROL_FIELDS } from '../../src/extras/panel/control-fields.js';
import { PROBE_FIELDS } from '../../src/extras/probe/probe-fields.js';
import { VIEWER_FIELDS } from '../../src/viewer/element/fields/viewer-fields.js';
import { LIGHT_FIELDS } from '../../src/phong/light/light-state.js';
import { MESH_FIELDS } from '../../src/viewer/scene/mesh/mesh-fields.js';

export { attributeOf, formatValue } from '../../src/phong/fields/attribute-text.js';

export const fields: Readonly<Record<string, Readonly<Record<string, Field<unknown>>>>> = {
  'phong-viewer': VIEWER_FIELDS,
  'phong-light': LIGHT_FIELDS,
  'phong-mesh': MESH_FIELDS,
  'phong-compare': COMPARE_FIELDS,
  'phong-control': CONTROL_FIELDS,
  'phong-probe': PROBE_FIELDS,
};
