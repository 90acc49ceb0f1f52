// A page that tests itself, so that any browser on any driver can run it: the contract's
// categories, with numbers from the address
// (?cases=1000000&seed=1&driver=shipped&only=generic&checks=16384&chunks=unitOrZero&everyLight=1),
// a text to look at and a report for whoever drives the page.
import { CATEGORIES } from '../../stress/categories.js';
import { BRANCHES, CONE_EDGE, EXACT } from '../../stress/contract.js';
import { type Measured, mergeMeasured } from '../../stress/measure.js';
import { verdict } from '../../stress/verdict.js';
import { floatContext, rendererName } from '../float-pass.js';
import { type Checked, checkChunks, type Extent } from '../chunk-checks.js';
import type { Edit } from '../edit.js';
import { LOOP_MARK } from '../loop-mark.js';
import { stressRun } from '../stress-run.js';
import type { Driver } from '../worst-driver.js';

/** What the measured is held against. */
const CONTRACT = { edge: CONE_EDGE, branches: BRANCHES, exact: EXACT } as const;

export interface Report {
  readonly contract: typeof CONTRACT;
  /** Of the shipped loop: see {@link LOOP_MARK}. */
  readonly loop: string;
  readonly renderer: string;
  readonly browser: string;
  readonly driver: Driver;
  readonly seed: number;
  readonly seconds: number;
  readonly checked: readonly Checked[];
  readonly measured: readonly Measured[];
  /** What broke the contract, in words; empty where nothing did. */
  readonly broken: readonly string[];
  /** Why the run ended early; null where it did not. */
  readonly error: string | null;
}

declare global {
  interface Window {
    /** The report, once there is one. */
    finished: Promise<Report>;
    /** Reports of several pages, with the same driver and other seeds, as one. */
    merged: (reports: readonly Report[]) => Pick<Report, 'checked' | 'measured' | 'broken'>;
  }
}

const show = (...lines: readonly string[]) => {
  document.getElementById('text')!.textContent = lines.join('\n');
};

const asked = new URLSearchParams(location.search);

window.finished = run();
window.merged = (reports) => {
  const measured = CATEGORIES.map(({ id }) =>
    reports.flatMap((report) => report.measured.filter((result) => result.id === id)),
  )
    .filter((parts) => parts.length > 0)
    .map(mergeMeasured);
  const checked = reports[0]?.checked ?? [];
  const worst = reports[0]?.driver !== 'shipped';
  return {
    checked,
    measured,
    broken: [...checked.flatMap(brokenCheck), ...verdict(measured, worst)],
  };
};

function brokenCheck({ title, max, bound }: Checked) {
  return max <= bound ? [] : [`${title}: ${max.toPrecision(3)} above ${String(bound)}`];
}

async function run(): Promise<Report> {
  const seed = Number(asked.get('seed') ?? 1);
  const driver = (asked.get('driver') ?? 'shipped') as Driver;
  const extent: Extent = {
    cases: Number(asked.get('checks') ?? 1 << 14),
    only: asked.get('chunks') ?? '',
    everyLight: Number(asked.get('everyLight') ?? 1),
  };
  const edit = JSON.parse(asked.get('edit') ?? 'null') as Edit | null;
  const start = performance.now();
  let renderer = '';
  let checked: readonly Checked[] = [];
  let measured: readonly Measured[] = [];
  let error: string | null = null;
  try {
    const gl = floatContext();
    renderer = rendererName(gl);
    checked = checkChunks(gl, driver, seed, edit, extent);
    measured = await stressRun(gl, {
      seed,
      driver,
      cases: Number(asked.get('cases') ?? 1e6),
      only: asked.get('only')?.split(',') ?? [],
      edit,
      progress(share, id) {
        document.querySelector('progress')!.value = share;
        show(id);
      },
    });
  } catch (thrown) {
    error = thrown instanceof Error ? thrown.message : String(thrown);
  }
  const broken = [...checked.flatMap(brokenCheck), ...verdict(measured, driver !== 'shipped')];
  const words =
    error ?? (broken.length === 0 ? 'The contract holds.' : `Broken: ${broken.join('; ')}`);
  show(`${renderer} · ${driver} · seed ${seed}`, words, ...measured.map(lineOf));
  const seconds = (performance.now() - start) / 1000;
  return {
    contract: CONTRACT,
    loop: LOOP_MARK,
    renderer,
    browser: navigator.userAgent,
    driver,
    seed,
    seconds,
    checked,
    measured,
    broken,
    error,
  };
}

function lineOf({ title, cases, bound, max, notFinite, exact, channels, ...more }: Measured) {
  const excluded = Object.entries(more.excluded).map(([name, count]) => `${name} ${count}`);
  return [
    `${title}: ${cases} cases, largest error ${max.toPrecision(2)} (bound ${bound})`,
    `${notFinite} not finite, ${((100 * exact) / channels).toFixed(3)} % exact codes, ${more.wrongCodes} wrong`,
    ...excluded,
  ].join(', ');
}
