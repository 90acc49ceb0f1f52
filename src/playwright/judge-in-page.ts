// Finds the pixels of a viewer's picture that differ from what shadeAt explains. Runs inside the page. Positions are
// device pixels from the top left, colours 8-bit codes.
import type { LightValues } from '../light/light-state.js';
import { scale, subtract, type Vec3 } from '../math/vector.js';
import type { PhongViewer } from '../index.js';
import { judgeMeans, type Means } from './judge-means.js';
import { deviceSubpixelBits, type Explain, explainer, pictureOf, type Row, rowsOf } from './page-picture.js';
import { textureFault, type Explained } from './texture-fault.js';
import { type Tile, tilesOf } from './tiles.js';

/** What the equation takes at one pixel, as `shadeAt` gives it. */
export interface Point {
  readonly p: Vec3;
  readonly N: Vec3;
  readonly ka: Vec3;
  readonly kd: Vec3;
  readonly ks: Vec3;
  readonly shininess: number;
  readonly emissive: Vec3;
  readonly sum: Vec3;
}

/** A pixel that is more codes off than allowed at its centre. */
export interface Suspect {
  readonly x: number;
  readonly y: number;
  /** r, g, b, a. */
  readonly drawn: readonly number[];
  /** 255 times the colour by the equation, not rounded. */
  readonly expected: Vec3;
  readonly reflection: 'phong' | 'blinn-phong';
  /** The sum is interpolated (Gouraud shading) or independent of the lights (unlit). */
  readonly interpolated: boolean;
  readonly here: Point;
  /** One pixel to the right, and one pixel down, on the same face. */
  readonly right: Point;
  readonly below: Point;
}

export interface Judgement {
  readonly width: number;
  readonly height: number;
  /** Bits of the grid that the device moves vertices to. */
  readonly subpixelBits: number;
  /** Share of the picture that was looked at, 0–1. The counts below are of this part. */
  readonly sampled: number;
  /** Pixels that show a Phong-lit surface, without the picture's border. */
  readonly surface: number;
  readonly judged: number;
  /** Pixels of surfaces that are not judged, by reason: edges of triangles or texels, opacity, textures. */
  readonly edges: number;
  readonly translucent: number;
  readonly minified: number;
  /** Judged as means of samples; null where the picture shows single points. Then there are no suspects. */
  readonly means: Means | null;
  readonly suspects: readonly Suspect[];
  /** All of them; `suspects` holds the first `most`. */
  readonly suspectCount: number;
  readonly eye: Vec3;
  readonly target: Vec3;
  readonly up: Vec3;
  readonly terms: readonly ('ambient' | 'diffuse' | 'specular')[];
  readonly linear: boolean;
  /** Empty for the head-light. */
  readonly lights: readonly LightValues[];
}

export interface JudgeOptions {
  readonly codes: number;
  /** The same in outlines that are means of samples; null: by their number. */
  readonly outlineCodes: number | null;
  /** Pixels to judge at least, where the picture has them; null: all. */
  readonly pixels: number | null;
  /** Chooses the pixels. */
  readonly seed: number;
  /** Suspects returned at most. */
  readonly most: number;
  /** Names of a light's values. */
  readonly lightKeys: readonly string[];
}

/** What a picture's pixels have been found to be. */
export type Counts = {
  -readonly [K in 'surface' | 'judged' | 'edges' | 'translucent' | 'minified' | 'suspectCount']: Judgement[K];
};

/** A picture, and how its pixels are explained. */
export interface Subject {
  readonly viewer: PhongViewer;
  readonly picture: ImageData;
  readonly explain: Explain;
  readonly subpixelBits: number;
}

export type Findings = Counts & Pick<Judgement, 'sampled' | 'means' | 'suspects'>;

/** Judges each pixel by one point of the equation, or where samples have been averaged by their mean. */
export async function judgeInPage(viewer: PhongViewer, options: JudgeOptions): Promise<Judgement> {
  const before = JSON.stringify(viewer.camera);
  const picture = await pictureOf(viewer);
  const { width, height } = picture;
  const subpixelBits = deviceSubpixelBits();
  const subject = { viewer, picture, explain: explainer(viewer, width, height), subpixelBits };
  const { samples } = viewer.stats;
  const findings = await (samples > 0
    ? judgeMeans(subject, samples, options)
    : judgePoints(subject, options));
  if (JSON.stringify(viewer.camera) !== before)
    throw new Error('the camera moved while the picture was judged');
  return { width, height, subpixelBits, ...findings, ...settingOf(viewer, options.lightKeys) };
}

/** A pixel inside one face, with those to the right and below. */
interface Inside {
  readonly here: Explained;
  readonly right: Explained;
  readonly below: Explained;
}

/**
 * Judges a pixel if its four neighbours show the same triangle: the diamond between their centres contains the pixel's
 * square. Translucent surfaces are left out, because shadeAt explains them without what lies behind, and so are
 * textures where several texels share a pixel, because it samples without mipmaps. Borders of texels that are not
 * filtered count as edges.
 */
async function judgePoints(
  { viewer, picture, explain, subpixelBits }: Subject,
  { codes, pixels, seed, most }: JudgeOptions,
): Promise<Findings> {
  const { data, width, height } = picture;
  const counts: Counts = { surface: 0, judged: 0, edges: 0, translucent: 0, minified: 0, suspectCount: 0 };
  const suspects: Suspect[] = [];
  const tiles = tilesOf(width, height, seed);
  let done = 0;
  for (const tile of tiles) {
    if (pixels !== null && counts.judged >= pixels) break;
    done += 1;
    const rows = await rowsOf(explain, tile);
    for (const { x, y, inside } of insides(tile, rows, subpixelBits, counts)) {
      const drawn = [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 4)];
      const expected = scale(inside.here.color, 255);
      if (drawn[3] === 255 && !isOff(drawn, expected, codes)) continue;
      counts.suspectCount += 1;
      if (suspects.length < most) suspects.push({ x, y, drawn, expected, ...evidence(viewer, inside) });
    }
  }
  const sampled = tiles.length === 0 ? 1 : done / tiles.length;
  return { ...counts, sampled, means: null, suspects };
}

/** The pixels of a tile that can be judged. `rows` are those of the tile and of one pixel around it. */
function* insides(
  { left, top, right, bottom }: Tile,
  rows: readonly Row[],
  subpixelBits: number,
  counts: Counts,
): Generator<{ x: number; y: number; inside: Inside }> {
  for (let y = top; y < bottom; y++) {
    const [above, line, under] = [rows[y - top]!, rows[y - top + 1]!, rows[y - top + 2]!];
    for (let x = left; x < right; x++) {
      const inside = judged(above, line, under, x - left + 1, subpixelBits, counts);
      if (inside !== null) yield { x, y, inside };
    }
  }
}

/** The pixel at `x` of `line` with its neighbours, if it can be judged; counts it either way. */
function judged(
  above: Row,
  line: Row,
  under: Row,
  x: number,
  subpixelBits: number,
  counts: Counts,
): Inside | null {
  const here = line[x];
  if (!here) return null;
  counts.surface += 1;
  const [right, below] = [line[x + 1], under[x]];
  const isSame = (one: Explained | null | undefined): one is Explained =>
    one?.object === here.object && one.triangle === here.triangle;
  if (!isSame(right) || !isSame(below) || !isSame(line[x - 1]) || !isSame(above[x])) {
    counts.edges += 1;
    return null;
  }
  const steps = [subtract(right.p, here.p), subtract(below.p, here.p)];
  const fault = here.opacity < 1 ? 'translucent' : textureFault(here, steps, subpixelBits);
  counts[fault ?? 'judged'] += 1;
  return fault === null ? { here, right, below } : null;
}

export const isOff = (drawn: readonly number[], expected: Vec3, codes: number): boolean =>
  expected.some((value, channel) => Math.abs(Math.round(value) - drawn[channel]!) > codes);

/** What is needed to evaluate the equation around the pixel. */
function evidence(
  viewer: PhongViewer,
  { here, right, below }: Inside,
): Omit<Suspect, 'x' | 'y' | 'drawn' | 'expected'> {
  const own = here.mesh === viewer ? null : here.mesh;
  return {
    interpolated: (own?.shading ?? viewer.shading) === 'gouraud' || here.unlit,
    reflection: own?.reflection ?? viewer.reflection,
    here: pointOf(here),
    right: pointOf(right),
    below: pointOf(below),
  };
}

const pointOf = ({ p, N, ka, kd, ks, shininess, emissive, sum }: Explained): Point => ({
  ...{ p, N, ka, kd, ks, shininess, emissive, sum },
});

/** The viewer's camera, terms and lights. */
function settingOf(
  viewer: PhongViewer,
  lightKeys: readonly string[],
): Pick<Judgement, 'eye' | 'target' | 'up' | 'terms' | 'linear' | 'lights'> {
  const { eye, target, up } = viewer.camera;
  const values = (light: object): LightValues =>
    Object.fromEntries(
      lightKeys.map((key) => [key, Reflect.get(light, key) as unknown]),
    ) as unknown as LightValues;
  return {
    ...{ eye, target, up },
    terms: viewer.terms,
    linear: viewer.colorInterpolation === 'linear',
    lights: viewer.lights.map(values),
  };
}
