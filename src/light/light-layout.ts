// Where each number of a packed light stands. This one table gives the offsets that pack-lights writes to and the
// defines that the GLSL reads with, so the two cannot disagree. Rows are vec4. Knows nothing of three.js or storage.

/** Rows before the first light: how many lights of each kind, and the ambient light that reaches everywhere. */
export const HEADER = { counts: 0, ambient: 1, rows: 2 } as const;

/**
 * Rows before the lists of a divided box, relative to the row that the counts' w names. `low`: the box's low corner, w = the
 * first cell's row; `scale`: cells a unit, w = the first row of listed lights, four a row; `size`: cells along each axis;
 * `everywhere`: of each kind, how many lights stand in no list because they reach everywhere: the first ones.
 * A cell's row: the place of its first light among the listed, how many are points, and how many, after them, spots.
 */
export const GRID = { low: 0, scale: 1, size: 2, everywhere: 3, rows: 4 } as const;

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
    /** Place; w = kc. */
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
    /** Ia; w = the cone's limit, see coneLimit in pack-lights. */
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
 * What a light needs beyond its kind, as bits of one number that both the packing and the GLSL know: each is set where more
 * has to be done, so what lights have in common is every bit that any of them has. `power` and above hold a spot's cutoff
 * where it is whole and at most LARGEST_MILD; other cutoffs above 0 have `decay`, and also `mild` up to LARGEST_MILD.
 */
export const SHAPE = {
  ambient: 1,
  diffuse: 2,
  specular: 4,
  attenuated: 8,
  /** A cone whose limit is compared on the axis's side, by (1 - c)/2; else `wide`, on the far side. */
  narrow: 16,
  wide: 32,
  decay: 64,
  mild: 128,
  /** The cone or the decay is too steep for a cosine. */
  chords: 256,
  /** kc below 1: near the light, attenuation is cut off at 1. */
  clamped: 512,
  /** kl above 0: attenuation needs the distance, and not its square alone. */
  linear: 1024,
  /** Diffuse or specular light whose channels differ; grey is summed as one number. */
  tintedDiffuse: 2048,
  tintedSpecular: 4096,
  /** Its rows are in the program's text: programs for exactly some lights have it, packed lights never. */
  constant: 8192,
  powerShift: 14,
} as const;

/**
 * Largest exponent for which errors that it multiplies stay small: those of a cosine of float32 vectors, 2e-7, and log2's
 * lawful 2^-21 near 1 grow to 3e-5, or 0.008 of a code.
 */
export const LARGEST_MILD = 64;

/**
 * Rows in a uniform block: 16 KiB, which every WebGL 2 device has (MAX_UNIFORM_BLOCK_SIZE).
 */
export const BLOCK_ROWS = 1024;

/** Rows in the largest block: 64 KiB, as most GPUs have. More lights than fit go into a texture. */
export const LARGE_BLOCK_ROWS = 4096;

/** Width in texels, one a row, of the texture for more lights; a power of two, within every device's limit. */
export const TEXTURE_ROWS_LOG2 = 10;

/**
 * A light nearer to the fragment than this has no direction: NoL = spec = 0, inside any cone, decay 1. Its square is
 * a normal float32, so the comparison cannot be lost to flushed denormals.
 */
export const NEAREST = 1e-15;

/** Exponents below this are 0: x^0 = 1 for every x. */
export const LEAST_EXPONENT = 1e-6;

/**
 * Positive numbers below this count as zero. A device may flush what is below 2^-126; not that number itself, because
 * Firefox on Mesa reads literals of 1.2e-38 and less as zero.
 */
const TINY = 2 ** -120;

const snake = (name: string): string => name.replace(/[A-Z]/g, '_$&').toUpperCase();
const float = (n: number): string => (Number.isInteger(n) ? n.toFixed(1) : n.toExponential());

/** Not String(n): V8 keeps what that gives in a cache, which grows to 64 KiB for good where two such numbers collide in it, as these do. */
const whole = (n: number): string => n.toFixed();

/** `#define` lines for the GLSL: the whole layout. */
export function layoutDefines(): string {
  const lines = [
    `#define LIMIT_OPEN ${float(LIMIT_OPEN)}`,
    `#define BLOCK_ROWS ${whole(BLOCK_ROWS)}`,
    `#define TEXTURE_ROWS_LOG2 ${whole(TEXTURE_ROWS_LOG2)}`,
    `#define NEAREST_SQUARED ${float(NEAREST * NEAREST)}`,
    `#define LEAST_EXPONENT ${float(LEAST_EXPONENT)}`,
    `#define TINY ${float(TINY)}`,
  ];
  const tables = { HEADER, GRID, SHAPE, ...ROWS };
  for (const [table, numbers] of Object.entries(tables)) {
    for (const [name, number] of Object.entries(numbers)) {
      lines.push(`#define ${table.toUpperCase()}_${snake(name)} ${whole(number)}`);
    }
  }
  return lines.join('\n');
}
