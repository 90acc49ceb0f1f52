// What is the picture to assistive technology: its role, name and keys? Follows the author's attributes as HTML
// and ARIA define them. Must not know how the picture is drawn.
import { phrase, type ViewerTexts } from '../fields/texts.js';
import { fieldsOf } from '../internals.js';
import type { PhongViewer } from '../phong-viewer.js';
import { set } from './template.js';

/** Attributes, besides `alt`, that name the picture or say what it is. */
export const NAMING = ['aria-label', 'aria-labelledby', 'role'] as const;

/**
 * Writes role, name and keys to the surface. An application gets the keys that a screen reader would keep for itself on an
 * image. False if nothing of the viewer is to be read.
 */
export function nameSurface(surface: HTMLElement, viewer: PhongViewer, texts: ViewerTexts | null): boolean {
  const label = viewer.getAttribute('aria-label') || viewer.alt;
  // Missing in browsers without element reflection, whatever the types say.
  const labelledBy = (viewer as Partial<Element>).ariaLabelledByElements ?? null;
  const keys = usable(viewer, 'ArrowLeft ArrowRight ArrowUp ArrowDown', 'Plus - PageUp PageDown', 'Home');
  // Nothing that can have the focus may be hidden or nameless.
  const hidden = keys === '' && label === '' && labelledBy === null && isDecoration(viewer);
  set(surface, 'tabindex', keys === '' ? null : '0');
  set(surface, 'role', keys === '' ? 'img' : 'application');
  set(surface, 'aria-hidden', hidden ? 'true' : null);
  set(surface, 'aria-label', label || phrase(texts, '3D scene'));
  set(surface, 'aria-keyshortcuts', keys || null);
  if (labelledBy !== null || surface.hasAttribute('aria-labelledby'))
    surface.ariaLabelledByElements = labelledBy;
  return !hidden;
}

export const keysText = (viewer: PhongViewer, texts: ViewerTexts | null): string =>
  usable(
    viewer,
    phrase(texts, 'Arrow keys rotate.'),
    phrase(texts, 'Plus and minus zoom.'),
    phrase(texts, 'Home resets the camera.'),
  );

const usable = ({ orbit, zoom }: PhongViewer, rotate: string, scale: string, reset: string): string =>
  [orbit ? rotate : '', zoom ? scale : '', orbit || zoom ? reset : '']
    .filter((part) => part !== '')
    .join(' ');

/** The picture has a name, needs none, or is hidden from assistive technology. */
export const isNamed = (viewer: PhongViewer): boolean =>
  isDecoration(viewer) ||
  viewer.matches('[aria-label],[aria-labelledby]') ||
  viewer.closest('[aria-hidden=true]') !== null;

/** By `alt=""`, as for an image, or by a role. */
const isDecoration = (viewer: PhongViewer): boolean =>
  fieldsOf(viewer).store.given('alt') || viewer.matches('[role=none],[role=presentation]');
