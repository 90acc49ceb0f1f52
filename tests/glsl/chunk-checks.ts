// Each chunk alone: its function on inputs from all over its domain, against the same law in
// float64.
import { TEXTURE_ROWS_LOG2 } from '../../src/phong/light/light-layout.js';
import { LARGEST_MILD_CUTOFF, LIMIT_OPEN } from '../../src/phong/light/precision.js';
import { ENCODING_GLSL, LIGHT_LOOP_GLSL } from '../../src/phong/material/program/source.js';
import { WHOLE_LOOP_GLSL } from './loop-mark.js';
import { srgbDecode, srgbEncode } from '../../src/phong/math/color.js';
import { dot, normalize, scale, type Vec3 } from '../../src/phong/math/vector.js';
import { float32, partSeed, Random } from '../stress/random.js';
import { FloatPass, type PassSource, type Uniforms } from './float-pass.js';
import { type Edit, edited } from './edit.js';
import { gridCheck } from './grid-checks.js';
import { specialisedChecks } from './specialised-checks.js';
import { type Driver, onDriver, mildPowerError, spoiledBy } from './worst-driver.js';

/** Up to four numbers in, up to four out. */
type Numbers = readonly number[];

export interface Check {
  /** What holds, as a sentence. */
  readonly title: string;
  /**
   * The program's defines, a name and a value each; without LIGHT_STORAGE, rows come from `rows`.
   */
  readonly defines?: readonly string[];
  /** Text before the loop's: the program's own `lightRow`. */
  readonly rows?: string;
  /** What these rows are read from: the texture `u_table`, 256 texels wide. Default: no texture. */
  readonly table?: Float32Array;
  /** Of inputs `a` and `b` (vec4) to `result`. */
  readonly glsl: string;
  readonly inputs: (random: Random) => readonly [Numbers, Numbers?];
  readonly expected: (a: Numbers, b: Numbers) => Numbers;
  /** Largest |difference|, over max(|expected|, `floor`). */
  readonly bound: number;
  readonly floor?: number;
}

export interface Checked {
  readonly title: string;
  readonly cases: number;
  readonly bound: number;
  readonly max: number;
}

export interface Extent {
  readonly cases: number;
  /** Checks whose title begins with this; empty for all. */
  readonly only: string;
  /** Of the lights of specialised programs, each so many-th alone. */
  readonly everyLight: number;
}

const WIDTH = 256;
const f = Math.fround;

const power = (x: number, y: number, k: number) => {
  if (k < f(1e-6)) return 1;
  if (x <= 0) return 0;
  return y < 0.25 ? Math.exp(k * Math.log1p(-y)) : x ** k;
};

/** A place, and a cone's limit that it is at or any other, or one of `more`. */
function coneInputs(random: Random, ...more: readonly number[]): [Numbers] {
  const q = f(random.from(0, 1));
  const limit = random.pick([q, f(random.from(0, 0.5)), -f(1 - q), ...more]);
  return [[q, f(1 - q), limit]];
}

const isInside = (q: number, p: number, limit: number): number =>
  (limit < 0 ? p >= -limit : q <= limit) ? 1 : 0;

/** `knee`: where the curve's straight part ends. */
const curve = (
  name: string,
  expected: (x: number) => number,
  knee: number,
  bound: number,
): Check => ({
  title: `${name} follows the curve, and gives 0 for less than 0`,
  glsl: `result.x = ${name}(vec3(a.x)).x;`,
  inputs: (random) => [
    [f(random.pick([-0.1, 0, knee, 1, random.from(0, 1), random.magnitude(1e-6, 100)]))],
  ],
  expected: ([x]) => [expected(x!)],
  bound,
  floor: 1e-6,
});

const CHECKS: readonly Check[] = [
  {
    title: 'powNearOne keeps x^k to 1e-6 for x beside 1 and exponents to 1e6',
    glsl: 'result.x = powNearOne(a.x, a.y, a.z);',
    inputs(random) {
      const y = f(random.pick([random.magnitude(1e-12, 1), random.from(0, 1), 0]));
      const far = [f(random.magnitude(1e-6, 1e6)), f(random.from(0, 40) / Math.max(y, 1e-6))];
      return [[f(1 - y), y, Math.min(random.pick([0, 1e-7, ...far]), 1e6)]];
    },
    expected: ([x, y, k]) => [power(x!, y!, k!)],
    bound: 1e-6,
    floor: 1,
  },
  {
    title: 'powNearOne gives 1 for exponents below 1e-6 and 0 for a base of 0',
    glsl: 'result.x = powNearOne(a.x, 1.0 - a.x, a.y);',
    inputs(random) {
      const k = random.pick([0, 1e-7, 1, 1e6]);
      return [[k < 1e-6 ? random.pick([0, f(random.from(0, 1)), 1]) : 0, k]];
    },
    expected: ([, k]) => [k! < 1e-6 ? 1 : 0],
    bound: 0,
  },
  {
    title: 'unitOrZero gives unit vectors of vectors of any length',
    glsl: 'result.xyz = unitOrZero(a.xyz);',
    inputs(random) {
      const usual = [random.magnitude(1e-30, 1e-3), random.magnitude(1e-3, 1e3)];
      return [float32(scale(random.unit(), random.pick([0, 1, ...usual, 1e30, 1e38])))];
    },
    expected: (v) => normalize(v as unknown as Vec3),
    // inversesqrt may be 2 ULP off, up to 2.4e-7; measured on the worst driver: 3.7e-7.
    bound: 4e-7,
    floor: 1,
  },
  {
    title: 'attenuation is 1/max(kc + kl·d + kq·d², 1), less what a feature mask leaves out',
    glsl: `
      result.x = attenuation(a.xyz, b.x, b.x * b.x, FEATURE_LINEAR + FEATURE_CLAMPED);
      result.y = attenuation(vec3(a.x, 0.0, a.z), b.x, b.x * b.x, FEATURE_CLAMPED);
      result.z = attenuation(vec3(1.0 + a.x, a.yz), b.x, b.x * b.x, FEATURE_LINEAR);`,
    inputs(random) {
      const k = () => f(random.pick([0, 1, random.magnitude(1e-6, 1e6)]));
      return [[k(), k(), k()], [f(random.pick([0, random.magnitude(1e-15, 1e15)]))]];
    },
    expected: ([kc, kl, kq], [d]) => [
      1 / Math.max(kc! + kl! * d! + kq! * d! * d!, 1),
      1 / Math.max(kc! + kq! * d! * d!, 1),
      1 / (f(1 + kc!) + kl! * d! + kq! * d! * d!),
    ],
    bound: 5e-7,
    floor: 2 ** -126,
  },
  {
    title: 'insideCone compares the nearer side of the axis, and the far side beyond 90°',
    glsl: 'result.x = insideCone(a.x, a.y, a.z, FEATURE_NARROW + FEATURE_WIDE) ? 1.0 : 0.0;',
    inputs: (random) => coneInputs(random, f(random.from(-0.5, 0)), LIMIT_OPEN),
    expected: ([q, p, limit]) => [isInside(q!, p!, limit!)],
    bound: 0,
  },
  {
    title:
      'insideCone does the same where the features name the side, and lets all through where it has no cone',
    glsl: `
      int features = a.z < 0.0 ? FEATURE_WIDE : FEATURE_NARROW;
      result.xy = vec2(insideCone(a.x, a.y, a.z, features), insideCone(a.x, a.y, a.z, FEATURE_DECAY));`,
    inputs: (random) => coneInputs(random, f(random.from(-0.5, -1e-6))),
    expected: ([q, p, limit]) => [isInside(q!, p!, limit!), 1],
    bound: 0,
  },
  {
    title: 'powInteger keeps x^k to the rounding of x for every integer k to 64, and 1 at 1',
    glsl: 'result.x = powInteger(a.x, int(a.y));',
    inputs(random) {
      const x = f(random.pick([0, 1, random.from(0, 1), 1 - random.magnitude(1e-7, 0.1)]));
      return [[x, Math.floor(random.from(1, 65))]];
    },
    expected: ([x, k]) => [x! ** k!],
    // Six squarings and six products, half a step each, up to 64 times over.
    bound: 4e-6,
    floor: 1,
  },
  {
    title: 'spotDecay multiplies integer cutoffs out, raises others and leaves 1 without either',
    glsl: `
      result.x = spotDecay(a.x, a.y, a.z, (int(a.z) << FEATURE_POWER_SHIFT) + FEATURE_CHORDS);
      result.y = spotDecay(a.x, a.y, a.w, FEATURE_DECAY + FEATURE_CHORDS);
      result.z = spotDecay(a.x, a.y, a.z, FEATURE_NARROW);`,
    inputs(random) {
      const q = f(random.pick([0, 1, random.from(0, 1), random.magnitude(1e-9, 0.1)]));
      return [[q, f(1 - q), Math.floor(random.from(1, 65)), f(random.magnitude(1e-3, 1e3))]];
    },
    expected: ([q, p, whole, cutoff]) => [power(1 - q!, q!, whole!), power(p!, q!, cutoff!), 1],
    bound: 5e-6,
    floor: 1,
  },
  {
    title:
      'spotDecay takes a cosine for mild cutoffs from 1, also where rounding made it less than -1 or more than 1',
    glsl: `
      result.x = spotDecay(1.0 - a.x, a.x, a.y, int(a.y) << FEATURE_POWER_SHIFT);
      result.y = spotDecay(1.0 - a.x, a.x, a.z, FEATURE_DECAY);`,
    inputs: (random) => [
      [
        f(
          random.pick([
            0,
            1,
            -6e-8,
            1 + 1.2e-7,
            random.from(0, 1),
            1 - random.magnitude(1e-7, 0.1),
          ]),
        ),
        Math.floor(random.from(1, LARGEST_MILD_CUTOFF + 1)),
        f(random.pick([1, LARGEST_MILD_CUTOFF, random.from(1, LARGEST_MILD_CUTOFF)])),
      ],
    ],
    expected: ([p, whole, cutoff]) => [Math.max(p!, 0) ** whole!, Math.max(p!, 0) ** cutoff!],
    bound: mildPowerError(LARGEST_MILD_CUTOFF),
    floor: 1,
  },
  {
    title: 'diffuseLobe is Lambert’s law, and 1 at most where rounding made a cosine more',
    glsl: 'result.x = diffuseLobe(a.x);',
    inputs: (random) => [[f(random.pick([1 + 2.4e-7, random.from(-1, 1)]))]],
    expected: ([NoL]) => [Math.min(Math.max(NoL!, 0), 1)],
    bound: 0,
  },
  {
    title: 'specularLobe is max(R·V, 0)^n for exponents to 100',
    glsl: 'vec3 N = vec3(0.0, 0.0, 1.0); result.x = specularLobe(N, a.xyz, specularView(N, b.xyz), a.w);',
    inputs(random) {
      const L = random.unit();
      return [
        [...float32([L[0], L[1], Math.abs(L[2])]), f(random.from(1, 100))],
        float32(random.unit()),
      ];
    },
    expected([x, y, z, n], V) {
      const RoV = dot([-x!, -y!, z!], V as unknown as Vec3);
      return [Math.max(RoV, 0) ** n!];
    },
    // The inputs are unit to float32 only: n times 1e-7.
    bound: 3e-5,
    floor: 1,
  },
  // 100 is decoded to 2^16, where exp2 may err by 35 ULP.
  curve('srgbDecode', srgbDecode, 0.04045, 1e-5),
  curve('srgbEncode', srgbEncode, 0.0031308, 6e-6),
];

/**
 * Runs all of them; the storages are checked by reading back a number of its own from every slot.
 */
export function checkChunks(
  gl: WebGL2RenderingContext,
  driver: Driver,
  seed: number,
  edit: Edit | null,
  { cases, only, everyLight }: Extent,
): Checked[] {
  const glsl = onDriver(edited(`${WHOLE_LOOP_GLSL}\n${ENCODING_GLSL}`, edit), driver);
  const source = ({ defines = [], rows = NO_ROWS }: Partial<Check>) =>
    (defines.some((define) => define.startsWith('LIGHT_STORAGE')) ? '' : head('STORAGE_OWN')) +
    defines.map((define) => `#define ${define}\n`).join('') +
    rows +
    glsl;
  const checks = [...CHECKS, ...specialisedChecks(everyLight), gridCheck()]
    .filter(({ title }) => title.startsWith(only))
    .map((check) => ({ ...check, glsl: check.glsl + spoiledBy(driver) }))
    .map((check) => runCheck(gl, check, source(check), seed, cases));
  if (only !== '') return checks;
  checks.push(checkCodes(gl, source({})), checkStorage(gl, 'STORAGE_UNIFORMS', 200));
  return [...checks, checkStorage(gl, 'STORAGE_TEXTURE', 3 << TEXTURE_ROWS_LOG2)];
}

const head = (storage: string) => `#define LIGHT_STORAGE ${storage}\n`;
const NO_ROWS = 'vec4 lightRow(int i) { return vec4(0.0); }\n';

type Gl = WebGL2RenderingContext;

function runCheck(gl: Gl, check: Check, source: string, seed: number, cases: number): Checked {
  const { title, glsl, bound, floor = 0, table } = check;
  const random = new Random(partSeed(seed, title));
  const texels = Math.ceil(cases / WIDTH) * WIDTH;
  const a = new Float32Array(texels * 4);
  const b = new Float32Array(texels * 4);
  for (let i = 0; i < cases; i++) {
    const [first, second = []] = check.inputs(random);
    a.set(first, i * 4);
    b.set(second, i * 4);
  }
  const textures = table === undefined ? [] : ['u_table'];
  const tables = table === undefined ? [] : [wholeTexels(table)];
  const pass = { glsl: source, inputs: ['a', 'b'], textures, main: glsl };
  const { floats } = once(gl, pass, [a, b, ...tables]);
  let max = 0;
  for (let i = 0; i < cases; i++) {
    const at = i * 4;
    const expected = check.expected([...a.subarray(at, at + 4)], [...b.subarray(at, at + 4)]);
    expected.forEach((wanted, k) => {
      const off = Math.abs(floats[at + k]! - wanted);
      // Not by Math.max: it would keep NaN, and a comparison with NaN is false.
      const error = off === 0 ? 0 : off / Math.max(Math.abs(wanted), floor);
      if (!(error <= max)) {
        max = Number.isNaN(error) ? Infinity : error;
      }
    });
  }
  return { title, cases, bound, max };
}

function wholeTexels(table: Float32Array): Float32Array {
  const data = new Float32Array(Math.ceil(table.length / (4 * WIDTH)) * 4 * WIDTH);
  data.set(table);
  return data;
}

/** Every code, and the floats beside the steps between codes, as 8-bit output and as floats. */
function checkCodes(gl: Gl, source: string): Checked {
  const beyond = [-1e6, -0.5, 1.5, 1e6].map((x) => ({ x, code: x < 0 ? 0 : 255 }));
  // A step itself is half-way; 1e-4 to either side of it the nearest code is clear.
  const beside = Array.from({ length: 256 }, (_, code) =>
    [0, 0.5 - 1e-4, -0.5 + 1e-4].map((off) => ({ x: f((code + off) / 255), code })),
  );
  const inputs = [...beyond, ...beside.flat()];
  const a = new Float32Array(1024 * 4);
  inputs.forEach(({ x }, i) => (a[i * 4] = x));
  const main = 'result = vec4(nearestCode(vec3(a.x)), 1.0); shown = result;';
  const { floats, codes } = once(gl, { glsl: source, inputs: ['a'], main }, [a]);
  let max = 0;
  inputs.forEach(({ code }, i) => {
    max = Math.max(max, Math.abs(codes[i * 4]! - code), Math.abs(floats[i * 4]! * 255 - code));
  });
  // Two ULP of the division by 255 are 6e-5 of a code.
  return {
    title: 'nearestCode gives the nearest of 256 codes',
    cases: inputs.length,
    bound: 1e-4,
    max,
  };
}

/** Every slot of a storage holds a number of its own. */
function checkStorage(gl: Gl, storage: string, rows: number): Checked {
  const data = new Float32Array(rows * 4).map((_, i) => i + 1);
  const index = new Float32Array(Math.ceil(rows / WIDTH) * WIDTH * 4);
  for (let i = 0; i < rows; i++) {
    index[i * 4] = i;
  }
  const width = 1 << TEXTURE_ROWS_LOG2;
  const inTexture = storage === 'STORAGE_TEXTURE';
  const pass = new FloatPass(gl, {
    glsl: `${head(storage)}#define LIGHT_ROWS ${String(rows)}\n${LIGHT_LOOP_GLSL}`,
    inputs: ['a'],
    textures: inTexture ? ['uLightTexture'] : [],
    main: 'result = lightRow(int(a.x));',
  });
  const input = { data: index, width: WIDTH };
  const held: Uniforms = inTexture
    ? { uLightTextureScale: [1 / width, width / rows] }
    : { uLightRows: data };
  const { floats } = pass.run([input, ...(inTexture ? [{ data, width }] : [])], held);
  pass.dispose();
  let max = 0;
  data.forEach((wanted, i) => (max = Math.max(max, Math.abs(floats[i]! - wanted))));
  return { title: `lightRow reads every number of ${storage}`, cases: rows * 4, bound: 0, max };
}

function once(gl: Gl, source: PassSource, inputs: readonly Float32Array[]) {
  const pass = new FloatPass(gl, source);
  const result = pass.run(inputs.map((data) => ({ data, width: WIDTH })));
  pass.dispose();
  return result;
}
