// A stress run in this browser: every category in every form of program, so many cases each, from
// one seed, on one driver.
import { CATEGORIES, type Category } from '../stress/categories.js';
import {
  type Judged,
  judged,
  type Measured,
  measureBatch,
  nothingMeasured,
} from '../stress/measure.js';
import type { Variant } from '../stress/case.js';
import { EXACT } from '../stress/contract.js';
import { partSeed, replayed } from '../stress/random.js';
import { Search } from '../stress/search.js';
import type { Edit } from './edit.js';
import { type LoopProgram, programsFor } from './loop-forms.js';
import { LoopPass } from './loop-pass.js';
import type { Driver } from './worst-driver.js';

interface RunOptions {
  readonly seed: number;
  /**
   * Fragments in all programs together, shared by the categories alike; those with many lights take
   * fewer.
   */
  readonly cases: number;
  readonly driver: Driver;
  readonly edit?: Edit | null;
  /** Ids of categories; all where none is named. */
  readonly only?: readonly string[];
  readonly progress?: (done: number, id: string) => void;
}

/** Few enough that a batch is done between two frames of a browser in most cases. */
const BATCH = 1 << 12;

/** So many cases are searched for each at random, where an error is a good part of a code. */
const CLIMBS_FURTHER = 8;

/** Cases of a step of the search: the worst of one are changed in the next. */
const STEP = 128;

/**
 * Of every category, however many lights it has: of two cases both may lie beside a branch point.
 */
const LEAST_CASES = 8;

/** At least so many programs draw a case, each a fragment: see {@link programsFor}. */
const PROGRAMS_A_CASE = 4;

export async function stressRun(
  gl: WebGL2RenderingContext,
  { seed, cases, driver, edit = null, only = [], progress }: RunOptions,
): Promise<Measured[]> {
  const chosen = CATEGORIES.filter(({ id }) => only.length === 0 || only.includes(id));
  const passes = new Passes(gl, driver, edit);
  // Where many lights make a case, the share of the work is what counts.
  const weight = ({ lights = 1 }: Category) => 1 / Math.max(1, lights / 8);
  const each =
    cases / PROGRAMS_A_CASE / chosen.reduce((sum, category) => sum + weight(category), 0);
  const results: Measured[] = [];
  for (const category of chosen) {
    const measured = nothingMeasured(category);
    const { variants } = category;
    const share = Math.ceil((each * weight(category)) / variants.length);
    const wanted = Math.max(Math.min(cases, LEAST_CASES), share);
    // A set of lights that cases share is no part of a case.
    const climbs = category.lights === undefined;
    for (const [v, variant] of variants.entries()) {
      const search = new Search(partSeed(seed, `${category.id} ${v} search`));
      const found = climbs ? wanted * (category.bound > EXACT.upTo ? CLIMBS_FURTHER : 1) : 0;
      for (let done = 0, batch = 0; done < wanted + found; batch++) {
        const climbing = done >= wanted;
        const left = (climbing ? wanted + found : wanted) - done;
        const count = Math.min(climbing ? STEP : BATCH, left);
        const partOf = partSeed(seed, `${category.id} ${v} ${batch}`);
        const random = replayed([], partOf);
        const list = Array.from({ length: count }, (_, i) => {
          if (!climbs) return judged(category.make(random, variant), variant);
          const numbers = climbing ? search.next() : [];
          const stress = category.make(replayed(numbers, partOf + i), variant);
          return judged(stress, variant, { numbers, found: climbing });
        });
        for (const [program, part] of byProgram(list, variant)) {
          const result = passes.run(program, variant, part);
          measureBatch(measured, category, program.name, part, result);
        }
        for (const { numbers, error } of climbs ? list : []) {
          search.add(numbers, error);
        }
        done += count;
        progress?.(
          (results.length + (v + done / (wanted + found)) / variants.length) / chosen.length,
          category.id,
        );
        await new Promise((resolve) => setTimeout(resolve));
      }
    }
    results.push(measured);
  }
  passes.dispose();
  return results;
}

/** The cases of each program; a case is drawn by several. */
function byProgram(list: readonly Judged[], variant: Variant) {
  const parts = new Map<LoopProgram, Judged[]>();
  for (const one of list) {
    for (const program of programsFor(one.stress, variant)) {
      if (!parts.has(program)) {
        parts.set(program, []);
      }
      parts.get(program)!.push(one);
    }
  }
  return parts;
}

/** Programs by their text: forms that differ in their masks alone share one. */
class Passes {
  readonly #gl: WebGL2RenderingContext;
  readonly #driver: Driver;
  readonly #edit: Edit | null;
  readonly #made = new Map<string, LoopPass>();

  constructor(gl: WebGL2RenderingContext, driver: Driver, edit: Edit | null) {
    this.#gl = gl;
    this.#driver = driver;
    this.#edit = edit;
  }

  run({ defines, form }: LoopProgram, variant: Variant, part: readonly Judged[]) {
    const key = defines.join();
    const pass = this.#made.get(key) ?? new LoopPass(this.#gl, defines, this.#driver, this.#edit);
    this.#made.set(key, pass);
    const cases = part.map(({ stress }) => stress);
    return pass.run(form, variant, cases);
  }

  dispose() {
    for (const pass of this.#made.values()) {
      pass.dispose();
    }
  }
}
