// How does the description put camera, lights and meshes into words, and do the page's own texts replace them?

import { describe, expect, test } from 'vitest';
import {
  cameraText,
  lightCountText,
  lightNameText,
  lightsText,
  lightText,
  meshTitle,
} from '../../src/element/viewer/description.js';
import { phrase } from '../../src/element/fields/texts.js';
import { LightState, type LightValues } from '../../src/light/light-state.js';

const light = (values: Partial<LightValues> = {}): LightValues => new LightState(values).values;
type Mesh = Parameters<typeof meshTitle>[1];
const mesh = (values: Partial<Mesh> = {}): Mesh => ({
  name: '',
  src: '',
  geometry: null,
  ...values,
});

describe('the camera', () => {
  test.each([
    [30, 70, 4, 'Camera: azimuth 30°, polar angle 70°, distance 4.'],
    [-179.6, 0, 1.23456, 'Camera: azimuth −180°, polar angle 0°, distance 1.23.'],
    [-0.2, 89.5, 12345.6, 'Camera: azimuth 0°, polar angle 90°, distance 12300.'],
    [0, 0, 1e-9, 'Camera: azimuth 0°, polar angle 0°, distance 1e−9.'],
  ])('at %d, %d, %d is rounded for listeners', (theta, phi, radius, text) => {
    expect(cameraText(null, { theta, phi, radius })).toBe(text);
  });
});

describe('a light', () => {
  test.each([
    [{}, 'sun: directional light, position 1 2 3, diffuse 255 255 255'],
    [
      { position: [0.12345, -2, 0, 1] as const },
      'sun: point light, position 0.123 −2 0, diffuse 255 255 255',
    ],
    [{ position: [0, 2, 0, 1] as const, cutoff: 4 }, 'sun: spot light, position 0 2 0, diffuse 255 255 255'],
    [{ active: false }, 'sun (off): directional light, position 1 2 3, diffuse 255 255 255'],
    [
      { space: 'camera' as const },
      'sun: directional light, position 1 2 3, diffuse 255 255 255, in camera space',
    ],
  ])('with %j is named with its kind, place and colour', (values, text) => {
    expect(lightText(null, 'sun', light(values as Partial<LightValues>))).toBe(text);
  });

  test('that is off is called so', () => {
    expect(lightNameText(null, 'sun', { active: true })).toBe('sun');
    expect(lightNameText(null, 'sun', { active: false })).toBe('sun (off)');
  });
});

describe('all lights', () => {
  test('are named, the first eight of them', () => {
    expect(lightsText(null, ['a', 'b'])).toBe('Lights: a, b.');
    const names = Array.from({ length: 9 }, (_, i) => `l${i}`);
    expect(lightsText(null, names.slice(0, 8))).toBe('Lights: l0, l1, l2, l3, l4, l5, l6, l7.');
    expect(lightsText(null, names)).toBe('Lights: l0, l1, l2, l3, l4, l5, l6, l7, ....');
  });

  test('are counted', () => expect(lightCountText(null, 12)).toBe('Lights: 12.'));

  test('are not mentioned if there are none', () => expect(lightsText(null, [])).toBe(''));
});

describe('a mesh', () => {
  test.each([
    [{ name: 'floor', geometry: 'plane' as const }, 'floor'],
    [{ geometry: 'plane' as const }, 'plane'],
    [{ src: 'models/teapot.glb?v=2#a', geometry: 'plane' as const }, 'teapot.glb'],
    [{ src: 'models/' }, 'mesh 3'],
    [{ src: new File([], 'bunny.stl') }, 'bunny.stl'],
    [{}, 'mesh 3'],
  ])('of %j has a title', (values, title) => {
    expect(meshTitle(null, mesh(values), 2)).toBe(title);
  });
});

describe("the page's own words", () => {
  test('replace a text by its English form, values included', () => {
    const texts = {
      'Lights: {lights}.': 'Lichter: {lights}.',
      '{name} (off)': '{name} (aus)',
      '{name}: point light, position {position}, diffuse {diffuse}': 'Punktlicht {name} bei {position}',
    };
    expect(lightsText(texts, ['a', 'b'])).toBe('Lichter: a, b.');
    expect(lightText(texts, 'a', light({ position: [1, 2, 3, 1], active: false }))).toBe(
      'Punktlicht a (aus) bei 1 2 3',
    );
    expect(cameraText(texts, { theta: 1, phi: 2, radius: 3 })).toMatch(/^Camera/);
  });

  test('may repeat or omit values; unknown placeholders are removed', () => {
    expect(phrase({ name: '{x}{x} {y}' }, 'name', { x: '$&' })).toBe('$&$& ');
  });
});
