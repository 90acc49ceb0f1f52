// Role, name and keys of the picture for assistive technology. Follows the author's attributes as HTML and ARIA define
// them.
import { phrase, type ViewerTexts } from '../fields/texts.js';
import { fieldsOf } from '../internals.js';
import type { PhongViewer } from '../elements.js';

/** Attributes, besides `alt`, that name the picture or say what it is. */
export const NAMING = ['aria-label', 'aria-labelledby', 'role'] as const;

/** An application gets the keys that a screen reader would keep for itself on an image; `keys` is empty for an image. */
export function surfaceName(viewer: PhongViewer, texts: ViewerTexts | null) {
  const label = viewer.getAttribute('aria-label') || viewer.alt;
  // Missing in browsers without element reflection, whatever the types say.
  const labelledBy = (viewer as Partial<Element>).ariaLabelledByElements ?? null;
  const keys = usable(viewer, 'ArrowLeft ArrowRight ArrowUp ArrowDown', 'Plus - PageUp PageDown', 'Home');
  // Nothing that can have the focus may be hidden or nameless.
  const hidden = keys === '' && label === '' && labelledBy === null && isDecoration(viewer);
  return { keys, label: label || phrase(texts, '3D scene'), labelledBy, hidden };
}

export const keysText = (viewer: PhongViewer, texts: ViewerTexts | null): string =>
  usable(
    viewer,
    phrase(texts, 'Arrow keys rotate.'),
    phrase(texts, 'Plus and minus zoom.'),
    phrase(texts, 'Home resets the camera.'),
  );

const usable = ({ orbit, zoom }: PhongViewer, rotate: string, scale: string, reset: string): string =>
  [orbit && rotate, zoom && scale, (orbit || zoom) && reset].filter(Boolean).join(' ');

/** The picture has a name, needs none, or is hidden from assistive technology. */
export const isNamed = (viewer: PhongViewer): boolean =>
  isDecoration(viewer) ||
  viewer.matches('[aria-label],[aria-labelledby]') ||
  viewer.closest('[aria-hidden=true]') !== null;

/** By `alt=""`, as for an image, or by a role. */
const isDecoration = (viewer: PhongViewer): boolean =>
  fieldsOf(viewer).store.given('alt') || viewer.matches('[role=none],[role=presentation]');
