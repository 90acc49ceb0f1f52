// How does the author name the picture, or is it decoration? By attributes, as HTML and ARIA define them. Must not know how
// the picture is drawn.
import { fieldsOf } from '../internals.js';
import type { PhongViewer } from '../phong-viewer.js';

/** Attributes, besides `alt`, that name the picture or say what it is. */
export const NAMING = ['aria-label', 'aria-labelledby', 'role'] as const;

export interface Naming {
  /** Text alternative; empty for none. */
  readonly label: string;
  /** Elements of the page that name the picture, instead of `label`; null for none. */
  readonly labelledBy: readonly Element[] | null;
  /** The picture has no name and needs none. */
  readonly decoration: boolean;
}

export function namingOf(viewer: PhongViewer): Naming {
  const label = viewer.getAttribute('aria-label') || viewer.alt;
  // Missing in browsers without element reflection, whatever the types say.
  const labelledBy = (viewer as Partial<Element>).ariaLabelledByElements ?? null;
  return { label, labelledBy, decoration: label === '' && labelledBy === null && isDecoration(viewer) };
}

/** The picture has a name, needs none, or is hidden from assistive technology. */
export const isNamed = (viewer: PhongViewer): boolean =>
  isDecoration(viewer) ||
  viewer.matches('[aria-label],[aria-labelledby]') ||
  viewer.closest('[aria-hidden=true]') !== null;

/** By `alt=""`, as for an image, or by a role. */
const isDecoration = (viewer: PhongViewer): boolean =>
  fieldsOf(viewer).store.given('alt') || viewer.matches('[role=none],[role=presentation]');
