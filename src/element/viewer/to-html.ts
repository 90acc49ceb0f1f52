// A viewer's scene as markup that gives the same picture back. Text only: building elements would upgrade them.
import type { FieldStore } from '../../fields/field-store.js';
import { attributeOf, formatValue } from '../fields/attribute-text.js';
import type { PhongViewer } from '../phong-viewer.js';
import type { CameraState } from './camera.js';

interface Part {
  readonly tag: string;
  readonly attributes: readonly (readonly [name: string, value: string])[];
}

/** The viewer with its meshes and lights. */
export function sceneMarkup(viewer: PhongViewer): string {
  const { localName, state, camera, meshes, lights } = viewer;
  return markup(givenAttributes(localName, state, cameraValues(camera)), [
    ...meshes.map((mesh) => givenAttributes(mesh.localName, mesh.state)),
    ...lights.map((light) => givenAttributes(light.localName, light.state)),
  ]);
}

/** The attributes that were given, in the order of the fields, with `instead` in place of what it names. */
function givenAttributes<V extends object>(
  tag: string,
  state: FieldStore<V>,
  instead: { readonly [K in keyof V]?: unknown } = {},
): Part {
  const attributes: [string, string][] = [];
  for (const key of Object.keys(state.fields) as (keyof V & string)[]) {
    const replaced = key in instead;
    if (!replaced && !state.given(key)) continue;
    const text = formatValue(replaced ? instead[key] : state.values[key], state.fields[key]);
    if (text !== null) attributes.push([attributeOf(key), text]);
  }
  return { tag, attributes };
}

/** The camera's numbers as they are now: shortest decimals that read back as the same doubles. */
const cameraValues = ({ theta, phi, radius, target }: CameraState) => ({ theta, phi, radius, target });

/** The viewer's markup with one child a line. */
function markup(viewer: Part, children: readonly Part[]): string {
  const inner = children.map((child) => `  ${startTag(child)}</${child.tag}>\n`).join('');
  return `${startTag(viewer)}${inner === '' ? '' : `\n${inner}`}</${viewer.tag}>`;
}

const startTag = ({ tag, attributes }: Part): string =>
  `<${tag}${attributes.map(([name, value]) => (value === '' ? ` ${name}` : ` ${name}="${escape(value)}"`)).join('')}>`;

const escape = (text: string): string => text.replace(/[&"<>\r]/g, (c) => `&#${String(c.charCodeAt(0))};`);
