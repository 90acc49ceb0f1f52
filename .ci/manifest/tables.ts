// The parts of the source that the manifests import and run: the tables of fields by tag, and the
// functions that write a field's value as an attribute.

import type { Field } from '../../src/phong/fields/field.js';
import { COMPARE_FIELDS } from '../../src/viewer/element/fields/compare-fields.js';
import { VIEWER_FIELDS } from '../../src/viewer/element/fields/viewer-fields.js';
import { LIGHT_FIELDS } from '../../src/phong/light/light-state.js';
import { MESH_FIELDS } from '../../src/phong/model/mesh-fields.js';

export { attributeOf, formatValue } from '../../src/phong/fields/attribute-text.js';

type Table = Readonly<Record<string, Field<unknown>>>;

/** The fields of an element whose code is an extra, in a file of its name: control-fields.ts. */
const ofExtras = Object.entries(
  import.meta.glob<Readonly<Record<string, Table>>>('../../src/extras/*/*-fields.ts', {
    eager: true,
  }),
).map(([path, module]): [string, Table] => {
  const name = /([a-z]+)-fields/.exec(path)![1]!;
  return [`phong-${name}`, module[`${name.toUpperCase()}_FIELDS`]!];
});

export const fields: Readonly<Record<string, Table>> = {
  'phong-viewer': VIEWER_FIELDS,
  'phong-light': LIGHT_FIELDS,
  'phong-mesh': MESH_FIELDS,
  'phong-compare': COMPARE_FIELDS,
  ...Object.fromEntries(ofExtras),
};
