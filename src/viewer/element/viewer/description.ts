// The picture for people who do not see it: role, name and keys as HTML and ARIA define them;
// camera, lights and meshes in words, in degrees and scene units.
import { kindOf } from '../../../phong/light/light-features.js';
import type { LightValues } from '../../../phong/light/light-state.js';
import { localNumber, phrase, type ViewerTexts } from '../fields/texts.js';
import type { CameraState, PhongViewer } from '../elements.js';
import { fieldsOf } from '../internals.js';

/** Lights that the description names. It is read in one go, so it must be short. */
export const NAMED = 8;

const LIGHTS = 'Lights: {lights}.';

export const cameraText = (
  texts: ViewerTexts | null,
  { theta, phi, radius }: Pick<CameraState, 'theta' | 'phi' | 'radius'>,
): string =>
  phrase(texts, 'Camera: azimuth {theta}°, polar angle {phi}°, distance {radius}.', {
    theta: numbers([Math.round(theta)], texts),
    phi: numbers([Math.round(phi)], texts),
    radius: numbers([radius], texts),
  });

/** All lights in one sentence; empty for none. `names`: of {@link lightNameText}. */
export const lightsText = (texts: ViewerTexts | null, names: readonly string[]): string =>
  names.length === 0
    ? ''
    : phrase(texts, LIGHTS, {
        lights: names.slice(0, NAMED).join(', ') + (names.length > NAMED ? ', ...' : ''),
      });

export const lightCountText = (texts: ViewerTexts | null, count: number): string =>
  phrase(texts, LIGHTS, { lights: String(count) });

export const lightNameText = (
  texts: ViewerTexts | null,
  name: string,
  { active }: Pick<LightValues, 'active'>,
): string => (active ? name : phrase(texts, '{name} (off)', { name }));

export function lightText(texts: ViewerTexts | null, name: string, values: LightValues): string {
  const light = phrase(
    texts,
    `{name}: ${kindOf(values)} light, position {position}, diffuse {diffuse}`,
    {
      name: lightNameText(texts, name, values),
      position: numbers(values.position.slice(0, 3), texts),
      diffuse: numbers(values.diffuse, texts),
    },
  );
  return values.space === 'camera' ? phrase(texts, '{light}, in camera space', { light }) : light;
}

/**
 * Not as a literal: browsers would keep the whole first file at two bytes for each character
 * instead of one.
 */
const MINUS = /* @__PURE__ */ String.fromCodePoint(0x2212);

/** Three digits are enough for the ear. A minus sign, because some screen readers skip a hyphen. */
const numbers = (values: readonly number[], texts: ViewerTexts | null) =>
  values
    .map((value) => localNumber(String(Number(value.toPrecision(3))), texts))
    .join(' ')
    .replaceAll('-', MINUS);

/** Attributes, besides `alt`, that name the picture or say what it is. */
export const NAMING = ['aria-label', 'aria-labelledby', 'role'] as const;

/**
 * An application gets the keys that a screen reader would keep for itself on an image; `keys` is
 * empty for an image.
 */
export function surfaceName(viewer: PhongViewer, texts: ViewerTexts | null) {
  const label = viewer.getAttribute('aria-label') || viewer.alt;
  // Missing in browsers without element reflection, whatever the types say.
  const labelledBy = (viewer as Partial<Element>).ariaLabelledByElements ?? null;
  const keys = usable(
    viewer,
    'ArrowLeft ArrowRight ArrowUp ArrowDown',
    'Plus - PageUp PageDown',
    'Home',
  );
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

const usable = ({ orbit, zoom }: PhongViewer, rotate: string, scale: string, reset: string) =>
  [orbit && rotate, zoom && scale, (orbit || zoom) && reset].filter(Boolean).join(' ');

/** The picture has a name, needs none, or is hidden from assistive technology. */
export const isNamed = (viewer: PhongViewer): boolean =>
  isDecoration(viewer) ||
  viewer.matches('[aria-label],[aria-labelledby]') ||
  viewer.closest('[aria-hidden=true]') !== null;

/** By `alt=""`, as for an image, or by a role. */
const isDecoration = (viewer: PhongViewer) =>
  fieldsOf(viewer).store.given('alt') || viewer.matches('[role=none],[role=presentation]');
