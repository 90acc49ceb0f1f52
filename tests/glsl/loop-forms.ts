// The programs that a stress case can be drawn by: the defines of the shipped general and
// specialised variants for its lights and surface. What differs from light to light (feature masks,
// an integer exponent) is read at run time instead of being written into the text, so that cases
// with other lights share a program.
import { declaredFeatures } from '../../src/phong/light/light-features.js';
import { isIntegerPower, isMildPower } from '../../src/phong/light/precision.js';
import { LIGHT_FEATURES } from '../../src/phong/light/light-layout.js';
import { PLAIN_LOOK } from '../../src/phong/material/file-surface.js';
import {
  type Form,
  FORMS,
  specialisedVariant,
} from '../../src/phong/material/program/special-variant.js';
import { generalVariant } from '../../src/phong/material/program/variant.js';
import { DEFAULT_STYLE, type Reflection } from '../../src/phong/material/material-values.js';
import { TERMS } from '../../src/phong/light/light-state.js';
import { lightWith, pack, type StressCase, type Variant } from '../stress/case.js';

export type LoopForm = 'general' | Form;

/** A program of the harness, for all cases with the same. */
export interface LoopProgram {
  readonly form: LoopForm;
  /** The form and what its arithmetic depends on: a name for reports. */
  readonly name: string;
  /** Lines that begin its text. */
  readonly defines: readonly string[];
}

/**
 * Which lights and exponents came before the case's own: none, or some of every sort. Code that
 * they need stays.
 */
type History = 'none' | 'everything';

/** Every program that the shipped code may draw a case with. */
type Way = readonly [LoopForm, History];
const DRAWN_BY: readonly Way[] = [
  ['general', 'none'],
  ['general', 'everything'],
  ...FORMS.map((form) => [form, 'none'] as const),
];

export const programsFor = (
  stress: StressCase,
  { reflection }: Variant,
): ReadonlySet<LoopProgram> => new Set(DRAWN_BY.map((way) => programOf(way, stress, reflection)));

/** The same, without taking over programs of other cases. */
export function freshProgramsFor(stress: StressCase, { reflection }: Variant): LoopProgram[] {
  const fresh = DRAWN_BY.map((way) => loopProgram(way[0], variantDefines(way, stress, reflection)));
  return [...new Map(fresh.map((program) => [program.name, program])).values()];
}

/** Which variant it is depends on these alone: see {@link variantDefines}. */
const made = new Map<string, LoopProgram>();

function programOf([form, history]: Way, stress: StressCase, reflection: Reflection) {
  const { shininess } = stress.surface;
  const declared = declaredBefore(history, stress);
  const key = [
    form,
    history,
    reflection,
    declared,
    isMildPower(shininess),
    isIntegerPower(shininess),
  ].join();
  const known = made.get(key);
  if (known !== undefined) return known;
  const program = shared(loopProgram(form, variantDefines([form, history], stress, reflection)));
  made.set(key, program);
  return program;
}

/** Programs of one name and text are one object. */
const programs = new Map<string, LoopProgram>();

function shared(program: LoopProgram) {
  const key = [program.name, ...program.defines].join();
  const known = programs.get(key);
  if (known === undefined) {
    programs.set(key, program);
  }
  return known ?? program;
}

type Defines = Readonly<Record<string, string>>;

/** The defines of the shipped variant. */
function variantDefines([form, history]: Way, stress: StressCase, reflection: Reflection) {
  const { shininess } = stress.surface;
  const material = {
    look: PLAIN_LOOK,
    style: { ...DEFAULT_STYLE, reflection },
    linear: false,
    mildShininess: history === 'none' && isMildPower(shininess),
  };
  const general = generalVariant(material, declaredBefore(history, stress), 0);
  if (form === 'general') return general.defines;
  const known = { terms: TERMS, integerShininess: isIntegerPower(shininess) ? shininess : null };
  return specialisedVariant(general, known, form, pack(stress, { reflection, linear: false }))
    .defines;
}

const COLORS = { ambient: [9, 9, 9], diffuse: [9, 9, 9], specular: [9, 9, 9] } as const;
const PLACE = [0, 0, 1, 1] as const;

/**
 * Lights that declare all but steep spots: code that only the lights of other cases need adds
 * nothing to this one's sums.
 */
const EVERY_KIND = [
  lightWith({ ...COLORS, position: [0, 0, 1, 0] }),
  lightWith({ ...COLORS, position: PLACE, attenuation: [1, 1, 1] }),
  lightWith({ ...COLORS, position: PLACE, axis: [0, 0, -1], aperture: 45, cutoff: 2 }),
];

const STEEP = lightWith({ ...COLORS, position: PLACE, axis: [0, 0, -1], aperture: 1, cutoff: 1e3 });

const EVERYTHING = declaredFeatures([...EVERY_KIND, STEEP]);

const declaredBefore = (history: History, { lights }: StressCase) =>
  history === 'everything' ? EVERYTHING : declaredFeatures([...EVERY_KIND, ...lights]);

/**
 * What a define is in the harness's program, where it is not as it is in the shipped one; null:
 * left out. The rows' place and the numbers that belong to one case are read at run time.
 */
const AT_RUN_TIME: Readonly<Record<string, string | null>> = {
  LIGHT_STORAGE: 'STORAGE_OWN',
  LIGHT_ROWS: null,
  LIGHT_ROW_LITERALS: null,
  LIGHT_STATEMENTS: `
    ivec3 counts = ivec3(lightRow(HEADER_COUNTS).xyz);
    int row = HEADER_ROWS;
    int light = 0;
    for (int i = 0; i < counts.x; i++, row += DIRECTIONAL_ROWS) addDirectional(sums, row, p, N, view, n, maskOf(light++));
    for (int i = 0; i < counts.y; i++, row += POINT_ROWS) addPoint(sums, row, p, N, view, n, maskOf(light++));
    for (int i = 0; i < counts.z; i++, row += SPOT_ROWS) addSpot(sums, row, p, N, view, n, maskOf(light++));`,
  DIRECTIONAL_FEATURES: 'maskOf(0)',
  POINT_FEATURES: 'maskOf(1)',
  SPOT_FEATURES: 'maskOf(2)',
  INTEGER_SHININESS: 'integerShininess',
};

/**
 * Defines that leave code out but change no number, or that are what a form is: no part of a
 * program's name.
 */
const isTrait = (name: string) =>
  name === 'INTEGER_SHININESS' ||
  !(name in AT_RUN_TIME || NO_TRAITS.includes(name) || name.startsWith('HAS_'));

const NO_TRAITS = ['REFLECTION_BLINN_PHONG', 'DECLARED_FEATURES'];

/**
 * The features that a general program leaves out. A specialised one has the masks of its lights.
 */
function withoutFeatures(declared: number) {
  const missing = Object.entries(LIGHT_FEATURES).filter(
    ([name, bit]) => name !== 'powerShift' && (EVERYTHING & bit) !== 0 && (declared & bit) === 0,
  );
  return missing.length === 0 ? [] : ['without', ...missing.map(([name]) => name)];
}

function loopProgram(form: LoopForm, variant: Defines): LoopProgram {
  // The masks of a specialised program's lights say more than what was declared.
  const declared = form === 'general' ? variant['DECLARED_FEATURES'] : String(EVERYTHING);
  const defines = Object.entries({
    ...variant,
    DECLARED_FEATURES: declared,
    ...AT_RUN_TIME,
  }).flatMap(([name, value]) =>
    name in variant && typeof value === 'string' ? [`${name} ${value.replace(/\n\s*/g, ' ')}`] : [],
  );
  const name = [
    form,
    ...Object.keys(variant).filter(isTrait),
    ...withoutFeatures(Number(declared)),
  ].join(' ');
  return { form, name, defines };
}
