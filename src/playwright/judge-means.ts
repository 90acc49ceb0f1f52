// Judges a picture of `antialias="full"`, whose pixels are means of samples. Runs inside the page. Positions are device
// pixels from the top left, colours 8-bit codes, premultiplied where they are means.
import { pixelOffset } from '../math/pixel-offsets.js';
import { scale, subtract, type Vec3 } from '../math/vector.js';
import type { PhongViewer } from '../index.js';
import { type Counts, type Findings, isOff, type JudgeOptions, type Subject } from './judge-in-page.js';
import { type Row, rowsOf } from './page-picture.js';
import { isTextured, textureFault } from './texture-fault.js';
import { shuffle, type Tile, tilesOf } from './tiles.js';

export interface Means {
  /** Of each pixel. */
  readonly samples: number;
  /** Pixels in outlines and other edges that were judged, and those found in the part that was looked at. */
  readonly outlines: number;
  readonly outlinesFound: number;
  /** Largest difference of an outline, in codes, and the limit for it. */
  readonly largest: number;
  readonly limit: number;
  /** The first of them. */
  readonly wrong: readonly WrongMean[];
  /** There may be more: the search was ended. */
  readonly ended: boolean;
}

export interface WrongMean extends Place {
  /** r, g, b, a. */
  readonly drawn: readonly number[];
  readonly expected: readonly number[];
}

interface Place {
  readonly x: number;
  readonly y: number;
  readonly kind: Kind;
}

/**
 * What a pixel shows: the inside of a smooth surface, the edge of an object, an edge between triangles, or a colour that
 * changes fast inside a triangle.
 */
export type Kind = 'inside' | 'contour' | 'crease' | 'steep';

/**
 * Most codes between the nine points in and around a pixel for its middle to stand for its mean. Where the mean is
 * another, samples tell.
 */
const SMOOTH = 16;

/** Samples evaluated in outlines: 20 to 50 µs each. */
const OUTLINE_SAMPLES = 10_000;

/** Outlines judged at least, where the picture has them. */
const FEWEST_OUTLINES = 50;

/**
 * Codes that outlines may be off beyond one sample. A device moves each vertex to its grid, so an edge may turn as well as
 * shift. The largest of 37 scenes on a grid of sixteenths was 16 codes with 16 samples, which is one of them, 6 with 64
 * and 1 with 1,024; most have 1.
 */
const TURNED = 4;

/** Wrong pixels after which a picture is wrong anyway. */
const MOST_WRONG = 50;

/**
 * Inside a surface a pixel passes by the colour at its centre, or else by the mean. Of the others as many as there is
 * time for are judged by the mean, equally many of each kind.
 */
export async function judgeMeans(
  subject: Subject,
  samples: number,
  options: JudgeOptions,
): Promise<Findings> {
  const { pixels, seed } = options;
  const { counts, sampled, suspects, outlines } = await survey(subject, options);
  for (const list of outlines) shuffle(list, seed);
  const found = [...inTurn(outlines)];
  const enough = Math.max(FEWEST_OUTLINES, Math.round(OUTLINE_SAMPLES / samples));
  const chosen = pixels === null ? found : found.slice(0, enough);
  const offsets = Array.from({ length: samples }, (_, i) => pixelOffset(i));
  const limit = options.outlineCodes ?? Math.ceil(255 / samples) + TURNED;
  const wrong: WrongMean[] = [];
  let judged = 0;
  let largest = 0;
  for (const place of [...chosen, ...suspects]) {
    if (wrong.length === MOST_WRONG) break;
    const isOutline = place.kind === 'contour' || place.kind === 'crease';
    const most = isOutline ? limit : options.codes;
    const off = await offOf(subject, place, offsets, most);
    if (off === null) continue;
    if (place.kind !== 'inside') judged += 1;
    if (isOutline) largest = Math.max(largest, off.codes);
    if (off.codes > most) wrong.push({ ...place, ...off });
  }
  const ended = wrong.length === MOST_WRONG;
  const means = { samples, outlines: judged, outlinesFound: found.length, largest, limit, wrong, ended };
  return { ...counts, sampled, means, suspects: [] };
}

interface Survey {
  readonly counts: Counts;
  readonly sampled: number;
  /** Inside a surface, but not of the colour at their centre. */
  readonly suspects: readonly Place[];
  /** Each kind by itself. */
  readonly outlines: readonly Place[][];
}

/** Looks at the picture's parts in a random order, until enough pixels inside surfaces have been found. */
async function survey(subject: Subject, { codes, pixels, seed }: JudgeOptions): Promise<Survey> {
  const { viewer, picture, explain, subpixelBits } = subject;
  const counts: Counts = { surface: 0, judged: 0, edges: 0, translucent: 0, minified: 0, suspectCount: 0 };
  const ownObjects = hasOwnObjects(viewer);
  const places: Record<Kind, Place[]> = { inside: [], contour: [], crease: [], steep: [] };
  const tiles = tilesOf(picture.width, picture.height, seed);
  let done = 0;
  for (const tile of tiles) {
    if (pixels !== null && counts.judged >= pixels) break;
    done += 1;
    for (const { x, y, around } of squares(tile, await rowsOf(explain, tile))) {
      const here = around[4];
      if (here) counts.surface += 1;
      const fault = faultOf(around, subpixelBits);
      const kind = kindOf(around);
      if (fault !== null) {
        if (here) counts[fault] += 1;
      } else if (here && kind === 'inside') {
        counts.judged += 1;
        const drawn = drawnAt(picture, x, y);
        const isRight = drawn[3] === 255 && !isOff(drawn, scale(here.color, 255), codes);
        if (!isRight) places.inside.push({ x, y, kind });
      } else {
        if (here) counts.edges += 1;
        // Beside an object of the page's own, nothing says where that one ends.
        if (!ownObjects || !around.includes(null)) places[kind].push({ x, y, kind });
      }
    }
  }
  const sampled = tiles.length === 0 ? 1 : done / tiles.length;
  const { inside, ...outlines } = places;
  return { counts, sampled, suspects: inside, outlines: Object.values(outlines) };
}

/** The pixels of a tile in or beside which there is a surface, with what is shown at the nine points around each. */
function* squares(
  { left, top, right, bottom }: Tile,
  rows: readonly Row[],
): Generator<{ x: number; y: number; around: Row }> {
  for (let y = top; y < bottom; y++) {
    for (let x = left; x < right; x++) {
      const lines = rows.slice(y - top, y - top + 3);
      const around = lines.flatMap((line) => line.slice(x - left, x - left + 3));
      if (around.some((one) => one !== null)) yield { x, y, around };
    }
  }
}

function kindOf(around: Row): Kind {
  const here = around[4];
  if (!here || around.some((one) => one?.object !== here.object)) return 'contour';
  const colors = around.map((one) => one!.color);
  const range = (channel: 0 | 1 | 2): number => {
    const values = colors.map((color) => color[channel]);
    return 255 * (Math.max(...values) - Math.min(...values));
  };
  if (Math.max(range(0), range(1), range(2)) <= SMOOTH) return 'inside';
  return around.every((one) => one?.triangle === here.triangle) ? 'steep' : 'crease';
}

/** Why a pixel cannot be judged, as for single points. Texels that are not filtered are no fault: samples see them. */
function faultOf(around: Row, subpixelBits: number): 'translucent' | 'minified' | null {
  if (around.some((one) => one !== null && one.opacity < 1)) return 'translucent';
  const isMinified = around.some((one, i) => {
    if (one === null || !isTextured(one)) return false;
    const stepTo = (...beside: number[]): Vec3 | null => {
      const other = beside.map((k) => around[k]).find((each) => each?.object === one.object);
      return other ? subtract(other.p, one.p) : null;
    };
    const right = i % 3 === 2 ? stepTo(i - 1) : i % 3 === 0 ? stepTo(i + 1) : stepTo(i + 1, i - 1);
    const below = stepTo(i + 3, i - 3);
    return right === null || below === null || textureFault(one, [right, below], subpixelBits) === 'minified';
  });
  return isMinified ? 'minified' : null;
}

/**
 * How many codes a pixel is from the means of the equation: at its place, or if that is more than the limit or one code,
 * within one step of the device's subpixel grid. Null where a sample meets what cannot be judged.
 */
async function offOf(
  { viewer, picture, explain, subpixelBits }: Subject,
  { x, y }: Place,
  offsets: readonly Offset[],
  limit: number,
): Promise<{ codes: number; drawn: readonly number[]; expected: readonly number[] } | null> {
  const ownObjects = hasOwnObjects(viewer);
  const drawn = premultiplied(drawnAt(picture, x, y));
  const meanAt = async (dx: number, dy: number): Promise<readonly number[] | null> => {
    const points = await Promise.all(
      offsets.map((offset) => explain(x + 0.5 + offset.x + dx, y + 0.5 + offset.y + dy, true)),
    );
    const isUnknown = points.some((one) => (one === null ? ownObjects : one.opacity < 1));
    return isUnknown ? null : meanOf(points);
  };
  const expected = await meanAt(0, 0);
  if (expected === null) return null;
  const off = (means: readonly (readonly number[])[]): number =>
    Math.max(
      ...drawn.map((code, channel) => {
        const codes = means.map((mean) => Math.round(mean[channel]!));
        return Math.max(Math.min(...codes) - code, code - Math.max(...codes), 0);
      }),
    );
  const codes = off([expected]);
  if (codes <= Math.min(limit, 1)) return { codes, drawn, expected };
  const step = 2 ** -subpixelBits;
  const means = [expected];
  for (const dx of [-step, step])
    for (const dy of [-step, step]) means.push((await meanAt(dx, dy)) ?? expected);
  return { codes: off(means), drawn, expected };
}

type Offset = ReturnType<typeof pixelOffset>;

/** r, g, b, a; premultiplied. */
function meanOf(points: Row): readonly number[] {
  const sum = [0, 0, 0, 0];
  for (const point of points) {
    if (point === null) continue;
    for (const channel of [0, 1, 2] as const) sum[channel]! += 255 * point.color[channel];
    sum[3]! += 255;
  }
  return sum.map((codes) => codes / points.length);
}

const drawnAt = ({ data, width }: ImageData, x: number, y: number): readonly number[] => [
  ...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 4),
];

const premultiplied = (drawn: readonly number[]): readonly number[] =>
  drawn.map((code, channel) => (channel === 3 ? code : Math.round((code * drawn[3]!) / 255)));

/** Whether the scene shows objects that shadeAt does not explain. */
function hasOwnObjects({ scene }: PhongViewer): boolean {
  let found = false;
  scene.traverseVisible((object) => {
    const { material } = object as { material?: object };
    found ||= material !== undefined && !('look' in material);
  });
  return found;
}

/** The first of each list, then the second of each. */
function* inTurn<T>(lists: readonly (readonly T[])[]): Generator<T> {
  const longest = Math.max(...lists.map((list) => list.length));
  for (let i = 0; i < longest; i++) for (const list of lists) if (i < list.length) yield list[i]!;
}
