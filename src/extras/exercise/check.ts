// One run of a learner's function: at the sheet, at the picture, and what the colours say.
import { type Term, TERMS } from '../../phong/light/light-state.js';
import type { Vec3 } from '../../phong/math/vector.js';
import type { MistakeId } from '../../phong/mistakes/mistakes.js';
import { checked, type Fault } from './guard.js';
import {
  type Case,
  colorAt,
  compare,
  type Difference,
  differenceOf,
  exactAt,
  isRight,
  type Judged,
  mistakesIn,
  STEP,
} from '../../phong/mistakes/judge.js';
import type { PicturePoints } from './picture.js';
import { LostError, type Message, NoContextError, Program } from './program.js';
import {
  only,
  type SceneName,
  SCENE_NAMES,
  sheetOf,
  type SheetPoint,
  type Task,
} from '../../phong/mistakes/sheet.js';

/** Why there is no verdict. */
export type Stop = 'slow' | 'lost' | 'no-webgl2';

export interface Failure {
  readonly fault?: Fault;
  readonly messages?: readonly Message[];
  readonly stop?: Stop;
}

export interface Verdict {
  readonly right: boolean;
  readonly mistakes: readonly MistakeId[];
  /** Of the judged pixels; of the sheet's points where there is no picture. */
  readonly share: number;
  readonly rightPixels: number;
  readonly pixels: number;
  /** At which the result is not a number. */
  readonly undefinedPixels: number;
  readonly difference: Difference;
  /** The pixel where it shows best; null where none is wrong. */
  readonly worst: { readonly x: number; readonly y: number; found: Vec3; exact: Vec3 } | null;
  /** A scene of the sheet that shows it, where the picture does not. */
  readonly scene: SceneName | null;
  /** Colours of the picture's points, three numbers each. */
  readonly colors: Float32Array;
}

/** Points of each scene: all of a scene in one tile, with those of single terms. */
const COUNT = 150;

/** Points of each scene that are also lit by one term alone. */
const ALONE = 30;

/** Points of the picture that a mistake has to explain. */
const MOST_PICTURE = 300;

export async function check(
  source: string,
  task: Task,
  picture: PicturePoints | null,
): Promise<Verdict | Failure> {
  const reading = checked(source);
  if ('fault' in reading) return reading;
  let program: Program | undefined;
  try {
    program = new Program(reading.glsl, reading.cost);
    if (program.messages.length > 0) return { messages: program.messages };
    return await verdictOf(program, task, picture);
  } catch (error) {
    if (error instanceof LostError) return { stop: 'lost' };
    if (error instanceof NoContextError) return { stop: 'no-webgl2' };
    throw error;
  } finally {
    program?.dispose();
  }
}

async function verdictOf(
  program: Program,
  task: Task,
  picture: PicturePoints | null,
): Promise<Verdict | Failure> {
  const points = sheetOf(task, COUNT);
  const few = points.filter((_, i) => i % COUNT < ALONE);
  const parts: Readonly<Record<Term | 'all', readonly Case[]>> = {
    all: points.map(({ given }) => [given]),
    ambient: litBy('ambient', few),
    diffuse: litBy('diffuse', few),
    specular: litBy('specular', few),
  };
  const cases = [...parts.all, ...parts.ambient, ...parts.diffuse, ...parts.specular];
  const sheet = await program.run(cases, 64);
  if (sheet.done < cases.length) return { stop: 'slow' };
  let from = 0;
  const judgedPart = (part: readonly Case[]): Judged => {
    const colors = sheet.colors.subarray(3 * from, 3 * (from += part.length));
    return compare(part, colors, true);
  };
  const all = judgedPart(parts.all);
  const alone = Object.fromEntries(TERMS.map((term) => [term, judgedPart(parts[term])])) as Record<
    Term,
    Judged
  >;
  const drawn = picture === null ? null : await program.run(picture.cases, 256);
  if (picture !== null && drawn!.done < picture.cases.length) return { stop: 'slow' };
  const colors = drawn?.colors ?? new Float32Array(0);
  const shown = compare(picture?.cases ?? [], colors);
  const right = isRight(all) && isRight(shown);
  const mistakes = right ? [] : mistakesIn([all, sampleOf(shown)]);
  const of = picture === null ? all : shown;
  return {
    right,
    mistakes,
    share: of.count === 0 ? 0 : 1 - of.wrong.length / of.count,
    rightPixels: shown.count - shown.wrong.length,
    pixels: shown.count,
    undefinedPixels: shown.wrong.filter((i) => colorAt(colors, i).some(Number.isNaN)).length,
    difference: differenceOf(all.wrong.length > 0 ? all : shown, alone),
    worst: picture === null ? null : worstOf(shown, picture),
    scene: isRight(shown) && !right ? sceneOf(all, points) : null,
    colors,
  };
}

const litBy = (term: Term, points: readonly SheetPoint[]): Case[] =>
  points.map(({ given }) => [{ ...given, light: only([term], given.light) }]);

/** Wrong points of the picture, and others. */
function sampleOf({ cases, colors, wrong }: Judged): Judged {
  const isWrong = new Set(wrong);
  const fine = Array.from(cases, (_, i) => i).filter((i) => !isWrong.has(i));
  const kept = [wrong, fine].flatMap((list) => {
    const stride = Math.max(Math.ceil(list.length / MOST_PICTURE), 1);
    return list.filter((_, i) => i % stride === 0);
  });
  return compare(
    kept.map((i) => cases[i]!),
    kept.flatMap((i) => colorAt(colors, i)),
  );
}

/** The scene in which it shows at most points. */
function sceneOf({ wrong }: Judged, points: readonly SheetPoint[]): SceneName | null {
  const count = (name: SceneName): number => wrong.filter((i) => points[i]!.scene === name).length;
  const [first] = [...SCENE_NAMES].sort((a, b) => count(b) - count(a));
  return first !== undefined && count(first) > 0 ? first : null;
}

function worstOf({ wrong, cases, colors }: Judged, picture: PicturePoints): Verdict['worst'] {
  let worst: Verdict['worst'] = null;
  let most = STEP;
  for (const i of wrong) {
    const exact = exactAt(cases[i]!);
    const found = colorAt(colors, i);
    const off = Math.max(...exact.map((x, k) => distance(x, found[k]!)));
    if (off > most) {
      most = off;
      const pixel = picture.pixels[i]!;
      worst = { x: pixel % picture.width, y: Math.floor(pixel / picture.width), found, exact };
    }
  }
  return worst;
}

/** Of what a screen shows; not a number is as far as can be. */
const distance = (a: number, b: number): number =>
  Number.isNaN(b) ? 1 : Math.abs(shownValue(a) - shownValue(b));

export const shownValue = (x: number): number => Math.min(Math.max(x, 0), 1);
