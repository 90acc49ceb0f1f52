// Is the ray caster's truth true? Against closed forms: areas of outlines, known points of known
// shapes. On smaller pictures than in a release run.
import { existsSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { LightState, type Vec3 } from '../../../src/phong/reference/index.js';
import { dot, normalize, scale, subtract } from '../../../src/phong/math/vector.js';
import { createGeometry } from '../../../src/phong/model/shapes/shapes.js';
import { castPicture } from '../../support/cast.mjs';
import { castHere } from '../../../src/extras/still/threads.js';
import type { CastMaterial, CastObject, CastScene } from '../../../src/extras/still/cast-scene.js';
import { type Sample, Tracer } from '../../../src/extras/still/tracer.js';
import { fullOr } from '../../support/repeats.js';
import { trianglesOf } from '../../visual/ray-cast.js';

const FOV = 45;
const WHITE: CastMaterial = { ka: [0, 0, 0], kd: [255, 255, 255], ks: [0, 0, 0], shininess: 32 };
const UNLIT: CastMaterial = { ...WHITE, unlit: true };

const sceneOf = (distance: number, ...objects: readonly CastObject[]): CastScene => ({
  camera: { eye: [0, 0, distance], right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1], fov: FOV },
  lights: [],
  objects,
});
const SPHERE = trianglesOf(await createGeometry('sphere', 512));
const CONE = trianglesOf(await createGeometry('cone', 512));

/** Pixels of a unit of slope. */
const pixelsOf = (height: number) => height / (2 * Math.tan((FOV * Math.PI) / 360));

describe('a picture by the ray caster', () => {
  it('covers the area of a sphere’s outline', () => {
    const size = fullOr(60, 20);
    const picture = castHere(sceneOf(1.5, { shape: SPHERE, material: UNLIT }), {
      width: size,
      height: size,
    });
    const area = picture.reduce((sum, value, i) => (i % 4 === 3 ? sum + value / 255 : sum), 0);
    // Its standard error falls with the size to the power of 3/2.
    expect((8 * area) / (Math.PI * pixelsOf(size) ** 2)).toBeCloseTo(1, fullOr(4, 3));
  });

  it('is within a quarter of a code of hundreds of samples where colours vary smoothly', () => {
    const size = { width: 24, height: 18 };
    const shiny: CastMaterial = { ...WHITE, ks: [255, 255, 255], shininess: 60 };
    const lamp = { position: [1, 1.5, 2, 1], attenuation: [1, 0.2, 0] } as const;
    const spot = { position: [-1, 1, 2, 1], axis: [1, -1, -2], aperture: 12 } as const;
    const scene = {
      ...sceneOf(1.6, { shape: SPHERE, material: shiny }, { shape: CONE, material: shiny }),
      lights: [new LightState(lamp).values, new LightState(spot).values],
    };
    const found = castHere(scene, size);
    const tracer = new Tracer(scene, size.width, size.height);
    const sample: Sample = { color: [0, 0, 0, 0], piece: 0 };
    const side = fullOr(50, 25);
    let [smooth, edges] = [0, 0];
    for (let pixel = 0; pixel < size.width * size.height; pixel += fullOr(1, 3)) {
      const [column, row] = [pixel % size.width, Math.floor(pixel / size.width)];
      const pieces = new Set<number>();
      let red = 0;
      for (let i = 0; i < side * side; i++) {
        const [x, y] = [(i % side) + 0.5, Math.floor(i / side) + 0.5];
        tracer.sampleAt(column + x / side, row + y / side, sample);
        pieces.add(sample.piece);
        red += sample.color[0] / side ** 2;
      }
      const error = Math.abs(found[4 * pixel]! - red);
      if (pieces.size === 1) {
        smooth = Math.max(smooth, error);
      } else {
        edges = Math.max(edges, error);
      }
    }
    expect(smooth).toBeLessThan(0.25);
    // The sphere has a radius of 6 pixels here: a sliver of 2 % of a pixel lies between the points.
    expect(edges).toBeLessThan(6);
  });

  it('has the mean of two colours that meet between two columns or rows of the nine points', () => {
    const size = 5;
    const slope = 1 / pixelsOf(size);
    for (const share of [0.1, 0.3, 0.7, 0.9]) {
      for (const turned of [false, true]) {
        // The first texel ends so far into the middle pixel.
        const edge = (share - 0.5) * slope;
        const across = [-1, 1, -1, 1].map((side) => edge + 4 * side);
        const down = [-4, -4, 4, 4];
        const [x, y] = turned ? [down, across] : [across, down];
        const shape = {
          positions: x.flatMap((at, i) => [at, y[i]!, 0]),
          normals: x.flatMap(() => [0, 0, 1]),
          uvs: [[0, 0.5, 1, 0.5, 0, 0.5, 1, 0.5]],
          index: [0, 1, 2, 1, 3, 2],
        } as const;
        const texture = {
          width: 2,
          height: 1,
          data: [0, 0, 0, 255, 240, 240, 240, 255],
          wrapS: 'clamp',
          nearest: true,
        } as const;
        const scene = sceneOf(1, { shape, material: { ...UNLIT, texture } });
        const found = castHere(scene, { width: size, height: size });
        const middle = found[4 * (2 * size + 2)]!;
        expect(Math.abs(middle - 240 * (1 - share)), `${share}`).toBeLessThan(1);
      }
    }
  });

  it('is the same from threads and from disk', async () => {
    const shape = trianglesOf(await createGeometry('torus', 16));
    const scene = sceneOf(1.6, { shape, material: UNLIT });
    const options = { width: 24, height: 18, samples: 16 };
    const here = castHere(scene, options);
    expect(await castPicture(scene, options)).toEqual(here);
    expect(await castPicture(scene, options)).toEqual(here);
    expect(existsSync(new URL('../../../truths', import.meta.url))).toBe(true);
  });
});

const lights = [new LightState({ position: [1, 2, 3, 0], specular: [0, 0, 0] }).values];
const L = normalize([1, 2, 3]);

it('a ray sees N·L at known points of spheres that are moved, stretched and mirrored', () => {
  for (const stretch of [
    [1, 1, 1],
    [1, 0.5, 2],
    [-1, 1, 0.3],
  ] as const) {
    const [a, b, c] = stretch;
    const matrix = [a, 0, 0, 0, 0, b, 0, 0, 0, 0, c, 0, 0.2, 0.1, 0, 1];
    const scene = { ...sceneOf(4, { shape: SPHERE, material: WHITE, matrix }), lights };
    const tracer = new Tracer(scene, 100, 100);
    for (const direction of [
      [0, 0, 1],
      [0.6, 0, 0.8],
      [-0.36, 0.48, 0.8],
    ] as const) {
      // On the side toward the eye, whichever way the shape is mirrored.
      const local = scale([a < 0 ? -direction[0] : direction[0], direction[1], direction[2]], 0.5);
      const place: Vec3 = [a * local[0] + 0.2, b * local[1] + 0.1, c * local[2]];
      const N = normalize([local[0] / a, local[1] / b, local[2] / c]);
      const { x, y } = tracer.screen.project(subtract(place, scene.camera.eye));
      const sample: Sample = { color: [0, 0, 0, 0], piece: 0 };
      tracer.sampleAt(x, y, sample);
      expect(sample.color[0]).toBeCloseTo(255 * Math.max(dot(N, L), 0), 2);
    }
  }
});
