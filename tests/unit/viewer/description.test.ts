// How does the description put camera, lights and meshes into words, and do the page's own texts
// replace them?

import { describe, expect, test } from 'vitest';
import {
  cameraText,
  lightCountText,
  lightsText,
  lightText,
} from '../../../src/viewer/element/viewer/description.js';
import { meshTitle } from '../../../src/extras/panel/mesh-title.js';
import { phrase } from '../../../src/viewer/element/fields/texts.js';
import { LightState, type LightValues } from '../../../src/phong/light/light-state.js';

const light = (values: Partial<LightValues> = {}) => new LightState(values).values;

test.each([
  [30, 70, 4, 'Camera: azimuth 30°, polar angle 70°, distance 4.'],
  [-179.6, 0, 1.23456, 'Camera: azimuth −180°, polar angle 0°, distance 1.23.'],
  [-0.2, 89.5, 12345.6, 'Camera: azimuth 0°, polar angle 90°, distance 12300.'],
  [0, 0, 1e-9, 'Camera: azimuth 0°, polar angle 0°, distance 1e−9.'],
])('a camera at %d, %d, %d is rounded for listeners', (theta, phi, radius, text) => {
  expect(cameraText(null, { theta, phi, radius })).toBe(text);
});

test.each<[Partial<LightValues>, string]>([
  [{}, 'sun: directional light, position 1 2 3, diffuse 255 255 255'],
  [{ position: [0.12345, -2, 0, 1] }, 'sun: point light, position 0.123 −2 0, diffuse 255 255 255'],
  [{ position: [0, 2, 0, 1], cutoff: 4 }, 'sun: spot light, position 0 2 0, diffuse 255 255 255'],
  [{ active: false }, 'sun (off): directional light, position 1 2 3, diffuse 255 255 255'],
  [
    { space: 'camera' },
    'sun: directional light, position 1 2 3, diffuse 255 255 255, in camera space',
  ],
])('a light with %j is named with its kind, place and colour', (values, text) => {
  expect(lightText(null, 'sun', light(values))).toBe(text);
});

test('all lights are counted, and the first eight named', () => {
  const names = Array.from({ length: 9 }, (_, i) => `l${i}`);
  expect(lightsText(null, [])).toBe('');
  expect(lightsText(null, ['a', 'b'])).toBe('Lights: a, b.');
  expect(lightsText(null, names.slice(0, 8))).toBe('Lights: l0, l1, l2, l3, l4, l5, l6, l7.');
  expect(lightsText(null, names)).toBe('Lights: l0, l1, l2, l3, l4, l5, l6, l7, ....');
  expect(lightCountText(null, 12)).toBe('Lights: 12.');
});

test.each([
  [{ name: 'floor', geometry: 'plane' as const }, 'floor'],
  [{ geometry: 'plane' as const }, 'plane'],
  [{ src: 'models/teapot.glb?v=2#a', geometry: 'plane' as const }, 'teapot.glb'],
  [{ src: 'models/' }, 'mesh 3'],
  [{ src: new File([], 'bunny.stl') }, 'bunny.stl'],
  [{}, 'mesh 3'],
])('a mesh of %j has a title', (values, title) => {
  expect(meshTitle(null, { name: '', src: '', geometry: null, ...values }, 2)).toBe(title);
});

describe("the page's own words", () => {
  test('replace a text by its English form, values included', () => {
    const texts = {
      'Lights: {lights}.': 'Lichter: {lights}.',
      '{name} (off)': '{name} (aus)',
      '{name}: point light, position {position}, diffuse {diffuse}':
        'Punktlicht {name} bei {position}',
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
