// What only programs for exactly some lights have: whole exponents, vectors of usual lengths, lights written out or in loops
// over what they have in common. Each against the same law in float64.
import { SHAPE } from '../../src/light/light-layout.js';
import { emptyPack, packLights } from '../../src/light/pack-lights.js';
import { LIGHT_FIELDS, type LightValues } from '../../src/light/light-state.js';
import {
  constant,
  constantRows,
  counted,
  inLoops,
  rowText,
  writtenOut,
} from '../../src/material/exact-lights.js';
import { add, dot, normalize, scale, subtract, type Vec3 } from '../../src/math/vector.js';
import { shade, type Surface } from '../../src/reference/equation.js';
import { float32, Random } from '../stress/random.js';
import type { Check } from './chunk-checks.js';

/** L of a light in front, and V anywhere, exactly opposite L and zero among them. */
function lobeInputs(random: Random): readonly [number[], number[]] {
  const [x, y, z] = random.unit();
  const L: Vec3 = [x, y, Math.abs(z)];
  const V = random.pick([random.unit(), scale(L, -1), [0, 0, 0] as Vec3, add(L, scale(random.unit(), 0.1))]);
  return [[...float32(L)], [...float32(normalize(V))]];
}

const blinn: Check['expected'] = ([x, y, z], V) => [
  Math.max(normalize(add([x!, y!, z!], V as unknown as Vec3))[2], 0) ** 8,
];

/** The same without V = -L: of a sum that is nothing but rounding, an H200 makes some H, and software none. */
function blinnInputs(random: Random): readonly [number[], number[]] {
  for (;;) {
    const inputs = lobeInputs(random);
    const [L, V] = inputs;
    const isView = Math.hypot(...V) > 0;
    if (!isView || Math.hypot(...add(L as unknown as Vec3, V as unknown as Vec3)) > 1e-3) return inputs;
  }
}

/** V = -L but for the last digits of float32, in which a device may leave either. */
function opposed(random: Random): readonly [number[], number[]] {
  const [L] = lobeInputs(random);
  const ulp = (x: number): number => 2 ** -23 * x * random.pick([-1, 0, 1]);
  return [L, [...float32(L.map((x) => -x + ulp(x)) as unknown as Vec3)]];
}

const lobe = (
  defines: readonly string[],
  title: string,
  expected: Check['expected'],
  bound: number,
): Check => ({
  title,
  defines,
  glsl: 'vec3 N = vec3(0.0, 0.0, 1.0); result.x = specularLobe(N, a.xyz, specularView(N, b.xyz), 8.0);',
  inputs: defines.includes('REFLECTION_BLINN_PHONG') ? blinnInputs : lobeInputs,
  expected,
  bound,
  floor: 1,
});

const LOBES: readonly Check[] = [
  ...['SHININESS_TO_64', 'INTEGER_SHININESS 8', 'IS_ANY_SHININESS'].map((define) => ({
    ...lobe(
      [define, 'REFLECTION_BLINN_PHONG'],
      `specularLobe makes no half vector of what rounding leaves of L + V (${define})`,
      () => [0],
      0,
    ),
    inputs: opposed,
  })),
  lobe(
    ['INTEGER_SHININESS 8'],
    'specularLobe multiplies a whole exponent out, and is 0 behind and without a view',
    ([x, y, z], V) => [Math.max(dot([-x!, -y!, z!], V as unknown as Vec3), 0) ** 8],
    5e-6,
  ),
  lobe(
    ['INTEGER_SHININESS 8', 'REFLECTION_BLINN_PHONG'],
    'specularLobe multiplies Blinn’s whole exponent out, and is 0 where there is no H',
    blinn,
    5e-6,
  ),
  lobe(
    ['SHININESS_TO_64', 'REFLECTION_BLINN_PHONG'],
    'specularLobe raises Blinn’s mild exponent without the series',
    blinn,
    2e-5,
  ),
  lobe(
    ['SHININESS_TO_64'],
    'specularLobe raises a mild exponent without the series',
    ([x, y, z], V) => [Math.max(dot([-x!, -y!, z!], V as unknown as Vec3), 0) ** 8],
    2e-5,
  ),
  {
    title: 'powTo64 keeps x^k to the error of log2 for exponents to 64, 0^k = 0 and x^0 = 1',
    glsl: 'result.x = powTo64(a.x, a.y);',
    inputs: (random) => [
      [
        Math.fround(random.pick([0, 1, random.from(0, 1), 1 - random.magnitude(1e-7, 0.1)])),
        Math.fround(random.pick([0, 1e-7, 0.01, 64, random.magnitude(1e-6, 64)])),
      ],
    ],
    expected: ([x, k]) => [k! < 1e-6 ? 1 : x! ** k!],
    bound: 3e-5, // 64 · 2^-21 · ln 2 of log2, and exp2's own
    floor: 1,
  },
  {
    title: 'unitOrZero gives unit vectors of vectors of usual lengths, and zero of zero',
    defines: ['USUAL_LENGTHS'],
    glsl: 'result.xyz = unitOrZero(a.xyz);',
    inputs: (random) => [
      float32(scale(random.unit(), random.pick([0, 1, 1.1e-10, random.magnitude(1.1e-10, 1e15)]))),
    ],
    expected: (v) => normalize(v as unknown as Vec3),
    bound: 4e-7, // as of any lengths
    floor: 1,
  },
];

const TERMS = { ambient: SHAPE.ambient, diffuse: SHAPE.diffuse, specular: SHAPE.specular } as const;
type Term = keyof typeof TERMS;
export const ALL: readonly Term[] = ['ambient', 'diffuse', 'specular'];

export const EYE: Vec3 = [0, 0, 5];

/** Multiplies nothing away. */
export const SURFACE: Surface = {
  ka: [255, 255, 255],
  kd: [255, 255, 255],
  ks: [255, 255, 255],
  shininess: 8,
};

export const light = (values: Partial<LightValues>): LightValues => ({
  ...(Object.fromEntries(
    Object.entries(LIGHT_FIELDS).map(([key, field]) => [key, field.fallback]),
  ) as unknown as LightValues),
  ...values,
});

/** Lights of every kind and shape around a unit ball. */
export function allLights(): LightValues[] {
  const random = new Random(1);
  const lamp = (values: Partial<LightValues>): LightValues => {
    const place = scale(random.unit(), random.from(2, 4));
    const color = { ambient: random.color(60), diffuse: random.color(60), specular: random.color(60) };
    const aim = { position: [...place, 1], axis: subtract(random.vector(-0.5, 0.5), place) } as const;
    return light({ ...color, ...aim, ...values });
  };
  const none = [0, 0, 0] as const;
  return [
    lamp({ position: [1, 2, 3, 0] }),
    lamp({ position: [-1, 1, 3, 0], specular: none }),
    lamp({ attenuation: [1, 0.2, 0.05] }),
    lamp({ diffuse: none }),
    lamp({ aperture: 25 }),
    lamp({ aperture: 110, cutoff: 3, attenuation: [0, 0, 1] }),
    lamp({ cutoff: 64 }),
    lamp({ cutoff: 2.5, ambient: none }),
    lamp({ aperture: 30, cutoff: 70.5, specular: none }),
    lamp({ aperture: 60, cutoff: 1, diffuse: none, specular: none }),
    lamp({ aperture: 60, cutoff: 12.5, attenuation: [1, 0, 0.1] }),
    lamp({ aperture: 60, cutoff: 7.5, diffuse: [50, 50, 50], attenuation: [0.5, 0.1, 0] }),
    lamp({ aperture: 172, cutoff: 0.5, specular: [40, 40, 40] }),
    lamp({ diffuse: [30, 30, 30], specular: [60, 60, 60] }),
    lamp({ diffuse: [50, 50, 50], specular: [20, 20, 20], attenuation: [0.2, 0, 0.05] }),
    lamp({ position: [1, -2, 3, 0], diffuse: [50, 50, 50], specular: [20, 20, 20] }),
  ];
}

/** All terms at place a with the normal b, seen from {@link EYE}. */
export const ANYWHERE = `
  LightSums sums = lightSums(a.xyz, b.xyz, unitOrZero(vec3(${EYE.map((x) => x.toFixed(1)).join(', ')}) - a.xyz), 8.0);
  result.xyz = sums.ambient + sums.diffuse + sums.specular;`;

const TEXTS = { 'written out': writtenOut, 'in the text': constant, counted, 'in loops': inLoops } as const;

/** `apart`: a define that says more of where they are. */
export function sumsOf(
  form: keyof typeof TEXTS,
  terms: readonly Term[],
  chosen: readonly LightValues[],
  apart: '' | 'LIGHTS_APART' = '',
): Check {
  const packed = emptyPack();
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  packLights(chosen, { worldToShading: identity, cameraToShading: identity, linear: false }, packed);
  const bits = terms.reduce((sum, term) => sum | TERMS[term], 0);
  const text = TEXTS[form](packed, bits);
  const rows = Array.from({ length: packed.rows }, (_, row) => rowText(packed, row));
  const all = terms.length === ALL.length;
  return {
    title: `lights ${apart === '' ? '' : 'that stand apart '}${form} add up to the reference’s sum of ${all ? 'all terms' : terms.join(' and ')}, ${chosen.length} lights`,
    defines: [
      `LIGHT_STATEMENTS ${text}`,
      ...(form === 'in the text' ? [`LIGHT_CONSTANTS ${constantRows(packed)}`] : []),
      ...(apart === '' ? [] : [apart]),
      ...terms
        .filter((term) => form !== 'in the text' || term !== 'ambient')
        .map((term) => `HAS_${term.toUpperCase()}`),
    ],
    rows: `const vec4 ROWS[] = vec4[](${rows.join()});\nvec4 lightRow(int i) { return ROWS[i]; }\n`,
    glsl: ANYWHERE,
    inputs(random) {
      for (;;) {
        const N = random.unit();
        const p = float32(scale(N, random.from(0.5, 1)));
        if (chosen.every((one) => !isAtEdge(one, p))) return [[...p], [...float32(N)]];
      }
    },
    expected: ([x, y, z], N) => {
      const fragment = { p: [x!, y!, z!] as Vec3, normal: N as unknown as Vec3, eye: EYE };
      return shade(fragment, SURFACE, chosen, { terms }).sum;
    },
    bound: 2e-5,
    floor: 1,
  };
}

/** So near to the edge of its cone that float32 may take it for either side. */
export function isAtEdge({ position, axis, aperture }: LightValues, p: Vec3): boolean {
  if (aperture === 180 || position[3] === 0) return false;
  const c = dot(normalize(subtract(p, [position[0], position[1], position[2]])), normalize(axis));
  return Math.abs(Math.acos(c) - (aperture * Math.PI) / 180) < 1e-4;
}

const isSpot = ({ aperture, cutoff }: LightValues): boolean => aperture < 180 || cutoff > 0;

/**
 * @param every of the lights, each so many-th alone: a program takes a driver in software the square of its lights to compile, and
 * with each built-in replaced by a function four times as long.
 */
export function exactChecks(every = 1): readonly Check[] {
  const lights = allLights().filter((_, i) => i % every === 0);
  return [
    ...LOBES,
    sumsOf('written out', ALL, lights),
    sumsOf('written out', ['specular'], lights),
    sumsOf('in the text', ALL, lights),
    sumsOf('counted', ALL, lights),
    sumsOf('counted', ['diffuse', 'specular'], lights),
    sumsOf('in loops', ALL, lights),
    sumsOf('in loops', ['ambient', 'diffuse'], lights.filter(isSpot)),
  ];
}
