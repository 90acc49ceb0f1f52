// Do the levels of `segments="auto"` show what the round shapes show, at the default view? In
// float64, by rays. Fewer sizes, lines and pixels than in a release run, which has them all.
import { expect, it } from 'vitest';
import { fitRadius } from '../../../src/phong/camera/fit.js';
import { basisOf, type Pose } from '../../../src/phong/camera/orbit.js';
import { dot, normalize, scale, type Vec3 } from '../../../src/phong/math/vector.js';
import { LightState } from '../../../src/phong/reference/index.js';
import type { Frustum } from '../../../src/phong/geometry/frustum-clip.js';
import { levelIn } from '../../../src/phong/model/shapes/segments.js';
import {
  createGeometry,
  type GeometryName,
  roundOf,
} from '../../../src/phong/model/shapes/shapes.js';
import { outlineErrors } from '../../support/outlines.js';
import type { CastShape } from '../../../src/extras/still/cast-scene.js';
import { type Sample, Tracer } from '../../../src/extras/still/tracer.js';
import { firstOf, fullOr } from '../../support/repeats.js';
import { IDENTITY } from '../../support/matrices.js';
import { trianglesOf } from '../../visual/ray-cast.js';

type RoundName = Exclude<GeometryName, 'box' | 'plane' | 'pyramid'>;

const FOV = 45;
const SLOPE = Math.tan((FOV * Math.PI) / 360);
const HEADLIGHT = new LightState({ space: 'camera', position: [0, 0, 1, 0] }).values;
const POSE = { theta: 30, phi: 70 };
const gray = (code: number): Vec3 => [code, code, code];

const built = async (name: RoundName, segments: number, isLevel: boolean) =>
  trianglesOf(await createGeometry(name, segments, isLevel));

/**
 * A picture that a shape fills: its view, and how shapes are seen in it, of a default material but
 * for the exponent.
 */
function pictureOf(name: RoundName, size: number, pose: Pick<Pose, 'theta' | 'phi'>) {
  const radius = fitRadius(roundOf(name)!.radius, FOV, 1);
  const basis = basisOf(pose);
  const eye = scale(basis.back, radius);
  const view: Frustum = {
    frame: { origin: [0, 0, 0], eye, ...basis },
    slopeX: SLOPE,
    slopeY: SLOPE,
    radius,
  };
  const tracer = (shape: CastShape, shininess: number) => {
    const material = { ka: gray(200), kd: gray(200), ks: gray(128), shininess };
    const camera = { ...basis, eye, fov: FOV };
    return new Tracer({ camera, lights: [HEADLIGHT], objects: [{ shape, material }] }, size, size);
  };
  return { view, tracer };
}

const LINES = fullOr(60, 12);

/**
 * Least share of pixels within one code. Measured at 60, 200, 400 and 800 pixels, exponents 32 and
 * 200.
 */
const LEAST: Readonly<Record<RoundName, number>> = {
  sphere: 0.995,
  cylinder: 0.995,
  cone: 0.995,
  torus: 0.98,
  'torus-knot': 0.94, // 0.942 at 60 pixels, exponent 32
  teapot: 0.75,
};
const NAMES = Object.keys(LEAST) as RoundName[];

/** Segments of shapes that stand for the round ones. */
const MANY: Readonly<Record<RoundName, number>> = {
  sphere: 512,
  cylinder: 512,
  cone: 2048,
  torus: 512,
  'torus-knot': 1024,
  teapot: 256,
};

/** Sizes of pictures in pixels, the first one in a short run. */
const OUTLINES = [
  ['sphere', [400, 100, 1600]],
  ['torus', [400, 100, 1600]],
  ['torus-knot', [100, 400, 1600]],
  ['teapot', [100, 400, 1600]],
] as const;

it.each(
  OUTLINES.flatMap(([name, sizes]) => firstOf(sizes, 1).map((size) => [name, size] as const)),
)(
  'outlines of a %s of %i pixels, inner ones too, are within 1/4 of a pixel of the round ones',
  async (name, size) => {
    for (const pose of name !== 'sphere' || size === 1600
      ? [POSE]
      : [POSE, { theta: 250, phi: 50 }]) {
      const { view, tracer } = pictureOf(name, size, pose);
      // In a picture that may have as many triangles as the outline needs.
      const level = levelIn(view, size, false, name, IDENTITY, Infinity)!;
      // Triangles that are 1/9 as far off as the level's.
      const [round, drawn] = [await built(name, 3 * level, false), await built(name, level, true)];
      const { worst, compared, missed } = outlineErrors(tracer(round, 1), tracer(drawn, 1), LINES);
      expect([compared > LINES, missed]).toEqual([true, 0]);
      expect(worst).toBeLessThan(0.25);
    }
  },
);

const PIXELS = fullOr(8000, 1500);

const CASES = firstOf(NAMES, 4).flatMap((name) =>
  firstOf(LEAST[name] < 0.99 ? [800, 60, 200, 400] : [200, 60, 400, 800], 1).map(
    (size) => [name, size] as const,
  ),
);

/** Random pixels whose centre and corners meet one smooth face. */
it.each(CASES)(
  'shades a %s of %i pixels as the round shape, within one code',
  async (name, size) => {
    const { view, tracer } = pictureOf(name, size, POSE);
    const level = levelIn(view, size, false, name, IDENTITY, 2 ** 14)!;
    const [round, drawn] = [await built(name, MANY[name], false), await built(name, level, true)];
    for (const shininess of [32, 200]) {
      const [truth, picture] = [tracer(round, shininess), tracer(drawn, shininess)];
      const colorOf = (of: Tracer, x: number, y: number) => {
        const sample: Sample = { color: [0, 0, 0, 0], piece: 0 };
        of.sampleAt(x, y, sample);
        return sample.color;
      };
      /** Null where nothing is met. */
      const hitAt = (x: number, y: number) => {
        const { t, normal } = truth.hitAt(x, y);
        return t === Infinity ? null : { t, N: normalize(normal) };
      };
      let [inside, close] = [0, 0];
      for (let k = 0; k < PIXELS; k++) {
        // Spread evenly: the golden ratio's multiples.
        const x = Math.floor(size * ((k * 0.7548776662) % 1));
        const y = Math.floor(size * ((k * 0.5698402909) % 1));
        const center = hitAt(x + 0.5, y + 0.5);
        const isSmooth = (i: number) => {
          const corner = hitAt(x + 0.02 + 0.96 * (i & 1), y + 0.02 + 0.96 * (i >> 1));
          return (
            corner !== null &&
            dot(corner.N, center!.N) > 0.7 &&
            Math.abs(corner.t / center!.t - 1) < 0.04
          );
        };
        if (center === null || ![0, 1, 2, 3].every(isSmooth)) continue;
        const expected = colorOf(truth, x + 0.5, y + 0.5);
        const found = colorOf(picture, x + 0.5, y + 0.5);
        inside += 1;
        if (found.every((code, i) => Math.abs(code - expected[i]!) <= 1)) {
          close += 1;
        }
      }
      expect(inside, 'pixels').toBeGreaterThan(PIXELS / 20);
      const text = `${name}, ${size} pixels, exponent ${shininess}: ${level} segments`;
      expect(close / inside, text).toBeGreaterThanOrEqual(LEAST[name]);
    }
  },
);
