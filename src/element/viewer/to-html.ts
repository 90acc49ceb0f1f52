// A viewer's scene as markup that gives the same picture. Text only: building elements would upgrade them.
import type { FieldStore } from '../../fields/field-store.js';
import { attributeOf, formatValue } from '../fields/attribute-text.js';
import { fieldsOf } from '../internals.js';
import type { PhongViewer } from '../phong-viewer.js';

/** The viewer with its meshes and lights, one child per line. The camera is the one shown now. */
export function sceneMarkup(viewer: PhongViewer): string {
  const { theta, phi, radius, target } = viewer.camera;
  const children = [
    ...viewer.meshes.map((mesh) => startTag(mesh, fieldsOf(mesh).store) + endTag(mesh)),
    ...viewer.lights.map((light) => startTag(light, fieldsOf(light).store) + endTag(light)),
  ];
  const inner = children.length === 0 ? '' : `\n${children.map((child) => `  ${child}\n`).join('')}`;
  return startTag(viewer, fieldsOf(viewer).store, { theta, phi, radius, target }) + inner + endTag(viewer);
}

/** With the attributes that were given, in the order of the fields, and `instead` in place of the values it names. */
function startTag<V extends object>(
  { localName }: Element,
  store: FieldStore<V>,
  instead: { readonly [K in keyof V]?: unknown } = {},
): string {
  let tag = `<${localName}`;
  for (const key of Object.keys(store.fields) as (keyof V & string)[]) {
    const replaced = key in instead;
    if (!replaced && !store.given(key)) continue;
    const text = formatValue(replaced ? instead[key] : store.values[key], store.fields[key]);
    if (text !== null) tag += ` ${attributeOf(key)}${text === '' ? '' : `="${escape(text)}"`}`;
  }
  return `${tag}>`;
}

const endTag = ({ localName }: Element): string => `</${localName}>`;

const escape = (text: string): string => text.replace(/[&"<>\r]/g, (c) => `&#${String(c.charCodeAt(0))};`);
