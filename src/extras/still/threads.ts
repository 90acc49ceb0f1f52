// Shares the rows of a picture among threads. Which thread casts a row changes nothing.
import { castRows } from './picture.js';
import type { CastOptions, CastScene } from './cast-scene.js';
import type { PixelLists } from './pixel-lists.js';
import { Tracer } from './tracer.js';

/** What a thread gets. The arrays are shared. */
export interface CastJob {
  readonly scene: CastScene;
  readonly options: CastOptions;
  /** The first row that no thread has taken. */
  readonly next: Int32Array;
  /** r, g, b, a of each pixel; see {@link castRows}. */
  readonly means: Float64Array;
  /** Default: the thread's own. */
  readonly lists?: PixelLists;
}

/** Rows that a thread takes at a time: small enough that all end together. */
const BAND = 8;

/** Casts rows until none is left. */
export function castShare({ scene, options, next, means, lists }: CastJob): void {
  const { width, height } = options;
  const tracer = new Tracer(scene, width, height, lists);
  for (;;) {
    const from = Atomics.add(next, 0, BAND);
    if (from >= height) return;
    means.set(castRows(tracer, options, from, Math.min(height, from + BAND)), 4 * width * from);
  }
}

/** All rows, in this thread. */
export function castHere(scene: CastScene, options: CastOptions): Float64Array {
  const means = new Float64Array(4 * options.width * options.height);
  castShare({ scene, options, next: new Int32Array(1), means });
  return means;
}

/** All rows, on several threads. Node only. @param code the module of `worker.ts`. */
export async function castOnThreads(
  scene: CastScene,
  options: CastOptions,
  threads: number,
  code: URL,
): Promise<Float64Array> {
  const { Worker: Thread } = await import('node:worker_threads');
  const next = new Int32Array(new SharedArrayBuffer(4));
  const means = new Float64Array(new SharedArrayBuffer(32 * options.width * options.height));
  const { lists } = new Tracer(scene, options.width, options.height);
  const workerData: CastJob = { scene, options, next, means, lists };
  const thread = (): Promise<void> =>
    new Promise((resolve, reject) => {
      // Not the flags of who calls: --input-type would stop a thread.
      new Thread(code, { workerData, execArgv: [] })
        .on('error', reject)
        .on('exit', () => resolve());
    });
  await Promise.all(Array.from({ length: threads }, thread));
  return means;
}
