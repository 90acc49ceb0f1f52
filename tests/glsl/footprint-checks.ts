// The averaged lobe and what it is made of, in float32 against float64, with footprints that are given; and with the
// derivatives of neighbours that may be anything.
import { add, dot, normalize, scale, subtract, type Vec3, type Vec4 } from '../../src/math/vector.js';
import { declaredFeatures } from '../../src/light/light-features.js';
import { emptyPack, packLights } from '../../src/light/pack-lights.js';
import { LIGHT_FIELDS, type LightValues } from '../../src/light/light-state.js';
import { LARGEST_MILD_POWER } from '../../src/light/light-layout.js';
import { BRANCHES } from '../stress/contract.js';
import { float32, type Random } from '../stress/random.js';
import type { Check, Numbers } from './chunk-checks.js';
import { closedAverage, type Sides } from './filtered-lobe.js';
import { MILD_POWER_ERROR } from './worst-driver.js';

const f = Math.fround;
const FILTER = 'FILTER_HIGHLIGHTS';

/** n, e and sides from eight numbers: what is missing is halves and quarters of others, which round nothing. */
const GIVEN = `
  vec3 dx = a.xyz;
  vec3 dy = vec3(b.xy, 0.5 * b.x);
  vec3 e = vec3(b.zw, -0.25 * b.w);`;

function given([x, y, z, n]: Numbers, [u, v, s, t]: Numbers): { e: Vec3; sides: Sides; n: number } {
  const sides: Sides = { dx: [x!, y!, z!], dy: [u!, v!, 0.5 * u!] };
  return { e: [s!, t!, -0.25 * t!], sides, n: n! };
}

/** Footprints from nothing to as wide as they can be, parallel sides among them; e where the average is not nothing. */
function footprints(random: Random, n: number): readonly [Numbers, Numbers] {
  const size = random.pick([0, random.magnitude(1e-9, 1e-3), random.magnitude(1e-3, 1), 2]);
  const across = scale(random.unit(), size * random.pick([1e-3, 0.1, 1]));
  const aside = scale(random.unit(), size);
  const k = random.from(-1, 1);
  // With z half of x both sides can be parallel.
  const dx: Vec3 = random.pick([aside, [aside[0], aside[1], 0.5 * aside[0]]]);
  const dy = random.pick([across, scale(dx, k)]);
  // x^n jumps at x = 0 where n is next to nothing.
  const reach = Math.min(2.5 * (size + 1 / Math.sqrt(Math.max(n, 1))), n < 1 ? 1.3 : 2);
  const e = scale(random.unit(), random.pick([0, random.from(0, reach)]));
  return [
    [...float32(dx), f(n)],
    [f(dy[0]), f(dy[1]), f(e[0]), f(e[1])],
  ];
}

const anyExponent = (random: Random): number =>
  random.pick([0, 1, 1e6, random.magnitude(1e-3, 1), random.magnitude(1, 1e6)]);

const averaged = (
  title: string,
  defines: readonly string[],
  exponent: (random: Random) => number,
  bound: number,
): Check => ({
  title,
  defines: [FILTER, ...defines],
  glsl: `${GIVEN}
  result.x = averagedLobe(e, a.w, footprintOf(dx, dy, a.w));`,
  inputs: (random) => footprints(random, exponent(random)),
  expected(a, b) {
    const { e, sides, n } = given(a, b);
    return [closedAverage(e, sides, n)];
  },
  bound,
  floor: 1,
});

/** Unit vectors in front of N = z, and sides that W, V or N may move by, from their last number. */
const SIDES = 'vec3 dx = b.w * vec3(1.0, 0.5, -0.25); vec3 dy = b.w * vec3(-0.5, 1.0, 0.125);';
const sidesOf = (w: number): Sides => ({ dx: [w, 0.5 * w, -0.25 * w], dy: [-0.5 * w, w, 0.125 * w] });
const N: Vec3 = [0, 0, 1];

function lobeInputs(random: Random): readonly [Numbers, Numbers] {
  const L = random.unit();
  const front: Vec3 = [L[0], L[1], Math.abs(L[2])];
  const V = random.pick([
    random.unit(),
    normalize(add([-front[0], -front[1], front[2]], scale(random.unit(), 0.01))),
    [0, 0, 0] as Vec3,
  ]);
  const n = random.magnitude(1, 1e3);
  return [
    [...float32(front), f(n)],
    [...float32(V), f(random.magnitude(1e-3, 1))],
  ];
}

/** As turning() in the shader. */
function turning(along: Vec3, move: Vec3, squared: number): Vec3 {
  const across = subtract(move, scale(along, dot(along, move)));
  return scale(across, 1 / Math.sqrt(Math.max(squared + dot(across, across), 1e-30)));
}

const LOBES: readonly Check[] = [
  {
    title: 'specularLobe is Phong’s averaged over the sides that W moves by, and 0 without a view',
    defines: [FILTER],
    glsl: `${SIDES}
      vec3 N = vec3(0.0, 0.0, 1.0);
      PixelView view = PixelView(mirroredView(N, b.xyz), dx, dy, vec3(0.0), vec3(0.0), footprintOf(dx, dy, a.w));
      result.x = specularLobe(N, a.xyz, view, a.w);`,
    inputs: lobeInputs,
    expected([x, y, z, n], [u, v, w, side]) {
      const V: Vec3 = [u!, v!, w!];
      if (V.every((c) => c === 0)) return [0];
      const W = subtract(scale(N, 2 * dot(N, V)), V);
      return [closedAverage(subtract([x!, y!, z!], W), sidesOf(side!), n!)];
    },
    bound: 1e-6, // measured 7.7e-7
    floor: 1,
  },
  {
    title: 'specularLobe is Phong’s averaged over what L turns by too, where the light is near',
    defines: [FILTER],
    glsl: `${SIDES}
      vec3 N = vec3(0.0, 0.0, 1.0);
      vec3 W = mirroredView(N, b.xyz);
      PixelView view = PixelView(W, dx, dy, dy, -dx, footprintOf(dx, dy, a.w));
      result.x = specularLobe(N, a.xyz, pixelViewNear(view, a.xyz, 0.5, a.w), a.w);`,
    inputs: lobeInputs,
    expected([x, y, z, n], [u, v, w, side]) {
      const V: Vec3 = [u!, v!, w!];
      if (V.every((c) => c === 0)) return [0];
      const L: Vec3 = [x!, y!, z!];
      const W = subtract(scale(N, 2 * dot(N, V)), V);
      const { dx, dy } = sidesOf(side!);
      const turned = { dx: add(dx, turning(L, dy, 0.25)), dy: add(dy, turning(L, scale(dx, -1), 0.25)) };
      return [closedAverage(subtract(L, W), turned, n!)];
    },
    bound: 1e-6, // measured 7.3e-7
    floor: 1,
  },
  {
    title: 'specularLobe is Blinn’s averaged over what N and H move by, and 0 where there is no H',
    defines: [FILTER, 'REFLECTION_BLINN_PHONG'],
    glsl: `${SIDES}
      vec3 N = vec3(0.0, 0.0, 1.0);
      PixelView view = PixelView(b.xyz, 0.5 * dx, dy, -dy, 0.25 * dx, dy, dx);
      result.x = specularLobe(N, a.xyz, view, a.w);
      result.y = specularLobe(N, a.xyz, pixelViewNear(view, a.xyz, 0.5, a.w), a.w);`,
    inputs(random) {
      // The contract leaves out L + V nearly 0: there roundings of the inputs decide where H points.
      let [a, b] = lobeInputs(random);
      while (Math.hypot(a[0]! + b[0]!, a[1]! + b[1]!, a[2]! + b[2]!) < BRANCHES.half)
        [a, b] = lobeInputs(random);
      return random.chance(0.1)
        ? [
            [0, 0, 0, a[3]!],
            [0, 0, 0, b[3]!],
          ]
        : [a, b];
    },
    expected([x, y, z, n], [u, v, w, side]) {
      const L: Vec3 = [x!, y!, z!];
      const sum = add(L, [u!, v!, w!]);
      if (dot(sum, sum) === 0) return [0, 0];
      const H = normalize(sum);
      const { dx, dy } = sidesOf(side!);
      const squared = dot(sum, sum);
      const e = subtract(N, H);
      const average = (dxSum: Vec3, dySum: Vec3): number =>
        closedAverage(
          e,
          {
            dx: subtract(scale(dy, -1), turning(H, dxSum, squared)),
            dy: subtract(scale(dx, 0.25), turning(H, dySum, squared)),
          },
          n!,
        );
      const half = scale(dx, 0.5);
      return [
        average(half, dy),
        average(subtract(half, turning(L, dy, 0.25)), subtract(dy, turning(L, dx, 0.25))),
      ];
    },
    bound: 1e-5, // measured 5.4e-6, of five million inputs
    floor: 1,
  },
];

/** Of neighbours that a triangle does not reach: beyond its horizon there may be anything. */
function anything(random: Random): Vec3 {
  const size = random.pick([0, 1e-30, 1, random.magnitude(1e-15, 1e15), 1e18, 3e38, Infinity]);
  const v = random.unit();
  return size < Infinity
    ? float32(scale(v, size))
    : [Infinity * Math.sign(v[0]), random.pick([0, -Infinity]), v[2]];
}

function anythingGoes(reflection: 'phong' | 'blinn-phong'): Check {
  const lamp = (position: Vec4): LightValues => ({
    ...(Object.fromEntries(
      Object.entries(LIGHT_FIELDS).map(([key, field]) => [key, field.fallback]),
    ) as unknown as LightValues),
    position,
  });
  const packed = emptyPack();
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const space = { worldToShading: identity, cameraToShading: identity, linear: false };
  const lamps = [lamp([0, 0, 1, 0]), lamp([0, 0, 3, 1]), lamp([1e15, 1e15, 0, 1])];
  packLights(lamps, space, packed);
  const rows = Array.from({ length: packed.rows }, (_, row) => {
    const four = [...packed.data.subarray(row * 4, row * 4 + 4)];
    return `vec4(${four.map((x) => x.toExponential(9)).join(', ')})`;
  });
  const facts = [`DECLARED_FEATURES ${String(declaredFeatures(lamps))}`];
  return {
    title: `surfaceColor of ${reflection} stays between 0 and what the lights bring, whatever its neighbours are`,
    defines: [FILTER, ...facts, ...(reflection === 'phong' ? [] : ['REFLECTION_BLINN_PHONG'])],
    rows: `const vec4 ROWS[${String(packed.rows)}] = vec4[](${rows.join(', ')});\nvec4 lightRow(int i) { return ROWS[i]; }\n`,
    glsl: `
      vec3 eye = vec3(0.0, 0.0, 5.0);
      vec3 color = surfaceColor(a.xyz, b.xyz, eye, vec3(0.0), vec3(0.0), vec3(1.0), a.w);
      result.x = color.x >= 0.0 && color.x <= 3.001 ? 1.0 : 0.0;`,
    inputs: (random) => [[...anything(random), f(anyExponent(random))], anything(random)],
    expected: () => [1],
    bound: 0,
  };
}

export const FOOTPRINT_CHECKS: readonly Check[] = [
  averaged(
    'averagedLobe keeps the closed form for any footprint and exponents to 1e6',
    [],
    anyExponent,
    2e-6, // measured: 6.1e-7 to 8.2e-7 of eleven runs on four stacks, 1.04e-6 and 1.73e-6 (H200, OpenGL) of two others
  ),
  averaged('averagedLobe multiplies a whole exponent out', ['INTEGER_SHININESS 8'], () => 8, 1e-6),
  averaged(
    'averagedLobe raises a mild exponent from the chord, without the series',
    ['SHININESS_IS_MILD'],
    (random) => random.magnitude(1, LARGEST_MILD_POWER),
    MILD_POWER_ERROR,
  ),
  {
    title: 'turning is the sine that a unit vector turns by, of at most 1',
    defines: [FILTER],
    glsl: 'result.xyz = turning(a.xyz, b.xyz, a.w * a.w);',
    inputs(random) {
      const d = random.pick([0, random.magnitude(1e-15, 1e15)]);
      const move = random.pick([0, d, random.magnitude(1e-15, 1e18)]);
      const L = d === 0 ? ([0, 0, 0] as Vec3) : random.unit();
      // Not along L: of a long move there what is across is rounding alone, times one over the sine between them.
      let way = random.unit();
      while (Math.abs(dot(way, L)) > 0.995) way = random.unit();
      return [[...float32(L), f(d)], float32(scale(way, move))];
    },
    expected: ([x, y, z, d], move) => turning([x!, y!, z!], move as unknown as Vec3, d! * d!),
    bound: 2.5e-6, // twelve roundings over a sine of 0.1 or more
    floor: 1,
  },
  ...LOBES,
  anythingGoes('phong'),
  anythingGoes('blinn-phong'),
];
