// One channel of a picture, and filters over it that are a product of a row's and a column's: 2 r taps a pixel in place of r².
// At the picture's edge its outermost pixels go on. Knows no colour.

/** Rows from the top. */
export interface Plane {
  readonly width: number;
  readonly height: number;
  readonly data: Float64Array;
}

/** Weights at -r … r; 2 r + 1 of them. */
export type Kernel = Float64Array;

export const kernelOf = (radius: number, weight: (x: number) => number): Kernel =>
  Float64Array.from({ length: 2 * radius + 1 }, (_, i) => weight(i - radius));

/** The positive weights made to sum to 1, and the negative ones, if any, to -1. */
export function normalized(kernel: Kernel): Kernel {
  const sums = { positive: 0, negative: 0 };
  for (const weight of kernel) sums[weight > 0 ? 'positive' : 'negative'] += Math.abs(weight);
  return kernel.map((weight) => (weight === 0 ? 0 : weight / sums[weight > 0 ? 'positive' : 'negative']));
}

/** `across` along rows, `down` along columns. The weights meet the pixels as they stand: nothing is turned round. */
export function filtered(plane: Plane, across: Kernel, down: Kernel): Plane {
  return alongColumns(alongRows(plane, across), down);
}

function alongRows({ width, height, data }: Plane, kernel: Kernel): Plane {
  const radius = (kernel.length - 1) / 2;
  const result = new Float64Array(data.length);
  const row = new Float64Array(width + 2 * radius);
  for (let y = 0; y < height; y++) {
    const first = y * width;
    row.fill(data[first]!, 0, radius);
    row.set(data.subarray(first, first + width), radius);
    row.fill(data[first + width - 1]!, radius + width);
    for (let x = 0; x < width; x++) {
      let sum = 0;
      for (let k = 0; k < kernel.length; k++) sum += kernel[k]! * row[x + k]!;
      result[first + x] = sum;
    }
  }
  return { width, height, data: result };
}

/** A whole row at a time, since neighbours in a column lie far apart in memory. */
function alongColumns({ width, height, data }: Plane, kernel: Kernel): Plane {
  const radius = (kernel.length - 1) / 2;
  const result = new Float64Array(data.length);
  for (let y = 0; y < height; y++) {
    const to = y * width;
    for (let k = 0; k < kernel.length; k++) {
      const weight = kernel[k]!;
      const from = Math.min(height - 1, Math.max(0, y + k - radius)) * width;
      for (let x = 0; x < width; x++) result[to + x]! += weight * data[from + x]!;
    }
  }
  return { width, height, data: result };
}
