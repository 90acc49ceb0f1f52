// Where each number of a packed light is. These tables give the offsets that pack-lights writes to and the defines that
// the GLSL reads with, so the two cannot disagree. A row is a vec4.

/** Rows before the first light: the number of lights of each kind, and the ambient light that reaches everywhere. */
export const HEADER = { counts: 0, ambient: 1, rows: 2 } as const;

/**
 * Rows of a light grid, relative to the row that the counts' w names. `low`: the box's low corner, w = the first cell's
 * row; `scale`: cells per unit, w = the first row of the list of spots, four to a row; `size`: cells along each axis, w
 * = the number of leading spots that stand in no list because they reach most cells. A cell's row: the index of its
 * first spot in the list, and its number of spots.
 */
export const GRID = { low: 0, scale: 1, size: 2, rows: 3 } as const;

/**
 * Rows of each kind of light, relative to the light's first row. xyz (or rgb) is the vector; w holds a scalar.
 * Lights stand sorted by kind in this order: directional, point, spot.
 */
export const ROWS = {
  directional: {
    /** L, unit. */
    direction: 0,
    diffuse: 1,
    specular: 2,
    rows: 3,
  },
  point: {
    /** Position; w = kc. */
    position: 0,
    /** Id; w = kl. */
    diffuse: 1,
    /** Is; w = kq. */
    specular: 2,
    rows: 3,
  },
  /** Begins as a point light does. */
  spot: {
    position: 0,
    diffuse: 1,
    specular: 2,
    /** A, unit; w = cutoff. */
    axis: 3,
    /** Ia; w = the cone's limit, see packedLimit in light-features. */
    ambient: 4,
    rows: 5,
  },
} as const;

/**
 * The cone's limit is one float: from 0 the largest allowed (1 - c)/2, below 0 minus the smallest allowed (1 + c)/2;
 * this value, above any (1 - c)/2, lets every direction through.
 */
export const LIMIT_OPEN = 4;

/**
 * The code that a light needs beyond its kind, as bits of one mask that the packing and the GLSL share. Each bit adds
 * code, so the union of several lights' masks is right for all of them. `power` and above hold a spot's cutoff where it
 * is an integer from 1 to LARGEST_INTEGER_POWER; other cutoffs above 0 set `decay`.
 */
export const LIGHT_FEATURES = {
  ambient: 1,
  diffuse: 2,
  specular: 4,
  attenuated: 8,
  /** A cone compared on the axis's side, by (1 - c)/2; `wide` on the far side, by (1 + c)/2. */
  narrow: 16,
  wide: 32,
  decay: 64,
  /** Cone or decay are too steep for a cosine. */
  chords: 128,
  /** kc below 1: near the light, attenuation is clamped to 1. */
  clamped: 256,
  /** kl above 0: attenuation needs the distance, not its square alone. */
  linear: 512,
  /** Channels differ; grey light is summed as one number. */
  tintedDiffuse: 1024,
  tintedSpecular: 2048,
  /** Kinds that a scene has declared. Packed lights are sorted by kind instead. */
  directional: 4096,
  point: 8192,
  spot: 16384,
  powerShift: 15,
} as const;

/**
 * Largest shininess that log2 and the lobe's cosine are precise enough for: 0.1 of a code on the worst lawful driver.
 * log2 near 1 may be 2^-21 off, of which an exponent of 200 makes 6.6e-5, or 0.02 of a code.
 */
export const LARGEST_MILD_POWER = 200;

/**
 * The same of a spot's decay. Its (c + 1)/2 may be 2e-7 off as well: an exponent of 32 makes 1.1e-5 and 6e-6 of them,
 * 0.007 of a code at most.
 */
export const LARGEST_MILD_CUTOFF = 32;

/**
 * Largest integer exponent that a specialised program multiplies out: six squarings (powInteger) round to 0.001 of a
 * code.
 */
export const LARGEST_INTEGER_POWER = 64;

/** Width of the light texture in texels, one row of a light each: a power of two within every device's limit. */
export const TEXTURE_ROWS_LOG2 = 10;

/**
 * A light nearer to the fragment than this has no direction: NoL = spec = 0, inside any cone, decay 1. Its square is
 * a normal float32, so the comparison cannot be lost to flushed denormals.
 */
export const NEAREST = 1e-15;

/** Exponents below this are 0: x^0 = 1 for every x. */
export const LEAST_EXPONENT = 1e-6;

/**
 * Positive numbers below this count as zero: a device may flush numbers below 2^-126. Not 2^-126 itself, because
 * Firefox on Mesa reads literals of 1.2e-38 and less as zero.
 */
const TINY = 2 ** -120;

const snake = (name: string): string => name.replace(/[A-Z]/g, '_$&').toUpperCase();
const float = (n: number): string => (Number.isInteger(n) ? n.toFixed(1) : n.toExponential());

/** Not String(n): V8's number-to-string cache grows to 64 KiB for good when numbers collide in it, as these do. */
const integer = (n: number): string => n.toFixed();

/** `#define` lines for the GLSL: the whole layout. */
export function layoutDefines(): string {
  const lines = [
    `#define LIMIT_OPEN ${float(LIMIT_OPEN)}`,
    `#define TEXTURE_ROWS_LOG2 ${integer(TEXTURE_ROWS_LOG2)}`,
    `#define NEAREST_SQUARED ${float(NEAREST * NEAREST)}`,
    `#define LEAST_EXPONENT ${float(LEAST_EXPONENT)}`,
    `#define TINY ${float(TINY)}`,
  ];
  const tables = { HEADER, GRID, FEATURE: LIGHT_FEATURES, ...ROWS };
  for (const [table, numbers] of Object.entries(tables)) {
    for (const [name, number] of Object.entries(numbers)) {
      lines.push(`#define ${table.toUpperCase()}_${snake(name)} ${integer(number)}`);
    }
  }
  return lines.join('\n');
}
