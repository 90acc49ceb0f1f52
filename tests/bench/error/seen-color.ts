// Colours as FLIP compares them: opponent channels to blur, then L*a*b* with chroma as bright as it looks, and the distance
// there (the paper that flip.ts names). Linear light has 1 as full; the white is D65, as sRGB's.

import { cross, dot, map, type Vec3 } from '../../../src/math/vector.js';

/** Linear sRGB to XYZ, as exact fractions from the primaries and the white of IEC 61966-2-1. */
const XYZ_OF_RGB: readonly [Vec3, Vec3, Vec3] = [
  [10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
  [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
  [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382],
];
const RGB_OF_XYZ = inverse(XYZ_OF_RGB);
const WHITE = times(XYZ_OF_RGB, [1, 1, 1]);

/**
 * Achromatic, red against green, blue against yellow: L*a*b* without its cube roots, so that blurring a
 * channel blurs light.
 */
export function opponentsOf(linear: Vec3): Vec3 {
  const [x, y, z] = relative(times(XYZ_OF_RGB, linear));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** Back to linear light. */
export function linearOf([achromatic, redGreen, blueYellow]: Vec3): Vec3 {
  const y = luminanceOf(achromatic);
  return times(RGB_OF_XYZ, [
    (y + redGreen / 500) * WHITE[0],
    y * WHITE[1],
    (y - blueYellow / 200) * WHITE[2],
  ]);
}

/** Of an achromatic channel, 0-1. */
export const luminanceOf = (achromatic: number): number => (achromatic + 16) / 116;

/** L* and a* b* scaled by it: the same chroma looks stronger in brighter light, as Hunt found. */
export function seenColorOf(linear: Vec3): Vec3 {
  const [x, y, z] = map(relative(times(XYZ_OF_RGB, linear)), lightness);
  const L = 116 * y - 16;
  return [L, 0.01 * L * 500 * (x - y), 0.01 * L * 200 * (y - z)];
}

/** HyAB: lightness apart from chroma, which holds for large differences where CIEDE2000 does not. */
export const hyab = (dL: number, da: number, db: number): number =>
  Math.abs(dL) + Math.sqrt(da * da + db * db);

/** CIE 15: a cube root, and its tangent where light is so faint that the root would be too steep. */
function lightness(t: number): number {
  const knee = 6 / 29;
  return t > knee ** 3 ? Math.cbrt(t) : t / (3 * knee ** 2) + 4 / 29;
}

const relative = ([x, y, z]: Vec3): Vec3 => [x / WHITE[0], y / WHITE[1], z / WHITE[2]];

function times(rows: readonly [Vec3, Vec3, Vec3], v: Vec3): Vec3 {
  return [dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)];
}

/** Columns of the inverse are cross products of rows, over the determinant. */
function inverse([u, v, w]: readonly [Vec3, Vec3, Vec3]): readonly [Vec3, Vec3, Vec3] {
  const determinant = dot(u, cross(v, w));
  const columns = [cross(v, w), cross(w, u), cross(u, v)] as const;
  const row = (i: 0 | 1 | 2): Vec3 => [
    columns[0][i] / determinant,
    columns[1][i] / determinant,
    columns[2][i] / determinant,
  ];
  return [row(0), row(1), row(2)];
}
