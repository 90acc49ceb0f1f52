// Measures one front of time against error in this browser, variant by variant in turns, in tasks
// so short that the page stays responsive. Knows nothing of how results are shown.
import type { ErrorFigures } from '../../tests/bench/front/errors.js';
import { type Front, openFront } from '../../tests/bench/front/front.js';
import { rendererName } from '../../tests/bench/pages/timing.js';
import { median, pairedRatios } from '../../tests/bench/statistics.mjs';

export interface TableRow {
  readonly label: string;
  /** Median time of a frame in milliseconds, and relative to the equation as specified. */
  readonly ms: number;
  readonly ratio: number;
  /** In 1/255. */
  readonly error: ErrorFigures;
}

export interface FrontTable {
  readonly title: string;
  readonly rows: readonly TableRow[];
}

/** Duration of a sample: long beside the timer's own cost, short enough not to be noticed. */
const SAMPLE_MS = 25;
const MOST_FRAMES = 400;
const LEAST_ROUNDS = 2;
/**
 * Pixels of a frame. Software takes about as long for the smaller picture as a GPU for the larger
 * one.
 */
const SIZES = { gpu: [960, 720], software: [160, 120] } as const;

const isSoftware = (renderer: string): boolean =>
  /SwiftShader|llvmpipe|Software|Basic Render/i.test(renderer);

/** The driver's name for itself. Throws where this browser has no WebGL 2. */
export function rendererHere(): string {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (gl === null) throw new Error('this browser has no WebGL 2');
  const name = rendererName(gl);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return name;
}

/**
 * `holder` has to be on screen. `progress` gets the table so far and the share that is done, 0 to
 * 1, after each round.
 */
export async function measureFront(
  holder: HTMLElement,
  name: string,
  ms: number,
  signal: AbortSignal,
  progress: (table: FrontTable, done: number) => void,
): Promise<FrontTable> {
  const size = SIZES[isSoftware(rendererHere()) ? 'software' : 'gpu'];
  const front = openFront(holder, name, size);
  try {
    const until = performance.now() + ms;
    const { title, variants, base } = front.facts;
    const errors = await front.errors();
    const counts: number[] = [];
    for (const i of variants.keys()) {
      counts.push(await framesFor((frames) => sample(front, i, frames, signal)));
    }
    const times: number[][] = variants.map(() => []);
    let table: FrontTable = { title, rows: [] };
    for (let round = 0; round < LEAST_ROUNDS || performance.now() < until; round++) {
      const order = [...variants.keys()];
      if (round % 2 === 1) {
        order.reverse(); // no variant always follows the same one
      }
      for (const i of order) {
        times[i]!.push((await sample(front, i, counts[i]!, signal)) / counts[i]!);
      }
      const rows = variants.map((label, i) => ({
        label,
        ms: median(times[i]!),
        ratio: median(pairedRatios(times[i]!, times[base]!)),
        error: errors[i]!,
      }));
      table = { title, rows };
      progress(table, Math.min(1, 1 - (until - performance.now()) / ms));
    }
    return table;
  } finally {
    front.close();
  }
}

/** So many frames that a sample is long enough. */
async function framesFor(time: (frames: number) => Promise<number>): Promise<number> {
  await time(1); // compiles
  let count = 1;
  for (;;) {
    const taken = await time(count);
    if (taken >= SAMPLE_MS || count >= MOST_FRAMES) return count;
    count = Math.min(
      MOST_FRAMES,
      Math.ceil(count * Math.min(8, (1.3 * SAMPLE_MS) / Math.max(taken, 0.1))),
    );
  }
}

/**
 * Milliseconds, by the GPU's timer where the browser has one. Waits while the page is in the
 * background.
 */
async function sample(
  front: Front,
  variant: number,
  frames: number,
  signal: AbortSignal,
): Promise<number> {
  signal.throwIfAborted();
  while (document.hidden) {
    await new Promise((resolve) => {
      document.addEventListener('visibilitychange', resolve, { once: true });
    });
  }
  await new Promise((resolve) => setTimeout(resolve)); // the page's turn
  const { hasTimer, renderer } = front.facts;
  return hasTimer && !isSoftware(renderer)
    ? front.time(variant, frames)
    : front.draw(variant, frames);
}
