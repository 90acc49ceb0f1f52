// What the programs of src/phong/material/program/variant.ts add up to, in each form: the general
// loops, counted loops and inlined lights. Also the lobes that a program with a known exponent has.
// Each against the same law in float64.
import { declaredFeatures } from '../../src/phong/light/light-features.js';
import { LARGEST_MILD_CUTOFF, LARGEST_MILD_POWER } from '../../src/phong/light/precision.js';
import { emptyPack, type PackedLights, packLights } from '../../src/phong/light/pack-lights.js';
import { type LightValues, type Term, TERMS } from '../../src/phong/light/light-state.js';
import { PLAIN_LOOK } from '../../src/phong/material/file-surface.js';
import { type Form, specialisedVariant } from '../../src/phong/material/program/special-variant.js';
import { generalVariant } from '../../src/phong/material/program/variant.js';
import { DEFAULT_STYLE, type Reflection } from '../../src/phong/material/material-values.js';
import { add, dot, normalize, scale, subtract, type Vec3 } from '../../src/phong/math/vector.js';
import { shade } from '../../src/phong/reference/equation.js';
import { lightWith } from '../stress/case.js';
import { BRANCHES } from '../stress/contract.js';
import { white } from '../stress/fragments.js';
import { float32, Random } from '../stress/random.js';
import type { Check } from './chunk-checks.js';
import { mildPowerError } from './worst-driver.js';
import { IDENTITY } from '../support/matrices.js';

/** L of a light in front, and V anywhere, exactly opposite L and zero among them. */
function lobeInputs(random: Random): readonly [number[], number[]] {
  const [x, y, z] = random.unit();
  const L: Vec3 = [x, y, Math.abs(z)];
  const V = random.pick([
    random.unit(),
    scale(L, -1),
    [0, 0, 0] as Vec3,
    add(L, scale(random.unit(), 0.1)),
  ]);
  return [[...float32(L)], [...float32(normalize(V))]];
}

const phong: Check['expected'] = ([x, y, z], V) => [
  Math.max(dot([-x!, -y!, z!], V as unknown as Vec3), 0) ** 8,
];
const blinn: Check['expected'] = ([x, y, z], V) => [
  Math.max(normalize(add([x!, y!, z!], V as unknown as Vec3))[2], 0) ** 8,
];

/**
 * The same without V near -L, as in the contract: there H is mostly rounding. With |L + V| down to
 * 1e-3 an H200's worst driver was off by 7e-6.
 */
function blinnInputs(random: Random): readonly [number[], number[]] {
  for (;;) {
    const inputs = lobeInputs(random);
    const [L, V] = inputs;
    const isView = Math.hypot(...V) > 0;
    if (!isView || Math.hypot(...add(L as unknown as Vec3, V as unknown as Vec3)) > BRANCHES.half) {
      return inputs;
    }
  }
}

/** V = -L but for the last digits of float32, in which a device may leave either. */
function opposed(random: Random): readonly [number[], number[]] {
  const [L] = lobeInputs(random);
  const ulp = (x: number) => 2 ** -23 * x * random.pick([-1, 0, 1]);
  return [L, [...float32(L.map((x) => -x + ulp(x)) as unknown as Vec3)]];
}

type Law = readonly [title: string, expected: Check['expected'], bound: number];
const lobe = (defines: readonly string[], ...[title, expected, bound]: Law): Check => ({
  title,
  defines,
  glsl: 'vec3 N = vec3(0.0, 0.0, 1.0); result.x = specularLobe(N, a.xyz, specularView(N, b.xyz), 8.0);',
  inputs: defines.includes('REFLECTION_BLINN_PHONG') ? blinnInputs : lobeInputs,
  expected,
  bound,
  floor: 1,
});

const LOBES: readonly Check[] = [
  ...['SHININESS_IS_MILD', 'INTEGER_SHININESS 8', 'ANY_SHININESS'].map((define) => ({
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
    'specularLobe multiplies an integer exponent out, and is 0 behind and without a view',
    phong,
    5e-6,
  ),
  lobe(
    ['INTEGER_SHININESS 8', 'REFLECTION_BLINN_PHONG'],
    'specularLobe multiplies Blinn’s integer exponent out, and is 0 where there is no H',
    blinn,
    5e-6,
  ),
  lobe(
    ['SHININESS_IS_MILD', 'REFLECTION_BLINN_PHONG'],
    'specularLobe raises Blinn’s mild exponent without the series',
    blinn,
    2e-5,
  ),
  lobe(
    ['SHININESS_IS_MILD'],
    'specularLobe raises a mild exponent without the series',
    phong,
    2e-5,
  ),
  {
    title: 'powMild keeps x^k to the error of log2, 0^k = 0 and x^0 = 1',
    glsl: 'result.x = powMild(a.x, a.y);',
    inputs(random) {
      const x = random.pick([0, 1, random.from(0, 1), 1 - random.magnitude(1e-7, 0.1)]);
      const any = random.magnitude(1e-6, LARGEST_MILD_POWER);
      return [[x, random.pick([0, 1e-7, 0.01, LARGEST_MILD_POWER, any])].map(Math.fround)];
    },
    expected: ([x, k]) => [k! < 1e-6 ? 1 : x! ** k!],
    bound: mildPowerError(LARGEST_MILD_POWER),
    floor: 1,
  },
];

const EYE: Vec3 = [0, 0, 5];

/** Multiplies nothing away. */
const SURFACE = white(8);

/** Lights of every kind and feature around a unit ball. */
function allLights() {
  const random = new Random(1);
  const lamp = (values: Partial<LightValues>) => {
    const place = scale(random.unit(), random.from(2, 4));
    const color = {
      ambient: random.color(60),
      diffuse: random.color(60),
      specular: random.color(60),
    };
    const aim = {
      position: [...place, 1],
      axis: subtract(random.vector(-0.5, 0.5), place),
    } as const;
    return lightWith({ ...color, ...aim, ...values });
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

/** Reads rows from the check's table, 256 texels wide. */
const ROWS_BY_TABLE = `
uniform sampler2D u_table;
vec4 lightRow(int i) { return texelFetch(u_table, ivec2(i & 255, i >> 8), 0); }
`;

/** In world space, where shading space is the world's. */
export function packedFor(lights: readonly LightValues[]): PackedLights {
  const packed = emptyPack();
  packLights(
    lights,
    { worldToShading: IDENTITY, cameraToShading: IDENTITY, linear: false },
    packed,
  );
  return packed;
}

interface SumsOptions {
  readonly terms?: readonly Term[];
  readonly reflection?: Reflection;
  /** The exponent is known when the program is made. Default true. */
  readonly integerShininess?: boolean;
}

/** What such a program has before the loop's text, and the rows that it reads. */
export function programOf(
  form: Form | 'general',
  lights: readonly LightValues[],
  packed: PackedLights,
  { terms = TERMS, reflection = 'phong', integerShininess = true }: SumsOptions = {},
): Pick<Check, 'defines' | 'rows' | 'table'> {
  const style = { ...DEFAULT_STYLE, reflection, terms: form === 'general' ? terms : TERMS };
  const any = { look: PLAIN_LOOK, style, linear: false, mildShininess: true };
  const general = generalVariant(any, declaredFeatures(lights), 0);
  const material = { terms, integerShininess: integerShininess ? SURFACE.shininess : null };
  const { defines } =
    form === 'general' ? general : specialisedVariant(general, material, form, packed);
  const list = Object.entries(defines).filter(([name]) => name !== 'LIGHT_STORAGE');
  const storage = form === 'inlined' ? 'STORAGE_INLINED' : 'STORAGE_OWN';
  const all = [`LIGHT_STORAGE ${storage}`, ...list.map((pair) => pair.join(' '))];
  if (form === 'inlined') return { defines: all, rows: '' };
  return { defines: all, rows: ROWS_BY_TABLE, table: packed.data.slice(0, packed.rows * 4) };
}

function sumsOf(
  form: Form | 'general',
  lights: readonly LightValues[],
  options: SumsOptions = {},
): Check {
  const { terms = TERMS, reflection = 'phong' } = options;
  const what = terms.length === TERMS.length ? 'all terms' : terms.join(' and ');
  return {
    title: `${form} lights add up to the reference’s sum of ${what}, ${reflection}, ${lights.length} lights`,
    ...programOf(form, lights, packedFor(lights), options),
    glsl: ANYWHERE,
    inputs(random) {
      for (;;) {
        const N = random.unit();
        const p = float32(scale(N, random.from(0.5, 1)));
        if (lights.every((one) => !isAtEdge(one, p))) return [[...p], [...float32(N)]];
      }
    },
    ...sumLaw(lights, { terms, reflection }),
  };
}

/** What {@link ANYWHERE} comes to in float64. */
export const sumLaw = (
  lights: readonly LightValues[],
  options: Pick<SumsOptions, 'terms' | 'reflection'> = {},
): Pick<Check, 'expected' | 'bound' | 'floor'> => ({
  expected: ([x, y, z], N) => {
    const fragment = { p: [x!, y!, z!] as Vec3, normal: N as unknown as Vec3, eye: EYE };
    return shade(fragment, SURFACE, lights, options).sum;
  },
  bound: 2e-5,
  floor: 1,
});

/** So near to the cone's edge that float32 may decide either way. */
export function isAtEdge({ position, axis, aperture }: LightValues, p: Vec3): boolean {
  if (aperture === 180 || position[3] === 0) return false;
  const c = dot(normalize(subtract(p, [position[0], position[1], position[2]])), normalize(axis));
  return Math.abs(Math.acos(c) - (aperture * Math.PI) / 180) < 1e-4;
}

/** No cone or decay is steep, so that cosines do: the general program has no chords. */
const isGentle = ({ aperture, cutoff }: LightValues) =>
  (aperture === 180 || (aperture >= 15 && aperture <= 165)) &&
  (cutoff === 0 || (cutoff >= 1 && cutoff <= LARGEST_MILD_CUTOFF));

const isSpot = ({ aperture, cutoff }: LightValues) => aperture < 180 || cutoff > 0;

/**
 * @param every of the lights, each so many-th alone: a driver in software takes the square of a
 * program's lights to compile it, and four times as long with each built-in replaced by a function.
 */
export function specialisedChecks(every: number): readonly Check[] {
  const lights = allLights().filter((_, i) => i % every === 0);
  return [
    ...LOBES,
    sumsOf('general', lights),
    sumsOf('general', lights, { reflection: 'blinn-phong' }),
    sumsOf('general', lights, { terms: ['diffuse'] }),
    sumsOf('general', lights.filter(isGentle)),
    sumsOf('general', lights.filter(isGentle), { reflection: 'blinn-phong' }),
    sumsOf('counted', lights),
    sumsOf('counted', [...lights, ...lights]), // more than are unrolled
    sumsOf('counted', lights, { terms: ['diffuse', 'specular'], integerShininess: false }),
    sumsOf('inlined', lights),
    sumsOf('inlined', lights, { terms: ['specular'] }),
    sumsOf('inlined', lights.filter(isSpot), {
      reflection: 'blinn-phong',
      integerShininess: false,
    }),
  ];
}
