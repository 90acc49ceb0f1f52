// LDR-FLIP: how much of a difference is seen when two pictures are flipped in place, 0 to 1 of each pixel.
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: "FLIP: A Difference Evaluator for Alternating Images",
// Proceedings of the ACM on Computer Graphics and Interactive Techniques 3 (2), HPG 2020. In float64; colours are sRGB in 0-255.

import { srgbDecode } from '../../../src/math/color.js';
import type { Vec3 } from '../../../src/math/vector.js';
import type { ColorPicture } from './error-figures.js';
import { filtered, kernelOf, normalized, type Kernel, type Plane } from './planes.js';
import { hyab, linearOf, luminanceOf, opponentsOf, seenColorOf } from './seen-color.js';

/** The paper's viewer: a screen of 3840 pixels that is 0.7 m wide, seen from 0.7 m. 67.02. */
const PIXELS_PER_DEGREE = 0.7 * (3840 / 0.7) * (Math.PI / 180);

/**
 * How the eye blurs each opponent channel: sums of Gaussians a √(π/b) exp(-π² x² / b), x in degrees.
 * In the order of the channels: achromatic, red against green, blue against yellow.
 */
const BLURS = [
  [{ a: 1, b: 0.0047 }],
  [{ a: 1, b: 0.0053 }],
  [
    { a: 34.1, b: 0.04 },
    { a: 13.5, b: 0.025 },
  ],
] as const;

/** Makes small differences of colour count for more. */
const COLOR_EXPONENT = 0.7;
/** Differences up to `share` of the largest get `range` of what lies between 0 and 1. */
const COMPRESSION = { share: 0.4, range: 0.95 } as const;
/** Width of the edges and points that the eye finds best, and the exponent of their difference. */
const FEATURE = { widthDegrees: 0.082, exponent: 0.5 } as const;
/** Where filters end, in standard deviations. */
const REACH = 3;

/** Of each pixel, rows as the pictures'. Both of one size, channels in 0-255. */
export function flipMap(picture: ColorPicture, truth: ColorPicture): Float64Array {
  const [ours, theirs] = [sightOf(picture), sightOf(truth)];
  return Float64Array.from({ length: picture.width * picture.height }, (_, i) => {
    const apart = (c: 0 | 1 | 2): number => ours.colors[c][i]! - theirs.colors[c][i]!;
    const color = compressed(hyab(apart(0), apart(1), apart(2)) ** COLOR_EXPONENT);
    const feature = Math.max(
      Math.abs(ours.edges[i]! - theirs.edges[i]!),
      Math.abs(ours.points[i]! - theirs.points[i]!),
    );
    // A feature has a strength across and one down, each at most 1, so √2 is its most. It lifts the colour's error.
    return color ** (1 - (feature / Math.SQRT2) ** FEATURE.exponent);
  });
}

interface Sight {
  /** Of each pixel, blurred as by the eye. */
  readonly colors: readonly [Float64Array, Float64Array, Float64Array];
  readonly edges: Float64Array;
  readonly points: Float64Array;
}

function sightOf({ width, height, data }: ColorPicture): Sight {
  const plane = (): Plane => ({ width, height, data: new Float64Array(width * height) });
  const opponents = [plane(), plane(), plane()] as const;
  const luminance = plane();
  for (let i = 0; i < luminance.data.length; i++) {
    const channel = (c: number): number => srgbDecode(data[3 * i + c]! / 255);
    const color = opponentsOf([channel(0), channel(1), channel(2)]);
    put(opponents, i, color);
    luminance.data[i] = luminanceOf(color[0]);
  }
  const seen = [0, 1, 2].map((c) => blurred(opponents[c]!, BLURS[c]!)) as [Plane, Plane, Plane];
  for (let i = 0; i < luminance.data.length; i++) {
    const [red, green, blue] = linearOf([seen[0].data[i]!, seen[1].data[i]!, seen[2].data[i]!]);
    put(seen, i, seenColorOf([unit(red), unit(green), unit(blue)]));
  }
  return {
    colors: [seen[0].data, seen[1].data, seen[2].data],
    edges: strengths(luminance, EDGE),
    points: strengths(luminance, POINT),
  };
}

function put(planes: readonly [Plane, Plane, Plane], i: number, [x, y, z]: Vec3): void {
  planes[0].data[i] = x;
  planes[1].data[i] = y;
  planes[2].data[i] = z;
}

/** Blurs of different channels mix to colours that no screen has. */
const unit = (x: number): number => Math.min(1, Math.max(0, x));

/** All blurs end where the widest does. */
const BLUR_RADIUS = Math.ceil(
  REACH * Math.sqrt(Math.max(...BLURS.flat().map(({ b }) => b)) / (2 * Math.PI ** 2)) * PIXELS_PER_DEGREE,
);

function blurred(plane: Plane, gaussians: readonly { readonly a: number; readonly b: number }[]): Plane {
  const parts = gaussians.map(({ a, b }) => {
    const kernel = kernelOf(BLUR_RADIUS, (x) =>
      Math.exp((-(Math.PI ** 2) * (x / PIXELS_PER_DEGREE) ** 2) / b),
    );
    const sum = kernel.reduce((total, weight) => total + weight, 0);
    return {
      weight: a * Math.sqrt(Math.PI / b) * sum ** 2,
      plane: filtered(plane, normalized(kernel), normalized(kernel)),
    };
  });
  const total = parts.reduce((sum, { weight }) => sum + weight, 0);
  const data = plane.data.map((_, i) =>
    parts.reduce((sum, part) => sum + (part.weight / total) * part.plane.data[i]!, 0),
  );
  return { ...plane, data };
}

/** Pixels; the width is that of two standard deviations. */
const DEVIATION = (FEATURE.widthDegrees / 2) * PIXELS_PER_DEGREE;
const FEATURE_RADIUS = Math.ceil(REACH * DEVIATION);
const bell = (x: number): number => Math.exp(-(x ** 2) / (2 * DEVIATION ** 2));
const BELL = normalized(kernelOf(FEATURE_RADIUS, bell));
/** The bell's first derivative finds edges, its second points. */
const EDGE = normalized(kernelOf(FEATURE_RADIUS, (x) => -x * bell(x)));
const POINT = normalized(kernelOf(FEATURE_RADIUS, (x) => (x ** 2 / DEVIATION ** 2 - 1) * bell(x)));

function strengths(luminance: Plane, derivative: Kernel): Float64Array {
  const across = filtered(luminance, derivative, BELL).data;
  const down = filtered(luminance, BELL, derivative).data;
  return across.map((x, i) => Math.sqrt(x * x + down[i]! ** 2));
}

/** Between black and white lie smaller distances than between the screen's green and blue. */
const LARGEST = ((): number => {
  const [green, blue] = [seenColorOf([0, 1, 0]), seenColorOf([0, 0, 1])];
  return hyab(green[0] - blue[0], green[1] - blue[1], green[2] - blue[2]) ** COLOR_EXPONENT;
})();

/** To 0-1: large differences look alike. */
function compressed(difference: number): number {
  const knee = COMPRESSION.share * LARGEST;
  if (difference < knee) return (COMPRESSION.range * difference) / knee;
  return COMPRESSION.range + ((1 - COMPRESSION.range) * (difference - knee)) / (LARGEST - knee);
}
