// Lights that only move are packed by their places alone: the same bits as packing everything, whatever else changed before.

import fc from 'fast-check';
import { expect, it } from 'vitest';
import type { LightValues } from '../../src/light/light-state.js';
import { emptyPack, packLights, type PackedLights } from '../../src/light/pack-lights.js';
import { anyLight, light } from './arbitraries.js';
import { WORLD } from './packed-reader.js';

const essence = ({ data, rows, active, sent, counts, shapes }: PackedLights): object => ({
  ...{ rows, active, sent, counts },
  data: [...data.slice(0, rows * 4)],
  shapes: [...shapes.slice(0, sent)],
});

function fresh(lights: readonly LightValues[], space = WORLD): object {
  const into = emptyPack();
  packLights(lights, space, into);
  return essence(into);
}

const coordinate = fc.oneof(fc.constant(0), fc.double({ min: -9, max: 9, noNaN: true }));
const places = fc.array(fc.tuple(coordinate, coordinate, coordinate), { minLength: 6, maxLength: 6 });

const move = (lights: LightValues[], to: readonly (readonly [number, number, number])[]): void => {
  lights.forEach((light, i) => (light.position = [...to[i]!, light.position[3]]));
};

it('gives the bits of packing all anew, for lights of every kind, that move to nowhere and back too', () => {
  const lists = fc.array(anyLight, { maxLength: 6 });
  fc.assert(
    fc.property(lists, places, places, (given, first, second) => {
      const lights = given.map((one) => ({ ...one }));
      const into = emptyPack();
      for (const to of [first, second, first]) {
        move(lights, to);
        packLights(lights, WORLD, into);
        expect(essence(into)).toStrictEqual(fresh(lights));
      }
    }),
    { numRuns: 500 },
  );
});

it('follows whatever else changes between moves', () => {
  const changes: readonly ((lights: LightValues[]) => unknown)[] = [
    (lights) => (lights[0]!.diffuse = [1, 2, 3]),
    (lights) => (lights[1]!.cutoff = 2),
    (lights) => (lights[1]!.aperture = 9),
    (lights) => (lights[0]!.position = [1, 2, 3, 0]),
    (lights) => (lights[0]!.position = [1, 2, 3, 1]),
    (lights) => (lights[2]!.active = false),
    (lights) => lights.reverse(),
    (lights) => lights.pop(),
    (lights) => (lights[0]!.space = 'camera'),
  ];
  const lights = fc.sample(anyLight, { numRuns: 5, seed: 1 }).map((one) => ({ ...one, active: true }));
  const to = fc.sample(places, { numRuns: 9, seed: 1 });
  const into = emptyPack();
  for (const [i, change] of changes.entries()) {
    change(lights);
    packLights(lights, WORLD, into);
    expect(essence(into)).toStrictEqual(fresh(lights));
    move(lights, to[i]!);
    packLights(lights, WORLD, into);
    expect(essence(into)).toStrictEqual(fresh(lights));
  }
  const turned = {
    ...WORLD,
    cameraToShading: Float64Array.of(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1),
  };
  packLights(lights, turned, into);
  expect(essence(into)).toStrictEqual(fresh(lights, turned));
});

it('follows a space that turns, axes and all, and ambient light that alone is left of a light', () => {
  const spot = light({ position: [1, 2, 3, 1], axis: [1, -1, 0], aperture: 20 });
  const lights = [
    spot,
    { ...spot, space: 'camera' as const },
    light({ diffuse: [0, 0, 0], specular: [0, 0, 0] }),
  ];
  const into = emptyPack();
  packLights(lights, WORLD, into);
  const turn = Float64Array.of(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1);
  for (const space of [
    { ...WORLD, worldToShading: turn },
    { ...WORLD, cameraToShading: turn },
  ]) {
    packLights(lights, space, into);
    expect(essence(into)).toStrictEqual(fresh(lights, space));
  }
  packLights(lights, WORLD, into);
  lights[2]!.ambient = [7, 8, 9];
  packLights(lights, WORLD, into);
  expect(essence(into)).toStrictEqual(fresh(lights));
});

it('finds nothing out anew of lights that move', () => {
  const lights = fc.sample(anyLight, { numRuns: 5, seed: 2 }).map((one) => ({ ...one, active: true }));
  const into = emptyPack();
  packLights(lights, WORLD, into);
  const first = into.steady.slice();
  move(lights, fc.sample(places, { numRuns: 1, seed: 2 })[0]!);
  packLights(lights, WORLD, into);
  expect(into.steady).toHaveLength(5);
  into.steady.forEach((one, i) => expect(one).toBe(first[i]));
});

it('follows a spot into another space, its axis too, where it stays at its place', () => {
  const lights = [light({ position: [1, 2, 3, 1], axis: [0, 1, 0], aperture: 30 })];
  const turned = new Float64Array([0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]);
  const space = { ...WORLD, cameraToShading: turned };
  const into = emptyPack();
  for (const named of ['world', 'camera', 'world'] as const) {
    lights[0]!.space = named;
    packLights(lights, space, into);
    expect(essence(into)).toStrictEqual(fresh(lights, space));
  }
});
