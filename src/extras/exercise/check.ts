// One run of a learner's function: at the sheet, at the picture, and what the colours say.
import type { Term } from '../../phong/light/light-state.js';
import { map, type Vec3 } from '../../phong/math/vector.js';
import type { MistakeId } from '../../phong/mistakes/mistakes.js';
import { guarded } from './guard.js';
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
  shownValue,
  type Work,
} from '../../phong/mistakes/judge.js';
import { type Images, imagesOf } from './paint.js';
import type { PicturePoints } from './picture.js';
import { run } from './program.js';
import { inTasks } from '../explain/in-tasks.js';
import { type SceneName, sheetOf, type SheetPoint, type Task } from '../../phong/mistakes/sheet.js';

/** What the event `check` has, and the command for marking reads. */
export interface Outcome {
  readonly right: boolean;
  readonly mistakes: readonly MistakeId[];
  /** Of the judged pixels; of the sheet's points where there is no picture. */
  readonly share: number;
  /** The wrong pixel where it shows best, with both colours, 255 as full; null where none is wrong. */
  readonly pixel: {
    readonly x: number;
    readonly y: number;
    readonly found: Vec3;
    readonly exact: Vec3;
  } | null;
}

export interface Verdict extends Outcome {
  readonly pixels: number;
  /** At which the result is not a number. */
  readonly undefinedPixels: number;
  /**
   * In which it is wrong where the power of a negative number is that of its absolute value. If it is
   * right, it depends on such a power.
   */
  readonly terms: readonly Term[];
  readonly difference: Difference;
  /** A scene of the sheet that shows it, where the picture does not. */
  readonly scene: SceneName | null;
  readonly images: Images | null;
}

/** Points of each scene. */
const COUNT = 150;

/** Points of each scene that are also lit by one term alone. */
const ALONE = 30;

/** Points of the picture that a mistake has to explain. */
const MOST_PICTURE = 300;

/** Throws why there is no verdict, or the signal's reason after an abort. */
export async function check(
  source: string,
  task: Task,
  picture: PicturePoints | null,
  signal: AbortSignal,
): Promise<Verdict> {
  const points = sheetOf(task, COUNT);
  const shared = [picture?.cases ?? [], points.map(({ given }) => [given])];
  const alone = task.terms.map((term) =>
    sheetOf({ ...task, terms: [term] }, ALONE).map(({ given }) => [given]),
  );
  const parts = [...shared, ...alone];
  const colors = await run(guarded(source), parts.flat(), shared.flat().length, signal);
  return inTasks(verdictOf(points, parts, colors, picture, task), signal);
}

/** `parts`: the picture, the sheet, and the sheet lit by each term that is asked for alone. */
function* verdictOf(
  points: readonly SheetPoint[],
  parts: readonly (readonly Case[])[],
  colors: Float32Array,
  picture: PicturePoints | null,
  { terms }: Task,
): Work<Verdict> {
  const judged: Judged[] = [];
  let from = 0;
  for (const [i, part] of parts.entries()) {
    const found = colors.subarray(3 * from, 3 * (from += part.length));
    judged.push(yield* compare(part, found, i > 0));
  }
  const [shown, all, ...alone] = judged as [Judged, Judged, ...Judged[]];
  const right = isRight(all) && isRight(shown);
  const sample = yield* sampleOf(shown);
  const of = shown.count > 0 ? shown : all;
  return {
    right,
    mistakes: right ? [] : yield* mistakesIn([all, sample]),
    share: 1 - of.wrong.length / of.count,
    pixels: shown.count,
    undefinedPixels: shown.wrong.filter((i) => colorAt(shown.colors, i).some(Number.isNaN)).length,
    terms: terms.filter((_, i) => !isRight(alone[i]!)),
    difference: differenceOf(all.wrong.length > 0 ? all : sample),
    pixel: worstOf(shown, picture),
    // Half of the wrong points come before: a scene with many of them.
    scene: isRight(shown) && !right ? points[all.wrong[all.wrong.length >> 1]!]!.scene : null,
    images: picture === null ? null : yield* imagesOf(picture, shown.colors),
  };
}

/** Wrong points of the picture, and any. */
function sampleOf({ cases, colors, wrong }: Judged): Work<Judged> {
  const kept = [wrong, Array.from(cases.keys())].flatMap((list) => {
    const stride = Math.max(Math.ceil(list.length / MOST_PICTURE), 1);
    return list.filter((_, i) => i % stride === 0);
  });
  return compare(
    kept.map((i) => cases[i]!),
    kept.flatMap((i) => colorAt(colors, i)),
  );
}

function worstOf(
  { wrong, cases, colors }: Judged,
  picture: PicturePoints | null,
): Verdict['pixel'] {
  // Of what a screen shows; not a number is as far as can be.
  const offAt = (i: number) => {
    const exact = exactAt(cases[i]!);
    const offs = colorAt(colors, i).map((x, k) =>
      Number.isNaN(x) ? 1 : Math.abs(shownValue(x) - shownValue(exact[k]!)),
    );
    return Math.max(...offs);
  };
  const [first] = wrong;
  if (picture === null || first === undefined) return null;
  const worst = wrong.reduce((most, i) => (offAt(i) > offAt(most) ? i : most), first);
  const pixel = picture.pixels[worst]!;
  return {
    x: pixel % picture.width,
    y: Math.floor(pixel / picture.width),
    found: codes(colorAt(colors, worst)),
    exact: codes(exactAt(cases[worst]!)),
  };
}

/** As a screen has them, but not clamped: negative light is seen here. */
const codes = (color: Vec3) => map(color, (x) => Math.round(255 * x));
