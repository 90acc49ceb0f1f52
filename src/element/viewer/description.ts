// Camera, lights and meshes in words, for people who do not see the picture. Plain functions from values to text;
// degrees and scene units.
import { kindOf } from '../../light/light-features.js';
import { type LightKind, type LightValues } from '../../light/light-state.js';
import { fileName } from '../../model/request-model.js';
import type { MeshValues } from '../../scene/mesh/mesh-fields.js';
import { localNumber, phrase, type ViewerText, type ViewerTexts } from '../fields/texts.js';
import type { CameraState } from '../elements.js';

/** Lights that the description names. It is read in one go, so it must be short. */
export const NAMED = 8;

const LIGHTS = 'Lights: {lights}.';

const lightOf = (kind: LightKind): ViewerText => `{name}: ${kind} light, position {position}, diffuse {diffuse}`;

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
  const light = phrase(texts, lightOf(kindOf(values)), {
    name: lightNameText(texts, name, values),
    position: numbers(values.position.slice(0, 3), texts),
    diffuse: numbers(values.diffuse, texts),
  });
  return values.space === 'camera' ? phrase(texts, '{light}, in camera space', { light }) : light;
}

type MeshNames = Pick<MeshValues, 'name' | 'src' | 'geometry'>;

/** A mesh's name, else its file or shape, else its number among the viewer's meshes; `index` counts from 0. */
export function meshTitle(texts: ViewerTexts | null, { name, src, geometry }: MeshNames, index: number): string {
  const file = typeof src === 'string' ? fileOf(src) : fileName(src);
  const shape = src === '' && geometry !== null ? phrase(texts, geometry) : '';
  return name || file || shape || phrase(texts, 'mesh {number}', { number: String(index + 1) });
}

/** `teapot.glb` from `models/teapot.glb?v=2`. */
const fileOf = (src: string): string => /([^/?#]*)(?:[?#].*)?$/.exec(src)?.[1] ?? '';

/** Not as a literal: browsers would keep the whole first file at two bytes for each character instead of one. */
const MINUS = /* @__PURE__ */ String.fromCodePoint(0x2212);

/** Three digits are enough for the ear. A minus sign, because some screen readers skip a hyphen. */
const numbers = (values: readonly number[], texts: ViewerTexts | null): string =>
  values
    .map((value) => localNumber(String(Number(value.toPrecision(3))), texts))
    .join(' ')
    .replaceAll('-', MINUS);
