// A picture's lights are packed anew, or by their places alone, as what has changed since the last frame asks for: the bits are
// those of a picture that has never drawn before.

import fc from 'fast-check';
import { expect, it } from 'vitest';
import { LightSet } from '../../src/light/light-set.js';
import { LightState } from '../../src/light/light-state.js';
import { PhongLighting, type ShadingFrame } from '../../src/material/lighting.js';
import { anyLight } from './arbitraries.js';

const SEED = 1;

interface Picture {
  readonly lights: LightSet;
  frame: ShadingFrame;
  linear: boolean;
}

const frameAt = (origin: ShadingFrame['origin'], turn: number): ShadingFrame => ({
  origin,
  eye: [4 * Math.sin(turn), 0, 4 * Math.cos(turn)],
  right: [Math.cos(turn), 0, -Math.sin(turn)],
  up: [0, 1, 0],
  back: [Math.sin(turn), 0, Math.cos(turn)],
});

function packedBy(lighting: PhongLighting, { frame, linear }: Picture): object {
  lighting.linear = linear;
  lighting.update(frame);
  const { data, rows, active, sent, counts, shapes } = lighting.packed;
  return {
    rows,
    active,
    sent,
    counts,
    data: [...data.slice(0, rows * 4)],
    shapes: [...shapes.slice(0, sent)],
  };
}

const coordinate = fc.double({ min: -9, max: 9, noNaN: true });
const place = fc.tuple(coordinate, coordinate, coordinate);

/** What may happen to a picture between two frames; mostly moves, as in motion. */
const change: fc.Arbitrary<(picture: Picture) => void> = fc.oneof(
  {
    weight: 3,
    arbitrary: place.map((to) => ({ lights }: Picture) => {
      for (const light of lights.lights) light.set('position', [...to, light.values.position[3]]);
    }),
  },
  fc.tuple(fc.nat(), anyLight).map(([i, values]) => ({ lights }: Picture) => {
    lights.lights[i % Math.max(lights.lights.length, 1)]?.assign(values);
  }),
  anyLight.map((values) => ({ lights }: Picture) => {
    lights.add(new LightState(values));
  }),
  fc.constant(({ lights }: Picture) => {
    lights.assign(lights.lights.slice(1));
  }),
  fc.tuple(place, coordinate).map(([origin, turn]) => (picture: Picture) => {
    picture.frame = frameAt(origin, turn);
  }),
  coordinate.map((turn) => (picture: Picture) => {
    picture.frame = frameAt(picture.frame.origin, turn);
  }),
  fc.boolean().map((linear) => (picture: Picture) => {
    picture.linear = linear;
  }),
);

it(`packs what a new picture packs, whatever changes from frame to frame (seed ${SEED})`, () => {
  const frames = fc.array(fc.array(change, { minLength: 1, maxLength: 2 }), { minLength: 2, maxLength: 8 });
  fc.assert(
    fc.property(fc.array(anyLight, { maxLength: 4 }), frames, (lights, changes) => {
      const picture: Picture = { lights: new LightSet(), frame: frameAt([0, 0, 0], 0), linear: false };
      picture.lights.assign(lights.map((values) => new LightState(values)));
      const lighting = new PhongLighting(picture.lights);
      packedBy(lighting, picture);
      for (const inOneFrame of changes) {
        for (const happen of inOneFrame) happen(picture);
        expect(packedBy(lighting, picture)).toStrictEqual(
          packedBy(new PhongLighting(picture.lights), picture),
        );
      }
    }),
    { numRuns: 500, seed: SEED },
  );
});
