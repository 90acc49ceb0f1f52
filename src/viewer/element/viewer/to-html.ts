// A viewer's scene as markup that gives the same picture. Text only: building elements would
// upgrade them.
import type { FieldStore } from '../../../phong/fields/field-store.js';
import { eightDigits } from '../../../phong/camera/written-pose.js';
import { fileName } from '../../../phong/fields/file-names.js';
import { registryOf } from '../child-registry.js';
import { attributeOf, formatValue } from '../../../phong/fields/attribute-text.js';
import { fieldsOf, viewerHosts } from '../internals.js';
import type { PhongCompare, PhongViewer } from '../elements.js';

/** The page's own attributes that are kept. */
const KEPT = ['id', 'class', 'style'];

/**
 * Wrappers that are kept. Others, such as custom elements with lights of their own, become `div`.
 */
const WRAPPERS = /^(div|section|article|aside|main|figure|fieldset|span|ul|ol|li)$/;

export function compareMarkup(compare: PhongCompare): string {
  const { store } = fieldsOf(compare);
  // Percent are rounded to eight digits, as any other value.
  const values = attributes('phong-compare', store, {}, 1);
  const inner = compare.viewers.map((viewer) => `${sceneMarkup(viewer, '  ')}\n`).join('');
  return `<phong-compare${kept(compare)}${values}>\n${inner}</phong-compare>`;
}

/**
 * The viewer and its children in their wrappers. The camera and a pinned point are those shown now.
 */
export function sceneMarkup(viewer: PhongViewer, margin = ''): string {
  const { theta, phi, radius, target } = viewer.camera;
  const host = viewerHosts.get(viewer);
  const pin = host?.pin ?? null;
  const framing = host?.camera.placement().framing;
  const shown = {
    theta,
    phi,
    radius: framing?.radius === 'auto' ? 'auto' : radius,
    target: framing?.target === 'auto' ? 'auto' : target,
    ...(pin === null ? {} : { probeAt: pin }),
  };
  const tree = treeOf(viewer);
  const write = (element: Element, indent: string): string => {
    const { localName } = element;
    const isOurs = localName.startsWith('phong-');
    const name = isOurs || WRAPPERS.test(localName) ? localName : 'div';
    const { store } = isOurs ? fieldsOf(element as PhongViewer) : { store: null };
    const values =
      store === null ? '' : attributes(name, store, element === viewer ? shown : {}, radius);
    const inner = (tree.get(element) ?? [])
      .map((child) => `${write(child, `${indent}  `)}\n`)
      .join('');
    return `${indent}<${name}${kept(element)}${values}>${inner === '' ? '' : `\n${inner}${indent}`}</${name}>`;
  };
  return write(viewer, margin);
}

/**
 * The meshes, lights and wrappers in the viewer and in each other. Shadow trees count as their
 * hosts' children.
 */
function treeOf(viewer: Element): ReadonlyMap<Element, readonly Element[]> {
  const tree = new Map<Element, Element[]>();
  for (const child of registryOf(viewer).inOrder) {
    for (let node: Element = child; node !== viewer;) {
      const parent: Element = node.parentElement ?? (node.getRootNode() as ShadowRoot).host;
      const list = tree.get(parent) ?? [];
      tree.set(parent, list);
      if (list.at(-1) === node) break;
      list.push(node);
      node = parent;
    }
  }
  return tree;
}

const kept = (element: Element) =>
  KEPT.map((name) => {
    const text = element.getAttribute(name) ?? '';
    return text === '' ? '' : attribute(name, text);
  }).join('');

/**
 * The values that were given, in the order of the fields, and `instead` in place of those it names.
 */
function attributes<V extends object>(
  tag: string,
  store: FieldStore<V>,
  instead: { readonly [K in keyof V]?: unknown },
  radius: number,
): string {
  let all = '';
  for (const key of Object.keys(store.fields) as (keyof V & string)[]) {
    const replaced = key in instead;
    if (!replaced && !store.given(key)) continue;
    const value: unknown = replaced ? instead[key] : store.values[key];
    const text =
      value instanceof Blob
        ? hostedName(tag, value)
        : formatValue(rounded(value, radius), store.fields[key]);
    if (text !== null) {
      all += attribute(attributeOf(key), text);
    }
  }
  return all;
}

function rounded(value: unknown, radius: number): unknown {
  if (Array.isArray(value)) return value.map((item) => rounded(item, radius));
  return typeof value === 'number' ? eightDigits(value, radius) : value;
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

const attribute = (name: string, text: string) =>
  ` ${name}${text === '' ? '' : `="${text.replace(/[&"<>\r]/g, (c) => `&#${String(c.charCodeAt(0))};`)}"`}`;
