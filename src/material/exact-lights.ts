// The light loop for the very lights of a list: written out, each light with literal rows and its own shape; counted, as loops
// of literal length over lights of one shape; or as loops over the shapes that all have in common. And the lights' numbers, as
// literals. Pure text; knows neither programs nor when one is worth it.
import { HEADER, ROWS, SHAPE } from '../light/light-layout.js';
import { forEachLight } from '../light/light-reach.js';
import { KINDS, type PackedLights } from '../light/pack-lights.js';
import type { LightKind } from '../light/light-kind.js';

/** The call that adds a light; all its arguments but kind, row and shape are lightSums' own. */
const add = (kind: LightKind, row: string, shape: number): string =>
  `addLight(sums,${row},KIND_${kind.toUpperCase()},p,N,seen,n,${String(shape)});`;

const COUNT: Readonly<Record<LightKind, string>> = { directional: 'x', point: 'y', spot: 'z' };

/** The value of the define EXACT_LIGHTS that adds each light by itself. `terms`: which terms are summed, SHAPE's bits. */
export function writtenOut(packed: PackedLights, terms: number): string {
  const calls: string[] = [];
  forEachLight(packed, (light, kind, row) => {
    calls.push(add(kind, String(row), shapeIn(packed.shapes[light] ?? 0, terms)));
  });
  return calls.join(' ');
}

/**
 * Turns of a counted loop at most. Of so many an H200's driver writes each out by itself, as fast as written-out lights in a
 * tenth of the time to compile (128 lights: 0.3 s for 3); beyond 64 it does not, and each row costs a load.
 */
const MOST_TURNS = 32;

/** Loops at most, as each is compiled by itself; lights of more shapes take the one that their kind has in common. */
const MOST_RUNS = 64;

interface Run {
  readonly kind: LightKind;
  readonly shape: number;
  readonly row: number;
  length: number;
}

/** The same, with a loop for each row of lights of one kind and shape. */
export function counted(packed: PackedLights, terms: number): string {
  const own = runsOf(packed, (light) => shapeIn(packed.shapes[light] ?? 0, terms));
  const common = commonShapes(packed, terms);
  const runs = own.length <= MOST_RUNS ? own : runsOf(packed, (_light, kind) => common[kind] ?? 0);
  const texts = runs.map(({ kind, shape, row, length }) => {
    if (length === 1) return add(kind, String(row), shape);
    const turn = add(kind, `${String(row)}+i*${kind.toUpperCase()}_ROWS`, shape);
    return `for(int i=0;i<${String(length)};i++)${turn}`;
  });
  return texts.join(' ');
}

function runsOf(packed: PackedLights, shapeOf: (light: number, kind: LightKind) => number): readonly Run[] {
  const runs: Run[] = [];
  forEachLight(packed, (light, kind, row) => {
    const shape = shapeOf(light, kind);
    const last = runs.at(-1);
    if (last?.kind === kind && last.shape === shape && last.length < MOST_TURNS) last.length += 1;
    else runs.push({ kind, shape, row, length: 1 });
  });
  return runs;
}

/** A vec3 or vec4 with these very numbers: nine digits are all that float32 has. */
export const literal = (numbers: ArrayLike<number>): string =>
  `vec${String(numbers.length)}(${Array.from(numbers, (x) => x.toExponential(8)).join()})`;

/** Lights with their numbers in a text at most: a driver in software takes the square of them to compile. */
export const MOST_CONSTANT = 64;

/** Lights of which so many have theirs there at most: 256 took 0.35 of MeshPhong's time so and 0.53 without, more would gain less. */
export const MOST_PARTLY = 4 * MOST_CONSTANT;

/** The first of the lights that have their numbers in the text: spots, which have the most of them, stand last. */
const firstConstant = ({ sent }: PackedLights): number => Math.max(sent - MOST_CONSTANT, 0);

/** Whether all numbers are in the text, so that no row is read. */
export const isAllConstant = (packed: PackedLights): boolean => firstConstant(packed) === 0;

/**
 * The same with the numbers in {@link constantRows}, for as many lights as may have theirs there; the others before, in loops. The
 * ambient light that no cone bounds is in it: HAS_AMBIENT, which would read it, is not to be defined.
 */
export function constant(packed: PackedLights, terms: number): string {
  const first = firstConstant(packed);
  const counts: Record<LightKind, number> = { directional: 0, point: 0, spot: 0 };
  const calls: string[] = [];
  let at = 0;
  forEachLight(packed, (light, kind) => {
    if (light < first) {
      counts[kind] += 1;
      return;
    }
    calls.push(add(kind, String(at), shapeIn(packed.shapes[light] ?? 0, terms) | SHAPE.constant));
    at += ROWS[kind].rows;
  });
  const before = loops(commonShapes(packed, terms, first), (kind) => String(counts[kind]));
  return [...ambientOf(packed, terms), ...(first > 0 ? [ROW] : []), ...before, ...calls].join(' ');
}

const ambientOf = (packed: PackedLights, terms: number): readonly string[] =>
  (terms & SHAPE.ambient) === 0 ? [] : [`sums.ambient=${rowText(packed, HEADER.ambient)}.rgb;`];

/** The value of the define LIGHT_CONSTANTS: the rows of those lights, from 0 on. */
export function constantRows(packed: PackedLights): string {
  const first = firstConstant(packed);
  const texts: string[] = [];
  forEachLight(packed, (light, kind, row) => {
    for (let i = row; light >= first && i < row + ROWS[kind].rows; i++) texts.push(rowText(packed, i));
  });
  if (texts.length === 0) texts.push('vec4(0)'); // GLSL has no array of nothing
  return `vec4[](${texts.join()})`;
}

/** A row as a literal. */
export const rowText = ({ data }: PackedLights, row: number): string =>
  literal(data.subarray(row * 4, row * 4 + 4));

/** The same as a loop per kind, for any number of lights of these shapes. */
export function inLoops(packed: PackedLights, terms: number): string {
  const shapes = commonShapes(packed, terms);
  return [COUNTS, ROW, ...loops(shapes)].join(' ');
}

/** The same for lights that have been divided: those that reach everywhere in loops, then the cell's own. */
export function inCells(packed: PackedLights, terms: number): string {
  const shapes = commonShapes(packed, terms);
  const { point, spot } = shapes;
  const text = [
    COUNTS,
    `ivec3 all=counts;counts=ivec3(lightRow(int(lightRow(HEADER_COUNTS).w)+GRID_EVERYWHERE).xyz);`,
    ROW,
  ];
  for (const [kind, loop] of KINDS.map((each) => [each, loops({ [each]: shapes[each] })] as const)) {
    const skipped = `row+=(all.${COUNT[kind]}-counts.${COUNT[kind]})*${String(ROWS[kind].rows)};`;
    text.push(...loop, loop.length > 0 ? skipped : '');
  }
  text.push('CellList listed=cellList(p);int place=listed.first;');
  if (point !== undefined)
    text.push(`for(int i=0;i<listed.points;i++,place++)${add('point', 'listedRow(place)', point)}`);
  if (spot !== undefined)
    text.push(`for(int i=0;i<listed.spots;i++,place++)${add('spot', 'listedRow(place)', spot)}`);
  return text.join(' ');
}

const COUNTS = 'ivec3 counts=ivec3(lightRow(HEADER_COUNTS).xyz);';
const ROW = 'int row=HEADER_ROWS;';

type Shapes = Partial<Record<LightKind, number | undefined>>;

const loops = (shapes: Shapes, count = (kind: LightKind) => `counts.${COUNT[kind]}`): string[] =>
  KINDS.flatMap((kind) => {
    const shape = shapes[kind];
    if (shape === undefined) return [];
    const step = `${kind.toUpperCase()}_ROWS`;
    return [`for(int i=0;i<${count(kind)};i++,row+=${step})${add(kind, 'row', shape)}`];
  });

/** Of all, or of those before one. */
function commonShapes(packed: PackedLights, terms: number, end = Infinity): Shapes {
  const common: Shapes = {};
  forEachLight(packed, (light, kind) => {
    if (light >= end) return;
    const shape = shapeIn(packed.shapes[light] ?? 0, terms);
    const before = common[kind];
    common[kind] = before === undefined ? shape : union(before, shape);
  });
  return common;
}

/** All of `terms`. */
export const ALL_TERMS = SHAPE.ambient | SHAPE.diffuse | SHAPE.specular;
const BITS = (1 << SHAPE.powerShift) - 1;

/** Without what only terms need that are not summed. */
const shapeIn = (shape: number, terms: number): number => {
  const { diffuse, specular, tintedDiffuse, tintedSpecular } = SHAPE;
  const tints =
    ((terms & diffuse) !== 0 ? tintedDiffuse : 0) | ((terms & specular) !== 0 ? tintedSpecular : 0);
  return shape & (terms | tints | ~(ALL_TERMS | tintedDiffuse | tintedSpecular));
};

const DECAYS = SHAPE.decay | SHAPE.mild;

/** No decay, a whole one or another small one. */
const isMild = (shape: number): boolean => (shape & DECAYS) !== SHAPE.decay;

/** What lights of both shapes need: a cutoff that not all have is a number like any other. */
function union(a: number, b: number): number {
  const bits = (a | b) & BITS;
  const power = a >> SHAPE.powerShift;
  if (power === b >> SHAPE.powerShift && (a & DECAYS) === (b & DECAYS))
    return bits | (power << SHAPE.powerShift);
  const mild = isMild(a) && isMild(b) ? SHAPE.mild : 0;
  return (bits & ~DECAYS) | SHAPE.decay | mild;
}
