// Are a picture's lights packed again whenever something changed, and then as a new picture packs
// them?

import fc from 'fast-check';
import { PerspectiveCamera } from 'three';
import { expect, it } from 'vitest';
import { LightSet } from '../../../src/phong/light/light-set.js';
import { LightState } from '../../../src/phong/light/light-state.js';
import { PhongLighting, type ShadingFrame } from '../../../src/phong/core.js';
import { anyLight, between, triple } from '../arbitraries.js';

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

function packedBy(lighting: PhongLighting, { frame, linear }: Picture) {
  lighting.linear = linear;
  lighting.updateFrame(frame);
  const { data, rows, active, sent, counts, features } = lighting.packing.buffer.packed;
  return {
    rows,
    active,
    sent,
    counts,
    data: [...data.slice(0, rows * 4)],
    features: [...features.slice(0, sent)],
  };
}

const coordinate = between(-9, 9);
const place = fc.oneof(
  { weight: 2, arbitrary: triple(coordinate) },
  fc.constant<[number, number, number]>([0, 0, 0]),
);

/**
 * Half of them without cone and decay: what a directional light's constant cone leaves of it
 * changes as it turns.
 */
const light = fc.oneof(
  anyLight,
  anyLight.map((values) => ({ ...values, aperture: 180, cutoff: 0 })),
);

/** What may happen to a picture between two frames; mostly moves, as in motion. */
const change: fc.Arbitrary<(picture: Picture) => void> = fc.oneof(
  {
    weight: 3,
    arbitrary: place.map((to) => ({ lights }: Picture) => {
      for (const light of lights.lights) {
        light.set('position', [...to, light.values.position[3]]);
      }
    }),
  },
  fc.tuple(fc.nat(), light).map(([i, values]) => ({ lights }: Picture) => {
    lights.lights[i % Math.max(lights.lights.length, 1)]?.assign(values);
  }),
  light.map((values) => ({ lights }: Picture) => {
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
  fc.boolean().map((active) => ({ lights }: Picture) => {
    lights.lights[0]?.set('active', active);
  }),
  fc.boolean().map((linear) => (picture: Picture) => {
    picture.linear = linear;
  }),
);

it(`a picture packs what a new picture packs, whatever changes between frames (seed ${SEED})`, () => {
  const frames = fc.array(fc.array(change, { minLength: 1, maxLength: 2 }), {
    minLength: 2,
    maxLength: 8,
  });
  fc.assert(
    fc.property(fc.array(light, { maxLength: 4 }), frames, (lights, changes) => {
      const picture: Picture = {
        lights: new LightSet(),
        frame: frameAt([0, 0, 0], 0),
        linear: false,
      };
      picture.lights.assign(lights.map((values) => new LightState(values)));
      const lighting = new PhongLighting(picture.lights);
      packedBy(lighting, picture);
      for (const inOneFrame of changes) {
        for (const happen of inOneFrame) {
          happen(picture);
        }
        expect(packedBy(lighting, picture)).toStrictEqual(
          packedBy(new PhongLighting(picture.lights), picture),
        );
      }
    }),
    { numRuns: 500, seed: SEED },
  );
});

it('a three.js camera gives the same as a frame with the same eye, axes and origin', () => {
  const lights = new LightSet();
  lights.add(new LightState({ space: 'camera', position: [1, 2, 3, 1] }));
  lights.add(new LightState({ position: [4, 5, 6, 1] }));
  const camera = new PerspectiveCamera();
  camera.position.set(14 + 4 * Math.sin(0.5), 3, 7 + 4 * Math.cos(0.5));
  camera.rotation.y = 0.5;
  camera.updateMatrixWorld();
  const [byCamera, byFrame] = [new PhongLighting(lights), new PhongLighting(lights)];
  byCamera.update(camera, [14, 3, 7]);
  byFrame.updateFrame(frameAt([14, 3, 7], 0.5));
  expect(byCamera.space.origin).toStrictEqual([14, 3, 7]);
  expect(byCamera.space.eye.value.distanceTo(byFrame.space.eye.value)).toBeLessThan(1e-12);
  const { data: packed, rows } = byFrame.packing.buffer.packed;
  byCamera.packing.buffer.packed.data
    .subarray(0, rows * 4)
    .forEach((x, i) => expect(x).toBeCloseTo(packed[i]!, 5));
  byCamera.update(camera);
  expect(byCamera.space.origin).toStrictEqual([0, 0, 0]);
});
