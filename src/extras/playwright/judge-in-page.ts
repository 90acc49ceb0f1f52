// Finds the pixels of a viewer's picture that differ from the equation. Runs inside the page.
// Positions are device pixels from the top left, colours 8-bit codes.
import { add, cross, dot, length, subtract } from '../../phong/math/vector.js';
import { radians } from '../../phong/math/angle.js';
import type { PhongViewer } from '../../viewer/index.js';

/** Pixels of surfaces, by what became of them. */
export interface Counts {
  readonly judged: number;
  /** Not judged: at an outline or a crease, beside another object, or at the picture's border. */
  readonly edges: number;
  readonly steep: number;
  readonly translucent: number;
  /** A texture is averaged that shadeAt reads at one point. */
  readonly filtered: number;
}

export interface WrongPixel {
  readonly x: number;
  readonly y: number;
  /** r, g, b, a. */
  readonly drawn: readonly number[];
  /** The equation's least and greatest red, green and blue in the pixel, not rounded. */
  readonly least: readonly number[];
  readonly greatest: readonly number[];
}

export interface Judgement {
  readonly counts: Counts;
  /** Pixels that show a Phong-lit surface: the sum of the counts. */
  readonly surface: number;
  /** Share of the picture that was looked at, 0–1. The counts are of this part. */
  readonly sampled: number;
  /** The first of the wrong pixels, and how many there are. */
  readonly wrong: readonly WrongPixel[];
  readonly wrongCount: number;
}

interface JudgeOptions {
  /** How far a channel may be outside the equation's range. */
  readonly codes: number;
  /** Pixels to judge at least, where the picture has them; null: all. */
  readonly pixels: number | null;
  readonly seed: number;
  /** Wrong pixels returned at most. */
  readonly most: number;
}

/**
 * Half a pixel, and one step of the coarsest grid that WebGL 2 lets a device move vertices to:
 * sixteenths. What shows in the pixel is within this of its centre in the unmoved scene.
 */
const REACH = 0.5 + 2 ** -4;

/**
 * Widest range of a channel in a pixel that is judged, in codes. Half of it is how far a wrong
 * colour can be from the right one and still pass. 44 % of a torus knot's pixels are within it at
 * 300 × 200, 17 % within half of it.
 */
const WIDEST = 8;

/**
 * How far the centre may be from the mean of opposite corners, in codes: the one that a picture may
 * be off. The mean of a quadratic over a square is 2/3 of its centre and 1/12 of each corner, so it
 * lies in the range of the five. More means detail that five points do not show.
 */
const STRAIGHT = 1;

/**
 * A surface goes on between two points if its normals there, and the line between the points and
 * its tangent plane, differ by no more. A cosine departs from a straight line by a code of 255
 * within this angle.
 */
const SMOOTH = Math.sin(radians(5));

type Fault = Exclude<keyof Counts, 'judged'>;

/** Judges pixels in which a single smooth surface shows, and its colour hardly changes. */
export async function judgeInPage(
  viewer: PhongViewer,
  { codes, pixels, seed, most }: JudgeOptions,
): Promise<Judgement> {
  const before = JSON.stringify(viewer.camera);
  const { data, width, height } = await pictureOf(viewer);
  const explain = explainer(viewer, width, height);
  const counts = { judged: 0, edges: 0, steep: 0, translucent: 0, filtered: 0 };
  const wrong: WrongPixel[] = [];
  let wrongCount = 0;
  let looked = 0;
  for (const at of spread(width * height, seed)) {
    if (pixels !== null && counts.judged >= pixels) break;
    looked += 1;
    const [x, y] = [at % width, Math.floor(at / width)];
    const points = await pointsIn(explain, x, y);
    if (points === null) continue;
    const fault = faultOf(points);
    counts[fault ?? 'judged'] += 1;
    if (fault !== null) continue;
    const drawn = [...data.subarray(4 * at, 4 * at + 4)];
    const { least, greatest } = rangeOf(points);
    const isRight = least.every(
      (low, k) =>
        drawn[k]! >= Math.round(low) - codes && drawn[k]! <= Math.round(greatest[k]!) + codes,
    );
    if (isRight && drawn[3] === 255) continue;
    wrongCount += 1;
    if (wrong.length < most) {
      wrong.push({ x, y, drawn, least, greatest });
    }
  }
  if (JSON.stringify(viewer.camera) !== before) {
    throw new Error('the camera moved while the picture was judged');
  }
  const surface = Object.values(counts).reduce((sum, count) => sum + count, 0);
  return { counts, surface, sampled: looked / (width * height), wrong, wrongCount };
}

/** Each number below `count` once, spread from the first on: steps of the golden ratio. */
function* spread(count: number, seed: number): Generator<number> {
  const factorOf = (a: number, b: number): number => (b === 0 ? a : factorOf(b, a % b));
  let step = Math.max(Math.round(count * 0.618), 1);
  while (factorOf(count, step) !== 1) {
    step += 1;
  }
  // Weyl's sequence: neighbouring seeds begin far from each other.
  const start = Math.floor((((seed * 0.7549) % 1) + 1) * count);
  for (let i = 0; i < count; i++) {
    yield (start + i * step) % count;
  }
}

type Points = readonly [center: Explained, ...corners: (Explained | null)[]];

async function pointsIn(explain: Explain, x: number, y: number): Promise<Points | null> {
  const [column, row] = [x + 0.5, y + 0.5];
  const center = await explain(column, row);
  if (center === null) return null;
  const corners = [
    explain(column - REACH, row - REACH),
    explain(column + REACH, row + REACH),
    explain(column + REACH, row - REACH),
    explain(column - REACH, row + REACH),
  ];
  return [center, ...(await Promise.all(corners))];
}

/** Why the pixel cannot be judged; null if it can. */
function faultOf(points: Points): Fault | null {
  const [center, ...corners] = points;
  if (!corners.every((corner) => corner !== null && goesOn(center, corner))) return 'edges';
  const all = points as readonly Explained[];
  if (all.some(({ opacity }) => opacity < 1)) return 'translucent';
  if (all.some(({ filtered }) => filtered)) return 'filtered';
  const { least, greatest } = rangeOf(points);
  const isWide = least.some((low, k) => greatest[k]! - low > WIDEST);
  return isWide || !isStraight(all) ? 'steep' : null;
}

/** Whether both points lie on one smooth surface. Inside a triangle nothing bends. */
function goesOn(a: Explained, b: Explained): boolean {
  if (a.object !== b.object) return false;
  if (dot(a.N, b.N) < 0 || length(cross(a.N, b.N)) > SMOOTH) return false;
  const step = subtract(b.p, a.p);
  const normal = add(a.N, b.N);
  return (
    a.triangle === b.triangle ||
    Math.abs(dot(step, normal)) <= SMOOTH * length(step) * length(normal)
  );
}

function isStraight([center, a, b, c, d]: readonly Explained[]): boolean {
  const isMean = (x: number, one: number, other: number) =>
    255 * Math.abs(x - (one + other) / 2) <= STRAIGHT;
  const isMeanOf = (one: Explained, other: Explained) =>
    center!.color.every((x, k) => isMean(x, one.color[k]!, other.color[k]!));
  return isMeanOf(a!, b!) && isMeanOf(c!, d!);
}

function rangeOf(points: Points): Pick<WrongPixel, 'least' | 'greatest'> {
  const bound = (of: (...values: number[]) => number): readonly number[] =>
    ([0, 1, 2] as const).map((k) => 255 * of(...points.map((point) => point!.color[k])));
  return { least: bound(Math.min), greatest: bound(Math.max) };
}

/** What shadeAt gives for a point of a surface. */
type Explained = NonNullable<Awaited<ReturnType<PhongViewer['shadeAt']>>>;

/** Explains the point at x, y; null where no Phong-lit surface is drawn. */
type Explain = (x: number, y: number) => Promise<Explained | null>;

async function pictureOf(viewer: PhongViewer): Promise<ImageData> {
  const bitmap = await createImageBitmap(await viewer.toBlob(), {
    premultiplyAlpha: 'none',
    colorSpaceConversion: 'none',
  });
  const { width, height } = bitmap;
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (context === null) throw new Error('the viewer cannot be drawn here');
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, width, height);
}

function explainer(viewer: PhongViewer, width: number, height: number): Explain {
  const surface = viewer.shadowRoot?.querySelector('[part=surface]');
  if (!surface) throw new Error('the viewer cannot be drawn here');
  // shadeAt takes CSS pixels of the picture before any transform; inside CSS zoom, those of pointer
  // events.
  const style = getComputedStyle(surface);
  const zoom = (surface as { currentCSSZoom?: number }).currentCSSZoom ?? 1;
  const cssX = (parseFloat(style.width) * zoom) / width;
  const cssY = (parseFloat(style.height) * zoom) / height;
  return (x, y) => viewer.shadeAt(x * cssX, y * cssY, { exact: true });
}
