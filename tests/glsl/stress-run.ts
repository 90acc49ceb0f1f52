// A stress run in this browser: every category, so many cases each, from one seed, on one driver.
import type { Category } from '../stress/category.js';
import { CATEGORIES } from '../stress/categories.js';
import { type Measured, measureBatch, nothingMeasured } from '../stress/measure.js';
import type { Variant } from '../stress/case.js';
import { partSeed, Random } from '../stress/random.js';
import type { Edit } from './edit.js';
import { LoopPass } from './loop-pass.js';
import type { Driver } from './worst-driver.js';

export interface RunOptions {
  readonly seed: number;
  /** Fragments in all, shared by the categories alike; those with many lights take fewer. */
  readonly cases: number;
  readonly driver: Driver;
  readonly edit?: Edit | null;
  /** Ids of categories; all where none is named. */
  readonly only?: readonly string[];
  readonly progress?: (done: number, id: string) => void;
}

/** Few enough that a batch is done between two frames of a browser in most cases. */
const BATCH = 1 << 14;

export async function stressRun(
  gl: WebGL2RenderingContext,
  { seed, cases, driver, edit = null, only = [], progress }: RunOptions,
): Promise<Measured[]> {
  const chosen = CATEGORIES.filter(({ id }) => only.length === 0 || only.includes(id));
  const passes = new Map<Variant, LoopPass>();
  const passFor = (variant: Variant): LoopPass => {
    const present = passes.get(variant) ?? new LoopPass(gl, variant, driver, edit);
    passes.set(variant, present);
    return present;
  };
  // Where many lights make a case, the share of the work is what counts.
  const weight = ({ lights = 1 }: Category): number => 1 / Math.max(1, lights / 8);
  const each = cases / chosen.reduce((sum, category) => sum + weight(category), 0);
  const results: Measured[] = [];
  for (const category of chosen) {
    const measured = nothingMeasured(category);
    const { variants } = category;
    const wanted = Math.ceil((each * weight(category)) / variants.length);
    for (const [v, variant] of variants.entries()) {
      for (let done = 0, batch = 0; done < wanted; batch++) {
        const random = new Random(partSeed(seed, `${category.id} ${v} ${batch}`));
        const count = Math.min(BATCH, wanted - done);
        const list = Array.from({ length: count }, () => category.make(random, variant));
        measureBatch(measured, category, variant, list, passFor(variant).run(list));
        done += count;
        progress?.((results.length + (v + done / wanted) / variants.length) / chosen.length, category.id);
        await new Promise((resolve) => setTimeout(resolve));
      }
    }
    results.push(measured);
  }
  for (const pass of passes.values()) pass.dispose();
  return results;
}
