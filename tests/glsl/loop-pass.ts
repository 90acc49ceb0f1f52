// The whole shipped light loop on stress cases, in any form of program: one fragment a texel, each
// with lights of its own, packed by the shipped packing. Only where rows and feature masks lie is
// the harness's own.
import { FloatPass, type PassResult } from './float-pass.js';
import { type Edit, edited } from './edit.js';
import type { LoopForm } from './loop-forms.js';
import { type Driver, onDriver, spoiledBy } from './worst-driver.js';
import { kindFeatures } from '../../src/phong/light/kind-features.js';
import { KINDS } from '../../src/phong/light/light-state.js';
import { GRID, HEADER, ROWS } from '../../src/phong/light/light-layout.js';
import type { PackedLights } from '../../src/phong/light/pack-lights.js';
import { ENCODING_GLSL } from '../../src/phong/material/program/source.js';
import { WHOLE_LOOP_GLSL } from './loop-mark.js';
import { srgbDecode } from '../../src/phong/math/color.js';
import { pack, type StressCase, type Variant } from '../stress/case.js';

const INPUTS = [
  'place',
  'side',
  'seer',
  'ka',
  'kd',
  'ks',
  'matrix0',
  'matrix1',
  'matrix2',
] as const;

/** Rows of the texture that holds all lights of a batch. */
const ROWS_WIDTH_LOG2 = 11;
const CASES_WIDTH = 256;

/** Rows, masks and whatever else a shipped program has as literals, of the case at hand. */
const OWN_ROWS = `
uniform sampler2D u_rows;
int firstRow;
int firstMask;
int integerShininess;
vec4 lightRow(int i) {
  int at = firstRow + i;
  return texelFetch(u_rows, ivec2(at & ${String((1 << ROWS_WIDTH_LOG2) - 1)}, at >> ${String(ROWS_WIDTH_LOG2)}), 0);
}
int maskOf(int i) { return int(lightRow(firstMask + i).x); }
`;

function loopSource(defines: readonly string[], driver: Driver, edit: Edit | null) {
  const text = edited(`${WHOLE_LOOP_GLSL}\n${ENCODING_GLSL}`, edit);
  return `${defines.map((define) => `#define ${define}`).join('\n')}\n${OWN_ROWS}\n${onDriver(text, driver)}`;
}

// As phong.vert and phong.frag do it. Linear light is a flag of the case: IS_LINEAR changes nothing
// before the last line.
const MAIN = `
  firstRow = int(side.w);
  firstMask = int(seer.w);
  integerShininess = int(place.w);
  mat3 normalMatrix = mat3(matrix0.xyz, matrix1.xyz, matrix2.xyz);
  vec3 normal = matrix0.w == 0.0 ? side.xyz : unitOrZero(normalMatrix * side.xyz);
  vec3 color = surfaceColor(place.xyz, normal, seer.xyz, ka.xyz, kd.xyz, ks.xyz, place.w);
  if (ka.w != 0.0) color = srgbEncode(color);
  result = vec4(color, 1.0);
  shown = vec4(nearestCode(color), 1.0);`;

/** One program's text, for any cases that it draws. */
export class LoopPass {
  readonly #pass: FloatPass;

  /** @param defines - of a {@link LoopProgram} */
  constructor(
    gl: WebGL2RenderingContext,
    defines: readonly string[],
    driver: Driver = 'shipped',
    edit: Edit | null = null,
  ) {
    this.#pass = new FloatPass(gl, {
      glsl: loopSource(defines, driver, edit),
      inputs: INPUTS,
      textures: ['u_rows'],
      main: MAIN + spoiledBy(driver),
    });
  }

  /** Four floats and four codes per case, in order, and a few texels of padding. */
  run(form: LoopForm, variant: Variant, cases: readonly StressCase[]): PassResult {
    const height = Math.ceil(cases.length / CASES_WIDTH);
    const inputs = INPUTS.map(() => new Float32Array(CASES_WIDTH * height * 4));
    const rows = new RowStore(form, variant);
    cases.forEach((stress, i) => writeCase(stress, i * 4, inputs, rows, variant));
    return this.#pass.run([
      ...inputs.map((data) => ({ data, width: CASES_WIDTH })),
      rows.texture(),
    ]);
  }

  dispose(): void {
    this.#pass.dispose();
  }
}

function writeCase(
  stress: StressCase,
  at: number,
  inputs: readonly Float32Array[],
  rows: RowStore,
  { linear }: Variant,
) {
  const { p, eye, normal, normalMatrix: m = [], surface } = stress;
  // Ka, Kd and Ks as the material sends them.
  const channel = (k: number) => (linear ? srgbDecode(k / 255) : k / 255);
  const [ka, kd, ks] = [surface.ka.map(channel), surface.kd.map(channel), surface.ks.map(channel)];
  const { first, masks } = rows.add(stress);
  const values = [
    [...p, surface.shininess],
    [...normal, first],
    [...eye, masks],
    [...ka, linear ? 1 : 0],
    kd,
    ks,
    m.length === 0 ? [] : [...m.slice(0, 3), 1],
    m.slice(3, 6),
    m.slice(6, 9),
  ];
  values.forEach((texel, k) => inputs[k]!.set(texel, at));
}

/** Where a case's rows begin, and its masks relative to them. */
interface Place {
  readonly first: number;
  readonly masks: number;
}

/**
 * Packed lights of all cases one after another, each with its masks; those of cases that share
 * their lights once.
 */
class RowStore {
  readonly #form: LoopForm;
  readonly #variant: Variant;
  #data = new Float32Array(1 << 16);
  #used = 0;
  #last: { lights: StressCase['lights']; origin: StressCase['origin']; place: Place } | null = null;

  constructor(form: LoopForm, variant: Variant) {
    this.#form = form;
    this.#variant = variant;
  }

  add(stress: StressCase) {
    const last = this.#last;
    if (last?.lights === stress.lights && last.origin === stress.origin) return last.place;
    const packed = pack(stress, this.#variant);
    const lights = packed.data.subarray(0, packed.rows * 4);
    const grid = this.#form === 'grid' ? oneCell(packed) : [];
    const masks = masksOf(this.#form, packed).flatMap((mask) => [mask, 0, 0, 0]);
    const place = { first: this.#used, masks: packed.rows + grid.length / 4 };
    const at = this.#used * 4;
    this.#reserve(at + lights.length + grid.length + masks.length);
    this.#data.set(lights, at);
    if (grid.length > 0) {
      this.#data[at + HEADER.counts * 4 + 3] = packed.rows;
    }
    this.#data.set([...grid, ...masks], at + lights.length);
    this.#used += (lights.length + grid.length + masks.length) / 4;
    this.#last = { lights: stress.lights, origin: stress.origin, place };
    return place;
  }

  texture(): { data: Float32Array; width: number } {
    const width = 1 << ROWS_WIDTH_LOG2;
    const height = Math.max(1, Math.ceil(this.#used / width));
    const data = new Float32Array(width * height * 4);
    data.set(this.#data.subarray(0, Math.min(this.#data.length, data.length)));
    return { data, width };
  }

  #reserve(floats: number) {
    if (floats <= this.#data.length) return;
    const grown = new Float32Array(Math.max(floats, this.#data.length * 2));
    grown.set(this.#data);
    this.#data = grown;
  }
}

/**
 * The feature masks that a specialised program of this form has as literals: of each light, or of
 * each kind in a grid.
 */
function masksOf(form: LoopForm, packed: PackedLights) {
  if (form === 'general') return [];
  if (form === 'inlined') return [...packed.features.subarray(0, packed.sent)];
  const ofKind = kindFeatures(packed);
  if (form === 'grid') return KINDS.map((kind) => ofKind[kind]);
  return KINDS.flatMap((kind) => Array.from({ length: packed.counts[kind] }, () => ofKind[kind]));
}

/**
 * A light grid of one cell that lists every spot: {@link GRID}. Which lights a cell lists is for
 * the check of real grids.
 */
function oneCell({ rows, counts }: PackedLights) {
  const firstSpot =
    HEADER.rows + counts.directional * ROWS.directional.rows + counts.point * ROWS.point.rows;
  const list = Array.from({ length: counts.spot }, (_, i) => firstSpot + i * ROWS.spot.rows);
  while (list.length % 4 > 0) {
    list.push(0);
  }
  const cell = rows + GRID.rows;
  return [0, 0, 0, cell, 1, 1, 1, cell + 1, 1, 1, 1, 0, 0, counts.spot, 0, 0, ...list];
}
