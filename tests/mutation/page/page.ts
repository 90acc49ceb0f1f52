// Does the shader harness notice a mutant? Runs its checks and stress cases with the text of one
// chunk exchanged, the cheapest first, up to the first that fails. Many mutants share one page and
// one WebGL context.

import { checkChunks, type Checked } from '../../glsl/chunk-checks.js';
import type { Edit } from '../../glsl/edit.js';
import { floatContext } from '../../glsl/float-pass.js';
import { stressRun } from '../../glsl/stress-run.js';
import type { Driver } from '../../glsl/worst-driver.js';
import { verdict } from '../../stress/verdict.js';

/** How much is run for each mutant. */
interface Extent {
  readonly seed: number;
  /** Inputs of each check. */
  readonly checks: number;
  /** Stress cases, all categories together. */
  readonly cases: number;
}

interface Outcome {
  readonly status: 'killed' | 'survived' | 'did not compile';
  /** The sentence that no longer holds, or the compiler's words. */
  readonly by: string;
}

declare global {
  interface Window {
    /**
     * Runs everything without a mutant and learns which checks are cheap. Throws where anything
     * fails already.
     */
    prepare: (extent: Extent) => Promise<void>;
    /** Whether the harness runs this chunk at all. */
    isRun: (chunk: string) => boolean;
    tryMutant: (edit: Edit, extent: Extent) => Promise<Outcome>;
  }
}

/** Checks that take less than this time alone, in ms, are run one by one and first. */
const CHEAP = 100;

const gl = floatContext();
const cheap: string[] = [];

/** Of the lights of the long programs one in four: they take the driver seconds to compile. */
function failingCheck(edit: Edit | null, only: string, { seed, checks }: Extent) {
  const checked = checkChunks(gl, 'shipped', seed, edit, { cases: checks, only, everyLight: 4 });
  return checked.find(({ max, bound }: Checked) => !(max <= bound))?.title;
}

async function failingCase(driver: Driver, edit: Edit | null, extent: Extent) {
  const { seed, cases } = extent;
  return verdict(await stressRun(gl, { seed, cases, driver, edit }), driver !== 'shipped')[0];
}

async function failing(edit: Edit | null, extent: Extent) {
  for (const title of cheap) {
    if (failingCheck(edit, title, extent) !== undefined) return title;
  }
  return (
    (await failingCase('shipped', edit, extent)) ??
    failingCheck(edit, '', extent) ??
    // For guards that this machine's own driver has no need of.
    (await failingCase('either', edit, extent))
  );
}

window.prepare = async (extent) => {
  const all = checkChunks(gl, 'shipped', extent.seed, null, { cases: 1, only: '', everyLight: 4 });
  for (const { title } of all) {
    const start = performance.now();
    failingCheck(null, title, extent);
    if (performance.now() - start < CHEAP) {
      cheap.push(title);
    }
  }
  const broken = await failing(null, extent);
  if (broken !== undefined) throw new Error(`fails without any mutant: ${broken}`);
};

window.isRun = (chunk) => {
  try {
    failingCheck({ from: chunk, to: chunk }, cheap[0] ?? '', { seed: 1, checks: 1, cases: 1 });
    return true;
  } catch {
    return false;
  }
};

window.tryMutant = async (edit, extent) => {
  try {
    const by = await failing(edit, extent);
    return by === undefined ? { status: 'survived', by: '' } : { status: 'killed', by };
  } catch (error) {
    if (gl.isContextLost()) throw error;
    return { status: 'did not compile', by: String(error).split('\n')[0]! };
  }
};
