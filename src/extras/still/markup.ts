// Reads the markup of one viewer: its values and those of its lights and meshes, by the tables of
// fields that the elements have, with the same defaults and warnings.
import { type DefaultTreeAdapterTypes, parseFragment } from 'parse5';
import type { Field } from '../../phong/fields/field.js';
import { FieldStore } from '../../phong/fields/field-store.js';
import { LightState, type LightValues } from '../../phong/light/light-state.js';
import { MESH_FIELDS, type MeshValues } from '../../phong/model/mesh-fields.js';
import { type ValuesByTag, VIEWER_FIELDS } from '../../viewer/extra.js';
import { cssColor } from './css-colors.js';
import { elementsBelow } from './elements.js';
import { attributeOf, parseText, valueWarning } from '../../phong/fields/attribute-text.js';

export type ViewerValues = ValuesByTag['phong-viewer'];

export type Warn = (message: string) => void;

/** What markup declares, in document order. */
export interface Declared {
  readonly viewer: FieldStore<ViewerValues>;
  readonly lights: readonly LightState[];
  readonly meshes: readonly FieldStore<MeshValues>[];
}

type Element = DefaultTreeAdapterTypes.Element;

/** @throws TypeError unless there is one viewer. */
export function readMarkup(markup: string, warn: Warn): Declared {
  const viewers = named(elementsBelow(parseFragment(markup)), 'phong-viewer');
  const [viewer] = viewers;
  if (viewer === undefined || viewers.length > 1) {
    const count = String(viewers.length);
    throw new TypeError(`a still is of one <phong-viewer>, and the markup has ${count}`);
  }
  const once = new Set<string>();
  const warnOnce = (message: string): void => {
    if (!once.has(message)) {
      warn(message);
    }
    once.add(message);
  };
  const children = elementsBelow(viewer);
  const lights = named(children, 'phong-light').map((element) =>
    declared<LightValues, LightState>(element, new LightState(), warnOnce),
  );
  // Without any light there is a head-light.
  if (lights.length === 0) {
    lights.push(new LightState({ name: 'head-light', space: 'camera', position: [0, 0, 1, 0] }));
  }
  return {
    viewer: declared(viewer, new FieldStore(VIEWER_FIELDS), warnOnce),
    lights,
    meshes: named(children, 'phong-mesh').map((element) =>
      declared(element, new FieldStore(MESH_FIELDS), warnOnce),
    ),
  };
}

const named = (elements: readonly Element[], tag: string): readonly Element[] =>
  elements.filter(({ tagName }) => tagName === tag);

/** Sets what an element's attributes say. */
function declared<V extends object, S extends FieldStore<V>>(
  element: Element,
  store: S & FieldStore<V>,
  warn: Warn,
): S {
  const keys = Object.keys(store.fields) as (keyof V & string)[];
  const keyOf = new Map(keys.map((key) => [attributeOf(key), key]));
  for (const { name, value } of element.attrs) {
    const key = keyOf.get(name);
    if (key === undefined) continue;
    const field: Field<unknown> = store.fields[key];
    const typed = parseText(value, field, cssColor);
    try {
      if (typed === undefined) throw new TypeError('malformed');
      store.set(key, typed);
    } catch {
      store.set(key, null);
      warn(valueWarning(element.tagName, key, value, field));
    }
  }
  return store;
}
