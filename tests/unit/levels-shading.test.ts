// Is what the levels of `segments="auto"` show within a face what the round shape shows? The share of pixels within one
// code of it, in float64, for a headlight on the default material. Random pixels whose centre and corners meet one
// smooth face. All four sizes in a release run.
import { expect, it } from 'vitest';
import { fitRadius } from '../../src/camera/fit.js';
import { basisOf } from '../../src/camera/orbit.js';
import { dot, normalize, scale, type Vec3 } from '../../src/math/vector.js';
import { LightState } from '../../src/reference/index.js';
import { levelIn } from '../../src/scene/mesh/levels.js';
import { createGeometry, roundOf } from '../../src/scene/mesh/shapes/shapes.js';
import type { CastShape } from '../support/caster/scene.js';
import { type Sample, Tracer } from '../support/caster/tracer.js';
import { firstOf, fullOr } from '../support/repeats.js';
import type { RoundName } from '../support/round-shapes.js';

const FOV = 45;
const SLOPE = Math.tan((FOV * Math.PI) / 360);
const PIXELS = fullOr(8000, 1500);
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const LIGHT = new LightState({ space: 'camera', position: [0, 0, 1, 0] }).values;

async function built(name: RoundName, segments: number, isLevel: boolean): Promise<CastShape> {
  const geometry = await createGeometry(name, segments, isLevel);
  const array = (key: string) => geometry.getAttribute(key).array;
  return {
    ...{ kind: 'triangles', positions: array('position'), normals: array('normal') },
    index: geometry.index!.array,
  };
}

/** The knot and the teapot by many triangles. */
const roundShape = (name: RoundName): CastShape | Promise<CastShape> =>
  name === 'torus-knot'
    ? built(name, 1024, false)
    : name === 'teapot'
      ? built(name, 256, false)
      : { kind: name };

/** Least share of pixels. Measured at 60, 200, 400 and 800 pixels, exponents 32 and 200. */
const LEAST: Readonly<Record<RoundName, number>> = {
  sphere: 0.995,
  cylinder: 0.995,
  cone: 0.995,
  torus: 0.98,
  'torus-knot': 0.95,
  teapot: 0.75,
};

const CASES = (Object.keys(LEAST) as RoundName[]).flatMap((name) =>
  firstOf(name === 'teapot' || name === 'torus-knot' ? [800, 60, 200, 400] : [200, 60, 400, 800], 1).map(
    (size) => [name, size] as const,
  ),
);

it.each(CASES)('shades a %s of %i pixels as the round shape, within one code', async (name, size) => {
  const distance = fitRadius(roundOf(name)!.radius, FOV, 1);
  const basis = basisOf({ theta: 30, phi: 70 });
  const eye = scale(basis.back, distance);
  const frame = { origin: [0, 0, 0] as const, eye, ...basis };
  const view = { frame, slopeX: SLOPE, slopeY: SLOPE, radius: distance };
  const level = levelIn(view, size, false, name, IDENTITY, 2 ** 14)!;
  const [round, drawn] = [await roundShape(name), await built(name, level, true)];
  for (const shininess of [32, 200]) {
    const gray = (code: number): Vec3 => [code, code, code];
    const material = { ka: gray(200), kd: gray(200), ks: gray(128), shininess };
    const tracer = (shape: CastShape): Tracer =>
      new Tracer(
        { camera: { ...basis, eye, fov: FOV }, lights: [LIGHT], objects: [{ shape, material }] },
        size,
        size,
      );
    const [truth, picture] = [tracer(round), tracer(drawn)];
    const colorOf = (of: Tracer, x: number, y: number): readonly number[] => {
      const sample: Sample = { color: [0, 0, 0, 0], piece: 0 };
      of.sampleAt(x, y, sample);
      return sample.color;
    };
    /** Null where nothing is met. */
    const hitAt = (x: number, y: number): { readonly t: number; readonly N: Vec3 } | null => {
      const { t, nx, ny, nz } = truth.hitAt(x, y);
      return t === Infinity ? null : { t, N: normalize([nx, ny, nz]) };
    };
    let [inside, close] = [0, 0];
    for (let k = 0; k < PIXELS; k++) {
      // Spread evenly: the golden ratio's multiples.
      const [x, y] = [
        Math.floor(size * ((k * 0.7548776662) % 1)),
        Math.floor(size * ((k * 0.5698402909) % 1)),
      ];
      const center = hitAt(x + 0.5, y + 0.5);
      const isSmooth = (corner: ReturnType<typeof hitAt>): boolean =>
        corner !== null && dot(corner.N, center!.N) > 0.7 && Math.abs(corner.t / center!.t - 1) < 0.04;
      const corners = [0, 1, 2, 3].map(
        (i) => [x + 0.02 + 0.96 * (i & 1), y + 0.02 + 0.96 * (i >> 1)] as const,
      );
      if (center === null || !corners.every(([cx, cy]) => isSmooth(hitAt(cx, cy)))) continue;
      const expected = colorOf(truth, x + 0.5, y + 0.5);
      const found = colorOf(picture, x + 0.5, y + 0.5);
      inside += 1;
      if (found.every((code, i) => Math.abs(code - expected[i]!) <= 1)) close += 1;
    }
    expect(inside, 'pixels').toBeGreaterThan(PIXELS / 20);
    const text = `${name}, ${String(size)} pixels, exponent ${String(shininess)}: ${String(level)} segments`;
    console.log(`${text}, ${((100 * close) / inside).toFixed(1)} % of ${String(inside)} within one code`);
    expect(close / inside, text).toBeGreaterThanOrEqual(LEAST[name]);
  }
});
