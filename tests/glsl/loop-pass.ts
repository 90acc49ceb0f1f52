// The whole shipped light loop on stress cases: one fragment a texel, each with lights of its own, packed by the shipped
// packing. Only where the rows lie is the harness's own.
import { FloatPass, type PassResult } from './float-pass.js';
import { type Edit, edited } from './edit.js';
import { type Driver, onDriver, spoiledBy } from './worst-driver.js';
import { ENCODING_GLSL, LIGHT_LOOP_GLSL } from '../../src/material/program/source.js';
import { srgbDecode } from '../../src/math/color.js';
import type { Surface } from '../../src/reference/equation.js';
import { pack, type StressCase, type Variant } from '../stress/case.js';

const INPUTS = ['place', 'side', 'seer', 'ka', 'kd', 'ks', 'matrix0', 'matrix1', 'matrix2'] as const;

/** Rows of the texture that holds all lights of a batch. */
const ROWS_WIDTH_LOG2 = 11;
const CASES_WIDTH = 256;

const OWN_ROWS = `
uniform sampler2D u_rows;
int firstRow;
vec4 lightRow(int i) {
  int at = firstRow + i;
  return texelFetch(u_rows, ivec2(at & ${String((1 << ROWS_WIDTH_LOG2) - 1)}, at >> ${String(ROWS_WIDTH_LOG2)}), 0);
}
`;

/** All code that lights may need: `HAS_` and these. */
export const FACTS = [
  'AMBIENT',
  'DIFFUSE',
  'SPECULAR',
  'DIRECTIONAL',
  'POINT',
  'SPOT',
  'ATTENUATION',
  'CONE',
  'DECAY',
];

function loopSource({ reflection, linear }: Variant, driver: Driver, edit: Edit | null): string {
  const text = edited(`${LIGHT_LOOP_GLSL}\n${ENCODING_GLSL}`, edit);
  const defines = [
    'LIGHT_STORAGE STORAGE_OWN',
    ...FACTS.map((fact) => `HAS_${fact}`),
    ...(reflection === 'blinn-phong' ? ['REFLECTION_BLINN_PHONG'] : []),
    ...(linear ? ['IS_LINEAR'] : []),
  ];
  return `${defines.map((define) => `#define ${define}`).join('\n')}\n${OWN_ROWS}\n${onDriver(text, driver)}`;
}

// As phong.vert and phong.frag do it.
const MAIN = `
  firstRow = int(side.w);
  mat3 normalMatrix = mat3(matrix0.xyz, matrix1.xyz, matrix2.xyz);
  vec3 normal = matrix0.w == 0.0 ? side.xyz : unitOrZero(normalMatrix * side.xyz);
  vec3 color = surfaceColor(place.xyz, normal, seer.xyz, ka.xyz, kd.xyz, ks.xyz, place.w);
#ifdef IS_LINEAR
  color = srgbEncode(color);
#endif
  result = vec4(color, 1.0);
  shown = vec4(nearestCode(color), 1.0);`;

export class LoopPass {
  readonly #pass: FloatPass;
  readonly #variant: Variant;

  constructor(
    gl: WebGL2RenderingContext,
    variant: Variant,
    driver: Driver = 'shipped',
    edit: Edit | null = null,
  ) {
    this.#variant = variant;
    this.#pass = new FloatPass(gl, {
      glsl: loopSource(variant, driver, edit),
      inputs: INPUTS,
      textures: ['u_rows'],
      main: MAIN + spoiledBy(driver),
    });
  }

  /** Four floats and four codes per case, in order, and a few texels of padding. */
  run(cases: readonly StressCase[]): PassResult {
    const height = Math.ceil(cases.length / CASES_WIDTH);
    const inputs = INPUTS.map(() => new Float32Array(CASES_WIDTH * height * 4));
    const rows = new RowStore();
    cases.forEach((stress, i) => this.#write(stress, i * 4, inputs, rows));
    return this.#pass.run([...inputs.map((data) => ({ data, width: CASES_WIDTH })), rows.texture()]);
  }

  dispose(): void {
    this.#pass.dispose();
  }

  #write(stress: StressCase, at: number, inputs: readonly Float32Array[], rows: RowStore): void {
    const { p, eye, normal, normalMatrix, surface } = stress;
    const material = surfaceUniforms(surface, this.#variant.linear);
    const first = rows.add(stress, this.#variant);
    const m = normalMatrix;
    const values = [
      [...p, material.shininess],
      [...normal, first],
      eye,
      material.ka,
      material.kd,
      material.ks,
      m === undefined ? [] : [m[0]!, m[1]!, m[2]!, 1],
      m === undefined ? [] : m.slice(3, 6),
      m === undefined ? [] : m.slice(6, 9),
    ];
    values.forEach((texel, k) => inputs[k]!.set(texel, at));
  }
}

/** Ka, Kd and Ks as the material sends them. */
function surfaceUniforms({ ka, kd, ks, shininess }: Surface, linear: boolean) {
  const channel = (k: number): number => (linear ? srgbDecode(k / 255) : k / 255);
  return { ka: ka.map(channel), kd: kd.map(channel), ks: ks.map(channel), shininess };
}

/** Packed lights of all cases one after another; those of cases that share their lights once. */
class RowStore {
  #data = new Float32Array(1 << 16);
  #used = 0;
  #last: { lights: StressCase['lights']; origin: StressCase['origin']; first: number } | null = null;

  add(stress: StressCase, variant: Variant): number {
    const last = this.#last;
    if (last?.lights === stress.lights && last.origin === stress.origin) return last.first;
    const { data, rows } = pack(stress, variant);
    const first = this.#used;
    const end = (first + rows) * 4;
    if (end > this.#data.length) {
      const grown = new Float32Array(Math.max(end, this.#data.length * 2));
      grown.set(this.#data);
      this.#data = grown;
    }
    this.#data.set(data.subarray(0, rows * 4), first * 4);
    this.#used += rows;
    this.#last = { lights: stress.lights, origin: stress.origin, first };
    return first;
  }

  texture(): { data: Float32Array; width: number } {
    const width = 1 << ROWS_WIDTH_LOG2;
    const height = Math.max(1, Math.ceil(this.#used / width));
    const data = new Float32Array(width * height * 4);
    data.set(this.#data.subarray(0, Math.min(this.#data.length, data.length)));
    return { data, width };
  }
}
