// How are camera, lights and meshes said in words, for people who do not see the picture? Plain functions from values to
// text; degrees and scene units. Knows neither the elements' tree nor when a text is read.
import { kindOf } from '../../light/light-features.js';
import type { LightValues } from '../../light/light-state.js';
import type { MeshValues } from '../../scene/mesh/mesh-fields.js';
import type { CameraState } from './camera.js';

/** Every phrase that assistive technology gets from a viewer. Words in braces are replaced by values. */
export const PHRASES = {
  /** The name of a viewer that has none. */
  scene: '3D scene',
  rotate: 'Arrow keys rotate.',
  zoom: 'Plus and minus zoom.',
  reset: 'Home resets the camera.',
  camera: 'Camera: azimuth {theta}°, polar angle {phi}°, distance {radius}.',
  /** Names of lights, or their number. */
  lights: 'Lights: {lights}.',
  /** The name of a light that is off. */
  off: '{name} (off)',
  /** The name of the list. */
  contents: 'Lights and meshes',
  directional: '{name}: directional light, position {position}, diffuse {diffuse}',
  point: '{name}: point light, position {position}, diffuse {diffuse}',
  spot: '{name}: spot light, position {position}, diffuse {diffuse}',
  /** A light with `space="camera"`. */
  fromCamera: '{light}, in camera space',
  mesh: '{name}: mesh',
} as const;

/** Lights that the description names. It is read in one go, so it must be short; the list names all of them. */
const NAMED = 8;

export interface Allowed {
  readonly orbit: boolean;
  readonly zoom: boolean;
}

/** For `aria-keyshortcuts`; empty if no key does anything. */
export const keyShortcuts = (allowed: Allowed): string =>
  used(allowed, 'ArrowLeft ArrowRight ArrowUp ArrowDown', 'Plus - PageUp PageDown', 'Home');

export const keyText = (allowed: Allowed): string =>
  used(allowed, PHRASES.rotate, PHRASES.zoom, PHRASES.reset);

const used = ({ orbit, zoom }: Allowed, rotate: string, scale: string, reset: string): string =>
  [orbit ? rotate : '', zoom ? scale : '', orbit || zoom ? reset : '']
    .filter((part) => part !== '')
    .join(' ');

export const cameraText = ({ theta, phi, radius }: Pick<CameraState, 'theta' | 'phi' | 'radius'>): string =>
  fill(PHRASES.camera, {
    theta: numbers([Math.round(theta)]),
    phi: numbers([Math.round(phi)]),
    radius: numbers([radius]),
  });

/** All lights in one sentence; empty for none. */
export const lightsText = (names: readonly string[]): string =>
  names.length === 0
    ? ''
    : fill(PHRASES.lights, {
        lights: names.slice(0, NAMED).join(', ') + (names.length > NAMED ? ', …' : ''),
      });

export const lightCountText = (count: number): string => fill(PHRASES.lights, { lights: String(count) });

/** A light's name, and whether it is off. */
export const lightName = (name: string, { active }: Pick<LightValues, 'active'>): string =>
  active ? name : fill(PHRASES.off, { name });

export function lightText(name: string, values: LightValues): string {
  const light = fill(PHRASES[kindOf(values)], {
    name: lightName(name, values),
    position: numbers(values.position.slice(0, 3)),
    diffuse: numbers(values.diffuse),
  });
  return values.space === 'camera' ? fill(PHRASES.fromCamera, { light }) : light;
}

export const meshText = (mesh: MeshValues, index: number): string =>
  fill(PHRASES.mesh, { name: meshTitle(mesh, index) });

/** A mesh's name, else its file or shape, else its number among the viewer's meshes; `index` counts from 0. */
export const meshTitle = (
  { name, src, geometry }: Pick<MeshValues, 'name' | 'src' | 'geometry'>,
  index: number,
): string => name || (src === '' ? geometry : fileOf(src)) || `mesh ${String(index + 1)}`;

/** `teapot.glb` from `models/teapot.glb?v=2`. */
const fileOf = (src: string): string => /([^/?#]*)(?:[?#].*)?$/.exec(src)?.[1] ?? '';

/** By a function: in a replacement text `$&` would have a meaning, and names may contain it. */
const fill = (phrase: string, values: Readonly<Record<string, string>>): string =>
  phrase.replace(/\{(\w+)\}/g, (_, key: string) => values[key] ?? '');

/** Three digits are enough for the ear. Some screen readers skip a hyphen, so a minus sign is used. */
const numbers = (values: readonly number[]): string =>
  values
    .map((value) => Number(value.toPrecision(3)))
    .join(' ')
    .replaceAll('-', '−');
