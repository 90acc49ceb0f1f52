// Run time against error in this very browser: the bench's own variants, one front after another, in turns and in small bites, so
// that the page stays alive. Times in milliseconds. Knows nothing of how results are shown.
import type { BenchResult } from '../../tests/bench/result-file.mjs';
import type { ErrorFigures } from '../../tests/bench/error/error-figures.js';
import type { Front } from '../../tests/bench/front.mjs';
import { pairedRatios, spread } from '../../tests/bench/statistics.mjs';
import { type StandFacts, Runner } from '../../tests/bench/stands/runner.js';
import { framesFor, isSoftware } from '../../tests/bench/sampling.mjs';
import type { Size } from '../../tests/bench/stands/stand.js';
import { floatContext, rendererName } from '../../tests/glsl/float-pass.js';

/** One scene of each axis: which the reader waits for. */
const FRONTS = [
  ['shading', '1 directional'],
  ['loops', '8 mixed'],
  ['budget', '32 lamps'],
  ['antialias', 'inside at shininess 1e3'],
  ['scale', 'shininess 32'],
] as const;

/** For a front in all, its errors included; together under a minute. A slow machine has the least rounds beyond it. */
const FRONT_SECONDS = 9;
const LEAST_ROUNDS = 2;
/** Of a sample: long beside what asking costs, short beside what a reader notices. */
const SAMPLE_MS = 25;
const MOST_FRAMES = 400;
const SEED = 1;
/** Shaded points of a reference, at most: about half a second of float64. */
const EVALUATIONS = 100_000;
/** What is timed; a processor takes for the smaller as long as any GPU for the larger. */
const SIZES: Readonly<Record<'gpu' | 'software', Size>> = { gpu: [960, 720], software: [160, 120] };

export interface Told {
  /** How far it is, 0 to 1, and what is being done. */
  progress(share: number, what: string): void;
  /** A front as it is now: after each round. */
  front(front: Front): void;
}

/** What the driver calls itself, not hidden by the browser. Throws where nothing can be measured. */
export function rendererHere(): string {
  const gl = floatContext();
  const name = rendererName(gl);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return name;
}

export interface Wanted {
  /** Axes; default: all. */
  readonly only?: readonly string[];
  /** For each front; default 9. */
  readonly seconds?: number;
}

/** `holder` has to be on screen: what is not seen is not drawn. */
export async function measure(
  holder: HTMLElement,
  told: Told,
  signal: AbortSignal,
  { only = [], seconds = FRONT_SECONDS }: Wanted = {},
): Promise<BenchResult> {
  const wanted = FRONTS.filter(([axis]) => only.length === 0 || only.includes(axis));
  const renderer = rendererHere();
  const size = SIZES[isSoftware(renderer) ? 'software' : 'gpu'];
  holder.style.setProperty('--shrunk', String(holder.clientWidth / size[0]));
  const runner = new Runner(holder);
  const fronts: Front[] = [];
  let rounds = 0;
  try {
    for (const [i, [axis, scene]] of wanted.entries()) {
      const progress = (share: number, what: string): void =>
        told.progress((i + share) / wanted.length, what);
      const front = await measureFront(
        runner,
        [axis, scene],
        size,
        { ...told, progress },
        signal,
        1000 * seconds,
      );
      fronts.push(front);
      rounds = Math.max(rounds, front.points[0]?.time.count ?? 0);
    }
  } finally {
    runner.close();
  }
  const { userAgent, hardwareConcurrency } = navigator;
  const machine = {
    ...{ renderer, browser: userAgent, cores: hardwareConcurrency, 'pixel ratio': devicePixelRatio },
    measured: new Date().toISOString().slice(0, 10),
  };
  return { machine, seed: SEED, launches: 1, rounds, fronts, growth: [], peers: [], figures: {} };
}

async function measureFront(
  runner: Runner,
  [axis, scene]: readonly [string, string],
  size: Size,
  told: Told,
  signal: AbortSignal,
  ms: number,
): Promise<Front> {
  const until = performance.now() + ms;
  const share = (): number => Math.min(1 - (until - performance.now()) / ms, 0.99);
  told.progress(0, `Preparing: ${runner.axes.find(({ name }) => name === axis)?.title ?? axis}`);
  const options = { size, seed: SEED, evaluations: EVALUATIONS, quick: true };
  const facts = await runner.open(axis, scene, options);
  const errors = await runner.errors((done) => {
    signal.throwIfAborted();
    told.progress(share(), `Errors of ${facts.subjects[done - 1]?.label ?? ''}`);
  });
  const frames: number[] = [];
  for (const i of facts.subjects.keys()) {
    const one = (count: number): Promise<number> => sample(runner, facts, i, count, signal);
    frames.push(await framesFor(one, SAMPLE_MS, MOST_FRAMES));
  }
  const samples: number[][] = facts.subjects.map(() => []);
  let front = frontOf(axis, scene, facts, errors, samples);
  for (let round = 0; round < LEAST_ROUNDS || performance.now() < until; round++) {
    const order = [...facts.subjects.keys()];
    if (round % 2 === 1) order.reverse(); // none always follows the same one
    for (const i of order) {
      told.progress(share(), `Timing ${facts.subjects[i]?.label ?? ''}`);
      const count = frames[i] ?? 1;
      samples[i]?.push((await sample(runner, facts, i, count, signal)) / count);
    }
    front = frontOf(axis, scene, facts, errors, samples);
    told.front(front);
  }
  return front;
}

/** By the GPU's own timer where the browser lends it, else by the clock. Waits for a page in the background to be seen. */
async function sample(
  runner: Runner,
  { hasTimer, renderer }: StandFacts,
  i: number,
  frames: number,
  signal: AbortSignal,
): Promise<number> {
  for (;;) {
    signal.throwIfAborted();
    await seen();
    await new Promise((resolve) => setTimeout(resolve)); // the page's turn
    try {
      return hasTimer && !isSoftware(renderer) ? await runner.time(i, frames) : runner.clock(i, frames);
    } catch (error) {
      if (!document.hidden) throw error; // else: hidden half-way, what is not seen is not drawn
    }
  }
}

async function seen(): Promise<void> {
  while (document.hidden) {
    await new Promise((resolve) => {
      document.addEventListener('visibilitychange', resolve, { once: true });
    });
  }
}

function frontOf(
  axis: string,
  scene: string,
  facts: StandFacts,
  errors: readonly ErrorFigures[],
  samples: readonly number[][],
): Front {
  const { title, truth, base, shipped, size, errorSize, subjects } = facts;
  const baseTimes = samples[subjects.findIndex(({ id }) => id === base)] ?? [];
  return {
    ...{ axis, scene, title, truth, base, shipped, size, errorSize },
    measure: facts.hasTimer && !isSoftware(facts.renderer) ? 'GPU timer' : 'clock',
    points: subjects.map(({ id, label }, i) => ({
      ...{ id, label, time: spread(samples[i] ?? []) },
      ratio: spread(pairedRatios(samples[i] ?? [], baseTimes)),
      error: errors[i]!,
    })),
  };
}
