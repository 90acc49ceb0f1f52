// A viewer's scene as markup that gives the same picture. Text only: building elements would upgrade them.
import type { FieldStore } from '../../fields/field-store.js';
import { fileName } from '../../scene/mesh/file-name.js';
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
    const value = replaced ? instead[key] : store.values[key];
    const text = value instanceof Blob ? hostedName(localName, value) : formatValue(value, store.fields[key]);
    if (text !== null) tag += ` ${attributeOf(key)}${text === '' ? '' : `="${escape(text)}"`}`;
  }
  return `${tag}>`;
}

/** Files of the user's that were warned about. */
const local = new WeakSet<Blob>();

/** The name that a file will have once it is hosted beside the page. */
function hostedName(tag: string, file: Blob): string {
  const name = fileName(file);
  if (!local.has(file)) {
    local.add(file);
    console.warn(
      `<${tag} src="${name}"> is a file on this device. The markup shows it once it is hosted beside the page.`,
    );
  }
  return encodeURIComponent(name);
}

const endTag = ({ localName }: Element): string => `</${localName}>`;

const escape = (text: string): string => text.replace(/[&"<>\r]/g, (c) => `&#${String(c.charCodeAt(0))};`);
